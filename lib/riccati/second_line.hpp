#pragma once
// Once one exponential solution y is known: is there a second one?
//
// A second solution is y int y^-2, and it is exponential exactly when int y^-2 = v y^-2 for a
// rational function v, that is when v' - 2 omega v = 1 with omega = y'/y; then it is v/y.  The
// exponents of omega leave v a polynomial part of one of two degrees.
//
// Source  docs/theory/riccati_one_place.md, 7, with proofs

#include "riccati/lift.hpp"

#include <optional>

namespace kov {

/// The product v of y and a second exponential solution, with Wronskian 1; unset: y is the only
/// one.
///
/// Requires y solves the equation of s, and y^2 is not rational (so it is when some place is
///          irregular or has an exponent difference that is not an integer)
/// Throws   OutOfBudget
/// Cost     one linear recurrence over K, at most two
/// Example  product_with_second_line({RationalFunction(1), Poly(1)}, singularities(1))  // -> -1/2
/// Example  product_with_second_line({RationalFunction(z), z}, singularities(z*z + 3))  // -> none
[[nodiscard]] std::optional<RationalFunction> product_with_second_line(const ExponentialSolution& y,
                                                                       const Singularities& s,
                                                                       const Budget& budget = {});

} // namespace kov
