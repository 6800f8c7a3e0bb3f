#pragma once
// Points of the plane where paths are planned: long floating-point numbers without radii.
//
// A plan needs no proof: the vertices are rounded to exact dyadic points, and what is claimed of
// the finished path is checked with balls (loops.hpp).

#include "exact/ball.hpp"

namespace kov::monodromy {

inline constexpr long plan_bits = 320;

/// A number, rounded to plan_bits after every operation.
class Real {
public:
  Real() = default;
  Real(long n) { arb_set_si(v_.raw(), n); }
  /// The midpoint.
  [[nodiscard]] static Real of(const arb_struct* x) {
    Real r;
    arb_set_round(r.v_.raw(), x, plan_bits);
    r.drop();
    return r;
  }

  [[nodiscard]] const arb_struct* raw() const noexcept { return v_.raw(); }

  friend Real operator+(const Real& a, const Real& b) { return made(arb_add, a, b); }
  friend Real operator-(const Real& a, const Real& b) { return made(arb_sub, a, b); }
  friend Real operator*(const Real& a, const Real& b) { return made(arb_mul, a, b); }
  friend Real operator/(const Real& a, const Real& b) { return made(arb_div, a, b); }
  friend bool operator<(const Real& a, const Real& b) {
    return arf_cmp(arb_midref(a.raw()), arb_midref(b.raw())) < 0;
  }
  friend Real hypot(const Real& a, const Real& b) { return made(arb_hypot, a, b); }
  friend Real atan2(const Real& y, const Real& x) { return made(arb_atan2, y, x); }
  /// sin and cos of pi k/n.
  static Real sin_pi(long k, long n);
  static Real cos_pi(long k, long n);
  /// The multiple of 2^e that is nearest to x.
  friend Real to_grid(const Real& x, long e);
  /// e with 2^(e-1) <= |x| < 2^e.  Requires x != 0.
  friend long exponent(const Real& x);

private:
  template <class Operation> static Real made(Operation f, const Real& a, const Real& b) {
    Real c;
    f(c.v_.raw(), a.raw(), b.raw(), plan_bits);
    c.drop();
    return c;
  }
  void drop() { mag_zero(arb_radref(v_.raw())); }
  Ball v_;
};

[[nodiscard]] inline const Real& min(const Real& a, const Real& b) { return b < a ? b : a; }
[[nodiscard]] inline const Real& max(const Real& a, const Real& b) { return a < b ? b : a; }

struct Point {
  Real x, y;

  friend Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(const Real& a, const Point& b) { return {a * b.x, a * b.y}; }
};

[[nodiscard]] inline Real abs(const Point& a) { return hypot(a.x, a.y); }
[[nodiscard]] Point point(const ComplexBall& z); ///< the midpoint
/// The same point as an exact ball.
[[nodiscard]] ComplexBall exact(const Point& a);
[[nodiscard]] Point to_grid(const Point& a, long e);
/// a turned about the origin by 2 pi k/n, counterclockwise.
[[nodiscard]] Point turned(const Point& a, long k, long n);

} // namespace kov::monodromy
