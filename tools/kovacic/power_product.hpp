#pragma once
// Products of powers as text.

#include <string>

namespace kov::cli {

/// The product of two formulas, each a product of powers and of other factors, with the powers of one
/// base together; constant factors may be lost, so that it is for solutions of linear equations.
/// Example: product_of_powers("x^(-1/2)", "sqrt(x)*J_n(x)") is "J_n(x)"
[[nodiscard]] std::string product_of_powers(const std::string& first, const std::string& second);

} // namespace kov::cli
