#pragma once
// Section 7 of system_certificates.md: the symplectic leaves around the curve.  What is excluded on the
// leaf of the curve is excluded near it then (mechanics.md (6), lemma T).

#include "certify/system/along_curve.hpp"
#include "exact/subsets.hpp"

namespace kov::certify {

/// The leaves around the curve are regular, of dimension four, and cut out by Casimir functions that are claimed.
class RegularLeaves {
public:
  RegularLeaves(const Way& w, const AlongCurve& x) : w_(w), x_(x), in_(x.algebra()) {}

  [[nodiscard]] bool operator()() const {
    const PhaseSystem& s = w_.system;
    if (!s.hamiltonian || s.dimension <= leaf_dimension || s.dimension > max_dimension)
      return false;
    const auto is_constant = [](const PhaseSymbol& f) { return f.gradient.empty(); };
    const auto is_of_constants = [&](const MPoly& f) {
      const auto used = used_variables(f);
      return std::ranges::none_of(used, [&](std::size_t i) { return i < s.dimension; });
    };
    return std::ranges::all_of(s.functions, is_constant) &&
           std::ranges::all_of(s.relations, is_of_constants) &&
           std::all_of(x_.values().begin(),
                       x_.values().begin() + static_cast<std::ptrdiff_t>(s.dimension),
                       [](const auto& v) { return v.has_value(); }) &&
           has_independent_casimirs(s.dimension - leaf_dimension) && has_rank_four();
  }

private:
  static constexpr std::size_t leaf_dimension = 4, max_dimension = 8, max_casimirs = 6;

  // A function of z alone, in which a coefficient is a number: at no point of the parameters it is 0 for
  // all z.
  [[nodiscard]] bool is_nowhere_zero(const CurveFunction& f) const {
    const std::size_t z = w_.curve.z();
    const auto used = used_variables(f.p);
    const auto c = coefficients(f.p, z);
    return std::ranges::none_of(used, [&](std::size_t i) { return i < z; }) &&
           std::ranges::any_of(c, [](const MPoly& x) { return !is_zero(x) && is_constant(x); });
  }

  // A Pfaffian of four coordinates.
  [[nodiscard]] bool has_rank_four() const {
    const std::size_t n = w_.system.dimension;
    std::vector<CurveRow> bracket(n, CurveRow(n, in_.zero()));
    for (const PhaseBracket& x : w_.system.brackets) {
      bracket[x.first][x.second] = x_.at(x.value);
      bracket[x.second][x.first] = in_.negative(bracket[x.first][x.second]);
    }
    const auto all = subsets(n, leaf_dimension);
    return std::ranges::any_of(all, [&](const std::vector<std::size_t>& s) {
      const auto pair = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        return in_.times(bracket[s[i]][s[j]], bracket[s[k]][s[l]]);
      };
      return is_nowhere_zero(
          in_.plus(in_.minus(pair(0, 1, 2, 3), pair(0, 2, 1, 3)), pair(0, 3, 1, 2)));
    });
  }

  // A minor of the gradients of k Casimir functions.
  [[nodiscard]] bool has_independent_casimirs(std::size_t k) const {
    std::vector<CurveRow> gradients;
    for (const ClaimedFunction& c : w_.claims)
      if (c.casimir && gradients.size() < max_casimirs)
        gradients.push_back(x_.at(x_.space().gradient(c.value)));
    if (gradients.size() < k) return false;
    for (const auto& rows : subsets(gradients.size(), k))
      for (const auto& columns : subsets(w_.system.dimension, k)) {
        std::vector<CurveRow> minor;
        for (const std::size_t i : rows) {
          minor.emplace_back();
          for (const std::size_t j : columns)
            minor.back().push_back(gradients[i][j]);
        }
        if (is_nowhere_zero(determinant(minor))) return true;
      }
    return false;
  }
  // By the first row.
  [[nodiscard]] CurveFunction determinant(std::vector<CurveRow> rows) const {
    if (rows.empty()) return in_.one();
    const CurveRow top = rows.front();
    rows.erase(rows.begin());
    CurveFunction sum = in_.zero();
    for (std::size_t j = 0; j < top.size(); ++j) {
      auto rest = rows;
      for (CurveRow& row : rest)
        row.erase(row.begin() + static_cast<long>(j));
      const CurveFunction term = in_.times(top[j], determinant(rest));
      sum = j % 2 == 0 ? in_.plus(sum, term) : in_.minus(sum, term);
    }
    return sum;
  }

  const Way& w_;
  const AlongCurve& x_;
  const CurveAlgebra& in_;
};

} // namespace kov::certify
