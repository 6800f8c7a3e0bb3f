// Section 7 of system_certificates.md: the symplectic leaves around the curve.  What is excluded on the
// leaf of the curve is excluded near it then (mechanics.md (6), lemma T).

#include "certify/system/on_curve.hpp"
#include "exact/subsets.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr std::size_t leaf_dimension = 4, max_dimension = 8, max_casimirs = 6;

// Leibniz' formula: k <= 4.
template <class Visit> void for_permutations(std::size_t k, Visit visit) {
  std::vector<std::size_t> order(k);
  for (std::size_t i = 0; i < k; ++i)
    order[i] = i;
  do {
    bool even = true;
    for (std::size_t i = 0; i < k; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (order[j] > order[i]) even = !even;
    visit(order, even);
  } while (std::next_permutation(order.begin(), order.end()));
}

} // namespace

// A function of z alone, in which a coefficient is a number: at no point of the parameters it is 0 for
// all z.
bool OnCurve::is_nowhere_zero(const CurveFunction& f) const {
  const std::size_t z = w_.curve.z();
  for (std::size_t i = 0; i < z; ++i)
    if (uses(f.p, i)) return false;
  const Coefficients c = coefficients(f.p, z);
  return std::ranges::any_of(c, [](const MPoly& x) { return !is_zero(x) && is_constant(x); });
}

// A Pfaffian of four coordinates.
bool OnCurve::has_rank_four() const {
  const std::size_t n = w_.system.dimension;
  std::vector<Row> bracket(n, Row(n, algebra_.zero()));
  for (const PhaseBracket& x : w_.system.brackets) {
    bracket[x.first][x.second] = at(x.value);
    bracket[x.second][x.first] = algebra_.minus(algebra_.zero(), bracket[x.first][x.second]);
  }
  const auto all = subsets(n, leaf_dimension);
  return std::ranges::any_of(all, [&](const std::vector<std::size_t>& s) {
    const auto pair = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      return algebra_.times(bracket[s[i]][s[j]], bracket[s[k]][s[l]]);
    };
    return is_nowhere_zero(
        algebra_.plus(algebra_.minus(pair(0, 1, 2, 3), pair(0, 2, 1, 3)), pair(0, 3, 1, 2)));
  });
}

// A minor of the gradients of k Casimir functions.
bool OnCurve::has_independent_casimirs(std::size_t k) const {
  std::vector<Row> gradients;
  for (const ClaimedFunction& c : w_.claims) {
    if (!c.casimir || gradients.size() == max_casimirs) continue;
    Row& row = gradients.emplace_back();
    for (std::size_t j = 0; j < w_.system.dimension; ++j)
      row.push_back(at(space_.partial(c.value, j)));
  }
  if (gradients.size() < k) return false;
  for (const auto& rows : subsets(gradients.size(), k))
    for (const auto& columns : subsets(w_.system.dimension, k)) {
      CurveFunction sum = algebra_.zero();
      for_permutations(k, [&](const std::vector<std::size_t>& order, bool even) {
        CurveFunction term = algebra_.integer(even ? 1 : -1);
        for (std::size_t i = 0; i < k; ++i)
          term = algebra_.times(term, gradients[rows[i]][columns[order[i]]]);
        sum = algebra_.plus(sum, term);
      });
      if (is_nowhere_zero(sum)) return true;
    }
  return false;
}

bool OnCurve::has_regular_leaves() const {
  const PhaseSystem& s = w_.system;
  if (!s.hamiltonian || s.dimension <= leaf_dimension || s.dimension > max_dimension) return false;
  const auto is_constant = [](const PhaseSymbol& f) { return f.gradient.empty(); };
  const auto has_value = [](const auto& v) { return v.has_value(); };
  const auto is_of_constants = [&](const MPoly& f) {
    const auto used = used_variables(f);
    return std::ranges::none_of(used, [&](std::size_t i) { return i < s.dimension; });
  };
  return std::ranges::all_of(s.functions, is_constant) &&
         std::ranges::all_of(s.relations, is_of_constants) &&
         std::all_of(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(s.dimension),
                     has_value) &&
         has_independent_casimirs(s.dimension - leaf_dimension) && has_rank_four();
}

} // namespace kov::certify
