// Rule "local": see witness.hpp.

#include "decide/witness.hpp"
#include "exact/factor.hpp"
#include "exact/tried.hpp"
#include "proof/text/limits.hpp"

namespace kov::witness {

namespace {

constexpr int local_prime_tries = 2000;
constexpr long largest_annihilator = 120; // degree over Q; the bound is cruder than it is useful

// Does the judge agree?
template <class Check> bool agrees(const Check& check) {
  return tried<certify::Refused>([&] { check(); });
}

PrimeIdeal prime_for_places(const certify::Judge& judge, const Singularities& s,
                            const Budget& budget) {
  std::vector<Poly> bases;
  for (const Singularity& place : s.finite)
    bases.push_back(place.place);
  const Poly all = product(std::move(bases));
  PrimeIdeals primes = PrimeIdeals::large(judge.field);
  for (int tries = 0; tries < local_prime_tries; ++tries) {
    budget.check();
    const PrimeIdeal prime = primes.next();
    if (agrees([&] {
          if (degree(all) > 0)
            certify::need_squarefree(all, judge.reduced(prime), &judge.equation.num);
          else
            static_cast<void>(judge.reduced(prime));
        }))
      return prime;
  }
  throw OutOfBudget("no prime keeps the places apart");
}

// A prime modulo which Delta^2 is at no root of q the square of an element of F_p.
std::optional<PrimeIdeal> irrational_at_every_root(const Singularity& s, const Field& k,
                                                   const Budget& budget) {
  PrimeIdeals primes = PrimeIdeals::large(k);
  for (int tries = 0; tries < local_prime_tries; ++tries) {
    budget.check();
    const PrimeIdeal prime = primes.next();
    const auto q = prime.reduce(s.place);
    const auto e = prime.reduce(s.delta_squared);
    if (!q || !e) continue;
    NmodPoly power(prime.p);
    nmod_poly_powmod_ui_binexp(power.raw(), e->raw(), (prime.p + 1) / 2, q->raw());
    const NmodPoly v = power - *e;
    if (!is_zero(v) && degree(gcd(v, *q)) == 0) return prime;
  }
  return std::nullopt;
}

// Roots modulo one prime at which the logarithm is seen: all of them if that is not too rare.
std::optional<certify::LogWitness> logarithm(const certify::Judge& judge, const Singularity& s,
                                             const Budget& budget) {
  const int tries = s.degree() == 1 ? 3 : s.degree() <= 4 ? 60 : 8;
  certify::LogWitness best;
  PrimeIdeals primes = PrimeIdeals::large(judge.field);
  for (int i = 0; i < tries && static_cast<long>(best.roots.size()) < s.degree(); ++i) {
    budget.check();
    const PrimeIdeal prime = primes.next();
    certify::LogWitness found{prime, {}};
    const auto seen_at = [&](std::optional<mp_limb_t> root) {
      return agrees([&] { certify::need_log(judge.reduced(prime), root, *s.delta); });
    };
    if (s.at_infinity) {
      if (seen_at(std::nullopt)) return found;
      continue;
    }
    const auto q = prime.reduce(s.place);
    if (!q) continue;
    for (const mp_limb_t c : roots(*q))
      if (seen_at(c)) found.roots.push_back(c);
    if (found.roots.size() > best.roots.size()) best = std::move(found);
  }
  if (best.roots.empty()) return std::nullopt;
  return best;
}

// The characteristic polynomial over Q of f in K[c]/q, by Newton's identities.
Poly characteristic_polynomial(const Poly& f, const Poly& q) {
  const long n = degree(q);
  std::vector<NfElem> power_sums; // of the roots of q: the coefficients of q'/q at infinity
  const Poly sums = reverse(derivative(q), n) * inverse_series(reverse(q, n + 1), n);
  const auto trace = [&](const Poly& g) {
    NfElem t(0);
    for (long i = 0; i <= degree(g); ++i)
      t += g.coeff(i) * sums.coeff(i);
    return t;
  };
  std::vector<NfElem> traces, c{NfElem(1)};
  Poly power = f % q;
  for (long k = 1; k <= n; ++k) {
    traces.push_back(trace(power));
    power = power * f % q;
    NfElem sum(0);
    for (long i = 1; i <= k; ++i)
      sum += c[static_cast<std::size_t>(k - i)] * traces[static_cast<std::size_t>(i - 1)];
    c.push_back(-(sum * NfElem(Rational(1, k))));
  }
  return norm(Poly::from_coefficients({c.rbegin(), c.rend()}));
}

bool is_rational_constant(const Poly& f) { return degree(f) <= 0 && is_rational(f.coeff(0)); }

std::optional<Poly> annihilator(const Singularity& s, const Field& k) {
  if (is_rational_constant(s.delta_squared)) return std::nullopt;
  const bool constant = degree(s.delta_squared) <= 0;
  if ((constant ? 1 : s.degree()) * k->degree() > largest_annihilator) return std::nullopt;
  if (constant) return norm(coerce(Poly::z(), k) - s.delta_squared);
  return characteristic_polynomial(s.delta_squared, s.place);
}

bool has_logarithm_to_show(const Singularity& s) {
  return s.kind == PlaceKind::regular && s.log == Truth::yes && s.delta && sign(*s.delta) > 0;
}

certify::LocalPlace finite_place(const certify::Judge& judge, const Singularity& s, Detail detail,
                                 const Budget& budget) {
  certify::LocalPlace x;
  x.q = s.place;
  x.order = s.order;
  if (detail == Detail::places) return x;
  if (s.kind == PlaceKind::regular) {
    x.delta2 = s.delta_squared;
    if (degree(s.delta_squared) > 0)
      x.irrational = irrational_at_every_root(s, judge.field, budget);
  }
  if (has_logarithm_to_show(s)) x.log = logarithm(judge, s, budget);
  if (detail == Detail::exponents ||
      (s.kind != PlaceKind::regular && s.kind != PlaceKind::irregular))
    return x;
  if (s.kind == PlaceKind::irregular && s.nu() <= certify::max_irregular) x.eps2 = s.delta_squared;
  x.annihilator = annihilator(s, judge.field);
  return x;
}

} // namespace

certify::Local local(const certify::Judge& judge, const Singularities& s, Detail detail,
                     const Budget& budget) {
  certify::Local data;
  data.prime = prime_for_places(judge, s, budget);
  for (const Singularity& place : s.finite)
    data.places.push_back(finite_place(judge, place, detail, budget));
  const Singularity& inf = s.infinity;
  const bool growth = detail == Detail::growth;
  if (detail != Detail::places && has_logarithm_to_show(inf))
    data.infinity_log = logarithm(judge, inf, budget);
  if (growth && inf.kind == PlaceKind::irregular && inf.nu() + 2 <= certify::max_irregular)
    data.infinity_eps2 = inf.delta_squared;
  if (growth && (inf.kind == PlaceKind::regular || inf.kind == PlaceKind::irregular))
    data.infinity_annihilator = annihilator(inf, judge.field);
  return data;
}

} // namespace kov::witness
