#pragma once
// Bounds of the ansatz on a part of the parameters: by a theorem where that leaves a small one, else those of the
// options.
//
// Source  docs/theory/integrals.md (4)

#include "integrals/find.hpp"

namespace kov {

struct IntegralBounds {
  /// is_regular: the metric is so on the part.  The other arguments outlive it.
  IntegralBounds(const PhaseSpace& p, const std::optional<NaturalHamiltonian>& natural,
                 const IntegralOptions& options, bool is_regular);

  const PhaseSpace& space;
  const std::optional<NaturalHamiltonian>& natural;
  const IntegralOptions& options;
  bool layered, bounded; ///< the ansatz; by a theorem, where that leaves a small one
  /// The coefficients of integrals of the highest degree, or of this one; unset: those of Theorems 2 and 3.
  std::optional<long> highest;
  [[nodiscard]] std::optional<long> coefficients(long degree) const;

  [[nodiscard]] Ansatz ansatz(const PhaseSpace& p, long degree,
                              std::optional<long> coefficients) const {
    return make_ansatz(p, {degree, coefficients, layered, options.power}, natural);
  }
  /// The class of functions, in words.
  [[nodiscard]] std::string searched() const;
};

} // namespace kov
