#pragma once
// Real intervals for the judges of loops and of homoclinic points: every operation contains the exact result, and
// every comparison that is true is proved (what is not finite compares as false).

#include "certify/equation/facts.hpp"
#include "exact/ball.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace kov::certify {

class Interval : public Ball {
public:
  static constexpr slong bits = 128;

  Interval() = default;
  Interval(long n) { arb_set_si(v_, n); }
  explicit Interval(const Rational& q) { arb_set_fmpq(v_, q.raw(), bits); }
  [[nodiscard]] static Interval exactly(double x) {
    Interval r;
    arb_set_d(r.v_, x);
    return r;
  }
  /// From -r to r, r >= 0.
  [[nodiscard]] static Interval around_zero(const Interval& r) { return Interval().wider(r); }
  /// From 0 to x.
  [[nodiscard]] static Interval from_zero(const Interval& x) {
    Interval r;
    arb_union(r.v_, r.v_, x.v_, bits);
    return r;
  }

  friend Interval operator+(Interval a, const Interval& b) {
    return arb_add(a.v_, a.v_, b.v_, bits), a;
  }
  friend Interval operator-(Interval a, const Interval& b) {
    return arb_sub(a.v_, a.v_, b.v_, bits), a;
  }
  friend Interval operator-(Interval a) { return arb_neg(a.v_, a.v_), a; }
  friend Interval operator*(Interval a, const Interval& b) {
    return arb_mul(a.v_, a.v_, b.v_, bits), a;
  }
  friend Interval operator/(Interval a, const Interval& b) {
    return arb_div(a.v_, a.v_, b.v_, bits), a;
  }
  /// a < b for all points of the two.
  friend bool operator<(const Interval& a, const Interval& b) { return arb_lt(a.v_, b.v_) != 0; }

  [[nodiscard]] bool has_zero() const { return arb_contains_zero(v_) != 0; }
  /// 1, -1; 0 if it is not known.
  [[nodiscard]] int sign() const {
    return arb_is_positive(v_) != 0 ? 1 : arb_is_negative(v_) != 0 ? -1 : 0;
  }
  /// The middle, exact.
  [[nodiscard]] Interval middle() const {
    Interval m;
    arb_get_mid_arb(m.v_, v_);
    return m;
  }
  /// An exact upper bound of |x|.
  [[nodiscard]] Interval most() const {
    Interval m;
    arb_get_abs_ubound_arf(arb_midref(m.v_), v_, bits);
    return m;
  }
  /// On both sides by r >= 0.
  [[nodiscard]] Interval wider(const Interval& r) const {
    Interval w(*this);
    arb_add_error(w.v_, r.v_);
    return w;
  }
  [[nodiscard]] bool inside(const Interval& o) const { // strictly
    return arb_is_finite(v_) != 0 && arb_contains_interior(o.v_, v_) != 0;
  }
  /// The intersection of two enclosures of the same number.
  [[nodiscard]] Interval meet(const Interval& o) const {
    if (arb_is_finite(v_) == 0 || arb_is_finite(o.v_) == 0) throw Refused{"an enclosure is lost"};
    Interval r;
    need(arb_intersection(r.v_, v_, o.v_, bits) != 0,
         "two enclosures of the same number are apart");
    return r;
  }
  /// The middle, rounded.
  [[nodiscard]] double about() const { return arf_get_d(arb_midref(v_), ARF_RND_NEAR); }
};

/// x 2^e
[[nodiscard]] inline Interval shifted(Interval x, long e) {
  arb_mul_2exp_si(x.raw(), x.raw(), e);
  return x;
}
[[nodiscard]] inline Interval power_of_two(long e) { return shifted(1, e); }
[[nodiscard]] inline Interval larger(Interval a, const Interval& b) {
  arb_max(a.raw(), a.raw(), b.raw(), Interval::bits);
  return a;
}

[[nodiscard]] inline Interval power(const Interval& x, int n) {
  Interval r;
  arb_pow_ui(r.raw(), x.raw(), static_cast<ulong>(n), Interval::bits);
  return r;
}

} // namespace kov::certify
