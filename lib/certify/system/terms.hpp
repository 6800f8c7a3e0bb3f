#pragma once
// The terms of a polynomial by their exponents.

#include "proof/algebra/arithmetic.hpp"

#include <algorithm>
#include <map>

namespace kov::certify {

using Exponents = std::vector<unsigned long>;

/// f by the exponents of these variables, those of the others 0: what stands beside them.
[[nodiscard]] inline std::map<Exponents, MPoly> parts_by(const MPoly& f,
                                                         const std::vector<bool>& variables) {
  std::map<Exponents, MPoly> parts;
  for (long t = 0; t < f.length(); ++t) {
    Exponents own = f.exponents(t), others = own;
    for (std::size_t i = 0; i < own.size(); ++i)
      (variables[i] ? others : own)[i] = 0;
    MPoly& part = parts.try_emplace(own, f.ring()).first->second;
    fmpz_mpoly_push_term_fmpz_ui(part.raw(), f.coefficient(t).raw(), others.data(), f.ctx());
  }
  for (auto& [own, part] : parts)
    fmpz_mpoly_sort_terms(part.raw(), part.ctx());
  return parts;
}

using Weights = std::vector<long>; ///< by variable; those of the rest are 0

/// 1 for these variables.
[[nodiscard]] inline Weights ones(std::size_t size, const std::vector<std::size_t>& variables) {
  Weights all(size, 0);
  for (const std::size_t i : variables)
    all[i] = 1;
  return all;
}

[[nodiscard]] inline long weight_of(const Exponents& exponents, const Weights& weights) {
  long sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i)
    sum += weights[i] * static_cast<long>(exponents[i]);
  return sum;
}

/// The lowest and the highest weight of a term; of 0: at least everything, at most nothing.
struct WeightRange {
  long lowest = std::numeric_limits<long>::max(), highest = std::numeric_limits<long>::min();

  [[nodiscard]] bool is(long weight) const { return lowest >= weight && highest <= weight; }
};
[[nodiscard]] inline WeightRange weights_of(const MPoly& f, const Weights& weights) {
  WeightRange range;
  for (long t = 0; t < f.length(); ++t) {
    const long w = weight_of(f.exponents(t), weights);
    range = {std::min(range.lowest, w), std::max(range.highest, w)};
  }
  return range;
}

} // namespace kov::certify
