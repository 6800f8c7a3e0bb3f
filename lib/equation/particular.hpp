#pragma once
// One solution of y'' + p y' + q y = f for a right side of powers, exponentials, sines and cosines.

#include "symbol/expression.hpp"

#include <optional>
#include <string>

namespace kov {

/// y = sum R_i(x) exp(g_i) and R_i(x) exp(g_i) cos(h_i), ... sin(h_i) with the g_i, h_i of the right side and rational
/// functions R_i: those of bounded degree are looked for, so that "none" means "none of these".  With rational numbers
/// only.  Checked: the equation holds, by substitution.
/// Given   const auto found = [](const char* ode, const char* f) {
///             return particular_solution(parse_expression(ode, "-e", true), "y", "x", parse_expression(f, "-e")); };
/// Example *found("y'' - y = 0", "exp(x)")  // -> (x/2)*exp(x)
/// Example *found("x^2*y'' - 2*y = 0", "3*x")  // -> -3*x/2
/// Example found("y'' + x^2*y = 0", "sin(x)").has_value()  // -> no
[[nodiscard]] std::optional<std::string> particular_solution(const Expression& homogeneous,
                                                             const std::string& unknown,
                                                             const std::string& variable,
                                                             const Expression& right_side);

} // namespace kov
