#pragma once
// Equations of the first order, by a linear one of the second order that can be decided:
//
//   y' = a y^2 + b y + c     y = -u'/(a u), a (u'/a)' - b u' + a c u = 0
//   y' = b y + c             what solves y' = b y, and the constants: y'' = (b + b'/b) y'
//   y' = b y + c y^n         v = y^(1-n): v' = (1-n) (b v + c)

#include "exact/integer.hpp"
#include "symbol/expression.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

struct FirstOrderForm {
  enum class Kind : std::uint8_t { riccati, linear, bernoulli };
  Kind kind = Kind::linear;
  std::string unknown; ///< of `decided`: u, v, or another letter; y itself where that is linear
  std::string decided; ///< the equation of the second order
  std::string substitution;            ///< y = -u'/(a*u), y = 1/sqrt(v); "" for a linear one
  std::string quadratic;               ///< a of Riccati's equation
  std::string linear;                  ///< v' - 2*v = x, for the others
  Rational exponent{1};                ///< y = v^exponent
  std::vector<std::string> divisors{}; ///< not 0 for all values of the variable: a
};

/// Nothing for an equation of another order.
/// Errors   InputError: of the first order, and of none of these forms
/// Given    const auto form = [](const char* s) { return *first_order_form(parse_expression(s, "-e", true), "y", "x"); };
/// Example  form("y' = y^2 + x").decided  // -> u'' + x*u = 0
/// Example  form("y' = y - x*y^3").substitution  // -> y = 1/sqrt(v)
/// Example  form("y' = y - x*y^3").linear  // -> v' + 2*v = 2*x
/// Example  form("y' = y^3 + x").decided  // -> throws InputError
[[nodiscard]] std::optional<FirstOrderForm>
first_order_form(const Expression& ode, const std::string& unknown, const std::string& variable);

} // namespace kov
