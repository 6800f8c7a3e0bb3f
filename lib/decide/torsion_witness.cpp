// Rule "torsion-function": see witness.hpp.

#include "decide/witness.hpp"

#include <algorithm>

namespace kov::witness {

namespace {

constexpr int torsion_prime_tries = 4000;
constexpr mp_limb_t points_to_try = 4000;

// h modulo a prime of degree one of K(w).
struct ReducedFunction {
  PrimeIdeal prime;
  mp_limb_t w;
  NmodPoly a, b, den, branch;

  // A point over x, with the class of h there modulo l-th powers.
  struct Point {
    mp_limb_t x, s, residue;
  };
  [[nodiscard]] std::optional<Point> point(mp_limb_t x, long l) const {
    const nmod_t mod = a.mod();
    const mp_limb_t square = evaluate(branch, x);
    const mp_limb_t below = evaluate(den, x);
    const mp_limb_t s = square == 0 ? 0 : n_sqrtmod(square, mod.n);
    if (s == 0 || below == 0) return std::nullopt;
    const mp_limb_t ws = nmod_mul(w, s, mod);
    const mp_limb_t top = nmod_add(evaluate(a, x), nmod_mul(evaluate(b, x), ws, mod), mod);
    if (top == 0) return std::nullopt;
    const mp_limb_t e = (mod.n - 1) / static_cast<mp_limb_t>(l);
    return Point{x, s, nmod_pow_ui(nmod_div(top, below, mod), e, mod)};
  }
};

std::optional<ReducedFunction> reduced(const certify::Judge& judge,
                                       const certify::TorsionFunction& h,
                                       const certify::InvariantFact& v, const PrimeIdeal& prime) {
  try {
    certify::ReducedCurve curve = certify::reduced_curve(judge, v, prime);
    const mp_limb_t w = n_sqrtmod(curve.w_squared, prime.p);
    ReducedFunction f{prime,
                      w,
                      certify::reduce(h.a, prime),
                      certify::reduce(h.b, prime),
                      certify::reduce(h.den, prime),
                      std::move(curve.branch)};
    if (w == 0 || certify::is_square(f.branch)) return std::nullopt;
    return f;
  } catch (const certify::Refused&) {
    return std::nullopt;
  }
}

std::optional<certify::NotAPower> two_points(const ReducedFunction& h, long l) {
  std::optional<ReducedFunction::Point> first;
  for (mp_limb_t x = 0; x < std::min(h.prime.p, points_to_try); ++x) {
    const auto now = h.point(x, l);
    if (!now) continue;
    if (!first) first = now;
    if (first->residue != now->residue)
      return certify::NotAPower{l, h.prime, h.w, first->x, first->s, now->x, now->s};
  }
  return std::nullopt;
}

certify::NotAPower not_a_power(const certify::Judge& judge, const certify::TorsionFunction& h,
                               const certify::InvariantFact& v, long l, const Budget& budget) {
  PrimeIdeals primes(judge.field, 40);
  for (int tries = 0; tries < torsion_prime_tries; ++tries) {
    budget.check();
    const PrimeIdeal prime = primes.next();
    if (prime.p % static_cast<mp_limb_t>(l) != 1) continue;
    const auto f = reduced(judge, h, v, prime);
    const auto found = f ? two_points(*f, l) : std::nullopt;
    if (found) return *found;
  }
  throw OutOfBudget("no prime shows that the torsion function is not a power");
}

} // namespace

certify::TorsionFunction torsion_function(const certify::Judge& judge, const DihedralCurve& curve,
                                          const DihedralAnswer& answer,
                                          const certify::InvariantFact& v,
                                          const certify::LocalFact& local, const Budget& budget) {
  if (!answer.a)
    throw OutOfBudget("degree limit: the torsion function is a power that is too large");
  if (answer.n > Integer(certify::largest_torsion_order))
    throw OutOfBudget("the order of the torsion function is above " +
                      std::to_string(certify::largest_torsion_order) +
                      ", which the checkers do not accept");
  // h = a + b W s with n W^2 b = g a' (W of dihedral.hpp is w of the rule, as v = g s)
  const NfElem n(Rational(answer.n));
  const RationalFunction& a = *answer.a;
  const RationalFunction b =
      curve.g * derivative(a) * RationalFunction(Poly(inverse(n * curve.w_squared / curve.k)));
  certify::TorsionFunction h;
  h.n = to_long(answer.n);
  h.den = lcm(a.den(), b.den());
  h.a = a.num() * exact_div(h.den, a.den());
  h.b = b.num() * exact_div(h.den, b.den());
  const Integer L = local.residue_denominator(v);
  long left = h.n;
  for (long l = 2; left > 1; ++l) {
    if (left % l != 0) continue;
    Integer power(1);
    for (; left % l == 0; left /= l)
      power *= Integer(l);
    if (gcd(power, L) != power) h.minimal.push_back(not_a_power(judge, h, v, l, budget));
  }
  return h;
}

} // namespace kov::witness
