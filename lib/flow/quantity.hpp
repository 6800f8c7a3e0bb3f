#pragma once
// A number as a scene writes it: "8/9", "sqrt(11)/24", "3*pi/2", "10^-14".  It keeps the formula, so that every
// number type gets it with its own precision, and exact rationals exactly.

#include "flow/big_real.hpp"
#include "flow/twin.hpp"
#include "symbol/expression.hpp"

#include <cmath>
#include <string>

namespace kov::flow {

// How a number type makes an integer, a root and pi.
template <class R> struct QuantityTraits {
  static R integer(const std::string& digits) { return static_cast<R>(std::stold(digits)); }
  static R root(const R& x, const Expression&) { return std::sqrt(x); }
  static R pi(const Expression&) { return pi_of(R(0)); }
};
template <> struct QuantityTraits<BigReal> {
  static BigReal integer(const std::string& digits) {
    BigReal r;
    mpfr_set_str(r.raw(), digits.c_str(), 10, MPFR_RNDN);
    return r;
  }
  static BigReal root(const BigReal& x, const Expression&) { return sqrt(x); }
  static BigReal pi(const Expression&) { return pi_of(BigReal()); }
};
template <> struct QuantityTraits<Rational> {
  static Rational integer(const std::string& digits) { return Rational(Integer::parse(digits)); }
  static Rational root(const Rational& x, const Expression& at) {
    const auto r = exact_sqrt(x);
    if (!r) throw at.error("a root that is not rational");
    return *r;
  }
  static Rational pi(const Expression& at) { throw at.error("pi is not rational"); }
};

/// The value of a constant formula of + - * / ^ sqrt and pi.  Throws InputError.
template <class R> R evaluate(const Expression& e) {
  using Kind = Expression::Kind;
  const auto part = [&](std::size_t i) { return evaluate<R>(e.operand(i)); };
  switch (e.kind()) {
  case Kind::number:
    return QuantityTraits<R>::integer(to_string(e.number()));
  case Kind::sum: {
    R sum = part(0);
    for (std::size_t i = 1; i < e.operands().size(); ++i)
      sum = sum + part(i);
    return sum;
  }
  case Kind::product: {
    R product = part(0);
    for (std::size_t i = 1; i < e.operands().size(); ++i)
      product = product * part(i);
    return product;
  }
  case Kind::negate:
    return R(0) - part(0);
  case Kind::quotient: {
    const R d = part(1);
    if (d == R(0)) throw e.operand(1).error("division by zero");
    return part(0) / d;
  }
  case Kind::power: {
    const auto exponent = evaluate<double>(e.operand(1));
    const int n = std::abs(exponent) <= 9999 ? static_cast<int>(exponent) : 0;
    if (exponent != n) throw e.operand(1).error("an exponent must be an integer up to 9999");
    const R base = part(0);
    R value(1);
    for (int i = 0; i < std::abs(n); ++i)
      value = value * base;
    if (n >= 0) return value;
    if (value == R(0)) throw e.operand(0).error("division by zero");
    return R(1) / value;
  }
  case Kind::name:
    if (e.name() == "pi" || e.name() == "Pi") return QuantityTraits<R>::pi(e);
    throw e.error("unknown name '" + e.name() + "'", "a number is written with + - * / ^ sqrt() and pi");
  case Kind::call:
    if (e.name() == "sqrt" && e.operands().size() == 1) {
      const R x = part(0);
      if (x < R(0)) throw e.error("the root of a negative number");
      return QuantityTraits<R>::root(x, e);
    }
    throw e.error("unknown function '" + e.name() + "'", "the only function here is sqrt(x)");
  default:
    throw e.error("not a number", "a number is written with + - * / ^ sqrt() and pi");
  }
}

inline Twin1 to_twin(const BigReal& x) {
  const auto high = static_cast<double>(x);
  return {high, static_cast<double>(x - BigReal(high))};
}
template <> inline Twin1 evaluate<Twin1>(const Expression& e) {
  const PrecisionScope scope(160);
  return to_twin(evaluate<BigReal>(e));
}

/// A number with its text.
class Quantity {
public:
  Quantity() : Quantity("0") {}
  Quantity(const char* text) : Quantity(parse_expression(std::string(text), "number")) {}
  Quantity(Expression e) : e_(std::move(e)) { (void)evaluate<double>(e_); }
  template <class R> [[nodiscard]] R as() const { return evaluate<R>(e_); }
  [[nodiscard]] std::string text() const { return std::string(e_.text()); }
  [[nodiscard]] const Expression& expression() const { return e_; }

private:
  Expression e_;
};

} // namespace kov::flow
