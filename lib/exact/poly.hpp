#pragma once
// K[z] for a constant field K = Q or Q(a).
//
// Layout.  With d = [K:Q] the coefficient of z^i, a polynomial of degree < d in the generator, sits
// at positions i(2d-1) ... i(2d-1)+d-1 of one flat polynomial over Q (Kronecker's substitution with
// room for one product).  For K = Q this *is* FLINT's fmpq_poly; for larger K a product is one
// product of flat polynomials followed by a reduction of each block modulo the minimal polynomial.

#include "exact/number_field.hpp"

#include <utility>
#include <vector>

namespace kov {

/// A polynomial in z.  Two may be combined when their fields may (number_field.hpp).
/// Given   const Field k = make_field({-2, 0, 1}, "s");
/// Example pow(z - Poly(NfElem::generator(k)), 2)  // -> z^2 - 2*s*z + 2
class Poly {
public:
  Poly() : Poly(rationals()) {}
  explicit Poly(Field k) : k_(std::move(k)) { fmpq_poly_init(v_); }
  Poly(const NfElem& constant);
  Poly(const Rational& constant) : Poly() { fmpq_poly_set_fmpq(v_, constant.raw()); }
  Poly(std::integral auto n) : Poly(Rational(n)) {}
  Poly(const Poly& o) : Poly(o.k_) { fmpq_poly_set(v_, o.v_); }
  Poly(Poly&& o) noexcept : Poly(o.k_) { fmpq_poly_swap(v_, o.v_); }
  Poly& operator=(Poly o) noexcept {
    k_.swap(o.k_);
    fmpq_poly_swap(v_, o.v_);
    return *this;
  }
  ~Poly() { fmpq_poly_clear(v_); }

  /// The polynomial z, or c*z^i.
  [[nodiscard]] static Poly z() { return monomial(NfElem(1), 1); }
  [[nodiscard]] static Poly monomial(const NfElem& c, long i);
  /// Ascending coefficients.
  [[nodiscard]] static Poly from_coefficients(const std::vector<NfElem>& c);

  [[nodiscard]] const Field& field() const noexcept { return k_; }
  [[nodiscard]] long stride() const noexcept { return 2 * k_->degree() - 1; }
  [[nodiscard]] const fmpq_poly_struct* raw() const noexcept { return v_; } ///< the flat layout
  [[nodiscard]] fmpq_poly_struct* raw() noexcept { return v_; }
  [[nodiscard]] NfElem coeff(long i) const;
  void set_coeff(long i, const NfElem& c);

  friend Poly operator+(const Poly& a, const Poly& b);
  friend Poly operator-(const Poly& a, const Poly& b);
  friend Poly operator*(const Poly& a, const Poly& b);
  friend Poly operator-(Poly a);
  Poly& operator+=(const Poly& b) { return *this = *this + b; }
  Poly& operator-=(const Poly& b) { return *this = *this - b; }
  Poly& operator*=(const Poly& b) { return *this = *this * b; }
  friend bool operator==(const Poly& a, const Poly& b) {
    return a.k_ == b.k_ ? fmpq_poly_equal(a.v_, b.v_) : equal_over_two_fields(a, b);
  }

private:
  /// Coefficient by coefficient, since the two flat layouts differ.
  [[nodiscard]] static bool equal_over_two_fields(const Poly& a, const Poly& b);

  Field k_;
  fmpq_poly_t v_;
};

[[nodiscard]] inline bool is_zero(const Poly& f) { return fmpq_poly_is_zero(f.raw()) != 0; }
[[nodiscard]] inline bool is_one(const Poly& f) { return fmpq_poly_is_one(f.raw()) != 0; }
[[nodiscard]] long degree(const Poly& f) noexcept; ///< -1 for the zero polynomial
[[nodiscard]] NfElem lead(const Poly& f);          ///< leading coefficient; 0 for 0
/// The same polynomial over k.  Throws InvalidArgument unless k is its field or f is over Q.
[[nodiscard]] Poly coerce(const Poly& f, const Field& k);
[[nodiscard]] Poly derivative(const Poly& f); ///< d/dz
[[nodiscard]] Poly monic(const Poly& f);      ///< Throws DomainError for 0.
[[nodiscard]] Poly scale(const Poly& f, const NfElem& c);
[[nodiscard]] Poly pow(const Poly& f, unsigned long e);
[[nodiscard]] Poly shift_left(const Poly& f, long k);     ///< z^k f
[[nodiscard]] Poly shift_right(const Poly& f, long k);    ///< f div z^k
[[nodiscard]] Poly truncate(const Poly& f, long n);       ///< f mod z^n
[[nodiscard]] Poly reverse(const Poly& f, long n);        ///< z^(n-1) f(1/z); Requires deg f < n.
[[nodiscard]] Poly inverse_series(const Poly& f, long n); ///< Requires f(0) != 0.
/// Quotient and remainder.  Throws DomainError for b = 0.
/// Example divrem(z*z + 1, z - 1)  // -> {z + 1, 2}
[[nodiscard]] std::pair<Poly, Poly> divrem(const Poly& a, const Poly& b);
[[nodiscard]] Poly operator%(const Poly& a, const Poly& b); ///< Throws DomainError for b = 0.
[[nodiscard]] Poly quotient(const Poly& a, const Poly& b);  ///< Throws DomainError for b = 0.
/// a/b; the remainder must be zero (checked).
[[nodiscard]] Poly exact_div(const Poly& a, const Poly& b);
[[nodiscard]] bool divides(const Poly& b, const Poly& a); ///< b | a
/// The largest e with q^e | f, and f/q^e.  Requires f != 0, deg q > 0.
[[nodiscard]] std::pair<long, Poly> remove_factor(const Poly& f, const Poly& q);
[[nodiscard]] Poly gcd(const Poly& a, const Poly& b); ///< monic; gcd(0,0) = 0
[[nodiscard]] Poly lcm(const Poly& a, const Poly& b); ///< monic
/// a^-1 modulo q.  Throws DomainError when a and q have a common factor.
/// Example inverse_mod(z, z*z)  // -> throws DomainError
[[nodiscard]] Poly inverse_mod(const Poly& a, const Poly& q);
[[nodiscard]] Poly compose(const Poly& f, const Poly& g);        ///< f(g(z))
[[nodiscard]] Poly taylor_shift(const Poly& f, const NfElem& c); ///< f(z+c)
[[nodiscard]] NfElem evaluate(const Poly& f, const NfElem& c);
/// f at a complex point, under the chosen embedding of K.
[[nodiscard]] ComplexBall evaluate(const Poly& f, const ComplexBall& z, long bits);
/// The monic square root of a monic polynomial, if it is a square.
[[nodiscard]] std::optional<Poly> exact_sqrt(const Poly& f);
/// Norm K[z] -> Q[z]: the product over all embeddings of K.
[[nodiscard]] Poly norm(const Poly& f);
/// A polynomial in z as text that the parser reads back; descending powers.
[[nodiscard]] std::string to_string(const Poly& f, const std::string& variable = "z");
/// A total order without meaning, the same in every run (degree, then coefficients), among the
/// polynomials over one field.
[[nodiscard]] int compare(const Poly& a, const Poly& b);

} // namespace kov
