#pragma once
// Differential operators as formulas: (Dx - x)*(Dx + x), D^2 - x, theta*(theta + c - 1) - x*(theta + a).

#include "symbol/expression.hpp"

#include <optional>
#include <string>

namespace kov {

/// The operator: the derivation by `variable`, or x d/dx.
struct Derivation {
  std::string name;
  std::string variable = {}; ///< "": the formula does not say it
  bool euler = false;        ///< x d/dx: the variable is known
};

/// The one name like Dx; nothing if there are several, or something is differentiated.
[[nodiscard]] std::optional<Derivation> derivation_in(const Expression& e);
/// Is something differentiated, with primes or diff?
[[nodiscard]] bool differentiates(const Expression& e);

/// The equation L y = 0, or L y = f where y (u, w, f) stands at the right end of each term with d.
/// Errors   InputError: no operator in d, its text too long
/// Given    const Expression airy = parse_expression("Dx^2 - x", "-e");
/// Example  applied(airy, *derivation_in(airy), 1000).kind()  // -> Kind::sum
[[nodiscard]] Expression applied(const Expression& e, const Derivation& d, std::size_t longest);

} // namespace kov
