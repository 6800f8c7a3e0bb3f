#pragma once
// A linear differential equation recognised in a formula: "z^2*y'' + z*y' + (z^2-1/4)*y = 0",
// "y'' = r(z)*y", "(p(z)*y')' = q(z)*y", "diff(y,z,2) = z*y".

#include "symbol/linear_reader.hpp"
#include "symbol/rational_form.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace kov {

/// c[0] y + c[1] y' + ... + rest, all over K(z).
using LinearForm = LinearFormOver<RationalFunction>;

/// The names of the unknown function and of its variable, as the formula itself tells them.
struct OdeNames {
  std::string unknown;  ///< what is differentiated
  std::string variable; ///< the second argument of diff, or the argument of y(z); else empty
};

/// The unknown function of (z*y)'' = y, where a product is differentiated, is y(z), or the only letter that is
/// usual for one; `declared` is its name where the user says it.
/// Errors  InputError: nothing is differentiated, or two different functions are
/// Given   const Expression ode = parse_expression("z^2*diff(u, z, 2) + z*u' = u", "ode", true);
/// Given   const Expression product = parse_expression("(z*y)'' = y", "ode", true);
/// Example ode_names(ode)  // -> {u, z}
/// Example ode_names(product).unknown  // -> y
/// Example ode_names(product, "z").unknown  // -> z
[[nodiscard]] OdeNames ode_names(const Expression& equation, const std::string& declared = {});

/// The names that are differentiated, and those that stand as the argument of one.
struct Differentiated {
  std::set<std::string> functions, arguments;
};
[[nodiscard]] Differentiated differentiated_in(const Expression& equation);

/// p and q of y'' + p y' + q y = 0.
struct SecondOrder {
  RationalFunction p, q;
};

/// Errors  InputError: not linear, an order other than 2, a term without y, y'' cancels
/// Given   Constants none; none.gather({&ode, 1});
/// Given   const Reading reading{"z", &none, {}};
/// Example second_order(ode, "u", reading)  // -> {1/z, -1/z^2}
[[nodiscard]] SecondOrder second_order(const Expression& equation, const std::string& unknown,
                                       const Reading& reading);

} // namespace kov
