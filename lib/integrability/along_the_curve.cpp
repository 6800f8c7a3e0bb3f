#include "integrability/along_the_curve.hpp"

#include <algorithm>

namespace kov {
namespace {

// One that moves along the curve; where it does not vanish the rows are a basis.
std::optional<std::size_t> moving_coordinate(const VectorField& v, const InvariantManifold& m) {
  for (std::size_t j = 0; j < v.dimension(); ++j)
    if (!m.vanishes_on_curve(m.restrict(v.components[j]))) return j;
  return std::nullopt;
}

} // namespace

std::optional<ExtendedSystem> extended_system(const System& s, const ManifoldReport& report) {
  const VectorField& v = s.field;
  const InvariantManifold& m = *report.manifold;
  if (v.poisson || !m.levels.empty() || report.normal.system.a.size() + 1 != v.dimension())
    return std::nullopt;
  const auto w = moving_coordinate(v, m);
  if (!w) return std::nullopt;
  Matrix rows;
  for (const std::size_t i : report.normal.equations)
    rows.push_back(restricted_gradient(v, m, m.equations[i].difference));
  rows.emplace_back(v.dimension(), MFraction(v.ring));
  rows.back()[*w] = MFraction(v.ring, Rational(1));
  std::vector<MFraction> target; // that of the coordinate: dw' = row w of the Jacobian
  for (std::size_t k = 0; k < v.dimension(); ++k)
    target.push_back(m.restrict(partial(v, v.components[*w], k)));
  ExtendedSystem e{report.normal.system, report.normal.divisors};
  auto last = combination(m, rows, target, e.divisors);
  if (!last) return std::nullopt;
  for (auto& row : e.system.a)
    row.emplace_back(v.ring);
  e.system.a.push_back(*std::move(last));
  e.system.names.push_back(v.name(*w));
  return e;
}

std::vector<std::vector<std::size_t>> pairs_with_the_curve(const ExtendedSystem& e,
                                                           const InvariantManifold& m) {
  const Matrix& a = e.system.a;
  const std::size_t last = a.size() - 1;
  std::vector<std::vector<std::size_t>> pairs;
  for (std::size_t i = 0; i < last; ++i) {
    if (m.vanishes_on_curve(a[last][i])) continue;
    bool used = false; // by another unknown, which then does not stay 0
    for (std::size_t k = 0; k < last; ++k)
      used = used || (k != i && !m.vanishes_on_curve(a[k][i]));
    if (!used) pairs.push_back({i, last});
  }
  return pairs;
}

} // namespace kov
