#include "system/weights.hpp"

#include "exact/error.hpp"

namespace kov {
namespace {

std::map<long, MPoly> grade(const MPoly& f, const Weights& weights) {
  std::map<long, MPoly> parts;
  for (long t = 0; t < f.length(); ++t) {
    const auto e = f.exponents(t);
    long degree = 0;
    for (const auto& [i, w] : weights)
      degree += w * static_cast<long>(e[i]);
    parts[degree] += MPoly::term(f.ring(), f.coefficient(t), e);
  }
  return parts;
}

long lowest_degree(const MFraction& f, const Weights& weights) {
  return grade(f.num(), weights).begin()->first - grade(f.den(), weights).begin()->first;
}

} // namespace

MPoly lowest_part(const MPoly& f, const Weights& weights) {
  return grade(f, weights).begin()->second;
}
MPoly highest_part(const MPoly& f, const Weights& weights) {
  return grade(f, weights).rbegin()->second;
}

std::vector<WeightTerm> weight_expansion(const MFraction& f, const Weights& weights, long count,
                                         long depth) {
  KOV_ENSURE(!is_zero(f));
  const auto num = grade(f.num(), weights);
  const auto den = grade(f.den(), weights);
  const long n0 = num.begin()->first;
  const long d0 = den.begin()->first;
  const MFraction lead(den.begin()->second);
  std::map<long, MFraction> series; // by k: the part of degree n0 - d0 + k
  std::vector<WeightTerm> terms;
  for (long k = 0; k <= depth && static_cast<long>(terms.size()) < count; ++k) {
    MFraction sum(f.ring());
    if (const auto part = num.find(n0 + k); part != num.end()) sum += MFraction(part->second);
    for (const auto& [d, g] : den)
      if (const auto earlier = series.find(k - (d - d0)); d > d0 && earlier != series.end())
        sum -= MFraction(g) * earlier->second;
    if (is_zero(sum)) continue;
    series[k] = sum / lead;
    terms.push_back({n0 - d0 + k, series[k]});
  }
  return terms;
}

std::optional<long> structure_weight(const VectorField& v, const Weights& weights) {
  if (!v.poisson) return std::nullopt;
  std::optional<long> s;
  const auto weight = [&](std::size_t j) {
    const auto w = weights.find(v.coordinates[j]);
    return w == weights.end() ? 0 : w->second;
  };
  for (std::size_t i = 0; i < v.dimension(); ++i)
    for (std::size_t j = 0; j < v.dimension(); ++j) {
      const MFraction& entry = (*v.poisson)[i][j];
      if (is_zero(entry)) continue;
      const auto terms = weight_expansion(entry, weights, 2);
      const long here = weight(i) + weight(j) - terms[0].degree;
      if (terms.size() > 1 || (s && *s != here)) return std::nullopt;
      s = here;
    }
  return s;
}

LowestSystem lowest_system(const System& s, long terms) {
  const VectorField& v = s.field;
  if (s.weights.empty())
    throw InvalidArgument("weights are missing: write [expansion] weights = {x = 1, ...}");
  LowestSystem low;
  const auto weight = [&](std::size_t j) {
    const auto w = s.weights.find(v.coordinates[j]);
    return w == s.weights.end() ? 0 : w->second;
  };
  std::optional<long> k;
  for (std::size_t j = 0; j < v.dimension(); ++j)
    if (!is_zero(v.components[j])) {
      const long here = lowest_degree(v.components[j], s.weights) - weight(j);
      if (!k || here < *k) k = here;
    }
  if (!k) throw InvalidArgument("the vector field is zero");
  low.degree = *k;
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    MFraction part(v.ring);
    if (!is_zero(v.components[j])) {
      const auto first = weight_expansion(v.components[j], s.weights, 1).front();
      if (first.degree == weight(j) + low.degree) part = first.value;
    }
    low.components.push_back(std::move(part));
  }
  low.structure = structure_weight(v, s.weights);
  if (v.hamiltonian && !is_zero(*v.hamiltonian)) {
    low.hamiltonian = weight_expansion(*v.hamiltonian, s.weights, terms);
    low.is_hamiltonian =
        low.structure &&
        hamiltonian_field(v, *v.poisson, low.hamiltonian.front().value) == low.components;
  }
  return low;
}

} // namespace kov
