#include "flow/number/quantity.hpp"

#include "exact/algebraic.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace kov::flow {
namespace {

using Kind = Expression::Kind;

bool is_root(const Expression& e) { return e.kind() == Kind::call; }

// ---- by enclosures ----

Enclosure enclosure_of(const Expression& e);

Enclosure integer(const Integer& n) {
  Enclosure x;
  arb_set_round_fmpz(x.raw(), n.raw(), Enclosure::bits());
  return x;
}

// Requires that e is an exponent that check() has seen.
long exponent_of(const Expression& e) {
  const EnclosureScope scope(128);
  return std::lround(static_cast<double>(enclosure_of(e)));
}

Enclosure power(const Expression& base, long n) {
  Enclosure x = enclosure_of(base);
  fmpz_t exponent;
  fmpz_init_set_si(exponent, n);
  arb_pow_fmpz(x.raw(), x.raw(), exponent, Enclosure::bits());
  fmpz_clear(exponent);
  return x;
}

// An enclosure of a formula that check() has accepted; its radius is whatever it is.
Enclosure enclosure_of(const Expression& e) {
  const auto part = [&](std::size_t i) { return enclosure_of(e.operand(i)); };
  switch (e.kind()) {
  case Kind::number:
    return integer(e.number());
  case Kind::sum:
  case Kind::product: {
    Enclosure all = part(0);
    for (std::size_t i = 1; i < e.operands().size(); ++i)
      e.kind() == Kind::sum ? all += part(i) : all *= part(i);
    return all;
  }
  case Kind::negate:
    return -part(0);
  case Kind::quotient:
    return part(0) / part(1);
  case Kind::power:
    return power(e.operand(0), exponent_of(e.operand(1)));
  case Kind::name:
    return pi_of(Enclosure());
  default: {
    Enclosure x = part(0); // of a number >= 0, although the enclosure may reach below
    arb_sqrtpos(x.raw(), x.raw(), Enclosure::bits());
    return x;
  }
  }
}

Enclosure enclosure_of(const Expression& e, long bits) {
  const EnclosureScope scope(bits);
  return enclosure_of(e);
}

// ---- exactly ----

// A polynomial in pi and 1/pi with algebraic coefficients, none of them 0; pi is transcendental, so
// that it is 0 only if it has no terms.
using Exact = std::map<long, QQbar>;
using Maybe = std::optional<Exact>; // unset: not of this kind, or too large

bool is_zero(const QQbar& a) { return a == QQbar(0); }

Exact monomial(const QQbar& c, long degree) { return is_zero(c) ? Exact{} : Exact{{degree, c}}; }

Exact sum(const Exact& a, const Exact& b) {
  Exact all = a;
  for (const auto& [degree, c] : b) {
    const QQbar now = all.contains(degree) ? all.at(degree) + c : c;
    all.erase(degree);
    if (!is_zero(now)) all.emplace(degree, now);
  }
  return all;
}

Exact product(const Exact& a, const Exact& b) {
  Exact all;
  for (const auto& [i, c] : a)
    for (const auto& [k, d] : b)
      all = sum(all, monomial(c * d, i + k));
  return all;
}

// -(c_1 + c_2 a + ...)/c_0 with the minimal polynomial c of a.
QQbar inverse(const QQbar& a) {
  const std::vector<Integer> c = minimal_polynomial(a);
  QQbar sum(0);
  for (std::size_t i = c.size(); i-- > 1;)
    sum = sum * a + QQbar(Rational(c[i]));
  return sum * QQbar(Rational(Integer(-1), c[0]));
}

Maybe inverse(const Maybe& a) {
  if (!a || a->size() != 1) return std::nullopt;
  return monomial(inverse(a->begin()->second), -a->begin()->first);
}

Maybe root(const Maybe& a) {
  if (!a || a->empty()) return a;
  const auto& [degree, c] = *a->begin();
  if (a->size() != 1 || degree % 2 != 0) return std::nullopt;
  return monomial(principal_root(c, 2), degree / 2);
}

Maybe exact_value(const Expression& e);

Maybe exact_power(const Expression& base, long n) {
  Maybe x = exact_value(base), all = monomial(QQbar(1), 0);
  if (n < 0) x = inverse(x);
  for (long left = std::abs(n); x && left > 0; left /= 2) {
    if (left % 2 == 1) all = product(*all, *x);
    if (left > 1) x = product(*x, *x);
  }
  return x ? all : std::nullopt;
}

Maybe exact_value(const Expression& e) {
  const auto part = [&](std::size_t i) { return exact_value(e.operand(i)); };
  switch (e.kind()) {
  case Kind::number:
    return monomial(QQbar(Rational(e.number())), 0);
  case Kind::name:
    return monomial(QQbar(1), 1);
  case Kind::power:
    return exact_power(e.operand(0), exponent_of(e.operand(1)));
  case Kind::call:
    return root(part(0));
  default:
    break;
  }
  Maybe all = part(0);
  if (all && e.kind() == Kind::negate) return product(*all, monomial(QQbar(-1), 0));
  for (std::size_t i = 1; all && i < e.operands().size(); ++i) {
    const Maybe next = e.kind() == Kind::quotient ? inverse(part(i)) : part(i);
    if (!next) return std::nullopt;
    all = e.kind() == Kind::sum ? sum(*all, *next) : product(*all, *next);
  }
  return all;
}

// A bound of the digits (in bits) that the exact value of e needs, and its different roots.
double height(const Expression& e, std::set<std::string>& roots) {
  double all = 0, most = 0;
  for (const Expression& part : e.operands()) {
    const double h = height(part, roots);
    all += h;
    most = std::max(most, h);
  }
  if (is_root(e)) roots.insert(std::string(e.text()));
  if (e.kind() == Kind::number) return 4.0 * static_cast<double>(e.text().size());
  if (e.kind() != Kind::power) return is_root(e) ? most : all + 1;
  return most * static_cast<double>(std::abs(exponent_of(e.operand(1))));
}

bool is_small(const Expression& e) {
  std::set<std::string> roots;
  const double bits = height(e, roots);
  return roots.empty() ? bits < 1e7 : bits < 2e5 && roots.size() <= 5;
}

int sign_in(const Enclosure& x) { return x.is_positive() ? 1 : x.is_negative() ? -1 : 0; }

// The sign of a formula whose parts have been checked.
int sign_of(const Expression& e) {
  const Enclosure first = enclosure_of(e, 256);
  if (sign_in(first) != 0 || arb_is_zero(first.raw()) != 0) return sign_in(first);
  if (is_small(e)) {
    const Maybe value = exact_value(e);
    if (value && value->empty()) return 0;
  }
  for (long bits = 1024; bits <= 1L << 16; bits *= 8)
    if (const int sign = sign_in(enclosure_of(e, bits)); sign != 0) return sign;
  throw e.error("it is not decided whether this number is 0", "write it in lowest terms");
}

// ---- what a formula must be ----

constexpr const char* allowed = "a number is written with + - * / ^ sqrt() and pi";

void check_exponent(const Expression& e, int base_sign) {
  const EnclosureScope scope(128);
  const Enclosure n = enclosure_of(e);
  if (arb_is_int(n.raw()) == 0 || !(std::abs(static_cast<double>(n)) <= 9999))
    throw e.error("an exponent must be an integer up to 9999");
  if (n.is_negative() && base_sign == 0) throw e.error("division by zero");
}

void check(const Expression& e) {
  switch (e.kind()) {
  case Kind::number:
  case Kind::sum:
  case Kind::product:
  case Kind::negate:
  case Kind::quotient:
  case Kind::power:
    break;
  case Kind::name:
    if (e.name() == "pi" || e.name() == "Pi") return;
    throw e.error("unknown name '" + e.name() + "'", allowed);
  case Kind::call:
    if (e.name() == "sqrt" && e.operands().size() == 1) break;
    throw e.error("unknown function '" + e.name() + "'", "the only function here is sqrt(x)");
  default:
    throw e.error("not a number", allowed);
  }
  for (const Expression& part : e.operands())
    check(part);
  if (e.kind() == Kind::quotient && sign_of(e.operand(1)) == 0)
    throw e.operand(1).error("division by zero");
  if (e.kind() == Kind::power) check_exponent(e.operand(1), sign_of(e.operand(0)));
  if (is_root(e) && sign_of(e.operand(0)) < 0) throw e.error("the root of a negative number");
}

} // namespace

Quantity::Quantity(const char* formula)
    : Quantity(parse_expression(std::string(formula), "number")) {}

Quantity::Quantity(Expression e) : e_(std::move(e)) {
  check(e_);
  sign_ = sign_of(e_);
  if (sign_ != 0 && !(std::abs(log2_size()) < 1e6))
    throw e_.error("this number is beyond 10^300000 or 10^-300000");
}

Quantity Quantity::shifted(long k) const {
  Quantity q = *this;
  q.shift_ += k;
  return q;
}

Enclosure Quantity::enclosed(long bits) const {
  if (is_zero()) return Enclosure(0);
  Enclosure x;
  for (long p = bits + 32; arb_rel_accuracy_bits(x.raw()) < bits || p == bits + 32; p *= 2) {
    if (p > bits + (1L << 20)) throw e_.error("this number takes too many digits");
    x = enclosure_of(e_, p);
  }
  arb_mul_2exp_si(x.raw(), x.raw(), shift_);
  return x;
}

double Quantity::log2_size() const {
  if (is_zero()) return -INFINITY;
  const PrecisionScope scope(53);
  return log2_estimate(as<BigReal>());
}

template <> BigReal Quantity::as<BigReal>() const {
  BigReal r;
  arf_get_mpfr(r.raw(), arb_midref(enclosed(BigReal::bits() + 16).raw()), MPFR_RNDN);
  return r;
}
template <> double Quantity::as<double>() const { return static_cast<double>(enclosed(128)); }
template <> long double Quantity::as<long double>() const {
  const PrecisionScope scope(128);
  return mpfr_get_ld(as<BigReal>().raw(), MPFR_RNDN);
}
template <> Twin1 Quantity::as<Twin1>() const {
  const PrecisionScope scope(160);
  return to_twin(as<BigReal>());
}
template <> Enclosure Quantity::as<Enclosure>() const { return enclosed(Enclosure::bits()); }

namespace {
Quantity combined(const Quantity& a, const char* sign, const Quantity& b) {
  return Quantity(parse_expression("(" + a.text() + ")" + sign + "(" + b.text() + ")", "number"));
}
} // namespace

Quantity operator+(const Quantity& a, const Quantity& b) { return combined(a, "+", b); }
Quantity operator-(const Quantity& a, const Quantity& b) { return combined(a, "-", b); }
Quantity operator*(const Quantity& a, const Quantity& b) { return combined(a, "*", b); }

} // namespace kov::flow
