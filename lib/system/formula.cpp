#include "system/formula.hpp"

#include "exact/error.hpp"
#include "symbol/suggest.hpp"

namespace kov {
namespace {

constexpr long max_exponent = 1000;

MFraction evaluate_name(const Expression& e, const Scope& scope) {
  if (auto v = scope.value(e.name())) return *std::move(v);
  const auto names = scope.known_names();
  const auto guess = nearest(e.name(), names);
  std::string hint = guess ? "did you mean '" + *guess + "'?" : "known names: " + enumerate(names);
  if (e.name() == "I" || e.name() == "i")
    hint = "declare it: constants = [\"I\"] and relations = [\"I^2 = -1\"] in [system]";
  throw e.error("unknown name '" + e.name() + "'", hint);
}

MFraction evaluate_power(const Expression& e, const Scope& scope) {
  const MFraction base = evaluate(e.operand(0), scope);
  const MFraction exponent = evaluate(e.operand(1), scope);
  if (!is_constant(exponent) || !is_integer(to_rational(exponent)))
    throw e.operand(1).error("an exponent must be an integer here",
                             "for a root, declare a function symbol with its relation: "
                             "[[system.function]] name = \"s\", means = \"sqrt(...)\"");
  const Rational k = to_rational(exponent);
  if (abs(k) > Rational(max_exponent))
    throw e.operand(1).error("the exponent is larger than " + std::to_string(max_exponent));
  const long n = to_long(floor(k));
  if (n < 0 && is_zero(base)) throw e.operand(0).error("division by zero: this is 0");
  return pow(base, n);
}

MFraction evaluate_call(const Expression& e, const Scope& scope) {
  if (e.operands().size() == 1) {
    const MFraction argument = evaluate(e.operand(0), scope);
    for (const auto& f : scope.functions())
      if (f.name == e.name() && f.argument == argument)
        return f.value ? *f.value : MFraction::variable(scope.ring(), f.variable);
  }
  throw e.error("the relation of " + std::string(e.text()) + " is missing",
                "declare a symbol: [[system.function]] name = \"s\", means = \"" +
                    std::string(e.text()) +
                    "\", derivative = {...}, and its relation in system.relations");
}

} // namespace

MFraction evaluate(const Expression& e, const Scope& scope) {
  using Kind = Expression::Kind;
  switch (e.kind()) {
  case Kind::number:
    return {scope.ring(), Rational(e.number())};
  case Kind::name:
    return evaluate_name(e, scope);
  case Kind::sum: {
    MFraction sum(scope.ring());
    for (const auto& x : e.operands())
      sum += evaluate(x, scope);
    return sum;
  }
  case Kind::negate:
    return -evaluate(e.operand(0), scope);
  case Kind::product: {
    MFraction product(scope.ring(), Rational(1));
    for (const auto& x : e.operands())
      product *= evaluate(x, scope);
    return product;
  }
  case Kind::quotient: {
    const MFraction denominator = evaluate(e.operand(1), scope);
    if (is_zero(denominator)) throw e.operand(1).error("division by zero: this is 0");
    return evaluate(e.operand(0), scope) / denominator;
  }
  case Kind::power:
    return evaluate_power(e, scope);
  case Kind::call:
    return evaluate_call(e, scope);
  case Kind::decimal:
    throw e.error("a decimal number has no place here", "write a fraction");
  case Kind::derivative:
    throw e.error("derivatives have no place here");
  case Kind::equation:
    throw e.error("an equation has no place here");
  }
  throw InternalError("an expression of unknown kind");
}

MFraction evaluate_equation(const Expression& e, const Scope& scope) {
  if (e.kind() != Expression::Kind::equation)
    throw e.error("an equation was expected", "write 'left = right'");
  return evaluate(e.operand(0), scope) - evaluate(e.operand(1), scope);
}

} // namespace kov
