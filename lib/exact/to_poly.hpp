#pragma once
// From many variables to one.

#include "exact/modular.hpp"
#include "exact/multivariate.hpp"

#include <map>

namespace kov {

/// f as a polynomial in the variable z over K, with these values of the others.
/// Given   const Ring plane = make_ring({"z", "a"});
/// Given   const MPoly f = MPoly::variable(plane, 0) * MPoly::variable(plane, 1);
/// Example to_poly(f, 0, rationals(), {{1, NfElem(3)}})  // -> 3*z
/// Example to_poly(f, 0, rationals(), {})  // -> throws InvalidArgument
[[nodiscard]] Poly to_poly(const MPoly& f, std::size_t z, const Field& k,
                           const std::map<std::size_t, NfElem>& values);
/// f modulo a prime.  Requires that f has no other variable than x.
[[nodiscard]] NmodPoly to_poly(const MPoly& f, std::size_t x, mp_limb_t p);

} // namespace kov
