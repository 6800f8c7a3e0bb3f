#pragma once
// Answers put back into the equation: polynomial identities, with no cancellation on the way.

#include "exact/rational_function.hpp"

namespace kov::kovacic {

/// omega' + omega^2 = r?
/// Example solves_riccati(RationalFunction(z*z + 1, z), z*z + 3)  // -> yes
[[nodiscard]] bool solves_riccati(const RationalFunction& omega, const RationalFunction& r);

/// phi'' + 3 phi phi' + phi^3 = 4 r phi + 2 r'?  That is: v = exp(int phi) solves the second
/// symmetric power, and omega^2 - phi omega + phi'/2 + phi^2/2 - r is kept by the derivation.
/// Example solves_second_power(RationalFunction(1, 2*z), RationalFunction(16*z - 3, 16*z*z))
///         // -> yes
[[nodiscard]] bool solves_second_power(const RationalFunction& phi, const RationalFunction& r);

} // namespace kov::kovacic
