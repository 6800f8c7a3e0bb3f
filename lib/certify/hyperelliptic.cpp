#include "certify/hyperelliptic.hpp"

#include "certify/modular_equation.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

NmodPoly monic(const NmodPoly& f) {
  NmodPoly g(f.modulus());
  nmod_poly_make_monic(g.raw(), f.raw());
  return g;
}

NmodPoly one(mp_limb_t p) {
  NmodPoly f(p);
  f.set_coeff(0, 1);
  return f;
}

struct Bezout {
  NmodPoly d, x, y; // d = x a + y b, monic
};

Bezout xgcd(const NmodPoly& a, const NmodPoly& b) {
  Bezout r{NmodPoly(a.modulus()), NmodPoly(a.modulus()), NmodPoly(a.modulus())};
  nmod_poly_xgcd(r.d.raw(), r.x.raw(), r.y.raw(), a.raw(), b.raw());
  return r;
}

NmodPoly reversed(const NmodPoly& f, mp_limb_t c, long n) {
  NmodPoly g(f.modulus());
  nmod_poly_reverse(g.raw(), taylor_shift(f, c).raw(), n + 1);
  return g;
}

} // namespace

Divisor HyperellipticCurve::zero() const { return {one(f_.modulus()), NmodPoly(f_.modulus())}; }

Divisor HyperellipticCurve::reduce(Divisor d) const {
  while (degree(d.u) > genus()) {
    d.u = monic(exact_div(f_ - d.s * d.s, d.u));
    d.s = remainder(NmodPoly(f_.modulus()) - d.s, d.u);
  }
  return d;
}

Divisor HyperellipticCurve::add(const Divisor& a, const Divisor& b) const {
  const Bezout first = xgcd(a.u, b.u);
  const Bezout second = xgcd(first.d, a.s + b.s);
  const NmodPoly u = exact_div(a.u * b.u, second.d * second.d);
  const NmodPoly top =
      second.x * (first.x * a.u * b.s + first.y * b.u * a.s) + second.y * (a.s * b.s + f_);
  return reduce({monic(u), remainder(exact_div(top, second.d), u)});
}

Divisor HyperellipticCurve::multiple(Divisor d, const Integer& k) const {
  Divisor r = zero();
  for (mp_bitcnt_t i = 0; i < fmpz_bits(k.raw()); ++i) {
    if (fmpz_tstbit(k.raw(), i) != 0) r = add(r, d);
    d = add(d, d);
  }
  return r;
}

NmodPoly send_to_infinity(const NmodPoly& f, mp_limb_t c) { return reversed(f, c, degree(f)); }

Divisor send_to_infinity(const Divisor& d, mp_limb_t c, long genus) {
  NmodPoly u = reversed(d.u, c, degree(d.u));
  need(degree(u) == degree(d.u), "a zero of v meets the branch point");
  u = monic(u);
  // Y = X^(g+1) s(c + 1/X) = X^(g+1-n) reversed(s), n >= deg s
  const long n = std::max(degree(d.s), 0L);
  NmodPoly X(d.u.modulus());
  X.set_coeff(1, 1);
  if (genus + 1 < n) X = inverse_mod(X, u);
  NmodPoly power(X.modulus());
  nmod_poly_powmod_ui_binexp(power.raw(), remainder(X, u).raw(),
                             static_cast<mp_limb_t>(std::abs(genus + 1 - n)), u.raw());
  return {u, remainder(reversed(d.s, c, n) * power, u)};
}

} // namespace kov::certify
