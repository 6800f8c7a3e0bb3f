#pragma once
// The Stokes directions of y'' = (a x^(n-2) + c/x^2) y, x = z - centre: x^(1/2) times Bessel
// functions of (2/n) (a x^n)^(1/2).  The slope at infinity is n/2, ramified for odd n.
// docs/theory/monodromy.md 10.6

#include "exact/rational_function.hpp"
#include "monodromy/crossings.hpp"
#include "monodromy/point.hpp"

namespace kov::monodromy {

struct BesselEquation {
  NfElem centre, a, c;
  long n = 1; ///< without c an equation of n >= 3 has no finite singularity
};

/// Nothing for other r, and for more than 24 directions.
[[nodiscard]] std::optional<BesselEquation> bessel_equation(const RationalFunction& r);

/// Counterclockwise, from the first direction behind the base; without a singularity from any.
/// Errors   Imprecise
[[nodiscard]] Crossings bessel_crossings(const BesselEquation& e, const Point& base, long bits);

} // namespace kov::monodromy
