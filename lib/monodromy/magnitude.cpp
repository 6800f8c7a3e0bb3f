#include "monodromy/magnitude.hpp"

#include "monodromy/imprecise.hpp"

namespace kov::monodromy {

long exponent(const Magnitude& a) {
  if (is_zero(a)) return 0;
  if (!is_finite(a) || !fmpz_fits_si(MAG_EXPREF(a.raw())))
    throw Imprecise("a bound is not a machine number");
  return fmpz_get_si(MAG_EXPREF(a.raw()));
}

} // namespace kov::monodromy
