#include "pullback/kernel.hpp"

#include "exact/linear.hpp"
#include "exact/modular.hpp"
#include "exact/nmod_matrix.hpp"

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
  NmodMatrix m(rows.size(), columns, prime.p);
  return m.fill([&](std::size_t i, std::size_t j) { return prime.reduce(rows[i][j]); }) &&
         m.has_independent_columns();
}

} // namespace

std::vector<Row> kernel(const std::vector<Row>& rows, std::size_t columns, const Budget& budget) {
  if (injective_modulo_a_prime(rows, columns, field_of(rows))) return {};
  return kov::kernel(rows, columns, NfElem(1), budget);
}

} // namespace kov::pullback
