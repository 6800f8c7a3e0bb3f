#pragma once
// Delta^2 = 1 + 4 b at the double poles of r = b/(z-c)^2 + ..., all of them together.

#include "exact/budget.hpp"
#include "exact/factor.hpp"
#include "exact/rational_function.hpp"

#include <optional>
#include <vector>

namespace kov {

/// Delta^2 for each factor of exponent 2 where it is a rational number that many conjugate or
/// equal places share, or where the pole itself is rational; unset elsewhere.
///
/// Requires factors = the irreducible factors of den(r)
/// Cost     for each 19 digits of a value one evaluation modulo a prime at each pole, then one
///          division of polynomials for all; one exact evaluation for each rational pole that has
///          longer values
/// Throws   OutOfBudget
/// Given    const RationalFunction r = RationalFunction(2, z*z) + RationalFunction(1, z - 1);
/// Example  double_pole_delta_squared(r, irreducible_factors(r.den()))  // -> {none, 9}
[[nodiscard]] std::vector<std::optional<Rational>>
double_pole_delta_squared(const RationalFunction& r, const std::vector<Factor>& factors,
                          const Budget& budget = {});

} // namespace kov
