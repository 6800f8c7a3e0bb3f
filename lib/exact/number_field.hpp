#pragma once
// Constant fields K = Q(a) = Q[x]/(m), and their elements.
//
// m is monic with integer coefficients and irreducible; K = Q is the case m = x.  Fields are
// immutable and shared; two elements may be combined when their fields are the same object or when
// one of them is Q.  The generator may carry a chosen complex root of m (for printing, and for
// questions about size); nothing algebraic depends on that choice.

#include "exact/ball.hpp"
#include "exact/flint.hpp"
#include "exact/integer.hpp"

#include <memory>
#include <string>
#include <vector>

namespace kov {

class NumberField;
using Field = std::shared_ptr<const NumberField>;

/// Q(a).  Made by make_field, and shared.
class NumberField {
public:
  /// Shape   minpoly: ascending integer coefficients, monic, irreducible (else InvalidArgument)
  ///         root: which complex root the generator means, as an index into Arb's root list
  ///         scale: the generator is scale times what the letter means; texts show the letter
  NumberField(const std::vector<Integer>& minpoly, std::string letter, int root = 0,
              Integer scale = Integer(1));
  NumberField(const NumberField&) = delete;
  NumberField& operator=(const NumberField&) = delete;
  ~NumberField();

  [[nodiscard]] long degree() const noexcept { return degree_; }
  [[nodiscard]] bool is_rational() const noexcept { return degree_ == 1; }
  /// The name of the generator: the letter, or "(3*a)".
  [[nodiscard]] std::string name() const;
  [[nodiscard]] const std::string& letter() const noexcept { return letter_; }
  [[nodiscard]] const Integer& scale() const noexcept { return scale_; }
  [[nodiscard]] const fmpz_poly_struct* minpoly() const noexcept { return minpoly_; }
  [[nodiscard]] const nf_struct* raw() const noexcept { return nf_; }
  [[nodiscard]] std::vector<Integer> minpoly_coefficients() const;

  /// The chosen complex root of the minimal polynomial, with radius below 2^-bits.
  [[nodiscard]] ComplexBall generator(long bits) const;

private:
  long degree_;
  std::string letter_;
  int root_;
  Integer scale_;
  fmpz_poly_t minpoly_;
  nf_t nf_;
};

/// The field Q itself.
[[nodiscard]] const Field& rationals();
/// A new field; arguments and errors as for NumberField.
/// Example make_field({-4, 0, 1}, "s")->degree()  // -> throws InvalidArgument
[[nodiscard]] Field make_field(const std::vector<Integer>& minpoly, std::string letter,
                               int root = 0, Integer scale = Integer(1));
/// The same object, or the same minimal polynomial: then the same coordinates are the same element of Q[x]/(m).
[[nodiscard]] bool same_minimal_polynomial(const Field& a, const Field& b);
/// The larger of two fields, one of which is Q or both of which are the same object; otherwise
/// InvalidArgument.
[[nodiscard]] const Field& common_field(const Field& a, const Field& b);

/// Reduces every block of length 2d-1 of a flat integer polynomial modulo m, in place.
/// (The layout of exact/poly.hpp; m monic and integral keeps numerators integral.)
void reduce_blocks(fmpz_poly_t flat, const NumberField& k);

/// An element of K, as a polynomial of degree < [K:Q] in the generator.
/// Given   const NfElem s = NfElem::generator(make_field({-2, 0, 1}, "s"));
/// Example inverse(s - 1)  // -> s + 1
class NfElem {
public:
  NfElem() : NfElem(rationals()) {}
  explicit NfElem(Field k) : k_(std::move(k)) { fmpq_poly_init(v_); }
  NfElem(const Rational& q, Field k = rationals()) : NfElem(std::move(k)) {
    fmpq_poly_set_fmpq(v_, q.raw());
  }
  NfElem(std::integral auto n) : NfElem(Rational(n)) {}
  NfElem(const NfElem& o) : NfElem(o.k_) { fmpq_poly_set(v_, o.v_); }
  NfElem(NfElem&& o) noexcept : NfElem(o.k_) { fmpq_poly_swap(v_, o.v_); }
  NfElem& operator=(NfElem o) noexcept {
    k_.swap(o.k_);
    fmpq_poly_swap(v_, o.v_);
    return *this;
  }
  ~NfElem() { fmpq_poly_clear(v_); }

  [[nodiscard]] static NfElem generator(const Field& k);

  [[nodiscard]] const Field& field() const noexcept { return k_; }
  [[nodiscard]] const fmpq_poly_struct* raw() const noexcept { return v_; }
  [[nodiscard]] fmpq_poly_struct* raw() noexcept { return v_; }
  [[nodiscard]] Rational coeff(long i) const; ///< of a^i

  friend NfElem operator+(const NfElem& a, const NfElem& b);
  friend NfElem operator-(const NfElem& a, const NfElem& b);
  friend NfElem operator*(const NfElem& a, const NfElem& b);
  friend NfElem operator/(const NfElem& a, const NfElem& b); ///< Throws DomainError for b = 0.
  friend NfElem operator-(NfElem a);
  NfElem& operator+=(const NfElem& b) { return *this = *this + b; }
  NfElem& operator-=(const NfElem& b) { return *this = *this - b; }
  NfElem& operator*=(const NfElem& b) { return *this = *this * b; }
  /// Irrational elements of fields with two minimal polynomials are different.
  friend bool operator==(const NfElem& a, const NfElem& b) {
    return fmpq_poly_equal(a.v_, b.v_) &&
           (fmpq_poly_degree(a.v_) <= 0 || same_minimal_polynomial(a.k_, b.k_));
  }

private:
  Field k_;
  fmpq_poly_t v_;
};

[[nodiscard]] inline bool is_zero(const NfElem& a) { return fmpq_poly_is_zero(a.raw()) != 0; }
[[nodiscard]] inline bool is_one(const NfElem& a) { return fmpq_poly_is_one(a.raw()) != 0; }
[[nodiscard]] bool is_rational(const NfElem& a);
[[nodiscard]] Rational to_rational(const NfElem& a); ///< Requires is_rational(a).
[[nodiscard]] NfElem inverse(const NfElem& a);       ///< Throws DomainError for 0.
[[nodiscard]] NfElem pow(const NfElem& a, unsigned long e);
/// The same element in the field k (k is its field, or a is in Q).
[[nodiscard]] NfElem coerce(const NfElem& a, const Field& k);
/// Enclosure under the chosen embedding K -> C.
[[nodiscard]] ComplexBall embed(const NfElem& a, long bits);
/// c with a = c[0] + c[1] x + ..., x what the letter of the field means.
[[nodiscard]] std::vector<Rational> shown_coefficients(const NfElem& a);
/// Text that the expression parser reads back, in the letter of the field.
[[nodiscard]] std::string to_string(const NfElem& a);
/// A square root in K, if there is one (of the two, no particular one).
/// Example exact_sqrt(s)  // -> none
[[nodiscard]] std::optional<NfElem> exact_sqrt(const NfElem& a);

} // namespace kov
