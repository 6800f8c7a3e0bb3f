#pragma once
// Elements and equations at points: every solution is compared with its equation before anybody sees it.

#include "elementary/element.hpp"
#include "symbol/expression.hpp"

#include <string>

namespace kov::elementary {

/// Is f' = g?  At some points, in balls of 300 bits, parameters and x positive: what differs by 10^-25 of the largest term is
/// not equal.  "Not" is certain, but for what has no value at any of the points.
/// Given   const auto letters = std::make_shared<Letters>("x", std::vector<std::string>{});
/// Given   const Element t(letters, letters->variable_value());
/// Example is_derivative_at_points(sin(t), cos(t))  // -> yes
/// Example is_derivative_at_points(sin(t), sin(t))  // -> no
[[nodiscard]] bool is_derivative_at_points(const Element& f, const Element& g);

/// The same for f = g.
[[nodiscard]] bool are_equal_at_points(const Element& f, const Element& g);

/// Does the equation hold with `y` for the unknown?  Its names are letters of y.
/// Given   const Expression oscillator = parse_expression("y'' + y = 0", "-e", true);
/// Example holds_at_points(oscillator, "y", sin(t))  // -> yes
/// Example holds_at_points(oscillator, "y", exp(t))  // -> no
[[nodiscard]] bool holds_at_points(const Expression& equation, const std::string& unknown,
                                   const Element& y);
[[nodiscard]] bool holds_at_points(const Expression& equation, const std::string& unknown,
                                   const Expression& y, const Letters& letters);

} // namespace kov::elementary
