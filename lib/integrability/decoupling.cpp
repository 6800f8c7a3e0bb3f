#include "integrability/decoupling.hpp"

#include "integrability/constant_matrices.hpp"

#include <algorithm>

namespace kov {
namespace {

// Rows that span smaller blocks, one after the other: of a splitting polynomial the kernels of its
// factors; of a power the kernel of the factor, and something outside of it.
std::optional<Matrix> smaller_blocks(const ConstantRows& block, const Matrix& t,
                                     const Budget& budget) {
  const auto factors = factors_of(minimal_polynomial(t, budget));
  Matrix rows;
  for (const auto& [p, multiplicity] : factors) {
    Matrix power = value(p, t);
    if (factors.size() > 1)
      for (long k = 1; k < multiplicity; ++k)
        power = product(power, value(p, t));
    std::ranges::move(row_kernel(power, budget), std::back_inserter(rows));
  }
  if (rows.empty() || (factors.size() < 2 && rows.size() == t.size())) return std::nullopt;
  std::ranges::move(identity(block.ring(), t.size()), std::back_inserter(rows));
  return block.basis(rows, budget);
}

// The rows for the matrix whose minimal polynomial has the most factors.
std::optional<Matrix> smaller_blocks(const ConstantRows& block, const Budget& budget) {
  std::size_t most = 0;
  std::optional<Matrix> best;
  for (const Matrix& t : with_combinations(block.commutant(budget))) {
    const std::size_t factors = factors_of(minimal_polynomial(t, budget)).size();
    if (factors <= most) continue;
    if (auto rows = smaller_blocks(block, t, budget)) {
      best = std::move(rows);
      most = factors;
    }
  }
  if (best)
    for (auto& row : *best)
      row = block.row(row);
  return best;
}

} // namespace

std::optional<ManifoldSpec> decoupled(const System& s, const ManifoldSpec& m,
                                      const ManifoldReport& report, const Budget& budget) {
  ManifoldSpec better = m;
  bool changed = false;
  for (const std::vector<std::size_t>& block : blocks(report.normal.system, *report.manifold)) {
    if (block.size() < 3 || block.size() > largest_decoupled) continue;
    const ConstantRows constant(s, report.normal.system, *report.manifold, block);
    const auto rows = smaller_blocks(constant, budget);
    if (!rows) continue;
    replace_equations(better, report.normal, block, *rows);
    changed = true;
  }
  if (!changed) return std::nullopt;
  return better;
}

} // namespace kov
