#pragma once
// A number as a scene writes it: "8/9", "sqrt(11)/24", "3*pi/2", "10^-14".  It keeps the formula, so that every
// number type gets it with its own precision, and its sign is decided exactly: what a scene has and has not
// (a lever, gravity, a gyrostat, an off-diagonal moment) never depends on rounding.

#include "flow/number/conversions.hpp"
#include "flow/number/enclosure.hpp"
#include "symbol/expression.hpp"

#include <string>

namespace kov::flow {

/// A real constant of + - * / ^ sqrt and pi, times a power of two.
class Quantity {
public:
  Quantity() : Quantity("0") {}
  Quantity(const char* formula);
  /// Errors  InputError: no constant, a division by zero, the root of a negative number, or a number that
  ///         nothing tells from 0 (a sum that seems to vanish, with many roots or with pi under a root)
  Quantity(Expression e);

  [[nodiscard]] int sign() const { return sign_; } ///< -1, 0, 1: exact
  [[nodiscard]] bool is_zero() const { return sign_ == 0; }
  /// Rounded to R: the error is below that of one operation.  0 only for 0 and below the range of R.
  template <class R> [[nodiscard]] R as() const;
  /// log2 |x| to 1/100; 0 gives -infinity.
  [[nodiscard]] double log2_size() const;
  /// x 2^k; the text stays that of x.
  [[nodiscard]] Quantity shifted(long k) const;
  [[nodiscard]] std::string text() const { return std::string(e_.text()); }

  friend Quantity operator+(const Quantity& a, const Quantity& b);
  friend Quantity operator-(const Quantity& a, const Quantity& b);
  friend Quantity operator*(const Quantity& a, const Quantity& b);

private:
  Expression e_;
  int sign_ = 0;
  long shift_ = 0;
  /// An enclosure of relative radius 2^-bits.
  [[nodiscard]] Enclosure enclosed(long bits) const;
};

template <> double Quantity::as<double>() const;
template <> long double Quantity::as<long double>() const;
template <> Twin1 Quantity::as<Twin1>() const;
template <> BigReal Quantity::as<BigReal>() const;
template <> Enclosure Quantity::as<Enclosure>() const;

} // namespace kov::flow
