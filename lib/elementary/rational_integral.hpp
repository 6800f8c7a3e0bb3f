#pragma once
// int R dx for a rational function R of x: Horowitz' reduction, then logarithms and arctangents.

#include "elementary/element.hpp"

#include <optional>

namespace kov::elementary {

/// Nothing where an irreducible factor of the denominator has a degree above 2, but for those that are functions of x^k
/// or products of two real quadratics.  near_zero: the sign in log(+-(x - c)) is the one at x = 0.
/// Given   const auto letters = std::make_shared<Letters>("x", std::vector<std::string>{"a"});
/// Given   const auto integral = [&](const char* s) {
///             return text(*rational_integral(*element(parse_expression(s, "f"), letters).rational(), letters)); };
/// Example integral("1/(x^2 + 1)")  // -> atan(x)
/// Example integral("(2*x + 1)/(x^2*(x - 1))")  // -> 3*log((x - 1)/x) + 1/x
[[nodiscard]] std::optional<Element>
rational_integral(const MFraction& f, const LettersPtr& letters, bool near_zero = false);
/// A value with positive numbers for all parameters: for the choice of a form, never of a fact.
[[nodiscard]] double sample(const MFraction& constant, const Letters& letters);

} // namespace kov::elementary
