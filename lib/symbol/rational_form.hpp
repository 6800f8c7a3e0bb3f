#pragma once
// From the tree of a formula to an element of K(z).

#include "exact/budget.hpp"
#include "exact/rational_function.hpp"
#include "symbol/constants.hpp"

#include <string>

namespace kov {

/// The meaning of names while a formula is evaluated.
struct Reading {
  std::string variable = "z"; ///< "" for a constant
  const Constants* constants = nullptr;
  Budget budget; ///< max_degree limits the degrees that are expanded
};

/// The rational function that the formula means.
///
/// Requires constants->gather(e) was called
/// Errors   InputError: an unknown name (with the nearest known one), a function that is not
///          rational, an exponent that is not an integer, division by zero
///          OutOfBudget: a degree above the budget, a power with absurdly long numbers
/// Cost     sums of monomials are linear; other sums are halved recursively
/// Given    const Constants none; const Reading in_z{"z", &none, {}};
/// Example  rational_function(parse_expression("(z^2 - 1)/(z - 1)", "-r"), in_z)  // -> z + 1
/// Example  rational_function(parse_expression("z + w", "-r"), in_z)  // -> throws InputError
[[nodiscard]] RationalFunction rational_function(const Expression& e, const Reading& reading);

/// The polynomial c0, c1, ... in `variable` with rational coefficients.  Throws InputError.
/// Example rational_polynomial(parse_expression("x^2 - 1/2", "p"), "x")  // -> {-1/2, 0, 1}
[[nodiscard]] std::vector<Rational> rational_polynomial(const Expression& e,
                                                        const std::string& variable);

/// The error for a name that nobody knows, where `known` names could be meant; variable: "" where a
/// constant is expected.
[[nodiscard]] InputError unknown_name(const Expression& at, std::vector<std::string> known,
                                      const std::string& variable);
[[nodiscard]] InputError unknown_name(const Expression& at, const Reading& reading);

} // namespace kov
