#include "pcurvature/p_curvature.hpp"

#include "exact/error.hpp"

namespace kov {

std::optional<NmodPoly> p_curvature(const RationalFunction& r, const PrimeIdeal& prime) {
  const auto n = prime.reduce(r.num());
  const auto d = prime.reduce(r.den());
  if (!n || !d) return std::nullopt;
  // y^(k) = (alpha_k y + beta_k y')/D^k on solutions:
  //   alpha_(k+1) = D alpha_k' - k D' alpha_k + N beta_k,
  //   beta_(k+1)  = D beta_k' - k D' beta_k + D alpha_k.
  // The second row of the matrix at k = p is the derivative of the first one, and its trace is 0.
  const mp_limb_t p = prime.p;
  const NmodPoly dd = derivative(*d);
  NmodPoly alpha(p);
  NmodPoly beta = *d;
  const auto derived = [&](mp_limb_t k, const NmodPoly& f) {
    return *d * derivative(f) - scale(dd * f, k % p);
  };
  for (mp_limb_t k = 1; k < p; ++k) {
    NmodPoly next = derived(k, alpha) + *n * beta;
    beta = derived(k, beta) + *d * alpha;
    alpha = std::move(next);
  }
  // in characteristic p: (alpha/D^p)' = alpha'/D^p, and all is multiplied by D^(2p)
  KOV_ENSURE(is_zero(scale(alpha, 2) + derivative(beta)));
  const NmodPoly lower = derivative(alpha) + exact_div(*n * beta, *d);
  return alpha * alpha + beta * lower; // -det
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
    if (is_zero(*b)) return std::nullopt; // most likely so at every prime
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
