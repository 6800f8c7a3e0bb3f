#include "integrability/decoupling.hpp"

#include "integrability/constant_matrices.hpp"

#include <algorithm>

namespace kov {
namespace {

// Rows that span smaller blocks, one after the other: of a splitting polynomial the kernels of its
// factors; of a power the kernel of the factor, and something outside of it.
std::optional<Matrix> smaller_blocks(const Matrix& t, const Budget& budget) {
  const std::size_t n = t.size();
  const auto factors = factors_of(characteristic_polynomial(t));
  Matrix rows;
  for (const auto& [p, multiplicity] : factors) {
    Matrix power = value(p, t);
    if (factors.size() > 1)
      for (long k = 1; k < multiplicity; ++k)
        power = product(power, value(p, t));
    for (auto& row : row_kernel(power, budget))
      rows.push_back(std::move(row));
  }
  if (rows.empty() || (factors.size() < 2 && rows.size() == n)) return std::nullopt;
  for (const auto& unit : identity(t[0][0].ring(), n)) {
    if (rows.size() == n) break;
    rows.push_back(unit);
    Matrix transposed(n);
    for (std::size_t j = 0; j < n; ++j)
      for (const auto& row : rows)
        transposed[j].push_back(row[j]);
    if (!null_space(transposed, rows.size(), t[0][0].ring(), budget).empty()) rows.pop_back();
  }
  return rows;
}

// That of most factors is the best.
std::optional<Matrix> smaller_blocks(const std::vector<Matrix>& commuting, const Budget& budget) {
  std::size_t most = 0;
  std::optional<Matrix> best;
  for (const Matrix& t : with_combinations(commuting)) {
    const std::size_t factors = factors_of(characteristic_polynomial(t)).size();
    if (factors <= most) continue;
    if (auto rows = smaller_blocks(t, budget)) {
      best = std::move(rows);
      most = factors;
    }
  }
  return best;
}

} // namespace

std::optional<ManifoldSpec> decoupled(const ManifoldSpec& m, const ManifoldReport& report,
                                      const Budget& budget) {
  ManifoldSpec better = m;
  bool changed = false;
  for (const std::vector<std::size_t>& block : blocks(report.normal.system, *report.manifold)) {
    if (block.size() < 3 || block.size() > largest_decoupled) continue;
    const auto all = by_monomials(report.normal.system, *report.manifold, block);
    if (all.empty()) continue;
    const auto rows = smaller_blocks(commutant(all, block.size(), budget), budget);
    if (!rows) continue;
    replace_equations(better, report.normal, block, *rows);
    changed = true;
  }
  if (!changed) return std::nullopt;
  return better;
}

} // namespace kov
