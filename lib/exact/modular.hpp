#pragma once
// Reduction modulo a prime ideal of degree one: K -> F_p, a -> one simple root of the minimal
// polynomial modulo p.  Proofs of absence need one such prime only.

#include "exact/poly.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace kov {

/// A polynomial over F_p, p < 2^63, as a value over FLINT's nmod_poly.
class NmodPoly {
public:
  explicit NmodPoly(mp_limb_t p) { nmod_poly_init(v_, p); }
  NmodPoly(const NmodPoly& o) : NmodPoly(o.modulus()) { nmod_poly_set(v_, o.v_); }
  NmodPoly(NmodPoly&& o) noexcept : NmodPoly(o.modulus()) { nmod_poly_swap(v_, o.v_); }
  NmodPoly& operator=(NmodPoly o) noexcept {
    std::swap(*v_, *o.v_); // nmod_poly_swap of FLINT 2.9 leaves the moduli where they are
    return *this;
  }
  ~NmodPoly() { nmod_poly_clear(v_); }

  [[nodiscard]] mp_limb_t modulus() const noexcept { return v_->mod.n; }
  [[nodiscard]] nmod_t mod() const noexcept { return v_->mod; }
  [[nodiscard]] const nmod_poly_struct* raw() const noexcept { return v_; }
  [[nodiscard]] nmod_poly_struct* raw() noexcept { return v_; }
  [[nodiscard]] mp_limb_t coeff(long i) const { return nmod_poly_get_coeff_ui(v_, i); }
  void set_coeff(long i, mp_limb_t c) { nmod_poly_set_coeff_ui(v_, i, c); }

  friend NmodPoly operator+(const NmodPoly& a, const NmodPoly& b) {
    NmodPoly c(a.modulus());
    nmod_poly_add(c.v_, a.v_, b.v_);
    return c;
  }
  friend NmodPoly operator-(const NmodPoly& a, const NmodPoly& b) {
    NmodPoly c(a.modulus());
    nmod_poly_sub(c.v_, a.v_, b.v_);
    return c;
  }
  friend NmodPoly operator*(const NmodPoly& a, const NmodPoly& b) {
    NmodPoly c(a.modulus());
    nmod_poly_mul(c.v_, a.v_, b.v_);
    return c;
  }
  friend bool operator==(const NmodPoly& a, const NmodPoly& b) {
    return nmod_poly_equal(a.v_, b.v_);
  }

private:
  nmod_poly_t v_;
};

[[nodiscard]] inline long degree(const NmodPoly& f) { return nmod_poly_degree(f.raw()); }
[[nodiscard]] inline bool is_zero(const NmodPoly& f) { return nmod_poly_is_zero(f.raw()) != 0; }
// As for Poly; polynomials of one modulus only.
[[nodiscard]] NmodPoly derivative(const NmodPoly& f);
[[nodiscard]] NmodPoly scale(const NmodPoly& f, mp_limb_t c);
[[nodiscard]] NmodPoly gcd(const NmodPoly& a, const NmodPoly& b);
[[nodiscard]] NmodPoly exact_div(const NmodPoly& a, const NmodPoly& b); ///< Requires b | a.
[[nodiscard]] NmodPoly truncate(const NmodPoly& f, long n);             ///< f mod z^n
[[nodiscard]] NmodPoly mul_series(const NmodPoly& a, const NmodPoly& b, long n); ///< ab mod z^n
[[nodiscard]] NmodPoly inverse_series(const NmodPoly& f, long n); ///< Requires f(0) != 0.
[[nodiscard]] NmodPoly pow_series(const NmodPoly& f, unsigned long e, long n); ///< f^e mod z^n
[[nodiscard]] NmodPoly taylor_shift(const NmodPoly& f, mp_limb_t c);           ///< f(z+c)
[[nodiscard]] mp_limb_t evaluate(const NmodPoly& f, mp_limb_t c);
/// The roots of f in F_p, without multiplicity.
[[nodiscard]] std::vector<mp_limb_t> roots(const NmodPoly& f);

/// A prime ideal of degree one of K, given by p and the image of the generator.
/// Example PrimeIdeal{7, 0}.reduce(Rational(1, 2))  // -> 4
/// Example PrimeIdeal{7, 0}.reduce(Rational(1, 7))  // -> none
struct PrimeIdeal {
  mp_limb_t p = 0;
  mp_limb_t generator = 0;

  /// The residue of a constant; nothing when p divides its denominator.
  [[nodiscard]] std::optional<mp_limb_t> reduce(const NfElem& a) const;
  [[nodiscard]] std::optional<NmodPoly> reduce(const Poly& f) const;
  [[nodiscard]] std::optional<mp_limb_t> reduce(const Rational& q) const;
};

/// Walks through prime ideals of degree one, their primes ascending from just above `start`.
/// Requires that the minimal polynomial stay squarefree modulo p (others are skipped).
/// Example PrimeIdeals(make_field({1, 0, 1}, "I"), 2).next().p  // -> 5
class PrimeIdeals {
public:
  PrimeIdeals(Field k, mp_limb_t start);
  [[nodiscard]] static PrimeIdeals large(const Field& k); ///< from just above 2^60
  /// The next prime ideal; one per rational prime.
  [[nodiscard]] PrimeIdeal next();
  /// The next rational prime that splits completely: all [K:Q] ideals above it.
  /// Cost  about [K:Q]! primes in the worst case; gives up (OutOfBudget) after 20000.
  [[nodiscard]] std::vector<PrimeIdeal> next_split();

private:
  [[nodiscard]] PrimeIdeal search();

  Field k_;
  mp_limb_t p_;
};

/// a/b = c with |a|,|b| bounded by sqrt(m/2): Wang's rational reconstruction.
[[nodiscard]] std::optional<Rational> rational_reconstruction(const Integer& c, const Integer& m);

/// An upper bound of deg gcd(a, b), from one prime; nothing if that prime is not good.
[[nodiscard]] std::optional<long> gcd_degree_bound(const Poly& a, const Poly& b);
/// True only if gcd(a, b) = 1 is certain (tested modulo one prime); false says nothing.
[[nodiscard]] bool provably_coprime(const Poly& a, const Poly& b);

} // namespace kov
