#pragma once
// From the tree of a formula to an elementary function, and a linear equation with such coefficients.

#include "elementary/element.hpp"
#include "symbol/expression.hpp"

#include <string>

namespace kov::elementary {

/// int(f, x) stays.
/// Errors  NotElementary: other functions, roots of sums, names that are no letters
/// Given   const auto letters = std::make_shared<Letters>("x", std::vector<std::string>{"a"});
/// Given   const auto read = [&](const char* s) { return element(parse_expression(s, "f"), letters); };
/// Example text(read("sin(x)^2"))  // -> 1/2 - cos(2*x)/2
/// Example text(read("x^a*exp(2*log(x))"))  // -> x^(a + 2)
/// Example text(read("gamma(x)"))  // -> throws NotElementary
[[nodiscard]] Element element(const Expression& e, const LettersPtr& letters);

/// c0 y + c1 y' + c2 y'' = right; c2 = 0: of the first order.
struct LinearEquation {
  Element c0, c1, c2, right;
};
/// Errors  NotElementary; InputError: not linear, or of another order
/// Example text(linear_equation(parse_expression("y'' + y = tan(x)", "e", true), "y", letters).right)
///         // -> tan(x)
[[nodiscard]] LinearEquation linear_equation(const Expression& equation, const std::string& unknown,
                                             const LettersPtr& letters);

/// Does the formula have cosh, sinh, ...?
[[nodiscard]] bool is_hyperbolic(const Expression& e);

} // namespace kov::elementary
