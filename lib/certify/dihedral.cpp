// Rules "torsion-function" and "jacobian": the curve s^2 = F0 on which the two exponential
// solutions of an imprimitive equation separate (docs/theory/dihedral_torsion.md).  v = V s, V =
// A/B.

#include "certify/hyperelliptic.hpp"
#include "certify/rules.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// w^2 as an element of K.
NfElem square_of_w(const InvariantFact& v) {
  long size = 0;
  for (const auto& [c, k] : v.powers)
    size += std::abs(k);
  need(size <= 100000, "an exponent is too large");
  NfElem w2 = v.top / v.bottom;
  for (const auto& [c, k] : v.powers) {
    const NfElem u = pow(c, static_cast<unsigned long>(std::abs(k)));
    w2 = k > 0 ? w2 * u : w2 / u;
  }
  return w2;
}

// h = (a + b w s)/den with h' = n (w/(V s)) h, as two identities over K.
void need_logarithmic_derivative(const TorsionFunction& t, const InvariantFact& v) {
  const auto [A, B] = v.fraction();
  const Poly& F = v.branch;
  const Poly& c = t.den;
  const Poly dc = derivative(c);
  const NfElem n(t.n);
  const NfElem w2 = square_of_w(v);
  need((derivative(t.a) * c - t.a * dc) * A == scale(t.b * B * c, n * w2), "h' = n (w/v) h fails");
  need((scale((derivative(t.b) * c - t.b * dc) * F, NfElem(2)) + t.b * c * derivative(F)) * A ==
           scale(t.a * B * c, NfElem(2) * n),
       "h' = n (w/v) h fails");
}

// Two points at which h takes values whose quotient is not an l-th power: so h is not a constant
// times an l-th power of a function.
void need_not_a_power(const Judge& j, const NotAPower& t, const TorsionFunction& f,
                      const InvariantFact& v) {
  const Reduced r = j.reduced(t.prime);
  const mp_limb_t p = t.prime.p;
  const nmod_t mod = r.num.mod();
  need(t.l >= 2 && p % static_cast<mp_limb_t>(t.l) == 1 && f.n % t.l == 0,
       "l must divide n and p - 1");
  NmodPoly m(p);
  fmpz_poly_get_nmod_poly(m.raw(), j.field->minpoly());
  need(evaluate(derivative(m), t.prime.generator) != 0, "the prime ramifies");
  v.need_root(t.w, t.prime);
  const NmodPoly F = reduce(v.branch, t.prime);
  need(!is_square(F), "F0 is a square modulo p");
  const NmodPoly a = reduce(f.a, t.prime);
  const NmodPoly b = reduce(f.b, t.prime);
  const NmodPoly c = reduce(f.den, t.prime);
  const auto value = [&](mp_limb_t x, mp_limb_t s) {
    need(x < p && s < p && s != 0 && nmod_mul(s, s, mod) == evaluate(F, x) && evaluate(c, x) != 0,
         "not a point where h is defined");
    const mp_limb_t ws = nmod_mul(t.w, s, mod);
    const mp_limb_t top = nmod_add(evaluate(a, x), nmod_mul(evaluate(b, x), ws, mod), mod);
    need(top != 0, "not a point where h is defined");
    return nmod_div(top, evaluate(c, x), mod);
  };
  const mp_limb_t ratio = nmod_div(value(t.x1, t.s1), value(t.x2, t.s2), mod);
  need(nmod_pow_ui(ratio, (p - 1) / static_cast<mp_limb_t>(t.l), mod) != 1, "h(1)/h(2) is a power");
}

// Every prime power l^k that exactly divides n divides L, or has a witness.
void need_minimal(const TorsionFunction& t, const Integer& L) {
  long left = t.n;
  for (long l = 2; left > 1; ++l) {
    if (left % l != 0) continue;
    Integer power(1);
    for (; left % l == 0; left /= l)
      power *= Integer(l);
    const bool seen = std::any_of(t.minimal.begin(), t.minimal.end(),
                                  [&](const NotAPower& w) { return w.l == l; });
    need(seen || gcd(power, L) == power, "it is not shown that h is not a power");
  }
}

// The zeros of v off the branch places, with the residues L Delta of L eta there.
struct Zeros {
  Poly q;
  Rational delta;
};

std::vector<Zeros> zeros_of(const InvariantFact& v, const LocalFact& local) {
  std::vector<Zeros> zeros;
  if (degree(v.data.p) > 0) zeros.push_back({v.data.p, 1});
  for (const InvariantFactor& f : v.data.factors) {
    if (!is_integer(f.e) || sign(f.e) <= 0) continue;
    const auto x = std::find_if(local.places.begin(), local.places.end(),
                                [&](const PlaceFact& y) { return *y.q == f.q; });
    need(x != local.places.end() && f.e == Rational(1),
         "a zero of v is not a place of r, or not simple");
    if (!is_zero(*x->delta)) zeros.push_back({f.q, *x->delta});
  }
  return zeros;
}

mp_limb_t reduce_rational(const Rational& q, const PrimeIdeal& p) {
  const auto r = p.reduce(q);
  need(r && *r != 0, "an exponent difference is not a unit modulo p");
  return *r;
}

// The divisor of the zeros at q, at the sheet where the residue of eta is +Delta: s = w B/(A'
// Delta).
Divisor divisor_at(const Zeros& z, const NmodPoly& A, const NmodPoly& B, mp_limb_t w,
                   const PrimeIdeal& prime, const NmodPoly& F) {
  NmodPoly u(prime.p);
  nmod_poly_make_monic(u.raw(), reduce(z.q, prime).raw());
  const nmod_t mod = u.mod();
  const mp_limb_t factor = nmod_div(w, reduce_rational(z.delta, prime), mod);
  const NmodPoly s = remainder(scale(B * inverse_mod(derivative(A), u), factor), u);
  need(is_zero(remainder(s * s - F, u)), "a zero of v is not on the curve");
  return {u, s};
}

} // namespace

TorsionFact check_torsion_function(const Judge& j, const TorsionFunction& data,
                                   const InvariantFact& v, const LocalFact* local) {
  need(data.n >= 1 && data.n <= 1000000 && !is_zero(data.den) &&
           !(is_zero(data.a) && is_zero(data.b)),
       "not a torsion function");
  need_logarithmic_derivative(data, v);
  need_minimal(data, local ? local->residue_denominator(v) : Integer(1));
  for (const NotAPower& t : data.minimal)
    need_not_a_power(j, t, data, v);
  return {data.n, &v};
}

JacobianFact check_jacobian(const Judge& j, const Jacobian& data, const LocalFact& local,
                            const InvariantFact& v) {
  const Reduced r = j.reduced(data.prime);
  const mp_limb_t p = data.prime.p;
  const nmod_t mod = r.num.mod();
  need(sign(data.multiple) > 0 && data.multiple < pow(Integer(10), 30) && degree(v.branch) >= 3,
       "not a multiple, or not a curve of positive genus");
  const NmodPoly F = reduce(v.branch, data.prime);
  need(degree(gcd(F, derivative(F))) == 0, "F0 is not squarefree modulo p");
  v.need_root(data.w, data.prime);
  const Integer L = local.residue_denominator(v);
  const auto fraction = v.fraction();
  const NmodPoly A = reduce(fraction.first, data.prime);
  const NmodPoly B = reduce(fraction.second, data.prime);
  need(degree(v.data.p) == 0 || degree(gcd(reduce(v.data.p, data.prime), r.den)) == 0,
       "zeros of v meet the poles of r");
  std::vector<std::pair<Divisor, Integer>> points;
  for (const Zeros& z : zeros_of(v, local))
    points.emplace_back(divisor_at(z, A, B, data.w, data.prime, F), (Rational(L) * z.delta).num());
  HyperellipticCurve curve(F);
  if (degree(F) % 2 == 0) {
    need(data.branch && *data.branch < p && evaluate(F, *data.branch) == 0,
         "an even curve needs a branch point modulo p");
    curve = HyperellipticCurve(send_to_infinity(F, *data.branch));
    for (auto& [d, k] : points)
      d = send_to_infinity(d, *data.branch, curve.genus());
    if (v.growth() == Rational(1) && !is_zero(*local.infinity.delta)) {
      const mp_limb_t lead = nmod_div(A.coeff(degree(A)), B.coeff(degree(B)), mod);
      const mp_limb_t t = nmod_div(nmod_div(data.w, lead, mod),
                                   reduce_rational(*local.infinity.delta, data.prime), mod);
      need(t == 1 || t == p - 1, "the residue at infinity is wrong");
      Divisor d{NmodPoly(p), NmodPoly(p)};
      d.u.set_coeff(1, 1);
      d.s.set_coeff(0, p - t);
      points.emplace_back(d, (Rational(L) * *local.infinity.delta).num());
    }
  }
  Divisor total = curve.zero();
  for (const auto& [d, k] : points)
    total = curve.add(total, curve.multiple(curve.reduce(d), k));
  need(curve.is_zero(curve.multiple(total, Integer(2) * data.multiple)),
       "the multiple is not principal");
  return {p, data.multiple, &v};
}

} // namespace kov::certify
