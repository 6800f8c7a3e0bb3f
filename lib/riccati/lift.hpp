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

/// Unset when an exponent does not lie in K[c]/q by inspection (a square root in a residue field of
/// degree > 1), or when the image does not lift.  A result is verified by the caller.
/// Cost  one recurrence of length deg P over K
[[nodiscard]] std::optional<RationalFunction>
lift_by_exponents(const Singularities& s, const ModularOmega& image, const Budget& budget = {});

} // namespace kov
