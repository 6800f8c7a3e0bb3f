#pragma once
// Coefficients in sin, cos, exp, tanh, ... of one argument, or in roots of one linear function: a variable in which
// they are rational.
//
//   exp(m c x)                       t = exp(g x)
//   sinh, cosh, tanh of m c x        t = exp(g x), or cosh(g x) where the equation does not change with x -> -x
//   sin, cos, tan of m c x           t = tan(g x/2), or cos(g x) likewise
//   (a x + b)^(k/n)                  t = (a x + b)^(1/n)
//
// t generates the field of the coefficients, or a field below it by two degrees, or above it by n: the identity
// component of the group is the same, and so is whether there are Liouvillian solutions (docs/theory/mechanics.md (6)).

#include "symbol/expression.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

struct ChangedEquation {
  std::string variable;              ///< its letter
  std::string p, q;                  ///< y_tt + p y_t + q y = 0
  std::string change;                ///< t = exp(a x)
  std::string nonzero;               ///< a: where it is 0 there is no such variable,
  std::string elsewhere;             ///< and the given equation is this one
  std::string leading;               ///< the coefficient of the second derivative, in t
  std::vector<std::string> divisors; ///< in t
};

/// Nothing where the coefficients are rational functions of x already.  divisors: formulas in x.
/// Errors   InputError: functions of arguments that no such variable serves, x beside them
/// Given    const auto changed = [](const char* ode) {
///              return function_change(parse_expression(ode, "-e", true), "y", "x"); };
/// Example  changed("y'' = exp(x)*y")->q  // -> -1/t
/// Example  changed("y'' = cos(x)*y")->change  // -> t = cos(x)
/// Example  changed("y'' = a*cos(a*x)*y")->nonzero  // -> a
/// Example  changed("y'' = a*cos(a*x)*y")->elsewhere  // -> y'' = a*(1)*y
/// Example  changed("y'' = x*y").has_value()  // -> no
/// Example  changed("y'' = x*exp(x)*y")->q  // -> throws InputError
[[nodiscard]] std::optional<ChangedEquation>
function_change(const Expression& ode, const std::string& unknown, const std::string& variable,
                const std::vector<Expression>& divisors = {});

/// The equation with the values of those functions whose argument does not change: exp(0*x) is 1.
/// Nothing where there are none.
[[nodiscard]] std::optional<std::string> with_constant_functions(const Expression& ode,
                                                                 const std::string& unknown,
                                                                 const std::string& variable);

/// Does a function of x, or a root, stand in it?
[[nodiscard]] bool has_functions_of(const Expression& e, const std::string& variable);

} // namespace kov
