#pragma once
// Two independent solutions of y'' + p y' + q y = 0 as elementary functions, real where the equation is.

#include "elementary/element.hpp"
#include "galois/classify.hpp"
#include "galois/solutions.hpp"

#include <optional>
#include <vector>

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

/// From what was found about y'' = r y, times exp(int gauge).  Nothing: no formula, or none of our form.
[[nodiscard]] std::optional<Basis> basis_from(const Classification& c,
                                              const std::vector<LiouvillianSolution>& found,
                                              const RationalFunction& gauge,
                                              const LettersPtr& letters);

} // namespace kov::elementary
