#pragma once
// Upper bounds of numbers >= 0 (Arb's mag), every operation rounded upwards.

#include "exact/ball.hpp"

namespace kov::monodromy {

class Magnitude {
public:
  Magnitude() noexcept { mag_init(v_); }
  Magnitude(unsigned long n) noexcept : Magnitude() { mag_set_ui(v_, n); }
  Magnitude(const Magnitude& o) : Magnitude() { mag_set(v_, o.v_); }
  Magnitude(Magnitude&& o) noexcept : Magnitude() { mag_swap(v_, o.v_); }
  Magnitude& operator=(Magnitude o) noexcept {
    mag_swap(v_, o.v_);
    return *this;
  }
  ~Magnitude() { mag_clear(v_); }

  [[nodiscard]] static Magnitude of(const acb_t z) {
    Magnitude m;
    acb_get_mag(m.v_, z);
    return m;
  }
  /// |re + i im| for integers.
  [[nodiscard]] static Magnitude of(const Integer& re, const Integer& im) {
    Magnitude x, y;
    mag_set_fmpz(x.v_, re.raw());
    mag_set_fmpz(y.v_, im.raw());
    mag_hypot(x.v_, x.v_, y.v_);
    return x;
  }

  [[nodiscard]] const mag_struct* raw() const noexcept { return v_; }
  [[nodiscard]] mag_struct* raw() noexcept { return v_; }

  Magnitude& operator+=(const Magnitude& b) { return mag_add(v_, v_, b.v_), *this; }
  Magnitude& operator*=(const Magnitude& b) { return mag_mul(v_, v_, b.v_), *this; }
  /// b a lower bound of the divisor; infinite for b = 0.
  Magnitude& operator/=(const Magnitude& b) { return mag_div(v_, v_, b.v_), *this; }
  friend Magnitude operator+(Magnitude a, const Magnitude& b) { return a += b; }
  friend Magnitude operator*(Magnitude a, const Magnitude& b) { return a *= b; }
  friend Magnitude operator/(Magnitude a, const Magnitude& b) { return a /= b; }
  friend bool operator<(const Magnitude& a, const Magnitude& b) { return mag_cmp(a.v_, b.v_) < 0; }
  friend bool operator==(const Magnitude& a, const Magnitude& b) { return mag_equal(a.v_, b.v_); }

private:
  mag_t v_;
};

[[nodiscard]] inline Magnitude max(const Magnitude& a, const Magnitude& b) { return a < b ? b : a; }
[[nodiscard]] inline Magnitude exp(const Magnitude& a) {
  Magnitude m;
  mag_exp(m.raw(), a.raw());
  return m;
}
/// max(0, a - b), rounded down.
[[nodiscard]] inline Magnitude less(const Magnitude& a, const Magnitude& b) {
  Magnitude d;
  mag_sub_lower(d.raw(), a.raw(), b.raw());
  return d;
}
/// a 2^e
[[nodiscard]] inline Magnitude times_power_of_two(const Magnitude& a, long e) {
  Magnitude m;
  mag_mul_2exp_si(m.raw(), a.raw(), e);
  return m;
}
[[nodiscard]] inline bool is_zero(const Magnitude& a) { return mag_is_zero(a.raw()) != 0; }
[[nodiscard]] inline bool is_finite(const Magnitude& a) { return mag_is_finite(a.raw()) != 0; }
/// The least e with a <= 2^e, within the range of long; 0 for a = 0.
[[nodiscard]] long exponent(const Magnitude& a);

} // namespace kov::monodromy
