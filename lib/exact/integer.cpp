#include "exact/integer.hpp"

#include "exact/error.hpp"

namespace kov {

Integer Integer::parse(std::string_view text) {
  const std::string_view digits = text.starts_with('-') ? text.substr(1) : text;
  // GMP would read over white space and stop at a zero byte
  const bool plain = !digits.empty() && digits.find_first_not_of("0123456789") == digits.npos;
  Integer n;
  if (!plain || fmpz_set_str(n.v_, std::string(text).c_str(), 10) != 0)
    throw InvalidArgument("not an integer: '" + std::string(text) + "'");
  return n;
}

long to_long(const Integer& n) {
  KOV_ENSURE(fits_long(n));
  return fmpz_get_si(n.raw());
}

std::string to_string(const Integer& n) {
  char* text = fmpz_get_str(nullptr, 10, n.raw());
  std::string s(text);
  flint_free(text);
  return s;
}

Integer gcd(const Integer& a, const Integer& b) {
  Integer g;
  fmpz_gcd(g.raw(), a.raw(), b.raw());
  return g;
}

Integer lcm(const Integer& a, const Integer& b) {
  Integer l;
  fmpz_lcm(l.raw(), a.raw(), b.raw());
  return l;
}

Integer pow(const Integer& a, unsigned long e) {
  Integer p;
  fmpz_pow_ui(p.raw(), a.raw(), e);
  return p;
}

Integer exact_div(const Integer& a, const Integer& b) {
  Integer q;
  fmpz_divexact(q.raw(), a.raw(), b.raw());
  return q;
}

Integer floor_div(const Integer& a, const Integer& b) {
  Integer q;
  fmpz_fdiv_q(q.raw(), a.raw(), b.raw());
  return q;
}

std::optional<Integer> exact_sqrt(const Integer& n) {
  if (sign(n) < 0 || !fmpz_is_square(n.raw())) return std::nullopt;
  Integer s;
  fmpz_sqrt(s.raw(), n.raw());
  return s;
}

std::pair<Integer, Integer> square_part(Integer d) {
  Integer s(1);
  const auto take = [&](const Integer& p) { // d = p^e d', in one go however large e is
    Integer rest;
    const auto e = static_cast<ulong>(fmpz_remove(rest.raw(), d.raw(), p.raw()));
    if (e < 2) return;
    s *= pow(p, e / 2);
    d = e % 2 == 0 ? rest : rest * p;
  };
  for (ulong p = 2; p < 10000 && fmpz_cmpabs(d.raw(), Integer(p * p).raw()) >= 0;
       p = n_nextprime(p, 1))
    take(Integer(p));
  Integer size = d;
  fmpz_abs(size.raw(), size.raw());
  if (const auto root = exact_sqrt(size); root && *root != Integer(1)) take(*root);
  fmpz_abs(size.raw(), d.raw());
  if (fmpz_abs_fits_ui(d.raw())) {
    n_factor_t f;
    n_factor_init(&f);
    n_factor(&f, fmpz_get_ui(size.raw()), 1);
    for (int i = 0; i < f.num; ++i)
      take(Integer(f.p[i]));
  }
  return {s, d};
}

Rational::Rational(const Integer& n, const Integer& d) : Rational() {
  if (is_zero(d)) throw DomainError("division by zero: " + to_string(n) + "/0");
  fmpq_set_fmpz_frac(v_, n.raw(), d.raw());
}

Rational Rational::parse(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return Integer::parse(text);
  return {Integer::parse(text.substr(0, slash)), Integer::parse(text.substr(slash + 1))};
}

Rational& Rational::operator/=(const Rational& b) {
  if (is_zero(b)) throw DomainError("division by zero: " + to_string(*this) + "/0");
  fmpq_div(v_, v_, b.v_);
  return *this;
}

std::string to_string(const Rational& q) {
  char* text = fmpq_get_str(nullptr, 10, q.raw());
  std::string s(text);
  flint_free(text);
  return s;
}

Integer floor(const Rational& q) { return floor_div(q.num(), q.den()); }
Integer ceil(const Rational& q) { return -floor(-q); }
Rational abs(const Rational& q) { return sign(q) < 0 ? -q : q; }

std::optional<Rational> exact_sqrt(const Rational& q) {
  const auto n = exact_sqrt(q.num());
  const auto d = exact_sqrt(q.den());
  if (!n || !d) return std::nullopt;
  return Rational(*n, *d);
}

} // namespace kov
