#pragma once
// Z and Q as values over FLINT's fmpz and fmpq.

#include "exact/flint.hpp"

#include <compare>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace kov {

/// An integer of any size.
/// Example pow(Integer(2), 100)  // -> 1267650600228229401496703205376
class Integer {
public:
  Integer() noexcept { fmpz_init(v_); }
  Integer(std::signed_integral auto n) : Integer() { fmpz_set_si(v_, static_cast<slong>(n)); }
  Integer(std::unsigned_integral auto n) : Integer() { fmpz_set_ui(v_, static_cast<ulong>(n)); }
  explicit Integer(const fmpz_t n) : Integer() { fmpz_set(v_, n); }
  Integer(const Integer& o) : Integer() { fmpz_set(v_, o.v_); }
  Integer(Integer&& o) noexcept : Integer() { fmpz_swap(v_, o.v_); }
  Integer& operator=(Integer o) noexcept {
    fmpz_swap(v_, o.v_);
    return *this;
  }
  ~Integer() { fmpz_clear(v_); }

  /// Decimal digits, perhaps after a minus sign, and nothing else.  Throws InvalidArgument.
  [[nodiscard]] static Integer parse(std::string_view text);

  [[nodiscard]] const fmpz* raw() const noexcept { return v_; }
  [[nodiscard]] fmpz* raw() noexcept { return v_; }

  Integer& operator+=(const Integer& b) { return fmpz_add(v_, v_, b.v_), *this; }
  Integer& operator-=(const Integer& b) { return fmpz_sub(v_, v_, b.v_), *this; }
  Integer& operator*=(const Integer& b) { return fmpz_mul(v_, v_, b.v_), *this; }
  friend Integer operator+(Integer a, const Integer& b) { return a += b; }
  friend Integer operator-(Integer a, const Integer& b) { return a -= b; }
  friend Integer operator*(Integer a, const Integer& b) { return a *= b; }
  friend Integer operator-(Integer a) { return fmpz_neg(a.v_, a.v_), a; }
  friend bool operator==(const Integer& a, const Integer& b) { return fmpz_equal(a.v_, b.v_); }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
    return fmpz_cmp(a.v_, b.v_) <=> 0;
  }

private:
  fmpz_t v_;
};

[[nodiscard]] inline bool is_zero(const Integer& n) { return fmpz_is_zero(n.raw()) != 0; }
[[nodiscard]] inline int sign(const Integer& n) { return fmpz_sgn(n.raw()); }
[[nodiscard]] inline bool fits_long(const Integer& n) { return fmpz_fits_si(n.raw()) != 0; }
[[nodiscard]] long to_long(const Integer& n); ///< Requires fits_long(n).
[[nodiscard]] std::string to_string(const Integer& n);
[[nodiscard]] Integer gcd(const Integer& a, const Integer& b); ///< >= 0; gcd(0, 0) = 0
[[nodiscard]] Integer lcm(const Integer& a, const Integer& b); ///< >= 0
[[nodiscard]] Integer pow(const Integer& a, unsigned long e);
[[nodiscard]] Integer exact_div(const Integer& a, const Integer& b); ///< Requires b != 0, b | a.
[[nodiscard]] Integer floor_div(const Integer& a, const Integer& b); ///< Requires b != 0.
[[nodiscard]] std::optional<Integer>
exact_sqrt(const Integer& n); ///< the root >= 0, if n is a square

/// d = s^2 n with s > 0; returns (s, n).  n is free of squares of primes below 10000, and of all
/// squares if it then fits a machine word.  Requires d != 0.
/// Example square_part(-12)  // -> {2, -3}
[[nodiscard]] std::pair<Integer, Integer> square_part(Integer d);

/// A fraction in lowest terms with a positive denominator.
/// Example Rational(6, -4)  // -> -3/2
/// Example Rational(1, 0)  // -> throws DomainError
class Rational {
public:
  Rational() noexcept { fmpq_init(v_); }
  Rational(std::integral auto n) : Rational(Integer(n)) {}
  Rational(const Integer& n) : Rational() { fmpz_set(fmpq_numref(v_), n.raw()); }
  Rational(const Integer& n, const Integer& d); ///< Throws DomainError when d = 0.
  explicit Rational(const fmpq_t q) : Rational() { fmpq_set(v_, q); }
  Rational(const Rational& o) : Rational() { fmpq_set(v_, o.v_); }
  Rational(Rational&& o) noexcept : Rational() { fmpq_swap(v_, o.v_); }
  Rational& operator=(Rational o) noexcept {
    fmpq_swap(v_, o.v_);
    return *this;
  }
  ~Rational() { fmpq_clear(v_); }

  /// "n" or "n/d".  Throws InvalidArgument or DomainError.
  [[nodiscard]] static Rational parse(std::string_view text);

  [[nodiscard]] const fmpq* raw() const noexcept { return v_; }
  [[nodiscard]] fmpq* raw() noexcept { return v_; }
  [[nodiscard]] Integer num() const { return Integer(fmpq_numref(v_)); }
  [[nodiscard]] Integer den() const { return Integer(fmpq_denref(v_)); }

  Rational& operator+=(const Rational& b) { return fmpq_add(v_, v_, b.v_), *this; }
  Rational& operator-=(const Rational& b) { return fmpq_sub(v_, v_, b.v_), *this; }
  Rational& operator*=(const Rational& b) { return fmpq_mul(v_, v_, b.v_), *this; }
  Rational& operator/=(const Rational& b);
  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend Rational operator-(Rational a) { return fmpq_neg(a.v_, a.v_), a; }
  friend bool operator==(const Rational& a, const Rational& b) { return fmpq_equal(a.v_, b.v_); }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return fmpq_cmp(a.v_, b.v_) <=> 0;
  }

private:
  fmpq_t v_;
};

[[nodiscard]] inline bool is_zero(const Rational& q) { return fmpq_is_zero(q.raw()) != 0; }
[[nodiscard]] inline bool is_integer(const Rational& q) {
  return fmpz_is_one(fmpq_denref(q.raw())) != 0;
}
[[nodiscard]] inline int sign(const Rational& q) { return fmpq_sgn(q.raw()); }
[[nodiscard]] std::string to_string(const Rational& q);
[[nodiscard]] Integer floor(const Rational& q);
[[nodiscard]] Integer ceil(const Rational& q);
[[nodiscard]] Rational abs(const Rational& q);
[[nodiscard]] std::optional<Rational> exact_sqrt(const Rational& q); ///< the root >= 0

} // namespace kov
