#pragma once
// Floating point of chosen precision over MPFR, for the same kernels as double: reference orbits to 1e-60 and
// beyond.  Rounding to nearest; the precision of results is that of the thread (PrecisionScope).

#include "flow/number/lanes.hpp"

#include <mpfr.h>

#include <concepts>
#include <string>

namespace kov::flow {

class BigReal {
public:
  BigReal() { mpfr_init2(v_, bits_), mpfr_set_zero(v_, 1); }
  BigReal(std::floating_point auto x) {
    mpfr_init2(v_, bits_);
    mpfr_set_ld(v_, static_cast<long double>(x), MPFR_RNDN);
  }
  BigReal(std::integral auto n) { mpfr_init2(v_, bits_), mpfr_set_si(v_, n, MPFR_RNDN); }
  BigReal(const BigReal& o) { mpfr_init2(v_, bits_), mpfr_set(v_, o.v_, MPFR_RNDN); }
  BigReal(BigReal&& o) noexcept : BigReal() { mpfr_swap(v_, o.v_); }
  BigReal& operator=(const BigReal& o) {
    if (this != &o) mpfr_set(v_, o.v_, MPFR_RNDN);
    return *this;
  }
  BigReal& operator=(BigReal&& o) noexcept {
    mpfr_swap(v_, o.v_);
    return *this;
  }
  ~BigReal() { mpfr_clear(v_); }

  [[nodiscard]] mpfr_srcptr raw() const noexcept { return v_; }
  [[nodiscard]] mpfr_ptr raw() noexcept { return v_; }
  [[nodiscard]] static mpfr_prec_t bits() noexcept { return bits_; }

  explicit operator double() const { return mpfr_get_d(v_, MPFR_RNDN); }

  BigReal& operator+=(const BigReal& b) { return mpfr_add(v_, v_, b.v_, MPFR_RNDN), *this; }
  BigReal& operator-=(const BigReal& b) { return mpfr_sub(v_, v_, b.v_, MPFR_RNDN), *this; }
  BigReal& operator*=(const BigReal& b) { return mpfr_mul(v_, v_, b.v_, MPFR_RNDN), *this; }
  BigReal& operator/=(const BigReal& b) { return mpfr_div(v_, v_, b.v_, MPFR_RNDN), *this; }
  friend BigReal operator+(BigReal a, const BigReal& b) { return a += b; }
  friend BigReal operator-(BigReal a, const BigReal& b) { return a -= b; }
  friend BigReal operator*(BigReal a, const BigReal& b) { return a *= b; }
  friend BigReal operator/(BigReal a, const BigReal& b) { return a /= b; }
  friend BigReal operator-(BigReal a) { return mpfr_neg(a.v_, a.v_, MPFR_RNDN), a; }
  friend bool operator==(const BigReal& a, const BigReal& b) { return mpfr_equal_p(a.v_, b.v_); }
  friend bool operator<(const BigReal& a, const BigReal& b) { return mpfr_less_p(a.v_, b.v_); }
  friend bool operator>(const BigReal& a, const BigReal& b) { return mpfr_greater_p(a.v_, b.v_); }
  friend bool operator<=(const BigReal& a, const BigReal& b) {
    return mpfr_lessequal_p(a.v_, b.v_);
  }
  friend bool operator>=(const BigReal& a, const BigReal& b) {
    return mpfr_greaterequal_p(a.v_, b.v_);
  }

private:
  friend class PrecisionScope;
  inline static thread_local mpfr_prec_t bits_ = 128;
  mpfr_t v_;
};

/// The precision of the thread's new BigReals, in bits, until the scope ends.
class PrecisionScope {
public:
  explicit PrecisionScope(long bits) : before_(BigReal::bits_) { BigReal::bits_ = bits; }
  ~PrecisionScope() { BigReal::bits_ = before_; }
  PrecisionScope(const PrecisionScope&) = delete;
  PrecisionScope& operator=(const PrecisionScope&) = delete;

private:
  mpfr_prec_t before_;
};

// Two roundings: mpfr_mul and mpfr_add are several times as fast as mpfr_fma up to 128 bits.
inline void add_product(BigReal& acc, const BigReal& a, const BigReal& b) {
  thread_local BigReal product;
  if (mpfr_get_prec(product.raw()) != BigReal::bits())
    mpfr_set_prec(product.raw(), BigReal::bits());
  mpfr_mul(product.raw(), a.raw(), b.raw(), MPFR_RNDN);
  mpfr_add(acc.raw(), acc.raw(), product.raw(), MPFR_RNDN);
}
inline void sub_product(BigReal& acc, const BigReal& a, const BigReal& b) {
  thread_local BigReal product;
  if (mpfr_get_prec(product.raw()) != BigReal::bits())
    mpfr_set_prec(product.raw(), BigReal::bits());
  mpfr_mul(product.raw(), a.raw(), b.raw(), MPFR_RNDN);
  mpfr_sub(acc.raw(), acc.raw(), product.raw(), MPFR_RNDN);
}
template <> inline BigReal unit_roundoff<BigReal>() {
  BigReal one(1);
  return mpfr_div_2ui(one.raw(), one.raw(), static_cast<unsigned long>(BigReal::bits()), MPFR_RNDN),
         one;
}
inline double log2_estimate(const BigReal& x) {
  if (!mpfr_regular_p(x.raw())) return mpfr_zero_p(x.raw()) ? -1e9 : 1e9;
  long e = 0;
  const double m = mpfr_get_d_2exp(&e, x.raw(), MPFR_RNDN);
  return static_cast<double>(e) + 2.0 * ((m < 0 ? -m : m) - 1.0);
}

inline BigReal sqrt(BigReal a) { return mpfr_sqrt(a.raw(), a.raw(), MPFR_RNDN), a; }
inline BigReal sin(BigReal a) { return mpfr_sin(a.raw(), a.raw(), MPFR_RNDN), a; }
inline BigReal cos(BigReal a) { return mpfr_cos(a.raw(), a.raw(), MPFR_RNDN), a; }
inline BigReal atan2(BigReal a, const BigReal& b) {
  return mpfr_atan2(a.raw(), a.raw(), b.raw(), MPFR_RNDN), a;
}
inline BigReal pi_of(const BigReal&) {
  BigReal p;
  mpfr_const_pi(p.raw(), MPFR_RNDN);
  return p;
}
inline double pi_of(double) { return 3.14159265358979323846; }
inline long double pi_of(long double) { return 3.141592653589793238462643383279502884L; }

/// `digits` significant decimal digits.
[[nodiscard]] std::string to_string(const BigReal& x, int digits);

} // namespace kov::flow
