#include "system/formula.hpp"

#include "exact/budget.hpp"
#include "symbol/suggest.hpp"
#include "system/written_functions.hpp"

#include <algorithm>
#include <cmath>

namespace kov {
namespace {

constexpr long max_exponent = 1000;
constexpr double max_terms = 1e5; // of a polynomial that is multiplied out
constexpr double max_bits = 1e7;  // of a number in it

// At most so many terms has f^n: those of a general sum of as many terms, and those with exponents
// up to n times the ones of f.
double terms_of_power(const MPoly& f, double n) {
  const auto t = static_cast<double>(f.length());
  if (t <= 1) return 1;
  const double general = std::lgamma(n + t) - std::lgamma(n + 1) - std::lgamma(t);
  double box = 0;
  for (const std::size_t i : used_variables(f))
    box += std::log(n * static_cast<double>(degree(f, i)) + 1);
  return std::exp(std::min(general, box));
}

void check_terms(double terms) {
  if (terms > max_terms)
    throw OutOfBudget("size limit: multiplied out, a formula would have more than " +
                      Budget::number(max_terms) + " terms");
}

void check_power(const MFraction& f, double n) {
  for (const MPoly& part : {f.num(), f.den()}) {
    check_terms(terms_of_power(part, n));
    const double bits = n * std::abs(static_cast<double>(fmpz_mpoly_max_bits(part.raw())));
    if (bits > max_bits)
      throw OutOfBudget("size limit: a power would have a number of more than " +
                        Budget::number(max_bits) + " binary digits");
  }
}

void check_product(const MPoly& a, const MPoly& b) {
  const double all = static_cast<double>(a.length()) * static_cast<double>(b.length());
  if (all <= max_terms) return;
  double box = 1;
  for (std::size_t i = 0; i < a.ring()->size(); ++i)
    box *= static_cast<double>(std::max(degree(a, i), 0L) + std::max(degree(b, i), 0L)) + 1;
  check_terms(std::min(all, box));
}

MFraction product(const MFraction& a, const MFraction& b) {
  check_product(a.num(), b.num());
  check_product(a.den(), b.den());
  return a * b;
}

MFraction sum(const MFraction& a, const MFraction& b) {
  check_product(a.num(), b.den());
  check_product(b.num(), a.den());
  check_product(a.den(), b.den());
  return a + b;
}

MFraction evaluate_name(const Expression& e, const Scope& scope) {
  if (auto v = scope.value(e.name())) return *std::move(v);
  const auto names = scope.known_names();
  const auto guess = nearest(e.name(), names);
  std::string hint = guess ? "did you mean '" + *guess + "'?" : "known names: " + enumerate(names);
  if (e.name() == "I" || e.name() == "i")
    hint = "declare it: constants = [\"I\"] and relations = [\"I^2 = -1\"] in [system]";
  throw e.error("unknown name '" + e.name() + "'", hint);
}

// base^(p/q) where a root of base has a symbol.
std::optional<MFraction> power_of_root(const MFraction& base, const MFraction& exponent,
                                       const Scope& scope) {
  if (is_zero(exponent) || !is_constant(exponent)) return std::nullopt;
  const Rational k = to_rational(exponent);
  if (is_integer(k)) return std::nullopt;
  for (const auto& f : scope.functions()) {
    const long order = order_of_root(f.name);
    if (order == 0 || !(f.argument == base)) continue;
    const Rational times = k * Rational(order);
    if (!is_integer(times) || abs(times) > Rational(max_exponent)) continue;
    if (sign(times) < 0) scope.divides_by(base);
    return pow(f.value ? *f.value : MFraction::variable(scope.ring(), f.variable),
               to_long(times.num()));
  }
  return std::nullopt;
}

MFraction evaluate_power(const Expression& e, const Scope& scope) {
  const MFraction base = evaluate(e.operand(0), scope);
  const MFraction exponent = evaluate(e.operand(1), scope);
  if (auto root = power_of_root(base, exponent, scope)) return *std::move(root);
  if (!is_constant(exponent) || !is_integer(to_rational(exponent)))
    throw e.operand(1).error("an exponent must be an integer here",
                             "for a root, declare a function symbol with its relation: "
                             "[[system.function]] name = \"s\", means = \"sqrt(...)\"");
  const Rational k = to_rational(exponent);
  if (abs(k) > Rational(max_exponent))
    throw OutOfBudget("size limit: the exponent of " + std::string(e.text()) + " is larger than " +
                      std::to_string(max_exponent));
  const long n = to_long(floor(k));
  if (n < 0 && is_zero(base)) throw NoValue(e.operand(0).error("division by zero: this is 0"));
  if (n < 0) scope.divides_by(base);
  if (n != 0 && !is_zero(base)) check_power(base, static_cast<double>(std::abs(n)));
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
    MFraction all(scope.ring());
    for (const auto& x : e.operands())
      all = sum(all, evaluate(x, scope));
    return all;
  }
  case Kind::negate:
    return -evaluate(e.operand(0), scope);
  case Kind::product: {
    MFraction all(scope.ring(), Rational(1));
    for (const auto& x : e.operands())
      all = product(all, evaluate(x, scope));
    return all;
  }
  case Kind::quotient: {
    const MFraction denominator = evaluate(e.operand(1), scope);
    if (is_zero(denominator)) throw NoValue(e.operand(1).error("division by zero: this is 0"));
    scope.divides_by(denominator);
    return product(evaluate(e.operand(0), scope), MFraction(denominator.den(), denominator.num()));
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
