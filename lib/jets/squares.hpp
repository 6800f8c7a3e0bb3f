#pragma once
// Sums of squares of rational numbers.

#include "exact/integer.hpp"

namespace kov::jets {

/// Is q a sum of n >= 2 squares of rational numbers?  "No" is proved (Fermat, Legendre); "yes" may
/// also mean that a number is too large to be factored here.
/// Example may_be_sum_of_squares(Rational(10, 3), 2)  // -> no
/// Example may_be_sum_of_squares(Rational(10, 9), 2)  // -> yes
/// Example may_be_sum_of_squares(Rational(7, 4), 3)  // -> no
[[nodiscard]] bool may_be_sum_of_squares(const Rational& q, long n);

} // namespace kov::jets
