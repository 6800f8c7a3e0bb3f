#pragma once
// One equation, from what somebody wrote to solutions in their letters: the given equation, its normal form, the
// decision, the classical equation, functions with a name, and back to the given variable.  Every command and the Python
// module ask here; what they show is written from these values.
//
//   right side, initial values, Riccati's equation: `Solutions::y` is the basis of the linear homogeneous equation in the
//   given variable; what is made of it goes behind `shown`

#include "decide/decide.hpp"
#include "equation/parametric_equation.hpp"
#include "symbol/read_back.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kov::answer {

/// The linear homogeneous equation in the letters in which it was given.
struct Given {
  Expression ode;
  std::string unknown, variable;
  /// The variable in which it is decided, as a function of the given one: t, exp(x).
  std::optional<std::pair<std::string, Expression>> change;
  std::map<std::string, Expression> values; ///< of names in it
};
/// Errors   InputError, as equation_names
/// Given    EquationText airy;
/// Given    airy.r = parse_expression("x + a", "-r"), airy.variable = "x", airy.parameters = {"a"};
/// Example  written(given_equation(airy).ode)  // -> y'' = (x + a)*y
[[nodiscard]] Given given_equation(const EquationText& text);

struct Solutions {
  std::vector<Expression> y;
  std::vector<std::string> where;  ///< conditions under which they solve the equation
  std::vector<std::string> unless; ///< and those under which they are not a basis
  std::vector<std::string> failed; ///< what was left out, and why: an error of ours
  bool read_back = true;           ///< all of them were
};

struct Style {
  bool complex = false; ///< exp(I x) stays
  bool maps =
      true; ///< a function with a name behind a change of variable is searched: some seconds
  std::map<std::string, std::string> constants = {}; ///< what letters of number fields mean
};

/// Both solutions of y'' = r y times exp(int gauge), where they are known as formulas.
/// Throws  OutOfBudget
[[nodiscard]] std::optional<std::pair<std::string, std::string>>
basis_of(const Decision& decision, const RationalFunction& gauge, const Budget& budget);

/// The solutions of a decided equation; empty where none is known.  gauge: -p/2 in the decision's variable.
[[nodiscard]] Solutions solutions_of(const Given& given, const GivenEquation& equation,
                                     const Decision& decision, const RationalFunction& gauge,
                                     const Style& style = {}, const Budget& budget = {});
/// The solutions of an equation with parameters.
struct FamilySolutions {
  /// In closed form on the general stratum; else in functions with a name, for all values of the parameters but those that
  /// are named.
  Solutions general;
  /// In closed form, on each stratum of on_domain(answer).told_apart().
  std::vector<std::vector<Solutions>> on_strata;
};
[[nodiscard]] FamilySolutions solutions_of(const Given& given, const ParametricEquation& equation,
                                           const strata::StrataAnswer& decided,
                                           const Style& style = {}, const Budget& budget = {});
/// Formulas in the variable of the decision, in the given one, real where they can be, and read back.
[[nodiscard]] Solutions shown(const Given& given, std::vector<Expression> formulas,
                              const Style& style = {});

} // namespace kov::answer
