#include "variation/leaf.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <optional>

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

} // namespace

void add_divisors(std::vector<MPoly>& divisors, const MFraction& f) {
  for (const MPoly& p : {f.num(), f.den()})
    if (!is_constant(p)) divisors.push_back(p);
}

namespace {

constexpr std::size_t most_rows = 5;

// The rows df_i P of the block.
std::vector<Row> rows_of(const VectorField& v, const InvariantManifold& m, const NormalSystem& n,
                         const std::vector<std::string>& unknowns) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < n.system.names.size(); ++i)
    if (is_among(n.system.names[i], unknowns))
      rows.push_back(on_the_leaf(v, m, m.equations[n.equations[i]].difference));
  return rows;
}

// dF P for a linear integral F of the normal system.
Row differential(const VectorField& v, const InvariantManifold& m, const NormalSystem& n,
                 const LinearIntegral& f) {
  Row row(v.dimension(), MFraction(v.ring));
  for (std::size_t i = 0; i < f.coefficients.size(); ++i) {
    if (is_zero(f.coefficients[i])) continue;
    const Row df = on_the_leaf(v, m, m.equations[n.equations[i]].difference);
    for (std::size_t k = 0; k < row.size(); ++k)
      row[k] = m.restrict(row[k] + f.coefficients[i] * df[k]);
  }
  return row;
}

// A minor that is not 0 on the curve.
std::optional<MFraction> some_minor(const std::vector<Row>& rows, const InvariantManifold& m) {
  MFraction f;
  const auto is_nonzero = [&](const MFraction& minor) {
    f = m.restrict(minor);
    return !is_zero(f) && !m.vanishes_on_curve(f);
  };
  const bool found = kov::some_minor(rows, rows[0].size(), rows[0][0].ring(), is_nonzero);
  return found ? std::optional(f) : std::nullopt;
}

// The functions that are 0 on the part of the leaf that the block is a quotient of.
std::vector<Row> restrictions(const VectorField& v, const InvariantManifold& m,
                              const NormalSystem& n, const Restriction& to) {
  std::vector<Row> rows = rows_of(v, m, n, to.unknowns);
  const auto is_used = [&](const LinearIntegral& f) {
    return std::ranges::any_of(to.integrals,
                               [&](const Elimination& e) { return e.integral == f.name; });
  };
  for (const LinearIntegral& f : n.integrals)
    if (is_used(f)) rows.push_back(differential(v, m, n, f));
  return rows;
}

} // namespace

bool seen_on_the_leaf(const VectorField& v, const InvariantManifold& m, const NormalSystem& n,
                      const Restriction& to, const std::vector<std::string>& unknowns,
                      std::vector<MPoly>& divisors) {
  if (!v.poisson || unknowns.empty()) return true;
  std::vector<Row> rows;
  for (Row& row : restrictions(v, m, n, to)) {
    rows.push_back(std::move(row));
    if (rows.size() + unknowns.size() > most_rows) return false;
    if (!some_minor(rows, m)) rows.pop_back(); // it is 0 where the others are
  }
  std::vector<Row> block = rows_of(v, m, n, unknowns);
  if (block.size() != unknowns.size()) return false;
  std::move(block.begin(), block.end(), std::back_inserter(rows));
  if (rows.size() > most_rows) return false;
  const auto f = some_minor(rows, m);
  if (f) add_divisors(divisors, *f);
  return f.has_value();
}

} // namespace kov
