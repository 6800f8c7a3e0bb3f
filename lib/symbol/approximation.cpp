#include "symbol/approximation.hpp"

#include "exact/error.hpp"

namespace kov {
namespace {

using Kind = Expression::Kind;

Rational decimal(const Expression& e) {
  const std::string& s = e.name();
  const std::size_t exponent_at = s.find_first_of("eE");
  std::string digits = s.substr(0, exponent_at);
  long scale = 0;
  if (exponent_at != std::string::npos) {
    const std::string exponent = s.substr(exponent_at + 1);
    if (exponent.size() > 5) throw e.error("the exponent of this approximation is too large");
    scale = std::stol(exponent);
  }
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    scale -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  const Integer power = pow(Integer(10), static_cast<unsigned long>(std::abs(scale)));
  const Integer n = Integer::parse(digits);
  return scale < 0 ? Rational(n, power) : Rational(n * power);
}

std::string decimal_text(const arb_t x, long digits) {
  char* s = arb_get_str(x, digits, ARB_STR_NO_RADIUS);
  std::string text(s);
  flint_free(s);
  if (text.front() == '[') return "0"; // an enclosure of zero
  return text;
}

std::string decimal_text(const ComplexBall& z, long digits) {
  const bool real = arb_is_zero(acb_imagref(z.raw())) != 0;
  const bool imaginary = arb_contains_zero(acb_realref(z.raw())) != 0;
  const std::string re = decimal_text(acb_realref(z.raw()), digits);
  if (real) return re;
  std::string im = decimal_text(acb_imagref(z.raw()), digits) + "*I";
  if (imaginary) return im;
  const bool minus = im.front() == '-';
  return re + (minus ? " - " : " + ") + (minus ? im.substr(1) : im);
}

} // namespace

Point read_approximation(const Expression& e) {
  switch (e.kind()) {
  case Kind::number:
    return {Rational(e.number()), 0};
  case Kind::decimal:
    return {decimal(e), 0};
  case Kind::name:
    if (e.name() == "I") return {0, 1};
    break;
  case Kind::negate: {
    const Point a = read_approximation(e.operand(0));
    return {-a.re, -a.im};
  }
  case Kind::sum: {
    Point sum{0, 0};
    for (const Expression& term : e.operands()) {
      const Point a = read_approximation(term);
      sum = {sum.re + a.re, sum.im + a.im};
    }
    return sum;
  }
  case Kind::product: {
    Point product{1, 0};
    for (const Expression& factor : e.operands()) {
      const Point a = read_approximation(factor);
      product = {product.re * a.re - product.im * a.im, product.re * a.im + product.im * a.re};
    }
    return product;
  }
  case Kind::quotient: {
    const Point a = read_approximation(e.operand(0));
    const Point b = read_approximation(e.operand(1));
    const Rational norm = b.re * b.re + b.im * b.im;
    if (is_zero(norm)) throw e.error("division by zero");
    return {(a.re * b.re + a.im * b.im) / norm, (a.im * b.re - a.re * b.im) / norm};
  }
  default:
    break;
  }
  throw e.error("this is not an approximation of a number", "write e.g. 1.26 or 0.5 - 0.87*I");
}

// Distances are compared as balls.
std::optional<QQbar> nearest_root(const std::vector<QQbar>& all, const Point& p) {
  for (long bits = 64; bits <= 4096; bits *= 2) {
    ComplexBall at;
    arb_set_fmpq(acb_realref(at.raw()), p.re.raw(), bits);
    arb_set_fmpq(acb_imagref(at.raw()), p.im.raw(), bits);
    std::vector<Ball> far(all.size());
    std::size_t best = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      ComplexBall d;
      acb_sub(d.raw(), enclosure(all[i], bits).raw(), at.raw(), bits);
      acb_abs(far[i].raw(), d.raw(), bits);
      if (arf_cmp(arb_midref(far[i].raw()), arb_midref(far[best].raw())) < 0) best = i;
    }
    bool sure = true;
    for (std::size_t i = 0; i < all.size(); ++i)
      sure = sure && (i == best || all[i] == all[best] || arb_lt(far[best].raw(), far[i].raw()));
    if (sure) return all[best];
  }
  return std::nullopt;
}

std::string approximate_text(const QQbar& a) {
  const std::vector<QQbar> all = roots(minimal_polynomial(a));
  for (long digits = 9; digits < 2000; digits *= 2) {
    std::string text = decimal_text(enclosure(a, 64 + 4 * digits), digits);
    const Expression e = parse_expression("root(x, " + text + ")", "approximation");
    const auto root = nearest_root(all, read_approximation(e.operand(1)));
    if (root && *root == a) return text;
  }
  throw InternalError("an algebraic number could not be approximated");
}

} // namespace kov
