#pragma once
// int f dx as an elementary function.
//
//   rational functions              rational_integral.hpp
//   times exp, sin, cos, powers     undetermined coefficients (undetermined.hpp), also with log and atan
//   of sin(h), cos(h), h' constant  u = sin h, cos h or tan h
//   of exp(g), g' constant          u = exp(g)
//   of log(x), times 1/x            u = log(x)
//   times a root of a quadratic     Euler's substitutions
//   sums of these

#include "elementary/element.hpp"

#include <optional>

namespace kov::elementary {

/// Compared with its derivative at points before it is returned.  Nothing: none was found, which proves nothing.
/// Constants are such that no denominator of the answer is 0 (excluded()).
/// Given   const auto letters = std::make_shared<Letters>("x", std::vector<std::string>{"a"});
/// Given   const auto integral = [&](const char* s) {
///             return antiderivative(element(parse_expression(s, "f"), letters)); };
/// Example text(*integral("x*exp(a*x)"))  // -> (a*x - 1)*exp(a*x)/a^2
/// Example text(*integral("x^a"))  // -> x^(a + 1)/(a + 1)
/// Example text(*integral("1/sqrt(x^2 + 1)"))  // -> log(sqrt(x^2 + 1) + x)
/// Example integral("exp(x^2)").has_value()  // -> no
[[nodiscard]] std::optional<Element> antiderivative(const Element& f);
/// The same, or int(f, x).
[[nodiscard]] Element integral(const Element& f);

} // namespace kov::elementary
