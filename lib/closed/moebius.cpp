#include "closed/moebius.hpp"

#include "exact/error.hpp"

namespace kov {
namespace {

Poly linear(const NfElem& a, const NfElem& b) { return scale(Poly::z(), a) + Poly(b); }

// sum f_i u^i v^(n-i)
Poly homogeneous(const Poly& f, const Poly& u, const Poly& v) {
  Poly sum(lead(f));
  Poly power(1); // of v
  for (long i = degree(f) - 1; i >= 0; --i) {
    power *= v;
    sum = sum * u;
    if (const NfElem c = f.coeff(i); !is_zero(c)) sum += scale(power, c);
  }
  return sum;
}

} // namespace

// With N/D in lowest terms, N(ax + b, cx + d) and D(ax + b, cx + d), made homogeneous, have no
// common zero, and cx + d divides neither.
RationalFunction pull_back(const RationalFunction& r, const Moebius& m) {
  const NfElem determinant = m.a * m.d - m.b * m.c;
  if (is_zero(determinant)) throw InvalidArgument("a Moebius map needs ad - bc != 0");
  if (is_zero(r)) return r;
  const Poly above = linear(m.a, m.b);
  const Poly below = linear(m.c, m.d);
  Poly num = scale(homogeneous(r.num(), above, below), determinant * determinant);
  Poly den = homogeneous(r.den(), above, below);
  const long power = degree(r.den()) - degree(r.num()) - 4;
  if (power >= 0)
    num *= pow(below, static_cast<unsigned long>(power));
  else
    den *= pow(below, static_cast<unsigned long>(-power));
  return RationalFunction::from_coprime(std::move(num), std::move(den));
}

std::string to_string(const Moebius& m, const std::string& variable) {
  return to_string(RationalFunction(linear(m.a, m.b), linear(m.c, m.d)), variable);
}

} // namespace kov
