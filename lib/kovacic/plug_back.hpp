#pragma once
// Answers put back into the equation: polynomial identities, with no cancellation on the way.

#include "exact/rational_function.hpp"

namespace kov::kovacic {

/// omega' + omega^2 = r?
[[nodiscard]] bool solves_riccati(const RationalFunction& omega, const RationalFunction& r);

/// phi'' + 3 phi phi' + phi^3 = 4 r phi + 2 r'?  That is: v = exp(int phi) solves the second
/// symmetric power, and omega^2 - phi omega + phi'/2 + phi^2/2 - r is kept by the derivation.
[[nodiscard]] bool solves_second_power(const RationalFunction& phi, const RationalFunction& r);

} // namespace kov::kovacic
