#include "certify/equation/modular_equation.hpp"

#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// Is a a root of the minimal polynomial of K modulo p?
bool is_image_of_generator(const NumberField& k, const PrimeIdeal& prime) {
  if (prime.generator >= prime.p) return false;
  NmodPoly m(prime.p);
  fmpz_poly_get_nmod_poly(m.raw(), k.minpoly());
  return evaluate(m, prime.generator) == 0;
}

} // namespace

NmodPoly reduce(const Poly& f, const PrimeIdeal& prime) {
  auto g = prime.reduce(f);
  need(g.has_value(), "p divides a denominator");
  return std::move(*g);
}

Reduced reduce(const Equation& e, const Field& k, const PrimeIdeal& prime) {
  need(prime.p > 2 && prime.p < (mp_limb_t{1} << 62) && n_is_prime(prime.p) != 0,
       "p is not an odd prime below 2^62");
  need(is_image_of_generator(*k, prime), "a is not a root of the minimal polynomial modulo p");
  return {prime, reduce(e.num, prime), reduce(e.den, prime)};
}

void need_squarefree(const Poly& f, const Reduced& r, const Poly* other) {
  if (degree(f) == 0) return;
  const NmodPoly g = reduce(f, r.prime);
  need(degree(gcd(g, derivative(g))) == 0, "not squarefree modulo p");
  if (other && !is_zero(*other))
    need(degree(gcd(g, reduce(*other, r.prime))) == 0, "a common factor modulo p");
}

ReducedCurve reduce_curve(const Equation& e, const Field& k, const Poly& branch,
                          const NfElem& w_squared, const PrimeIdeal& prime) {
  static_cast<void>(reduce(e, k, prime));
  NmodPoly m(prime.p);
  fmpz_poly_get_nmod_poly(m.raw(), k->minpoly());
  need(evaluate(derivative(m), prime.generator) != 0, "the prime ramifies");
  const auto unit = prime.reduce(w_squared);
  need(unit && *unit != 0, "w^2 is not a unit modulo p");
  return {reduce(branch, prime), *unit};
}

void need_smooth(const ReducedCurve& c) {
  need(degree(gcd(c.branch, derivative(c.branch))) == 0, "F0 is not squarefree modulo p");
}

bool is_square(const NmodPoly& f) {
  if (degree(f) % 2 != 0) return false;
  NmodPoly monic(f.modulus());
  nmod_poly_make_monic(monic.raw(), f.raw());
  NmodPoly root(f.modulus());
  return nmod_poly_sqrt(root.raw(), monic.raw()) != 0;
}

NmodPoly inverse_mod(const NmodPoly& f, const NmodPoly& q) {
  NmodPoly g(f.modulus());
  const NmodPoly a = remainder(f, q);
  need(degree(q) > 0 && !is_zero(a) && nmod_poly_invmod(g.raw(), a.raw(), q.raw()) != 0,
       "an element is not invertible modulo p");
  return g;
}

NmodPoly remainder(const NmodPoly& f, const NmodPoly& q) {
  NmodPoly r(f.modulus());
  nmod_poly_rem(r.raw(), f.raw(), q.raw());
  return r;
}

Expansion expand(const Reduced& r, std::optional<mp_limb_t> root, long order) {
  const auto reversed = [](const NmodPoly& f) {
    NmodPoly g(f.modulus());
    nmod_poly_reverse(g.raw(), f.raw(), degree(f) + 1);
    return g;
  };
  if (!root) {
    need(degree(r.den) - degree(r.num) == 4 - order, "the order at infinity changes modulo p");
    return {reversed(r.num), reversed(r.den), order};
  }
  need(*root < r.prime.p && evaluate(r.den, *root) == 0, "not a root of the place modulo p");
  const NmodPoly n = taylor_shift(r.num, *root);
  const NmodPoly d = taylor_shift(r.den, *root);
  for (long i = 0; i < order; ++i)
    need(d.coeff(i) == 0, "the order of the pole changes modulo p");
  need(n.coeff(0) != 0 && d.coeff(order) != 0, "the order of the pole changes modulo p");
  NmodPoly shifted(r.prime.p);
  nmod_poly_shift_right(shifted.raw(), d.raw(), order);
  return {n, shifted, order};
}

std::optional<std::vector<mp_limb_t>> riccati(const Expansion& e, mp_limb_t s0, long terms) {
  const nmod_t mod = e.num.mod();
  const long nu = std::max(1L, e.order / 2);
  const auto T = static_cast<double>(terms);
  need_within(T * T + T * static_cast<double>(degree(e.num) + degree(e.den) + 2) <= max_work,
              "too many terms");
  NmodPoly r(mod.n); // t^(2 nu) r
  nmod_poly_shift_left(r.raw(), mul_series(e.num, inverse_series(e.den, terms), terms).raw(),
                       2 * nu - e.order);
  const mp_limb_t square = nmod_mul(s0, s0, mod);
  need(r.coeff(0) == (nu == 1 ? nmod_sub(square, s0, mod) : square),
       "delta is not the square root that it should be");
  std::vector<mp_limb_t> S(static_cast<std::size_t>(terms));
  std::vector<mp_limb_t> reversed(S.size()); // reversed[terms-1-i] = S[i]
  const auto put = [&](long i, mp_limb_t v) {
    S[static_cast<std::size_t>(i)] = v;
    reversed[static_cast<std::size_t>(terms - 1 - i)] = v;
  };
  put(0, s0);
  const int limbs = _nmod_vec_dot_bound_limbs(terms, mod);
  const mp_limb_t twice = nmod_add(s0, s0, mod);
  const mp_limb_t inverse = twice != 0 ? nmod_inv(twice, mod) : 0;
  for (long i = 1; i < terms; ++i) {
    // the sum of S_a S_(i-a), 0 < a < i
    const mp_limb_t sum =
        _nmod_vec_dot(S.data() + 1, reversed.data() + (terms - i), i - 1, mod, limbs);
    mp_limb_t rhs = nmod_sub(r.coeff(i), sum, mod);
    if (nu == 1) {
      const mp_limb_t lead = nmod_add(twice, static_cast<mp_limb_t>(i - 1) % mod.n, mod);
      if (lead == 0) {
        need(rhs != 0, "the expansion is not unique");
        return std::nullopt;
      }
      put(i, nmod_mul(rhs, nmod_inv(lead, mod), mod));
      continue;
    }
    if (i >= nu - 1) { // (i - 2 nu + 1) S_(i-nu+1) from omega'
      mp_limb_t k = 0;
      NMOD_RED(k, static_cast<mp_limb_t>(std::abs(i - 2 * nu + 1)), mod);
      if (i - 2 * nu + 1 < 0) k = nmod_neg(k, mod);
      rhs = nmod_sub(rhs, nmod_mul(k, S[static_cast<std::size_t>(i - nu + 1)], mod), mod);
    }
    need(twice != 0, "the expansion is not unique");
    put(i, nmod_mul(rhs, inverse, mod));
  }
  return S;
}

void need_log(const Reduced& r, std::optional<mp_limb_t> root, const Rational& delta) {
  need(is_integer(delta) && delta >= Rational(1) && delta.num() < Integer(r.prime.p),
       "a logarithm needs a natural exponent difference below p");
  const nmod_t mod = r.num.mod();
  const long N = to_long(delta.num());
  const mp_limb_t start = nmod_sub(1, static_cast<mp_limb_t>(N) % mod.n, mod);
  const Expansion e = expand(r, root, 2);
  need(!riccati(e, nmod_mul(start, nmod_inv(2, mod), mod), N + 1), "no logarithm is seen");
}

} // namespace kov::certify
