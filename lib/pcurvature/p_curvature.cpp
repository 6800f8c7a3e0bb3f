#include "pcurvature/p_curvature.hpp"

#include "exact/error.hpp"
#include "exact/meter.hpp"

#include <algorithm>
#include <vector>

namespace kov {
namespace {

// Coefficients modulo a small prime, ascending.
using Residues = std::vector<mp_limb_t>;

constexpr mp_limb_t small_prime = 1 << 16; // sums of 2^32 products fit a word
constexpr std::size_t long_factor = 64;

Residues residues(const NmodPoly& f) {
  return {f.raw()->coeffs, f.raw()->coeffs + f.raw()->length};
}

NmodPoly polynomial(const Residues& c, mp_limb_t p) {
  NmodPoly f(p);
  for (std::size_t i = c.size(); i-- > 0;)
    if (c[i] != 0) f.set_coeff(static_cast<long>(i), c[i]);
  return f;
}

// The sum is left unreduced.
void add_product(Residues& sum, const Residues& f, const Residues& g, nmod_t mod) {
  if (f.size() < g.size()) return add_product(sum, g, f, mod);
  charge(static_cast<double>(f.size()) * static_cast<double>(std::min(g.size(), long_factor)) / 16);
  if (g.size() < long_factor) {
    for (std::size_t j = 0; j < g.size(); ++j)
      for (std::size_t i = 0; i < f.size(); ++i)
        sum[i + j] += f[i] * g[j];
    return;
  }
  Residues product(f.size() + g.size() - 1);
  _nmod_poly_mul(product.data(), f.data(), static_cast<slong>(f.size()), g.data(),
                 static_cast<slong>(g.size()), mod);
  for (std::size_t i = 0; i < product.size(); ++i)
    sum[i] += product[i];
}

Residues derivative(const Residues& f, mp_limb_t p) {
  Residues slope(f.empty() ? 0 : f.size() - 1);
  mp_limb_t i = 0; // modulo p
  for (std::size_t j = 0; j < slope.size(); ++j) {
    if (++i == p) i = 0;
    slope[j] = i * f[j + 1] % p;
  }
  return slope;
}

Residues scaled(Residues f, mp_limb_t c, mp_limb_t p) {
  for (mp_limb_t& x : f)
    x = x * c % p;
  return f;
}

// D f' + E f + g h
Residues next(const Residues& D, const Residues& E, const Residues& f, const Residues& g,
              const Residues& h, nmod_t mod) {
  Residues sum(std::max(D.size() + f.size(), g.size() + h.size()));
  add_product(sum, D, derivative(f, mod.n), mod);
  add_product(sum, E, f, mod);
  add_product(sum, g, h, mod);
  for (mp_limb_t& c : sum)
    c %= mod.n;
  while (!sum.empty() && sum.back() == 0)
    sum.pop_back();
  return sum;
}

} // namespace

std::optional<NmodPoly> p_curvature(const RationalFunction& r, const PrimeIdeal& prime) {
  const auto n = prime.reduce(r.num());
  const auto d = prime.reduce(r.den());
  if (!n || !d) return std::nullopt;
  // y^(k) = (alpha_k y + beta_k y')/D^k on solutions:
  //   alpha_(k+1) = D alpha_k' - k D' alpha_k + N beta_k,
  //   beta_(k+1)  = D beta_k' - k D' beta_k + D alpha_k.
  // The second row of the matrix at k = p is the derivative of the first one, and its trace is 0.
  const mp_limb_t p = prime.p;
  KOV_ENSURE(p < small_prime);
  const nmod_t mod = d->mod();
  const Residues D = residues(*d);
  const Residues N = residues(*n);
  const Residues slope = derivative(D, p);
  Residues a;
  Residues b = D;
  for (mp_limb_t k = 1; k < p; ++k) {
    const Residues E = scaled(slope, p - k, p); // -k D'
    Residues longer = next(D, E, a, N, b, mod);
    b = next(D, E, b, D, a, mod);
    a = std::move(longer);
  }
  const NmodPoly alpha = polynomial(a, p);
  const NmodPoly beta = polynomial(b, p);
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
