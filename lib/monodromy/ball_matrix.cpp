#include "monodromy/ball_matrix.hpp"

#include "monodromy/imprecise.hpp"

namespace kov::monodromy {

BallMatrix BallMatrix::identity(long n) {
  BallMatrix one(n);
  acb_mat_one(one.raw());
  return one;
}

BallMatrix multiply(const BallMatrix& a, const BallMatrix& b, long bits) {
  BallMatrix c(a.size());
  acb_mat_mul(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

BallMatrix inverse(const BallMatrix& a, long bits) {
  BallMatrix c(a.size());
  if (acb_mat_inv(c.raw(), a.raw(), bits) == 0)
    throw Imprecise("a transition matrix could not be inverted at this precision");
  return c;
}

BallMatrix inverse_or_unknown(const BallMatrix& a, long bits) {
  BallMatrix c(a.size());
  if (acb_mat_inv(c.raw(), a.raw(), bits) == 0) acb_mat_indeterminate(c.raw());
  return c;
}

ComplexBall trace(const BallMatrix& a, long bits) {
  ComplexBall t;
  acb_mat_trace(t.raw(), a.raw(), bits);
  return t;
}

ComplexBall determinant(const BallMatrix& a, long bits) {
  ComplexBall d;
  acb_mat_det(d.raw(), a.raw(), bits);
  return d;
}

Ball largest_radius(const BallMatrix& a) {
  mag_t most, one;
  mag_init(most);
  mag_init(one);
  for (long i = 0; i < a.size(); ++i)
    for (long j = 0; j < a.size(); ++j) {
      mag_hypot(one, arb_radref(acb_realref(a.entry(i, j))),
                arb_radref(acb_imagref(a.entry(i, j))));
      mag_max(most, most, one);
    }
  Ball r;
  arf_set_mag(arb_midref(r.raw()), most);
  mag_clear(most);
  mag_clear(one);
  return r;
}

bool overlap(const BallMatrix& a, const BallMatrix& b) {
  return acb_mat_overlaps(a.raw(), b.raw()) != 0;
}

} // namespace kov::monodromy
