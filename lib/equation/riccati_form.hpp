#pragma once
// y' = a y^2 + b y + c as a linear equation: y = -u'/(a u), a (u'/a)' - b u' + a c u = 0.

#include "symbol/expression.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

struct RiccatiForm {
  std::string unknown;               ///< u, or another letter
  std::string linear;                ///< the equation for u
  std::string quadratic;             ///< a
  std::string substitution;          ///< y = -u'/(a*u)
  std::vector<std::string> divisors; ///< not 0 for all values of the variable: a
};

/// Nothing for an equation of another form: second derivatives, no y^2, y' not alone.
/// Given    const auto linear = [](const char* s) {
///              return riccati_form(parse_expression(s, "-e", true), "y", "x")->linear; };
/// Example  linear("y' = y^2 + x")  // -> u'' + x*u = 0
/// Example  riccati_form(parse_expression("y' = x*y", "-e", true), "y", "x").has_value()  // -> no
[[nodiscard]] std::optional<RiccatiForm>
riccati_form(const Expression& ode, const std::string& unknown, const std::string& variable);

} // namespace kov
