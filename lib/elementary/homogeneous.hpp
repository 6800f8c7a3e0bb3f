#pragma once
// Two independent solutions of y'' + p y' + q y = 0 as elementary functions, real where the equation is.

#include "elementary/read.hpp"

#include <optional>

namespace kov::elementary {

struct Basis {
  Element first, second;
};

/// p and q constant, or p x and q x^2: exponentials, powers, sines and cosines.  Where the characteristic equation has
/// a parameter in its discriminant, that is not 0.
/// Given   const auto letters = std::make_shared<Letters>("x", std::vector<std::string>{"a"});
/// Given   const MFraction a = MFraction::variable(letters->ring(), "a"), zero = letters->number(0);
/// Example text(characteristic_basis(zero, a*a, letters)->first)  // -> cos(a*x)
/// Example text(characteristic_basis(zero, -a, letters)->second)  // -> exp(-sqrt(a)*x)
[[nodiscard]] std::optional<Basis> characteristic_basis(const MFraction& p, const MFraction& q,
                                                        const LettersPtr& letters);

/// y1 int exp(-int p)/y1^2 beside y1; an integral without a closed form stays.
/// Throws  NotElementary, also where int p has no closed form
/// Given   const auto bessel = linear_equation(parse_expression("x^2*y'' - 2*y = 0", "e", true), "y", letters);
/// Example text(second_solution(bessel, element(parse_expression("1/x", "y"), letters)))  // -> x^2/3
[[nodiscard]] Element second_solution(const LinearEquation& equation, const Element& first);

} // namespace kov::elementary
