#include "exact/modular.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <array>

namespace kov {

NmodPoly derivative(const NmodPoly& f) {
  NmodPoly g(f.modulus());
  nmod_poly_derivative(g.raw(), f.raw());
  return g;
}

NmodPoly scale(const NmodPoly& f, mp_limb_t c) {
  NmodPoly g(f.modulus());
  nmod_poly_scalar_mul_nmod(g.raw(), f.raw(), c);
  return g;
}

NmodPoly gcd(const NmodPoly& a, const NmodPoly& b) {
  NmodPoly g(a.modulus());
  nmod_poly_gcd(g.raw(), a.raw(), b.raw());
  return g;
}

NmodPoly exact_div(const NmodPoly& a, const NmodPoly& b) {
  NmodPoly q(a.modulus());
  nmod_poly_div(q.raw(), a.raw(), b.raw());
  return q;
}

NmodPoly truncate(const NmodPoly& f, long n) {
  NmodPoly g = f;
  nmod_poly_truncate(g.raw(), n);
  return g;
}

NmodPoly mul_series(const NmodPoly& a, const NmodPoly& b, long n) {
  NmodPoly c(a.modulus());
  nmod_poly_mullow(c.raw(), a.raw(), b.raw(), n);
  return c;
}

NmodPoly inverse_series(const NmodPoly& f, long n) {
  NmodPoly g(f.modulus());
  nmod_poly_inv_series(g.raw(), f.raw(), n);
  return g;
}

NmodPoly pow_series(const NmodPoly& f, unsigned long e, long n) {
  NmodPoly g(f.modulus());
  nmod_poly_pow_trunc(g.raw(), f.raw(), e, n);
  return g;
}

NmodPoly taylor_shift(const NmodPoly& f, mp_limb_t c) {
  NmodPoly g(f.modulus());
  nmod_poly_taylor_shift(g.raw(), f.raw(), c);
  return g;
}

mp_limb_t evaluate(const NmodPoly& f, mp_limb_t c) { return nmod_poly_evaluate_nmod(f.raw(), c); }

namespace {

// The roots of z^2 + 2 b z + c, ascending; p odd.
std::vector<mp_limb_t> quadratic_roots(const NmodPoly& f) {
  const nmod_t mod = f.mod();
  const mp_limb_t b = nmod_div(f.coeff(1), 2, mod);
  const mp_limb_t square = nmod_sub(nmod_mul(b, b, mod), f.coeff(0), mod);
  const mp_limb_t w = n_sqrtmod(square, mod.n);
  if (w == 0 && square != 0) return {}; // not a square
  const mp_limb_t x = nmod_sub(w, b, mod);
  const mp_limb_t y = nmod_sub(nmod_neg(w, mod), b, mod);
  if (x == y) return {x};
  return {std::min(x, y), std::max(x, y)};
}

} // namespace

std::vector<mp_limb_t> roots(const NmodPoly& f) {
  if (is_zero(f)) throw InvalidArgument("the zero polynomial has no root list");
  std::vector<mp_limb_t> found;
  if (degree(f) < 1) return found;
  const mp_limb_t p = f.modulus();
  // gcd(f, z^p - z) is the product of the linear factors
  NmodPoly monic(p);
  nmod_poly_make_monic(monic.raw(), f.raw());
  NmodPoly frobenius(p);
  NmodPoly z(p);
  z.set_coeff(1, 1);
  if (degree(monic) == 1) return {nmod_neg(monic.coeff(0), monic.mod())};
  if (degree(monic) == 2 && p > 2) return quadratic_roots(monic);
  nmod_poly_powmod_ui_binexp(frobenius.raw(), z.raw(), p, monic.raw());
  const NmodPoly linear = gcd(frobenius - z, monic);
  if (degree(linear) < 1) return found;
  nmod_poly_factor_t factors;
  nmod_poly_factor_init(factors);
  if (degree(linear) == 1)
    nmod_poly_factor_insert(factors, linear.raw(), 1);
  else
    nmod_poly_factor_equal_deg(factors, linear.raw(), 1);
  for (slong i = 0; i < factors->num; ++i) {
    const nmod_poly_struct* g = factors->p + i;
    const mp_limb_t c1 = nmod_poly_get_coeff_ui(g, 1);
    const mp_limb_t c0 = nmod_poly_get_coeff_ui(g, 0);
    found.push_back(nmod_neg(nmod_div(c0, c1, f.mod()), f.mod()));
  }
  nmod_poly_factor_clear(factors);
  std::ranges::sort(found);
  return found;
}

std::optional<mp_limb_t> PrimeIdeal::reduce(const Rational& q) const {
  const mp_limb_t d = fmpz_fdiv_ui(fmpq_denref(q.raw()), p);
  if (d == 0) return std::nullopt;
  nmod_t mod;
  nmod_init(&mod, p);
  return nmod_div(fmpz_fdiv_ui(fmpq_numref(q.raw()), p), d, mod);
}

std::optional<mp_limb_t> PrimeIdeal::reduce(const NfElem& a) const {
  const mp_limb_t d = fmpz_fdiv_ui(fmpq_poly_denref(a.raw()), p);
  if (d == 0) return std::nullopt;
  nmod_t mod;
  nmod_init(&mod, p);
  mp_limb_t value = 0;
  for (long i = fmpq_poly_degree(a.raw()); i >= 0; --i)
    value = nmod_add(nmod_mul(value, generator, mod),
                     fmpz_fdiv_ui(fmpq_poly_numref(a.raw()) + i, p), mod);
  return nmod_div(value, d, mod);
}

std::optional<NmodPoly> PrimeIdeal::reduce(const Poly& f) const {
  const mp_limb_t den = fmpz_fdiv_ui(fmpq_poly_denref(f.raw()), p);
  if (den == 0) return std::nullopt;
  NmodPoly g(p);
  const nmod_t mod = g.mod();
  const long s = f.stride();
  const long length = fmpq_poly_length(f.raw());
  const fmpz* c = fmpq_poly_numref(f.raw());
  const mp_limb_t unit = nmod_inv(den, mod);
  for (long i = (length - 1) / s; i >= 0 && length > 0; --i) {
    mp_limb_t value = 0;
    for (long j = std::min(s, length - i * s) - 1; j >= 0; --j)
      value = nmod_add(nmod_mul(value, generator, mod), fmpz_fdiv_ui(c + i * s + j, p), mod);
    g.set_coeff(i, nmod_mul(value, unit, mod));
  }
  return g;
}

PrimeIdeals::PrimeIdeals(Field k, mp_limb_t start) : k_(std::move(k)), p_(start) {}

PrimeIdeals PrimeIdeals::large(const Field& k) { return {k, (mp_limb_t{1} << 60) + 12345}; }

namespace {

// The roots of the minimal polynomial of K modulo p; empty when p ramifies or has none.
std::vector<mp_limb_t> generator_images(const NumberField& k, mp_limb_t p) {
  NmodPoly m(p);
  fmpz_poly_get_nmod_poly(m.raw(), k.minpoly());
  if (degree(gcd(m, derivative(m))) != 0) return {};
  return roots(m);
}

// The first primes of a field are asked for again and again: the latest answers.
class LatestIdeals {
public:
  [[nodiscard]] const PrimeIdeal* after(const Field& k, mp_limb_t p) const {
    const auto at =
        std::ranges::find_if(latest_, [&](const Entry& e) { return e.p == p && e.k == k; });
    return at == latest_.end() ? nullptr : &at->found;
  }
  void keep(const Field& k, mp_limb_t p, const PrimeIdeal& found) {
    latest_[next_++ % latest_.size()] = {k, p, found};
  }

private:
  struct Entry {
    Field k; // shared, so that no other field gets its address
    mp_limb_t p = 0;
    PrimeIdeal found;
  };
  std::array<Entry, 16> latest_;
  std::size_t next_ = 0;
};

} // namespace

PrimeIdeal PrimeIdeals::next() {
  thread_local LatestIdeals latest;
  const mp_limb_t start = p_;
  if (const PrimeIdeal* known = latest.after(k_, start)) {
    p_ = known->p;
    return *known;
  }
  const PrimeIdeal found = search();
  latest.keep(k_, start, found);
  return found;
}

PrimeIdeal PrimeIdeals::search() {
  for (int tries = 0; tries < 20000; ++tries) {
    p_ = n_nextprime(p_, 0);
    if (k_->is_rational()) return {p_, 0};
    const auto images = generator_images(*k_, p_);
    if (!images.empty()) return {p_, images.front()};
  }
  throw OutOfBudget("no prime ideal of degree one found among 20000 primes");
}

std::vector<PrimeIdeal> PrimeIdeals::next_split() {
  if (k_->is_rational()) return {next()};
  for (int tries = 0; tries < 20000; ++tries) {
    p_ = n_nextprime(p_, 0);
    const auto images = generator_images(*k_, p_);
    if (static_cast<long>(images.size()) != k_->degree()) continue;
    return mapped<PrimeIdeal>(images, [&](const mp_limb_t image) { return PrimeIdeal{p_, image}; });
  }
  throw OutOfBudget("no completely split prime found among 20000 primes");
}

std::optional<Rational> rational_reconstruction(const Integer& c, const Integer& m) {
  Rational q;
  if (!fmpq_reconstruct_fmpz(q.raw(), c.raw(), m.raw())) return std::nullopt;
  return q;
}

std::optional<long> gcd_degree_bound(const Poly& a, const Poly& b) {
  if (is_zero(a) || is_zero(b)) return std::nullopt;
  PrimeIdeals primes = PrimeIdeals::large(common_field(a.field(), b.field()));
  const PrimeIdeal prime = primes.next();
  const auto x = prime.reduce(a);
  const auto y = prime.reduce(b);
  // If one leading coefficient survives, a common factor keeps its degree.
  if (!x || !y || (degree(*x) != degree(a) && degree(*y) != degree(b))) return std::nullopt;
  return degree(gcd(*x, *y));
}

bool provably_coprime(const Poly& a, const Poly& b) { return gcd_degree_bound(a, b) == 0L; }

} // namespace kov
