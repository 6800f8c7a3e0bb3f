#pragma once
// One equation with free parameters, as text, for lib/strata.
//
// Assumptions are sentences:
//
//   A > 0     A + B >= C     d != 0     h^2 = 1 + A          (also <, <=)
//   n positive | negative | nonnegative | nonzero | real | rational | complex | arbitrary
//   2*nu odd integer     n even integer     n integer     n not an integer
//   nu in 1/2+Z          nu not in 1/2+Z
//
// joined by commas, semicolons or "and"; "is" and "an" may be written.

#include "equation/read_equation.hpp"
#include "strata/decide_strata.hpp"

#include <string>
#include <utility>
#include <vector>

namespace kov {

struct ParametricEquation {
  strata::Question question;
  std::string variable;
  GivenEquation::Form form = GivenEquation::Form::r;
  MFraction p, q;  ///< of the given y'' + p y' + q y = 0
  MFraction gauge; ///< -p/2
  Assumptions
      assumed; ///< of the author: those of the question say where the equation is this one, too
  std::vector<MPoly> nonzero; ///< irreducible: where one of them is 0 the equation is another one
};

/// Errors  InputError: an unknown name, a function that is not rational, as check_assumptions; an
///         equation that is not linear of the second order; NoValue: one that divides by 0
///         FreeParameters: root(...) or a square root of something else than an integer that is no
///         square, beside parameters
/// Given   EquationText weber;
/// Given   weber.r = parse_expression("z^2 + a", "r"), weber.parameters = {"a"};
/// Given   const ParametricEquation weber_equation = read_parametric_equation(weber);
/// Example weber_equation.variable  // -> z
/// Example weber_equation.question.r  // -> a + z^2
[[nodiscard]] ParametricEquation read_parametric_equation(const EquationText& text);

/// The equation on a part of the parameters.
struct EquationPart {
  std::vector<std::pair<std::string, std::string>>
      where;                                  ///< a != 0, and what is so elsewhere: a = 0
  std::optional<ParametricEquation> equation; ///< in another variable where `where` has an equation
  std::string none = {};                      ///< why there is none: it has no value
  std::string open = {};                      ///< why it is not known
};

/// Disjoint, and they cover all parameters: one, unless a variable was chosen that is none for some
/// values.  What the first of them is follows from the text; on the others a != 0 fails.
/// Errors  as read_parametric_equation
/// Given   EquationText mathieu = understood("y'' = cos(a*x)*y", "-e", weber).text;
[[nodiscard]] std::vector<EquationPart> read_parts(const EquationText& text);

/// Every name without a value but the variable becomes a parameter, `energy` among them.  Where no variable is named it
/// is the only one of z, x and t that occurs, or else the only other usual letter (is_usual_variable).
/// Errors  InputError: several could be it; a word may be a product (refuse_words)
/// Given   EquationText hermite;
/// Given   hermite.r = parse_expression("x^2 - E", "r");
/// Given   take_all_parameters(hermite);
/// Example hermite.variable  // -> x
/// Example hermite.parameters  // -> {E}
void take_all_parameters(EquationText& text, const std::string& energy = "E");

/// The variable of a parameter whose values are asked for.
/// Errors  InvalidArgument: the equation has no such parameter
/// Example weber_equation.question.r.ring()->name(energy_of(weber_equation, "a"))  // -> a
[[nodiscard]] std::size_t energy_of(const ParametricEquation& equation, const std::string& name);

} // namespace kov
