#pragma once
// K(z): quotients num/den with coprime num, den and den monic (a canonical form).

#include "exact/poly.hpp"

namespace kov {

/// An element of K(z).
/// Example RationalFunction(z*z - 1, 2*z - 2)  // -> (z + 1)/2
/// Example RationalFunction(1, z) / RationalFunction(0)  // -> throws DomainError
class RationalFunction {
public:
  RationalFunction() : den_(1) {}
  RationalFunction(Poly num) : num_(std::move(num)), den_(coerce(Poly(1), num_.field())) {}
  RationalFunction(const Rational& c) : RationalFunction(Poly(c)) {}
  RationalFunction(std::integral auto n) : RationalFunction(Poly(n)) {}
  RationalFunction(const Poly& num, const Poly& den); ///< Throws DomainError for den = 0.

  /// num/den without a gcd.  Requires num and den coprime, den != 0.
  [[nodiscard]] static RationalFunction from_coprime(Poly num, Poly den);

  [[nodiscard]] const Poly& num() const noexcept { return num_; }
  [[nodiscard]] const Poly& den() const noexcept { return den_; }
  [[nodiscard]] const Field& field() const noexcept { return num_.field(); }

  friend RationalFunction operator+(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator-(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator*(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator/(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator-(RationalFunction a);
  RationalFunction& operator+=(const RationalFunction& b) { return *this = *this + b; }
  RationalFunction& operator-=(const RationalFunction& b) { return *this = *this - b; }
  RationalFunction& operator*=(const RationalFunction& b) { return *this = *this * b; }
  friend bool operator==(const RationalFunction& a, const RationalFunction& b) {
    return a.num_ == b.num_ && a.den_ == b.den_;
  }

private:
  Poly num_;
  Poly den_;
};

[[nodiscard]] inline bool is_zero(const RationalFunction& f) { return is_zero(f.num()); }
[[nodiscard]] RationalFunction derivative(const RationalFunction& f);  ///< d/dz
[[nodiscard]] RationalFunction pow(const RationalFunction& f, long e); ///< e may be negative
/// f(g(z)).  Throws DomainError where the denominator of f vanishes at a constant g.
[[nodiscard]] RationalFunction compose(const RationalFunction& f, const RationalFunction& g);
[[nodiscard]] RationalFunction coerce(const RationalFunction& f, const Field& k);
/// deg den - deg num, Kovacic's "order at infinity".  Requires f != 0.
/// Example order_at_infinity(RationalFunction(z, pow(z, 3) + 1))  // -> 2
[[nodiscard]] long order_at_infinity(const RationalFunction& f);
/// Text that the parser reads back.
[[nodiscard]] std::string to_string(const RationalFunction& f, const std::string& variable = "z");

} // namespace kov
