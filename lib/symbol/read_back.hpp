#pragma once
// A solution is read back from its printed text before it is shown: GiNaC differentiates it and puts it into the given
// equation, and the value at random points is computed with balls of 40 digits.

#include "symbol/expression.hpp"

#include <map>
#include <optional>
#include <string>

namespace kov {

enum class ReadBack : std::uint8_t {
  solves,   ///< the value is below 10^-25 of the largest term at each point
  differs,  ///< above: the text is not a solution
  too_long, ///< not looked at: above 20 000 characters, or the work that this allows
  unknown   ///< a function, a constant or a point that has no value here
};

struct ReadBackEquation {
  Expression ode; ///< left = right, in the unknown, its variable and parameters
  std::string unknown, variable;
  std::map<std::string, Expression> values; ///< of parameters, in others: what is so on a stratum
  std::map<std::string, std::string> constants; ///< I, alpha: root(p, approx)
};

/// text: as for_programs writes it.
/// Given   const ReadBackEquation airy{parse_expression("y'' = x*y", "-e", true), "y", "x", {}, {}};
/// Example read_back("airyai(x)", airy) == ReadBack::solves   // -> yes
/// Example read_back("airyai(2*x)", airy) == ReadBack::differs  // -> yes
[[nodiscard]] ReadBack read_back(const std::string& text, const ReadBackEquation& equation);

/// The same where parameters and the variable are positive (the variable has a small imaginary part).
/// Example holds_where_positive(parse_expression("sqrt(x^2) = x", "-e", true), "x") == ReadBack::solves  // -> yes
[[nodiscard]] ReadBack holds_where_positive(const Expression& equation, const std::string& variable,
                                            std::map<std::string, Expression> values = {});

/// 1 or -1: the sign of its real part at numbers for all names, 0: it may be 0 there; unset: it has no value.
/// values: formulas for names, functions of the variable by which a prime differentiates.
/// Example sign_at(parse_expression("1 - x", "e"), {{"x", 2}}).value()  // -> -1
[[nodiscard]] std::optional<int> sign_at(const Expression& e,
                                         const std::map<std::string, Rational>& point,
                                         const std::string& variable = {},
                                         std::map<std::string, Expression> values = {});

/// Has it a value at numbers of which none is special?
/// Example has_value_somewhere(parse_expression("1/(a - b)", "c"))  // -> yes
/// Example has_value_somewhere(parse_expression("1/(a - a)", "c"))  // -> no
[[nodiscard]] bool has_value_somewhere(const Expression& e);

} // namespace kov
