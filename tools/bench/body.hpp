#pragma once
// A body and its integrals, written by hand for the peers and for tests.
//
// State X = (Omega, Gamma): angular velocity and the vertical unit vector, both in body axes.  With
//   K = I Omega,  v = L x Gamma,  z = L.Gamma (height of the centre of mass over the tip)
// the Lagrange function (paper, eq. (Lf)) is L = K.Omega/2 + m (v.Omega)^2/2 - m g z, and z' = v.Omega.
// M = K + m z' v is the momentum of the paper; H, F1, F2 below are its integrals (integralsM).
// For the body with a fixed tip, I is the tensor about the tip, M = K, and no term with m z' occurs.
// The motion is that of a system of Poisson type (scene/body_system.hpp).

#include "flow/scene/scene.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace kov::flow {

template <class R> using Vec = std::array<R, 3>;
template <class R> using Mat = std::array<Vec<R>, 3>;

template <class R> Vec<R> cross(const Vec<R>& a, const Vec<R>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class R> R dot(const Vec<R>& a, const Vec<R>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class R> Vec<R> scaled(const R& s, const Vec<R>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
template <class R> Vec<R> plus(const Vec<R>& a, const Vec<R>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class R> Vec<R> minus(const Vec<R>& a, const Vec<R>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class R> Vec<R> times(const Mat<R>& a, const Vec<R>& b) {
  return {dot(a[0], b), dot(a[1], b), dot(a[2], b)};
}

/// The body and its surroundings, in the units of the scene.
template <class R> struct Body {
  Mat<R> inertia{};  ///< I, symmetric, about the centre of mass (sliding) or the fixed tip
  Vec<R> lever{};    ///< L, from the tip to the centre of mass
  R mass = R(1);     ///< m
  R gravity{};       ///< g
  Vec<R> gyrostat{}; ///< B
  bool sliding = false;
};

/// A point of phase space.
template <class R> struct State {
  Vec<R> omega{}; ///< angular velocity, body axes, 1/time
  Vec<R> gamma{}; ///< vertical unit vector, body axes
};

template <class R> Vec<R> momentum(const Body<R>& b, const State<R>& x) {
  const Vec<R> k = times(b.inertia, x.omega);
  if (!b.sliding) return k;
  const Vec<R> v = cross(b.lever, x.gamma);
  return plus(k, scaled(R(b.mass * dot(v, x.omega)), v)); // M = K + m z' v
}

template <class R> struct Integrals {
  R energy{};  ///< H
  R length{};  ///< F1 = Gamma.Gamma
  R casimir{}; ///< F2 = Gamma.(M - B)
};

template <class R> Integrals<R> integrals(const Body<R>& b, const State<R>& x) {
  const Vec<R> k = times(b.inertia, x.omega);
  R twice = dot(k, x.omega);
  if (b.sliding) {
    const R zdot = dot(cross(b.lever, x.gamma), x.omega);
    twice = twice + b.mass * zdot * zdot;
  }
  return {twice / R(2) + b.mass * b.gravity * dot(b.lever, x.gamma), dot(x.gamma, x.gamma),
          dot(x.gamma, minus(k, b.gyrostat))}; // v.Gamma = 0, so Gamma.M = Gamma.K
}

template <class R> Mat<R> inverse_symmetric(const Mat<R>& a) {
  const Mat<R> rows{cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])};
  const R det = dot(a[0], rows[0]);
  Mat<R> out{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      out[i][j] = rows[j][i] / det;
  return out;
}

/// Omega with J Omega = M (J = I + m v (x) v if sliding), by Sherman-Morrison.
template <class R> Vec<R> omega_of(const Body<R>& b, const Vec<R>& m, const Vec<R>& gamma) {
  const Mat<R> a = inverse_symmetric(b.inertia);
  const Vec<R> w = times(a, m);
  if (!b.sliding) return w;
  const Vec<R> v = cross(b.lever, gamma);
  const Vec<R> u = times(a, v);
  const R d = R(1) + b.mass * dot(v, u);
  return minus(w, scaled(R(b.mass * dot(v, w) / d), u));
}

/// A body of a scene.
inline Body<double> body_of(const Scene& s) {
  Body<double> b;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      b.inertia[i][k] = s.inertia[i][k].as<double>();
    b.lever[i] = s.lever[i].as<double>();
    b.gyrostat[i] = s.gyrostat[i].as<double>();
  }
  b.mass = s.mass.as<double>();
  b.gravity = s.gravity.as<double>();
  b.sliding = s.sliding;
  return b;
}

/// The longitude of a vector in [0, 2 pi), and its height over its length.
inline std::array<double, 2> on_sphere(const Vec<double>& n) {
  const double l = std::atan2(n[0], n[1]);
  return {l < 0 ? l + 2 * M_PI : l, n[2] / std::sqrt(dot(n, n))};
}

/// (N, Gamma) of a state, along axes of which the third is the section's.
inline std::vector<double> coordinates_of(const Body<double>& b, const State<double>& x, int axis) {
  const Vec<double> n = minus(momentum(b, x), b.gyrostat);
  std::vector<double> all;
  for (const Vec<double>& v : {n, x.gamma})
    for (const int i : {1, 2, 3})
      all.push_back(v[static_cast<std::size_t>((axis + i) % 3)]);
  return all;
}

} // namespace kov::flow
