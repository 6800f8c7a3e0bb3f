#include "galois/infinite_torsion.hpp"

#include "certify/equation/modular_equation.hpp"
#include "exact/tried.hpp"
#include "galois/dihedral.hpp"
#include "pcurvature/p_curvature.hpp"

namespace kov {
namespace {

constexpr int good_tries = 400;
constexpr int patience = 25; ///< primes whose p-curvature vanishes, before any that does not
constexpr mp_limb_t largest_prime = 2000;

// Is q good in the sense of the rule "good-reduction"?  The checker's own function answers.
bool is_good(const DihedralCurve& c, const certify::Equation& r, const PrimeIdeal& q) {
  return tried<certify::Refused>([&] {
    certify::need_smooth(certify::reduce_curve(r, c.field, c.branch, c.w_squared / c.k, q));
  });
}

// The first prime at which the curve S^2 = (w^2/k) F0 has good reduction.
std::optional<PrimeIdeal> good_prime(const DihedralCurve& c, const RationalFunction& r,
                                     const Budget& budget) {
  const certify::Equation equation{coerce(r.num(), c.field), coerce(r.den(), c.field)};
  PrimeIdeals primes(c.field, 2);
  for (int tries = 0; tries < good_tries; ++tries) {
    budget.check();
    const PrimeIdeal q = primes.next();
    if (is_good(c, equation, q)) return q;
  }
  return std::nullopt;
}

// (q + 2 + floor(2 sqrt q))^g
Integer weil_bound(mp_limb_t q, long genus) {
  return pow(Integer(q + 2 + n_sqrt(4 * q)), static_cast<unsigned long>(genus));
}

// 2 and the denominators of the exponent differences.
Integer excluded(const Singularities& s) {
  Integer n(2);
  const auto take = [&](const Singularity& place) {
    if (place.delta) n *= place.delta->den();
  };
  take(s.infinity);
  for (const Singularity& place : s.finite)
    take(place);
  return n;
}

} // namespace

std::optional<InfiniteTorsion>
infinite_by_curvatures(const DihedralCurve& c, const Singularities& s, const Budget& budget) {
  const auto q = good_prime(c, s.r, budget);
  if (!q) return std::nullopt;
  InfiniteTorsion found{*q, weil_bound(q->p, c.genus), {}};
  const Integer avoid = excluded(s) * Integer(q->p);
  Integer product(1);
  PrimeIdeals primes(c.field, 2);
  for (int vanished = 0; product <= found.bound;) {
    budget.check();
    const PrimeIdeal prime = primes.next();
    if (prime.p > largest_prime) return std::nullopt;
    const Integer p(prime.p);
    if (gcd(avoid, p) != Integer(1) || gcd(product, p) != Integer(1)) continue;
    const auto curvature = p_curvature(s.r, prime);
    if (!curvature) continue;
    if (is_zero(*curvature)) {
      if (++vanished == patience && found.nonzero.empty()) return std::nullopt;
      continue;
    }
    found.nonzero.push_back(prime);
    product *= p;
  }
  return found;
}

} // namespace kov
