// Rules "torsion-function" and "good-reduction": the curve s^2 = F0 on which the two exponential
// solutions of an imprimitive equation separate (docs/theory/dihedral_torsion.md).  v = V s, V =
// A/B.

#include "certify/equation/rules.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// h = (a + b w s)/den with h' = n (w/(V s)) h, as two identities over K.
void need_logarithmic_derivative(const TorsionFunction& t, const InvariantFact& v) {
  const auto [A, B] = v.fraction();
  const Poly& F = v.branch;
  const Poly& c = t.den;
  const Poly dc = derivative(c);
  const NfElem n(t.n);
  const NfElem& w2 = v.w_squared;
  need((derivative(t.a) * c - t.a * dc) * A == scale(t.b * B * c, n * w2), "h' = n (w/v) h fails");
  need((scale((derivative(t.b) * c - t.b * dc) * F, NfElem(2)) + t.b * c * derivative(F)) * A ==
           scale(t.a * B * c, NfElem(2) * n),
       "h' = n (w/v) h fails");
}

// Two points at which h takes values whose quotient is not an l-th power: so h is not a constant
// times an l-th power of a function.
void need_not_a_power(const Judge& j, const NotAPower& t, const TorsionFunction& f,
                      const InvariantFact& v) {
  const ReducedCurve curve = reduced_curve(j, v, t.prime);
  j.spend(20 * static_cast<double>(degree(f.a) + degree(f.b) + degree(f.den)));
  const mp_limb_t p = t.prime.p;
  const NmodPoly& F = curve.branch;
  const nmod_t mod = F.mod();
  need(t.l >= 2 && p % static_cast<mp_limb_t>(t.l) == 1 && f.n % t.l == 0,
       "l must divide n and p - 1");
  need(t.w < p && nmod_mul(t.w, t.w, mod) == curve.w_squared,
       "w is not a square root of w^2 modulo p");
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
    const bool seen = std::ranges::any_of(t.minimal, [&](const NotAPower& w) { return w.l == l; });
    need(seen || gcd(power, L) == power, "it is not shown that h is not a power");
  }
}

} // namespace

TorsionFact check_torsion_function(const Judge& j, const TorsionFunction& data,
                                   const InvariantFact& v, const LocalFact* local) {
  need(data.n >= 1 && data.n <= largest_torsion_order && !is_zero(data.den) &&
           !(is_zero(data.a) && is_zero(data.b)),
       "not a torsion function");
  need_logarithmic_derivative(data, v);
  need_minimal(data, local ? local->residue_denominator(v) : Integer(1));
  for (const NotAPower& t : data.minimal)
    need_not_a_power(j, t, data, v);
  return {data.n, &v};
}

ReductionFact check_good_reduction(const Judge& j, const GoodReduction& data,
                                   const InvariantFact& v) {
  need_smooth(reduced_curve(j, v, data.prime));
  // (1 + sqrt p)^2 <= p + 2 + floor(2 sqrt p)
  Integer root(data.prime.p);
  root *= Integer(4);
  fmpz_sqrt(root.raw(), root.raw());
  const auto genus = static_cast<unsigned long>((degree(v.branch) - 1) / 2);
  return {data.prime.p, pow(Integer(data.prime.p) + Integer(2) + root, genus), &v};
}

} // namespace kov::certify
