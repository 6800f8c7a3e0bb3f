#pragma once
// The constants of the Taylor recurrences, and the labels of the axes.
//
// L = lambda Lh with lambda = max |L_i|, and e, f span the plane orthogonal to Lh with e.I^-1 f = 0, so
//   Lh x Gamma = alpha e + beta f,   alpha = p.Gamma,   beta = q.Gamma,
//   D - 1 = m v.I^-1 v = c_alpha alpha^2 + c_beta beta^2        (no mixed term, no square root).
// If L lies on a principal axis, the labels 1, 2, 3 are turned cyclically so that this axis is the first;
// then e, f are the other two axes, alpha = -+Gamma_3, beta = +-Gamma_2, and the sign of L is in Lh_1.

#include "flow/orbit/body.hpp"

namespace kov::flow {

template <class T> struct Model {
  int shift = 0; ///< inner axis i is the body axis (i + shift) mod 3
  T inertia[3][3], inverse[3][3];
  T euler[3];        ///< (I2-I3)/I1, ... for principal axes
  T spin[3][3];      ///< I^-1 [B]x : the gyrostat's part of -Omega'
  T lever[3];        ///< Lh
  T p[3], q[3];      ///< alpha = p.Gamma, beta = q.Gamma
  T e[3], f[3];      ///< the basis
  T ae[3], af[3];    ///< I^-1 e/(e.I^-1 e), I^-1 f/(f.I^-1 f)
  T c_alpha, c_beta; ///< m lambda^2 e.I^-1 e, ...
  T g_alpha, g_beta; ///< m g lambda e.I^-1 e, ...
  T m_lambda2;       ///< m lambda^2
  T m_g_lambda;      ///< m g lambda
  T gyro[3];         ///< B
};

template <class R> bool is_null(const R& x) { return x == R(0); }

/// The set of effects that the body needs, and nothing more.
template <class R> Effects effects_of(const Body<R>& b) {
  int nonzero = 0;
  for (const R& l : b.lever)
    nonzero += is_null(l) ? 0 : 1;
  Effects e;
  e.gravity = nonzero > 0 && !is_null(b.gravity) && !is_null(b.mass);
  e.sliding = nonzero > 0 && b.sliding && !is_null(b.mass);
  for (int i = 0; i < 3; ++i) {
    e.gyrostat = e.gyrostat || !is_null(b.gyrostat[i]);
    e.full_inertia = e.full_inertia || !is_null(b.inertia[i][(i + 1) % 3]);
  }
  e.axial = e.lever() && nonzero == 1 && !e.full_inertia;
  return e;
}

namespace detail {

template <class R> int first_axis(const Body<R>& b, const Effects& e) {
  for (int i = 0; e.axial && i < 3; ++i)
    if (!is_null(b.lever[i])) return i;
  return 0;
}

template <class R> void copy(R (&out)[3], const Vec<R>& v) {
  for (int i = 0; i < 3; ++i)
    out[i] = v[i];
}

template <class R> R magnitude(const R& x) { return x < R(0) ? R(-x) : x; }

// Lever: lambda, Lh, and the two conjugate directions orthogonal to Lh.
template <class R>
void set_lever(Model<R>& c, const Mat<R>& a, const Vec<R>& lever, const Body<R>& b, bool axial) {
  int largest = 0, smallest = 0;
  for (int i = 1; i < 3; ++i) {
    if (magnitude(lever[i]) > magnitude(lever[largest])) largest = i;
    if (magnitude(lever[i]) < magnitude(lever[smallest])) smallest = i;
  }
  const R lambda = magnitude(lever[largest]);
  if (is_null(lambda)) return;
  const Vec<R> lh{lever[0] / lambda, lever[1] / lambda, lever[2] / lambda};
  Vec<R> axis{R(0), R(0), R(0)};
  axis[axial ? 2 : smallest] = R(1);
  const Vec<R> e = axial ? Vec<R>{R(0), R(1), R(0)} : cross(lh, axis);
  const Vec<R> f = axial ? axis : cross(lh, times(a, e));
  const Vec<R> ae = times(a, e), af = times(a, f);
  const R eae = dot(e, ae), faf = dot(f, af);
  copy(c.lever, lh);
  copy(c.e, e);
  copy(c.f, f);
  copy(c.ae, scaled(R(R(1) / eae), ae));
  copy(c.af, scaled(R(R(1) / faf), af));
  copy(c.p, scaled(R(R(1) / eae), cross(ae, lh)));
  copy(c.q, scaled(R(R(1) / faf), cross(af, lh)));
  c.m_lambda2 = b.mass * lambda * lambda;
  c.m_g_lambda = b.mass * b.gravity * lambda;
  c.c_alpha = c.m_lambda2 * eae;
  c.c_beta = c.m_lambda2 * faf;
  c.g_alpha = c.m_g_lambda * eae;
  c.g_beta = c.m_g_lambda * faf;
  if (axial) { // the recurrences use Gamma_3, Gamma_2 for -alpha, beta: the sign of L goes here
    c.g_alpha = c.g_alpha * lh[0];
    c.g_beta = c.g_beta * lh[0];
  }
}

} // namespace detail

/// Requires a positive definite inertia; e must cover effects_of(b).
template <class R> Model<R> model_of(const Body<R>& b, const Effects& e) {
  Model<R> c{};
  c.shift = detail::first_axis(b, e);
  const auto turn = [&](int i) { return (i + c.shift) % 3; };
  Mat<R> inertia{};
  Vec<R> lever{}, gyro{};
  for (int i = 0; i < 3; ++i) {
    lever[i] = b.lever[turn(i)];
    gyro[i] = b.gyrostat[turn(i)];
    for (int j = 0; j < 3; ++j)
      inertia[i][j] = b.inertia[turn(i)][turn(j)];
  }
  const Mat<R> a = inverse_symmetric(inertia);
  const Mat<R> b_cross{Vec<R>{R(0), R(-gyro[2]), gyro[1]}, Vec<R>{gyro[2], R(0), R(-gyro[0])},
                       Vec<R>{R(-gyro[1]), gyro[0], R(0)}};
  detail::copy(c.gyro, gyro);
  for (int i = 0; i < 3; ++i) {
    c.euler[i] = (inertia[(i + 1) % 3][(i + 1) % 3] - inertia[(i + 2) % 3][(i + 2) % 3]) *
                 (R(1) / inertia[i][i]);
    for (int j = 0; j < 3; ++j) {
      c.inertia[i][j] = inertia[i][j];
      c.inverse[i][j] = a[i][j];
      c.spin[i][j] = a[i][0] * b_cross[0][j] + a[i][1] * b_cross[1][j] + a[i][2] * b_cross[2][j];
    }
  }
  detail::set_lever(c, a, lever, b, e.axial);
  return c;
}

} // namespace kov::flow
