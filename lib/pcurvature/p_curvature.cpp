#include "pcurvature/p_curvature.hpp"

#include "exact/error.hpp"

namespace kov {

std::optional<NmodPoly> p_curvature(const RationalFunction& r, const PrimeIdeal& prime) {
  const auto n = prime.reduce(r.num());
  const auto d = prime.reduce(r.den());
  if (!n || !d) return std::nullopt;
  // A_k = M_k / D^k for k >= 1 with M_1 = (0 D; N 0):
  //   M_(k+1) = D M_k' - k D' M_k + M_k (0 D; N 0)
  const mp_limb_t p = prime.p;
  const NmodPoly dd = derivative(*d);
  NmodPoly m11(p);
  NmodPoly m12 = *d;
  NmodPoly m21 = *n;
  NmodPoly m22(p);
  for (mp_limb_t k = 1; k < p; ++k) {
    const auto step = [&](const NmodPoly& m) { return *d * derivative(m) - scale(dd * m, k); };
    NmodPoly next11 = step(m11) + m12 * *n;
    NmodPoly next12 = step(m12) + m11 * *d;
    NmodPoly next21 = step(m21) + m22 * *n;
    NmodPoly next22 = step(m22) + m21 * *d;
    m11 = std::move(next11);
    m12 = std::move(next12);
    m21 = std::move(next21);
    m22 = std::move(next22);
  }
  KOV_ENSURE(is_zero(m11 + m22));
  return m11 * m11 + m12 * m21; // -det, as the trace is 0
}

namespace {

bool half_integral(const std::optional<Rational>& delta) {
  return delta && delta->den() == Integer(2);
}

bool admissible(const Singularity& s) {
  return s.kind == PlaceKind::ramified || (s.kind == PlaceKind::regular && half_integral(s.delta));
}

// The product of the irreducible factors of odd multiplicity.
NmodPoly odd_part(const NmodPoly& b) {
  nmod_poly_factor_t factors;
  nmod_poly_factor_init(factors);
  nmod_poly_factor_squarefree(factors, b.raw());
  NmodPoly odd(b.modulus());
  odd.set_coeff(0, 1);
  for (slong i = 0; i < factors->num; ++i)
    if (factors->exp[i] % 2 == 1) nmod_poly_mul(odd.raw(), odd.raw(), factors->p + i);
  nmod_poly_factor_clear(factors);
  return odd;
}

} // namespace

std::optional<PCurvatureProof> sl2_by_p_curvature(const Singularities& s, int tries,
                                                  const Budget& budget) {
  Poly places = coerce(Poly(1), s.r.field());
  for (const Singularity& place : s.finite)
    if (admissible(place)) places *= place.place;
  PrimeIdeals primes(s.r.field(), 6);
  for (int good = 0; good < tries;) {
    budget.check();
    const PrimeIdeal prime = primes.next();
    if (prime.p > 60) return std::nullopt;
    const auto allowed = prime.reduce(places);
    if (!allowed) continue;
    const auto b = p_curvature(s.r, prime);
    if (!b) continue;
    ++good;
    if (is_zero(*b)) continue;
    const NmodPoly odd = odd_part(*b);
    // r is integral and den monic, so no pole goes to infinity: infinity is odd exactly when the
    // degree of the odd part is.
    const bool infinity_odd = degree(odd) % 2 == 1;
    const long outside = degree(odd) - degree(gcd(odd, *allowed)) +
                         (infinity_odd && !admissible(s.infinity) ? 1 : 0);
    if (outside > 0) return PCurvatureProof{prime, outside};
  }
  return std::nullopt;
}

} // namespace kov
