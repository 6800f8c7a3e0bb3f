#pragma once
// From y'/y modulo one prime to y'/y over K: the image only has to say which exponent stands at
// each place; the polynomial part then follows from one linear recurrence over K.

#include "exact/modular.hpp"
#include "linode/singularities.hpp"

#include <optional>

namespace kov {

/// omega = num/den modulo a prime ideal; den monic, num and den coprime.
struct ModularOmega {
  PrimeIdeal prime;
  NmodPoly num;
  NmodPoly den;
};

/// y = P exp(int theta), y'/y = theta + P'/P.  Kept in two parts: P may have degree 10^4.
struct ExponentialSolution {
  RationalFunction theta;
  Poly p = Poly(1); ///< monic

  [[nodiscard]] RationalFunction omega() const;
};

/// P'' + 2 theta P' + (theta' + theta^2 - r) P = 0, cleared of denominators: c2 P'' + c1 P' + c0 P.
struct PolynomialEquation {
  Poly c2;
  Poly c1;
  Poly c0;
};
/// Example polynomial_equation(z, z*z + 3)  // -> {1, 2*z, -2}
[[nodiscard]] PolynomialEquation polynomial_equation(const RationalFunction& theta,
                                                     const RationalFunction& r);
/// Does y solve y'' = r y?  Linear in P.
/// Example solves({z, z}, z*z + 3)  // -> yes
[[nodiscard]] bool solves(const ExponentialSolution& y, const RationalFunction& r);

/// Unset when an exponent does not lie in K[c]/q by inspection (a square root in a residue field of
/// degree > 1), or when the image does not lift.  A result is verified by the caller.
/// Cost  one recurrence of length deg P over K
[[nodiscard]] std::optional<ExponentialSolution>
lift_by_exponents(const Singularities& s, const ModularOmega& image, const Budget& budget = {});

} // namespace kov
