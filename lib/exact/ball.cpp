#include "exact/ball.hpp"

#include "exact/error.hpp"

namespace kov {
namespace {

Rational endpoint(const Ball& x, bool upper) {
  if (!arb_is_finite(x.raw())) throw DomainError("an infinite ball has no rational bound");
  arf_t end;
  arf_init(end);
  if (upper)
    arb_get_ubound_arf(end, x.raw(), 64);
  else
    arb_get_lbound_arf(end, x.raw(), 64);
  Rational q;
  arf_get_fmpq(q.raw(), end);
  arf_clear(end);
  return q;
}

} // namespace

Rational upper_bound(const Ball& x) { return endpoint(x, true); }
Rational lower_bound(const Ball& x) { return endpoint(x, false); }

} // namespace kov
