#include "monodromy/point.hpp"

#include "exact/error.hpp"

namespace kov::monodromy {
namespace {

Rational half_turns(long k, long n) { return {Integer(k), Integer(n)}; }

} // namespace

Real Real::sin_pi(long k, long n) {
  Real s;
  arb_sin_pi_fmpq(s.v_.raw(), half_turns(k, n).raw(), plan_bits);
  s.drop();
  return s;
}

Real Real::cos_pi(long k, long n) {
  Real c;
  arb_cos_pi_fmpq(c.v_.raw(), half_turns(k, n).raw(), plan_bits);
  c.drop();
  return c;
}

Real to_grid(const Real& x, long e) {
  Integer n;
  arf_t shifted;
  arf_init(shifted);
  arf_mul_2exp_si(shifted, arb_midref(x.raw()), -e);
  arf_get_fmpz(n.raw(), shifted, ARF_RND_NEAR);
  arf_clear(shifted);
  Real y;
  arb_set_fmpz(y.v_.raw(), n.raw());
  arb_mul_2exp_si(y.v_.raw(), y.v_.raw(), e);
  return y;
}

long exponent(const Real& x) {
  Integer e;
  arf_abs_bound_lt_2exp_fmpz(e.raw(), arb_midref(x.raw()));
  return to_long(e);
}

Point point(const ComplexBall& z) {
  return {Real::of(acb_realref(z.raw())), Real::of(acb_imagref(z.raw()))};
}

ComplexBall exact(const Point& a) {
  ComplexBall z;
  acb_set_arb_arb(z.raw(), a.x.raw(), a.y.raw());
  return z;
}

Point to_grid(const Point& a, long e) { return {to_grid(a.x, e), to_grid(a.y, e)}; }

Point turned(const Point& a, long k, long n) {
  const Real c = Real::cos_pi(2 * k, n), s = Real::sin_pi(2 * k, n);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

} // namespace kov::monodromy
