#include "pullback/kernel.hpp"

#include "exact/lists.hpp"
#include "exact/modular.hpp"

#include <algorithm>

namespace kov::pullback {
namespace {

Field field_of(const std::vector<Row>& rows) {
  for (const Row& row : rows)
    for (const NfElem& x : row)
      if (!x.field()->is_rational()) return x.field();
  return rationals();
}

// A kernel modulo one prime ideal is at least as large as the kernel itself.
bool injective_modulo_a_prime(const std::vector<Row>& rows, std::size_t columns, const Field& k) {
  const PrimeIdeal prime = PrimeIdeals::large(k).next();
  nmod_mat_t m;
  nmod_mat_init(m, static_cast<slong>(rows.size()), static_cast<slong>(columns), prime.p);
  bool reduced = true;
  for (std::size_t i = 0; i < rows.size() && reduced; ++i)
    for (std::size_t j = 0; j < columns && reduced; ++j) {
      const auto x = prime.reduce(rows[i][j]);
      reduced = x.has_value();
      if (reduced) nmod_mat_entry(m, i, j) = *x;
    }
  const bool injective = reduced && nmod_mat_rank(m) == static_cast<slong>(columns);
  nmod_mat_clear(m);
  return injective;
}

void subtract(Row& row, const Row& other, std::size_t pivot) {
  if (is_zero(row[pivot])) return;
  const NfElem factor = row[pivot];
  for (std::size_t i = 0; i < row.size(); ++i)
    if (!is_zero(other[i])) row[i] -= factor * other[i];
}

} // namespace

std::vector<Row> kernel(const std::vector<Row>& rows, std::size_t columns, const Budget& budget) {
  if (injective_modulo_a_prime(rows, columns, field_of(rows))) return {};
  std::vector<Row> reduced; // one for each pivot, where it is 1 and the others are 0
  std::vector<std::size_t> pivots;
  for (Row row : rows) {
    budget.check();
    for (std::size_t i = 0; i < reduced.size(); ++i)
      subtract(row, reduced[i], pivots[i]);
    std::size_t at = 0;
    while (at < columns && is_zero(row[at]))
      ++at;
    if (at == columns) continue;
    const NfElem unit = inverse(row[at]);
    for (NfElem& x : row)
      x *= unit;
    for (Row& other : reduced)
      subtract(other, row, at);
    reduced.push_back(std::move(row));
    pivots.push_back(at);
  }
  std::vector<Row> found;
  for (std::size_t free = 0; free < columns; ++free) {
    if (is_among(free, pivots)) continue;
    Row& x = found.emplace_back(columns, NfElem(0));
    x[free] = NfElem(1);
    for (std::size_t i = 0; i < pivots.size(); ++i)
      x[pivots[i]] = -reduced[i][free];
  }
  return found;
}

} // namespace kov::pullback
