#include "exact/factor.hpp"

#include "exact/error.hpp"
#include "exact/modular.hpp"

#include <algorithm>

namespace kov {

std::vector<Factor> squarefree_factors(const Poly& f0) {
  KOV_ENSURE(!is_zero(f0));
  std::vector<Factor> found;
  const Poly f = monic(f0);
  if (degree(f) < 1) return found;
  // Yun: c holds the product of the bases of exponent >= i.
  const Poly df = derivative(f);
  Poly g = gcd(f, df);
  Poly c = exact_div(f, g);
  Poly d = exact_div(df, g) - derivative(c);
  for (long i = 1; degree(c) > 0; ++i) {
    const Poly base = gcd(c, d);
    if (degree(base) > 0) found.push_back({base, i});
    c = exact_div(c, base);
    d = exact_div(d, base) - derivative(c);
  }
  return found;
}

bool is_squarefree(const Poly& f) {
  return degree(f) < 2 || provably_coprime(f, derivative(f)) || degree(gcd(f, derivative(f))) == 0;
}

namespace {

void sort_factors(std::vector<Factor>& factors) {
  std::sort(factors.begin(), factors.end(), [](const Factor& a, const Factor& b) {
    if (a.exponent != b.exponent) return a.exponent < b.exponent;
    return compare(a.base, b.base) < 0;
  });
}

// The rational roots of a squarefree f over Q: roots modulo one prime, lifted by Newton's iteration
// until the denominator and numerator bounds are passed, then checked by division.
std::vector<Rational> rational_roots(const Poly& f) {
  std::vector<Rational> found;
  fmpz_poly_t g;
  fmpz_poly_init(g);
  fmpq_poly_get_numerator(g, f.raw());
  fmpz_poly_primitive_part(g, g);
  // A root n/d has d | lead, n | constant term: |n|,|d| < 2^bits.
  const slong bits = std::max(fmpz_bits(g->coeffs + fmpz_poly_degree(g)),
                              fmpz_is_zero(g->coeffs) ? flint_bitcnt_t{1} : fmpz_bits(g->coeffs));
  PrimeIdeals primes(rationals(), mp_limb_t{1} << 30);
  for (int tries = 0; tries < 20; ++tries) {
    const PrimeIdeal prime = primes.next();
    NmodPoly image(prime.p);
    fmpz_poly_get_nmod_poly(image.raw(), g);
    if (degree(image) != fmpz_poly_degree(g)) continue;
    if (degree(gcd(image, derivative(image))) != 0) continue;
    fmpz_poly_t dg;
    fmpz_poly_init(dg);
    fmpz_poly_derivative(dg, g);
    for (const mp_limb_t start : roots(image)) {
      Integer modulus(prime.p);
      Integer x(start);
      Integer value;
      Integer slope;
      std::optional<Rational> candidate;
      bool root = false;
      while (!root) {
        candidate = rational_reconstruction(x, modulus);
        if (candidate) {
          Rational at;
          fmpz_poly_evaluate_fmpq(at.raw(), g, candidate->raw());
          root = is_zero(at);
        }
        if (root || static_cast<slong>(fmpz_bits(modulus.raw())) > 2 * bits + 3) break;
        modulus = modulus * modulus;
        // x <- x - g(x)/g'(x) modulo p^(2k), by Horner's rule modulo p^(2k)
        const auto horner = [&](const fmpz_poly_struct* h, Integer& out) {
          fmpz_zero(out.raw());
          for (slong i = fmpz_poly_degree(h); i >= 0; --i) {
            fmpz_mul(out.raw(), out.raw(), x.raw());
            fmpz_add(out.raw(), out.raw(), h->coeffs + i);
            fmpz_mod(out.raw(), out.raw(), modulus.raw());
          }
        };
        horner(g, value);
        horner(dg, slope);
        fmpz_invmod(slope.raw(), slope.raw(), modulus.raw());
        x -= value * slope;
        fmpz_mod(x.raw(), x.raw(), modulus.raw());
      }
      if (root) found.push_back(*candidate);
    }
    fmpz_poly_clear(dg);
    break;
  }
  fmpz_poly_clear(g);
  return found;
}

// Irreducible factors of a squarefree monic f over Q.
std::vector<Poly> split_over_q(Poly f, const Budget& budget) {
  std::vector<Poly> found;
  if (degree(f) < 1) return found;
  if (degree(f) == 1) return {f};
  budget.check();
  for (const Rational& root : rational_roots(f))
    found.push_back(Poly::z() - Poly(root));
  if (!found.empty()) {
    // the product by a balanced tree: much cheaper than one division per root
    std::vector<Poly> layer = found;
    while (layer.size() > 1) {
      std::vector<Poly> next;
      for (std::size_t i = 0; i + 1 < layer.size(); i += 2)
        next.push_back(layer[i] * layer[i + 1]);
      if (layer.size() % 2 == 1) next.push_back(layer.back());
      layer = std::move(next);
    }
    f = exact_div(f, layer.front());
  }
  if (degree(f) < 1) return found;
  fmpz_poly_t g;
  fmpz_poly_init(g);
  fmpq_poly_get_numerator(g, f.raw());
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, g);
  for (slong i = 0; i < factors->num; ++i) {
    Poly q;
    fmpq_poly_set_fmpz_poly(q.raw(), factors->p + i);
    found.push_back(monic(q));
  }
  fmpz_poly_factor_clear(factors);
  fmpz_poly_clear(g);
  return found;
}

// Trager: the norm of f(z - s a) is squarefree for almost all integers s; its factors over Q give
// the factors of f(z - s a) as gcds.
std::vector<Poly> split_over_field(const Poly& f, const Budget& budget) {
  const Field& k = f.field();
  if (k->is_rational()) return split_over_q(f, budget);
  if (degree(f) == 1) return {f};
  const NfElem a = NfElem::generator(k);
  for (long s = 0;; ++s) {
    budget.check();
    const NfElem shift = a * NfElem(s);
    const Poly moved = s == 0 ? f : taylor_shift(f, -shift);
    const Poly n = norm(moved);
    if (!is_squarefree(n)) continue;
    std::vector<Poly> found;
    Poly rest = moved;
    const auto factors = split_over_q(monic(n), budget);
    for (const Poly& h : factors) {
      Poly g = factors.size() == 1 ? rest : gcd(coerce(h, k), rest);
      KOV_ENSURE(degree(g) > 0);
      rest = exact_div(rest, g);
      found.push_back(monic(s == 0 ? g : taylor_shift(g, shift)));
    }
    KOV_ENSURE(degree(rest) == 0);
    return found;
  }
}

} // namespace

Poly norm(const Poly& f) {
  const Field& k = f.field();
  if (k->is_rational()) return f;
  if (is_zero(f)) return Poly();
  // The resultant in a of m(a) and f(z, a), by values at integers and interpolation: degree d*deg
  // f.
  const long d = k->degree();
  const long points = d * degree(f) + 1;
  fmpq_poly_t m;
  fmpq_poly_init(m);
  fmpq_poly_set_fmpz_poly(m, k->minpoly());
  std::vector<Rational> values;
  for (long i = 0; i < points; ++i) {
    const long x = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
    const NfElem at = evaluate(f, NfElem(x));
    Rational r;
    if (!is_zero(at)) fmpq_poly_resultant(r.raw(), m, at.raw());
    values.push_back(r);
  }
  fmpq_poly_clear(m);
  // Newton interpolation with a common denominator.
  Integer den(1);
  for (const Rational& v : values)
    den = lcm(den, v.den());
  fmpz* xs = _fmpz_vec_init(points);
  fmpz* ys = _fmpz_vec_init(points);
  for (long i = 0; i < points; ++i) {
    fmpz_set_si(xs + i, i % 2 == 0 ? i / 2 : -(i + 1) / 2);
    const Integer y = (values[static_cast<std::size_t>(i)] * Rational(den)).num();
    fmpz_set(ys + i, y.raw());
  }
  Poly n;
  fmpq_poly_interpolate_fmpz_vec(n.raw(), xs, ys, points);
  fmpq_poly_scalar_div_fmpz(n.raw(), n.raw(), den.raw());
  _fmpz_vec_clear(xs, points);
  _fmpz_vec_clear(ys, points);
  return n;
}

std::vector<Factor> irreducible_factors(const Poly& f, const Budget& budget) {
  std::vector<Factor> found;
  for (const Factor& part : squarefree_factors(f)) {
    budget.check_degree(degree(part.base));
    for (Poly& q : split_over_field(part.base, budget))
      found.push_back({coerce(q, f.field()), part.exponent});
  }
  sort_factors(found);
  return found;
}

std::optional<NfElem> exact_sqrt(const NfElem& a) {
  if (is_zero(a)) return a;
  if (is_rational(a)) {
    if (const auto root = exact_sqrt(a.coeff(0))) return NfElem(*root, a.field());
    if (a.field()->is_rational()) return std::nullopt;
  }
  const Poly square = Poly::monomial(NfElem(Rational(1), a.field()), 2) - Poly(a); // z^2 - a
  for (const Factor& factor : irreducible_factors(square))
    if (degree(factor.base) == 1) return -factor.base.coeff(0);
  return std::nullopt;
}

} // namespace kov
