#pragma once
// From the tree of a formula to an exact rational function.

#include "exact/multivariate.hpp"
#include "symbol/expression.hpp"
#include "symbol/no_value.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace kov {

/// A declared function: its symbol stands for name(argument), e.g. s for sin(q1).
struct FunctionMeaning {
  std::size_t variable = 0;
  std::string name;
  MFraction argument;
  std::optional<MFraction> value = {}; ///< instead of the variable
};

/// The meaning of the names of a formula.
class Scope {
public:
  virtual ~Scope() = default;
  [[nodiscard]] virtual const Ring& ring() const = 0;
  /// The value of a name, or unset for an unknown one (evaluate then reports it).
  [[nodiscard]] virtual std::optional<MFraction> value(const std::string& name) const = 0;
  [[nodiscard]] virtual const std::vector<FunctionMeaning>& functions() const = 0;
  /// A formula divides by this, or by a root of it.
  virtual void divides_by(const MFraction& f) const { static_cast<void>(f); }
  /// Names for "did you mean", and the sentence for the hint.
  [[nodiscard]] virtual std::vector<std::string> known_names() const = 0;
};

/// Errors  InputError at the piece of text: unknown name, division by zero, an exponent that is not
///         an integer, a function without a declared relation
/// Given   const Entry file = parse_document("system = {kind = 'vector-field', "
///             "coordinates = ['x'], field = {x = '1'}}", "f.toml");
/// Given   const SystemScope scope(file, {});
/// Example evaluate(parse_expression("(x^2 - 1)/(x - 1)", "f"), scope)  // -> x + 1
/// Example evaluate(parse_expression("sin(x)", "f"), scope)  // -> throws InputError
[[nodiscard]] MFraction evaluate(const Expression& e, const Scope& scope);

/// left - right of an equation.
[[nodiscard]] MFraction evaluate_equation(const Expression& e, const Scope& scope);

} // namespace kov
