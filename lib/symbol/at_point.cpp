#include "symbol/at_point.hpp"

#include "symbol/constants.hpp"
#include "symbol/known_functions.hpp"
#include "symbol/linear_reader.hpp"
#include "symbol/written.hpp"

#include <acb_hypgeom.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace kov {

PowerSeries PowerSeries::at(const ComplexBall& c, slong known) {
  PowerSeries x(c);
  x.known = known;
  if (known > 1) acb_poly_set_coeff_si(x.v_, 1, 1);
  return x;
}

ComplexBall PowerSeries::coefficient(slong i) const {
  if (i >= known) throw NoValueHere("a derivative of a high order");
  ComplexBall c;
  acb_poly_get_coeff_acb(c.raw(), v_, i);
  return c;
}

namespace {

using Kind = Expression::Kind;

PowerSeries constant(const Rational& q, slong bits) {
  ComplexBall c;
  arb_set_fmpq(acb_realref(c.raw()), q.raw(), bits);
  return PowerSeries(c);
}

// The coefficients of a product, a quotient, ... that are computed: those that are known.
slong length(const PowerSeries& a) { return std::min(a.known, slong{8}); }

PowerSeries with(const PowerSeries& a, const PowerSeries& b) {
  PowerSeries c;
  c.known = std::min(a.known, b.known);
  return c;
}

PowerSeries product(const PowerSeries& a, const PowerSeries& b, slong bits) {
  PowerSeries c = with(a, b);
  acb_poly_mullow(c.raw(), a.raw(), b.raw(), length(c), bits);
  return c;
}

PowerSeries quotient(const PowerSeries& a, const PowerSeries& b, slong bits) {
  PowerSeries c = with(a, b);
  acb_poly_div_series(c.raw(), a.raw(), b.raw(), length(c), bits);
  return c;
}

PowerSeries differentiated(PowerSeries a, long order, slong bits) {
  for (; order > 0; --order) {
    acb_poly_derivative(a.raw(), a.raw(), bits);
    if (a.known != PowerSeries::whole) --a.known;
  }
  return a;
}

// D_n(x), DLMF 12.7.
const char* const cylinder = "2^(n/2)*exp(-x^2/4)*sqrt(pi)*(hyp1f1(-n/2, 1/2, x^2/2)*rgamma((1 - "
                             "n)/2) - sqrt(2)*x*hyp1f1((1 - n)/2, 3/2, x^2/2)*rgamma(-n/2))";

ComplexBall cylinder_at(const ComplexBall& n, const ComplexBall& x, slong bits) {
  static const Expression formula = parse_expression(std::string(cylinder), "D");
  return AtPoint({{"n", PowerSeries(n)}, {"x", PowerSeries(x)}}, bits)(formula).coefficient(0);
}

std::optional<ComplexBall> value(const std::string& f, const std::vector<ComplexBall>& a,
                                 slong bits) {
  ComplexBall out;
  const auto r = out.raw();
  const auto x = [&](std::size_t i) { return a.at(i).raw(); };
  using One = void (*)(acb_t, const acb_t, slong);
  static const std::map<std::string, One> of_one{
      {"exp", acb_exp},          {"log", acb_log},       {"sin", acb_sin},
      {"cos", acb_cos},          {"sinh", acb_sinh},     {"cosh", acb_cosh},
      {"atan", acb_atan},        {"asin", acb_asin},     {"acos", acb_acos},
      {"asinh", acb_asinh},      {"acosh", acb_acosh},   {"atanh", acb_atanh},
      {"erf", acb_hypgeom_erf},  {"Ei", acb_hypgeom_ei}, {"rgamma", acb_rgamma},
      {"erfi", acb_hypgeom_erfi}};
  if (const auto it = of_one.find(f); it != of_one.end()) return it->second(r, x(0), bits), out;
  if (f == "airyai") return acb_hypgeom_airy(r, nullptr, nullptr, nullptr, x(0), bits), out;
  if (f == "airyaiprime") return acb_hypgeom_airy(nullptr, r, nullptr, nullptr, x(0), bits), out;
  if (f == "airybi") return acb_hypgeom_airy(nullptr, nullptr, r, nullptr, x(0), bits), out;
  if (f == "airybiprime") return acb_hypgeom_airy(nullptr, nullptr, nullptr, r, x(0), bits), out;
  if (f == "besselj") return acb_hypgeom_bessel_j(r, x(0), x(1), bits), out;
  if (f == "bessely") return acb_hypgeom_bessel_y(r, x(0), x(1), bits), out;
  if (f == "besseli") return acb_hypgeom_bessel_i(r, x(0), x(1), bits), out;
  if (f == "besselk") return acb_hypgeom_bessel_k(r, x(0), x(1), bits), out;
  if (f == "hyp1f1") return acb_hypgeom_m(r, x(0), x(1), x(2), 0, bits), out;
  if (f == "hyperu") return acb_hypgeom_u(r, x(0), x(1), x(2), bits), out;
  if (f == "hyp2f1") return acb_hypgeom_2f1(r, x(0), x(1), x(2), x(3), 0, bits), out;
  if (f == "legenp") return acb_hypgeom_legendre_p(r, x(0), x(1), x(2), 0, bits), out;
  if (f == "legenq") return acb_hypgeom_legendre_q(r, x(0), x(1), x(2), 0, bits), out;
  if (f == "pcfd") return cylinder_at(a[0], a[1], bits);
  return std::nullopt;
}

// The series of a function at the constant term of its last argument, from the one of its derivative.
PowerSeries taylor(const std::string& name, const KnownFunction* f,
                   const std::vector<ComplexBall>& a, slong known, slong bits) {
  const auto here = value(name, a, bits);
  if (!here) throw NoValueHere(name);
  PowerSeries sum(*here);
  if (known == PowerSeries::whole) return sum; // of a constant
  if (f == nullptr) throw NoValueHere(name);
  if (known > 1) {
    AtPoint::Values values;
    for (std::size_t i = 0; i + 1 < a.size(); ++i)
      values.emplace(f->arguments[i], PowerSeries(a[i]));
    values.emplace(f->arguments.back(), PowerSeries::at(a.back(), known - 1));
    const PowerSeries slope = AtPoint(std::move(values), bits)(*f->slope);
    acb_poly_integral(sum.raw(), slope.raw(), bits);
    acb_poly_set_coeff_acb(sum.raw(), 0, here->raw());
  }
  sum.known = known;
  return sum;
}

} // namespace

PowerSeries AtPoint::named(const std::string& name) const {
  if (const auto it = values_.find(name); it != values_.end()) return it->second;
  ComplexBall c;
  if (name == "I")
    acb_onei(c.raw());
  else if (name == "pi")
    acb_const_pi(c.raw(), bits_);
  else
    throw NoValueHere(name);
  return PowerSeries(c);
}

PowerSeries AtPoint::power(const Expression& e) const {
  const PowerSeries base = (*this)(e.operand(0));
  const auto q = as_rational(e.operand(1));
  if (q && is_integer(*q) && abs(*q) < Rational(100000)) {
    const long n = to_long(q->num());
    PowerSeries all = with(base, base);
    acb_poly_pow_ui_trunc_binexp(all.raw(), base.raw(), static_cast<ulong>(std::abs(n)),
                                 length(base), bits_);
    return n < 0 ? quotient(constant(1, bits_), all, bits_) : all;
  }
  const PowerSeries exponent = (*this)(e.operand(1));
  PowerSeries all = with(base, exponent);
  if (exponent.known == PowerSeries::whole) {
    const ComplexBall c = exponent.coefficient(0);
    acb_poly_pow_acb_series(all.raw(), base.raw(), c.raw(), length(all), bits_);
  } else {
    acb_poly_log_series(all.raw(), base.raw(), length(all), bits_);
    all = product(all, exponent, bits_);
    acb_poly_exp_series(all.raw(), all.raw(), length(all), bits_);
  }
  return all;
}

// root(p, approx): Newton's method.
PowerSeries AtPoint::root(const Expression& e) const {
  const auto letters = names_in(parse_expression(written(e.operand(0)), "a polynomial"));
  if (letters.size() != 1) throw NoValueHere("root");
  ComplexBall x = (*this)(e.operand(1)).coefficient(0);
  for (int i = 0; i < 40; ++i) {
    acb_get_mid(x.raw(), x.raw());
    const PowerSeries p = AtPoint({{letters.front(), PowerSeries::at(x, 2)}}, bits_)(e.operand(0));
    ComplexBall step;
    acb_div(step.raw(), p.coefficient(0).raw(), p.coefficient(1).raw(), bits_);
    acb_sub(x.raw(), x.raw(), step.raw(), bits_);
  }
  acb_get_mid(x.raw(), x.raw());
  return PowerSeries(x);
}

PowerSeries AtPoint::called(const Expression& e) const {
  const std::string& f = e.name();
  const auto& a = e.operands();
  const KnownFunction* known = known_function(f, a.size());
  if (const auto it = values_.find(f); it != values_.end() && a.size() == 1 && known == nullptr)
    return it->second; // y(x)
  if (is_diff(e) && (a.size() == 2 || a.size() == 3)) {
    const auto n = a.size() == 3 ? as_rational(a[2]) : Rational(1);
    if (!n || !is_integer(*n) || *n > Rational(highest_derivative)) throw NoValueHere(f);
    return differentiated((*this)(a[0]), to_long(n->num()), bits_);
  }
  if (f == "root" && a.size() == 2) return root(e);
  if (f == "int" && a.size() == 2) {
    PowerSeries inside = (*this)(a[0]);
    acb_poly_integral(inside.raw(), inside.raw(), bits_);
    if (inside.known != PowerSeries::whole) ++inside.known;
    acb_poly_set_coeff_si(inside.raw(), 0,
                          3 + static_cast<slong>(std::hash<std::string>()(written(a[0])) % 97));
    return inside;
  }
  if (known != nullptr && known->means)
    return AtPoint({{known->arguments.front(), (*this)(a[0])}}, bits_)(*known->means);
  std::vector<ComplexBall> at;
  PowerSeries last;
  for (const Expression& x : a) {
    if (!at.empty() && last.known != PowerSeries::whole) throw NoValueHere(f); // by an index
    last = (*this)(x);
    at.push_back(last.coefficient(0));
  }
  if (at.empty()) throw NoValueHere(f);
  const PowerSeries outer = taylor(f, known, at, last.known, bits_);
  if (last.known == PowerSeries::whole) return outer;
  acb_poly_set_coeff_si(last.raw(), 0, 0);
  PowerSeries all = with(last, last);
  acb_poly_compose_series(all.raw(), outer.raw(), last.raw(), length(last), bits_);
  return all;
}

PowerSeries AtPoint::operator()(const Expression& e) const {
  switch (e.kind()) {
  case Kind::number:
    return constant(Rational(e.number()), bits_);
  case Kind::decimal: {
    ComplexBall c;
    arb_set_str(acb_realref(c.raw()), e.name().c_str(), bits_);
    return PowerSeries(c);
  }
  case Kind::name:
    return named(e.name());
  case Kind::sum:
  case Kind::equation: {
    PowerSeries sum = (*this)(e.operand(0));
    for (std::size_t i = 1; i < e.operands().size(); ++i) {
      const PowerSeries x = (*this)(e.operand(i));
      (e.kind() == Kind::sum ? acb_poly_add : acb_poly_sub)(sum.raw(), sum.raw(), x.raw(), bits_);
      sum.known = std::min(sum.known, x.known);
    }
    return sum;
  }
  case Kind::negate: {
    PowerSeries x = (*this)(e.operand(0));
    acb_poly_neg(x.raw(), x.raw());
    return x;
  }
  case Kind::product: {
    PowerSeries all = (*this)(e.operand(0));
    for (std::size_t i = 1; i < e.operands().size(); ++i)
      all = product(all, (*this)(e.operand(i)), bits_);
    return all;
  }
  case Kind::quotient:
    return quotient((*this)(e.operand(0)), (*this)(e.operand(1)), bits_);
  case Kind::power:
    return power(e);
  case Kind::derivative:
    return differentiated((*this)(e.operand(0)), e.order(), bits_);
  case Kind::call:
    return called(e);
  }
  throw NoValueHere("");
}

std::optional<bool> AtPoint::holds(const Expression& equation) const {
  ComplexBall sum;
  Ball size, largest;
  for (const SignedTerm& t : terms_of(equation)) {
    const ComplexBall c = (*this)(t.term).coefficient(0);
    if (acb_is_finite(c.raw()) == 0) return std::nullopt;
    (t.minus ? acb_sub : acb_add)(sum.raw(), sum.raw(), c.raw(), bits_);
    acb_abs(size.raw(), c.raw(), bits_);
    arb_max(largest.raw(), largest.raw(), size.raw(), bits_);
  }
  acb_abs(size.raw(), sum.raw(), bits_);
  Ball scaled;
  arb_set_si(scaled.raw(), 10);
  arb_pow_ui(scaled.raw(), scaled.raw(), 25, bits_);
  arb_mul(scaled.raw(), scaled.raw(), size.raw(), bits_);
  if (arb_le(scaled.raw(), largest.raw()) != 0) return true;
  if (arb_gt(scaled.raw(), largest.raw()) != 0) return false;
  return std::nullopt;
}

AtPoint::Values some_values(const std::vector<std::string>& names, const std::string& variable,
                            long number, bool complex) {
  AtPoint::Values values;
  for (const std::string& name : names) {
    const auto i = static_cast<long>(values.size());
    ComplexBall c; // dyadic numbers: n - n is 0
    arf_set_si_2exp_si(arb_midref(acb_realref(c.raw())),
                       2 * (266 + (i * 117 + number * 203) % 487) + 1, -10);
    const bool is_variable = name == variable;
    if (complex || is_variable)
      arf_set_si_2exp_si(arb_midref(acb_imagref(c.raw())),
                         2 * (27 + (i * 59 + number * 31) % 101) + 1, -10);
    values.emplace(name, is_variable ? PowerSeries::at(c) : PowerSeries(c));
  }
  return values;
}

} // namespace kov
