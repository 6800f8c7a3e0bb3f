#include "variation/leaf.hpp"

#include <algorithm>

namespace kov {
namespace {

using Row = std::vector<MFraction>;

// df P along the curve: df on the tangent vectors P dx_k of the leaf.
Row on_the_leaf(const VectorField& v, const InvariantManifold& m, const MFraction& f) {
  const Row df = restricted_gradient(v, m, f);
  Row row;
  for (std::size_t k = 0; k < v.dimension(); ++k) {
    MFraction sum(v.ring);
    for (std::size_t j = 0; j < v.dimension(); ++j)
      if (const MFraction& p = (*v.poisson)[j][k]; !is_zero(df[j]) && !is_zero(p)) sum += df[j] * p;
    row.push_back(m.restrict(sum));
  }
  return row;
}

// Laplace's expansion by the first row; the blocks that are studied have one or two rows.
MFraction minor(const std::vector<Row>& rows, const std::vector<std::size_t>& columns) {
  if (rows.size() == 1) return rows[0][columns[0]];
  return rows[0][columns[0]] * rows[1][columns[1]] - rows[0][columns[1]] * rows[1][columns[0]];
}

void add(std::vector<MPoly>& divisors, const MFraction& f) {
  for (const MPoly& p : {f.num(), f.den()})
    if (!is_constant(p)) divisors.push_back(p);
}

} // namespace

bool seen_on_the_leaf(const VectorField& v, const InvariantManifold& m, const NormalSystem& n,
                      const std::vector<std::string>& unknowns, std::vector<MPoly>& divisors) {
  if (!v.poisson || unknowns.empty()) return true;
  if (unknowns.size() > 2) return false;
  std::vector<Row> rows;
  for (std::size_t i = 0; i < n.system.names.size(); ++i)
    if (std::find(unknowns.begin(), unknowns.end(), n.system.names[i]) != unknowns.end())
      rows.push_back(on_the_leaf(v, m, m.equations[n.equations[i]].difference));
  if (rows.size() != unknowns.size()) return false;
  for (std::size_t a = 0; a < v.dimension(); ++a)
    for (std::size_t b = rows.size() == 1 ? a : a + 1; b < v.dimension(); ++b) {
      const MFraction f = m.restrict(minor(rows, {a, b}));
      if (is_zero(f) || m.vanishes_on_curve(f)) continue;
      add(divisors, f);
      return true;
    }
  return false;
}

} // namespace kov
