#pragma once
// Functions (a u + b)/(c u + d) of one variable: u is real where the value is.

#include "exact/multivariate.hpp"

namespace kov {

/// The variable u of f = (a u + b)/(c u + d), with rational numbers a, b, c, d and a d != b c.
/// At each point where f is real, or rational, so is u.  Unset: f is not of this form.
/// Given   const Ring ring = make_ring({"x", "y"});
/// Given   const MPoly x = MPoly::variable(ring, 0), y = MPoly::variable(ring, 1);
/// Example variable_of_linear_fraction(MFraction(x, x - MPoly(ring, Integer(2))))  // -> 0
/// Example variable_of_linear_fraction(MFraction(x * y))  // -> none
/// Example variable_of_linear_fraction(MFraction(x * x))  // -> none
[[nodiscard]] std::optional<std::size_t> variable_of_linear_fraction(const MFraction& f);

} // namespace kov
