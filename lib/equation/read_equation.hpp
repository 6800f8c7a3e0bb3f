#pragma once
// From what a person gives (r; or p and q; or a whole equation) to y'' = r y over one field.

#include "linode/normal_form.hpp"
#include "symbol/rational_form.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kov {

/// A sentence about parameters (lib/equation) and where it stands.
struct AssumedText {
  std::string text;
  OriginPtr origin;    ///< of the text; null: it stands by itself
  std::string subject; ///< a file's a = "positive": the name, left of the text
};

/// A formula that is divided by: there is no equation where it is 0 for all values of the variable.
struct Divisor {
  enum class By : std::uint8_t {
    author,   ///< it stands below a line
    order,    ///< the coefficient of the second derivative
    reduction ///< to a linear equation
  };
  Expression formula;
  By by = By::author;
};

/// The equation as it was before it got another variable.
struct VariableChange {
  Expression given;              ///< y'' = exp(a*x)*y
  std::string unknown, variable; ///< its letters
  std::string formula;           ///< t = exp(a*x)
  std::optional<Expression>
      nonzero;                   ///< of the parameters: where it is 0 there is no such variable;
  Expression elsewhere;          ///< and the given equation is this one,
  std::vector<Divisor> divisors; ///< with these
};

/// One equation as text, already cut into formulas.  Exactly one of r, ode, (p and q) is given.
struct EquationText {
  std::optional<Expression> r, p, q, ode;
  std::optional<Expression> minpoly; ///< in one name, which then means one of its roots
  std::vector<std::pair<std::string, Expression>> set; ///< names with constant values
  std::vector<std::string> parameters;                 ///< names without a value
  std::vector<AssumedText> assume;                     ///< what is assumed of them
  std::string variable;                                ///< empty: see `infer_variable`
  std::string unknown;                                 ///< of `ode`; empty: what is differentiated
  std::vector<std::string> names;        ///< of the given equation, where some are lost
  std::optional<VariableChange> change;  ///< the equation was another one before
  std::vector<Divisor> divisors;         ///< of it, which p and q do not show
  std::vector<Expression> zero, nonzero; ///< of the parameters: what is so here
  /// Without a variable: take the one name that has no other meaning (otherwise z).
  bool infer_variable = true;
};

/// The texts of r, p, q or the equation, and of what else is known of the parameters.
[[nodiscard]] std::vector<Expression> formulas(const EquationText& text);

/// The divisors in it: below lines, and in powers with negative exponents.
/// Example divisors_in(parse_expression("a/b + c^(-2)", "r")).size()  // -> 2
[[nodiscard]] std::vector<Expression> divisors_in(const Expression& e);

/// y'' = r y, and the form that was given.
struct GivenEquation {
  enum class Form : std::uint8_t { r, pq, ode };
  NormalForm normal_form;
  Form form = Form::r;
  RationalFunction p, q; ///< of y'' + p y' + q y = 0 (p = 0, q = -r for Form::r)
  std::string variable = "z";
  std::string unknown = "y";
  std::string constant;         ///< what the generator of the field is called in texts; "" over Q
  std::string constant_meaning; ///< root(p, approx)
};

/// Declared parameters without a value appear: not an error, but not decided either.
class FreeParameters : public Error {
public:
  /// why: there is no answer for all values at once, as a sentence; empty: nobody has looked
  explicit FreeParameters(std::vector<std::string> names, const std::string& why = {});
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }

private:
  std::vector<std::string> names_;
};

/// Throws InputError unless every declared parameter has a name that formulas can use.
void check_names(const EquationText& text);

struct EquationNames {
  std::string variable = "z";
  std::string unknown = "y";
};
/// Two or more names without a meaning, with the options that give them one.
[[nodiscard]] InputError unknown_names(const Expression& at, const std::vector<std::string>& names,
                                       const std::string& variable);
/// Given, or inferred.  Errors  InputError
[[nodiscard]] EquationNames equation_names(const EquationText& text);
/// The names that the text gives a meaning.
[[nodiscard]] std::vector<std::string> declared_names(const EquationText& text);
/// Throws InputError where a word that has no declared meaning may be a product: xy'' = y, y'' = sin2x*y.
/// Given   EquationText bessel_functions;
/// Given   bessel_functions.ode = parse_expression("xy'' = y", "-e", true);
/// Example refuse_words(bessel_functions)  // -> throws InputError
void refuse_words(const EquationText& text);
/// The names that can have a value: the parameters and every name in the formulas; sorted.
[[nodiscard]] std::vector<std::string> settable_names(const EquationText& text);

/// Errors  InputError; FreeParameters; OutOfBudget for degrees above the budget
/// Given   EquationText bessel, weber;
/// Given   bessel.ode = parse_expression("z^2*y'' + z*y' + (z^2 - 1/4)*y = 0", "ode", true);
/// Given   weber.r = parse_expression("z^2 + a", "r"), weber.parameters = {"a"};
/// Example read_equation(bessel).normal_form.r  // -> -1
/// Example read_equation(weber).variable  // -> throws FreeParameters
[[nodiscard]] GivenEquation read_equation(const EquationText& text, const Budget& budget = {});

/// May the only name without a meaning be the variable of a typed equation?  x, t, z, xi, ..., but not a, k, w, lambda,
/// x2 or pi; nor x as a function of y: x'' = y x is asked back.
/// Example is_usual_variable("t", "y")  // -> yes
/// Example is_usual_variable("k", "y")  // -> no
/// Example is_usual_variable("y", "x")  // -> no
[[nodiscard]] bool is_usual_variable(const std::string& name, const std::string& unknown);
/// The variable of a typed equation beside names that can only be constants: the only usual one beside letters that
/// are none (x beside n, E, k_1); nothing beside a, k, omega, ... is the unnamed one, or t by time.  Unset: to be asked
/// back.
/// Example obvious_variable({"n", "x"}, "y")  // -> x
/// Example obvious_variable({"omega"}, "x")  // -> t
/// Example obvious_variable({"t", "x"}, "y")  // -> none
/// Example obvious_variable({"s"}, "y")  // -> none
/// Example obvious_variable({"x", "x2"}, "y")  // -> none
/// Example obvious_variable({"omega0", "zeta"}, "theta", true)  // -> t
[[nodiscard]] std::optional<std::string> obvious_variable(const std::vector<std::string>& names,
                                                          const std::string& unknown,
                                                          bool by_time = false);
/// Greek letters that are usual variables also stand for a damping ratio, a density, an angle.
[[nodiscard]] bool may_be_constant(const std::string& variable);
/// The variable of an equation that does not name it: y'' + 4 y = 0 is about y(x), x'' + 4 x = 0 about x(t).
[[nodiscard]] std::string unnamed_variable(const EquationText& text, const std::string& unknown);
/// pi and e stand for numbers, and are names only where they are declared.
/// Example is_constant_of_mathematics("pi")  // -> yes
[[nodiscard]] bool is_constant_of_mathematics(const std::string& name);
[[nodiscard]] InputError variable_or_constant(const Expression& where, const std::string& name);

} // namespace kov
