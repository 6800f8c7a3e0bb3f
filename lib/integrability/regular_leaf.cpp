#include "integrability/regular_leaf.hpp"

#include "exact/finite_algebra.hpp"
#include "exact/subsets.hpp"
#include "integrability/report.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t leaf_dimension = 4, max_dimension = 8, max_casimirs = 6;

class LeavesAroundCurve {
public:
  LeavesAroundCurve(const VectorField& v, const AlgebraicOde& ode) : v_(v), ode_(ode) {}

  [[nodiscard]] bool are_regular(const std::vector<MFraction>& casimirs) const {
    return has_independent(casimirs, v_.dimension() - leaf_dimension) && has_rank_four();
  }

private:
  // A function of z alone, in which a coefficient is a number.
  [[nodiscard]] bool is_nowhere_zero(const MFraction& f) const {
    const auto value = is_zero(f) ? std::nullopt : ode_.field->evaluate(f);
    const auto in_z = value ? ode_.field->in_z(*value) : std::nullopt;
    if (!in_z || is_zero(*in_z)) return false;
    const auto c = coefficients(in_z->num(), ode_.z);
    return std::ranges::any_of(c, [](const MPoly& x) { return !is_zero(x) && is_constant(x); });
  }
  [[nodiscard]] bool has_rank_four() const {
    const auto& bracket = *v_.poisson;
    const auto all = subsets(v_.dimension(), leaf_dimension);
    return std::ranges::any_of(all, [&](const std::vector<std::size_t>& s) {
      const auto pair = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        return bracket[s[i]][s[j]] * bracket[s[k]][s[l]];
      };
      return is_nowhere_zero(pair(0, 1, 2, 3) - pair(0, 2, 1, 3) + pair(0, 3, 1, 2));
    });
  }
  [[nodiscard]] bool has_independent(const std::vector<MFraction>& casimirs, std::size_t k) const {
    for (const auto& rows : subsets(casimirs.size(), k))
      for (const auto& columns : subsets(v_.dimension(), k)) {
        Matrix minor;
        for (const std::size_t i : rows)
          for (auto& row = minor.emplace_back(); const std::size_t j : columns)
            row.push_back(partial(v_, casimirs[i], j));
        if (is_nowhere_zero(determinant(minor, casimirs.front().ring()))) return true;
      }
    return false;
  }

  const VectorField& v_;
  const AlgebraicOde& ode_;
};

std::vector<MFraction> casimirs_of(const System& s) {
  std::vector<MFraction> all;
  for (const SystemClaim& c : s.claims) {
    if (c.kind != SystemClaim::Kind::casimir || !c.holds || !c.on.empty()) continue;
    const auto x = hamiltonian_field(s.field, *s.field.poisson, c.value);
    const bool is_one = std::ranges::all_of(x, [](const MFraction& f) { return is_zero(f); });
    if (is_one && all.size() < max_casimirs) all.push_back(c.value);
  }
  return all;
}

} // namespace

bool has_regular_leaves(const System& s, const ManifoldReport& report) {
  const VectorField& v = s.field;
  if (!v.poisson || !v.functions.empty() || !v.relations.empty() ||
      v.dimension() <= leaf_dimension || v.dimension() > max_dimension)
    return false;
  const auto casimirs = casimirs_of(s);
  if (casimirs.size() < v.dimension() - leaf_dimension) return false;
  return std::ranges::any_of(report.blocks, [&](const BlockReport& b) {
    return b.ode && b.ode->field && LeavesAroundCurve(v, *b.ode).are_regular(casimirs);
  });
}

} // namespace kov
