#include "exact/factor.hpp"

#include "exact/error.hpp"
#include "exact/in_pairs.hpp"
#include "exact/modular.hpp"

#include <algorithm>
#include <functional>

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

Poly product(std::vector<Poly> factors) {
  if (factors.empty()) return Poly(1);
  return in_pairs(std::move(factors), std::multiplies{});
}

bool is_squarefree(const Poly& f) {
  return degree(f) < 2 || provably_coprime(f, derivative(f)) || degree(gcd(f, derivative(f))) == 0;
}

namespace {

void sort_factors(std::vector<Factor>& factors) {
  std::ranges::sort(factors, [](const Factor& a, const Factor& b) {
    if (a.exponent != b.exponent) return a.exponent < b.exponent;
    return compare(a.base, b.base) < 0;
  });
}

// f modulo p as a product of powers of squarefree polynomials, by Yun's algorithm.  Requires p >
// deg f.
std::vector<std::pair<NmodPoly, long>> modular_squarefree_parts(const NmodPoly& f) {
  std::vector<std::pair<NmodPoly, long>> parts;
  const NmodPoly df = derivative(f);
  const NmodPoly g = gcd(f, df);
  NmodPoly c = exact_div(f, g);
  NmodPoly d = exact_div(df, g) - derivative(c);
  for (long i = 1; degree(c) > 0; ++i) {
    const NmodPoly base = gcd(c, d);
    c = exact_div(c, base);
    d = exact_div(d, base) - derivative(c);
    if (degree(base) > 0) parts.emplace_back(base, i);
  }
  return parts;
}

// h = g^(k)/k!, in which a root of multiplicity k+1 is simple.
void divided_derivative(fmpz_poly_t h, const fmpz_poly_t g, slong k) {
  Integer binomial(1); // (j+k choose k)
  const slong length = fmpz_poly_length(g) - k;
  fmpz_poly_fit_length(h, length);
  for (slong j = 0; j < length; ++j) {
    if (j > 0) {
      binomial *= Integer(j + k);
      fmpz_divexact_si(binomial.raw(), binomial.raw(), j);
    }
    fmpz_mul(h->coeffs + j, g->coeffs + j + k, binomial.raw());
  }
  _fmpz_poly_set_length(h, length);
}

// The rational numbers that reduce to the given simple roots of g modulo p, as far as they can be
// guessed: by reconstruction from one prime where a second prime agrees, else by Newton's iteration
// modulo p^2, p^4, ... until the guess does not change or exceeds 2^bits.
std::vector<Rational> lifted_roots(const fmpz_poly_t g, const std::vector<mp_limb_t>& start,
                                   mp_limb_t p, mp_limb_t second_prime, slong bits) {
  std::vector<Rational> found;
  std::vector<Integer> open;
  std::vector<Rational> guess(start.size());
  std::vector<mp_limb_t> image(start.size());
  std::vector<mp_limb_t> values(start.size());
  const PrimeIdeal other{second_prime, 0};
  for (std::size_t i = 0; i < start.size(); ++i) {
    guess[i] = rational_reconstruction(Integer(start[i]), Integer(p)).value_or(Rational(0));
    image[i] = other.reduce(guess[i]).value_or(0);
  }
  NmodPoly reduced(second_prime);
  fmpz_poly_get_nmod_poly(reduced.raw(), g);
  nmod_poly_evaluate_nmod_vec(values.data(), reduced.raw(), image.data(),
                              static_cast<slong>(start.size()));
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (values[i] == 0)
      found.push_back(guess[i]);
    else
      open.emplace_back(start[i]);
  }
  fmpz_poly_t f;
  fmpz_poly_t df;
  fmpz_poly_init(f);
  fmpz_poly_init(df);
  Integer value;
  Integer slope;
  std::vector<std::optional<Rational>> last(open.size());
  for (Integer modulus(p);
       !open.empty() && static_cast<slong>(fmpz_bits(modulus.raw())) <= 4 * bits + 128;) {
    modulus = modulus * modulus;
    fmpz_poly_scalar_mod_fmpz(f, g, modulus.raw());
    fmpz_poly_derivative(df, f);
    const auto horner = [&](const fmpz_poly_t h, const Integer& x, Integer& out) {
      fmpz_zero(out.raw());
      for (slong i = fmpz_poly_degree(h); i >= 0; --i) {
        fmpz_mul(out.raw(), out.raw(), x.raw());
        fmpz_add(out.raw(), out.raw(), h->coeffs + i);
        fmpz_mod(out.raw(), out.raw(), modulus.raw());
      }
    };
    std::vector<Integer> still_open;
    std::vector<std::optional<Rational>> still_last;
    for (std::size_t i = 0; i < open.size(); ++i) {
      Integer& x = open[i];
      horner(f, x, value);
      horner(df, x, slope);
      if (!fmpz_invmod(slope.raw(), slope.raw(), modulus.raw())) continue;
      x -= value * slope;
      fmpz_mod(x.raw(), x.raw(), modulus.raw());
      auto candidate = rational_reconstruction(x, modulus);
      if (candidate && last[i] && *candidate == *last[i]) {
        found.push_back(*candidate);
        continue;
      }
      still_open.push_back(std::move(x));
      still_last.push_back(std::move(candidate));
    }
    open = std::move(still_open);
    last = std::move(still_last);
  }
  fmpz_poly_clear(f);
  fmpz_poly_clear(df);
  return found;
}

// Rational roots with their multiplicities in f over Q, by roots modulo one prime: a root of
// multiplicity e is a simple root of the (e-1)-st derivative.  Roots may be missing; those that are
// returned divide f with that multiplicity (checked by one division), and `rest` is what is left.
std::vector<Factor> linear_factors(const Poly& f, Poly& rest) {
  rest = f;
  if (degree(f) < 2 || !f.field()->is_rational()) return {};
  fmpz_poly_t g;
  fmpz_poly_init(g);
  fmpq_poly_get_numerator(g, f.raw());
  // A root n/d has d | lead and n | the lowest coefficient that is not 0.
  slong bits = static_cast<slong>(fmpz_bits(g->coeffs + fmpz_poly_degree(g)));
  for (slong i = 0; i <= fmpz_poly_degree(g); ++i)
    if (!fmpz_is_zero(g->coeffs + i)) {
      bits = std::max(bits, static_cast<slong>(fmpz_bits(g->coeffs + i)));
      break;
    }
  std::vector<Factor> found;
  // Splitting costs as many squarings as p has bits; n random roots differ modulo p > 64 n^2.
  const auto n = static_cast<mp_limb_t>(degree(f));
  const mp_limb_t p = PrimeIdeals(rationals(), std::max(mp_limb_t{1} << 28, 64 * n * n)).next().p;
  const mp_limb_t second_prime = PrimeIdeals::large(rationals()).next().p;
  NmodPoly image(p);
  fmpz_poly_get_nmod_poly(image.raw(), g);
  if (degree(image) == degree(f)) {
    for (const auto& [base, e] : modular_squarefree_parts(image)) {
      if (degree(base) < 1) continue;
      const auto images = roots(base);
      if (images.empty()) continue;
      fmpz_poly_t h;
      fmpz_poly_init(h);
      divided_derivative(h, g, e - 1);
      for (const Rational& x : lifted_roots(h, images, p, second_prime, bits))
        found.push_back({Poly::z() - Poly(x), e});
      fmpz_poly_clear(h);
    }
  }
  fmpz_poly_clear(g);
  std::vector<Poly> powers;
  for (const Factor& factor : found)
    powers.push_back(pow(factor.base, static_cast<unsigned long>(factor.exponent)));
  auto [quot, remainder] = divrem(f, product(powers));
  if (is_zero(remainder)) {
    rest = std::move(quot);
    return found;
  }
  // Some guess was wrong (roots that agree modulo p): keep those that divide, one by one.
  std::vector<Factor> kept;
  for (const Factor& factor : found) {
    auto [e, left] = remove_factor(rest, factor.base);
    if (e == 0) continue;
    kept.push_back({factor.base, e});
    rest = std::move(left);
  }
  return kept;
}

// Irreducible factors of a squarefree monic f over Q.
std::vector<Poly> split_over_q(Poly f, const Budget& budget) {
  std::vector<Poly> found;
  if (degree(f) < 1) return found;
  if (degree(f) == 1) return {f};
  budget.check();
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

namespace {

// The largest k with z^k | f.
long order_at_zero(const Poly& f) {
  long k = 0;
  while (
      fmpz_is_zero(f.raw()->coeffs + k)) // flat: the order of the first coefficient that is not 0
    ++k;
  return k / f.stride();
}

// z^k and a linear polynomial are at hand; what is left goes into `rest`.
std::vector<Factor> obvious_factors(const Poly& f, Poly& rest) {
  std::vector<Factor> found;
  const long k = order_at_zero(f);
  if (k > 0) found.push_back({coerce(Poly::z(), f.field()), k});
  rest = k > 0 ? shift_right(f, k) : f;
  if (degree(rest) != 1) return found;
  found.push_back({monic(rest), 1});
  rest = Poly(1);
  return found;
}

} // namespace

std::vector<Factor> irreducible_factors(const Poly& f, const Budget& budget) {
  KOV_ENSURE(!is_zero(f));
  Poly rest;
  std::vector<Factor> found = obvious_factors(f, rest);
  if (degree(rest) > 0) {
    const Poly open = rest;
    std::ranges::move(linear_factors(open, rest), std::back_inserter(found));
  }
  for (const Factor& part : squarefree_factors(rest)) {
    budget.check_degree(degree(part.base));
    for (Poly& q : split_over_field(part.base, budget)) {
      // a root that the quick look missed in part may have been found before
      const auto known = std::ranges::find_if(found, [&](const Factor& g) { return g.base == q; });
      if (known != found.end())
        known->exponent += part.exponent;
      else
        found.push_back({coerce(q, f.field()), part.exponent});
    }
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
