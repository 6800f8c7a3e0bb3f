#pragma once
// Taylor coefficients of an orbit, by the recurrences of body.hpp and model.hpp.
//
// All series have one index: x_k = x^(k)(t0)/k!.  With hats for quantities divided by lambda = max |L_i|,
//   vh = Lh x Gamma = alpha e + beta f,  w = Lh.Gamma' (the vertical speed),  Q = w',
//   Gamma'  = Gamma x Omega
//   Y       = I^-1((I Omega - B) x Omega)
//   D Q     = alpha' e.Omega + beta' f.Omega + alpha e.Y + beta f.Y - (g/lambda)(D - 1)
//   Omega'  = Y - (c_alpha Q alpha + g_alpha alpha) ae - (c_beta Q beta + g_beta beta) af
// and, if L lies on the first axis (axial), alpha = -Gamma_3, beta = Gamma_2, w = Gamma_1', so that the
// series of Gamma_1 comes from Q and two products fall away; there Q means Gamma_1''.
// The products of one order are summed in one loop: they are independent, so that a processor can work
// on all of them at once.  No product occurs that the set of effects does not need.
//
// Cost of order p: P p^2/2 multiplications and additions per lane,
//   P = 9 (fixed tip), 16 (sliding, axial), 18 (sliding); 3 more for full inertia.

#include "flow/number/lanes.hpp"
#include "flow/number/twin.hpp"
#include "flow/orbit/model.hpp"

namespace kov::flow {
inline namespace KOV_ISA {

/// Storage for the series of one pack; each points to at least order + 2 numbers.
template <class T> struct Jet {
  enum Name { // clang-format off
    omega1, omega2, omega3, gamma1, gamma2, gamma3,       // the state
    kin1, kin2, kin3, y2, y3,                             // I Omega; Y for axial L
    alpha, beta, alpha_dot, beta_dot,                     // vh and its derivative
    omega_e, omega_f, y_e, y_f, q, d, w,                  // in the basis e, f; Q, D, Lh.Gamma'
    m1, m2, m3, m_squared, section,                       // section_jets.hpp
    count }; // clang-format on
  T* s[count];
};

// The places of the series alpha, beta, ..., for axial and for general L.
template <bool axial, class T> struct Plane {
  T *al, *be, *ad, *bd, *oe, *of, *ye, *yf;
  explicit Plane(const Jet<T>& j) {
    using J = Jet<T>;
    al = j.s[axial ? J::gamma3 : J::alpha];
    be = j.s[axial ? J::gamma2 : J::beta];
    ad = j.s[J::alpha_dot];
    bd = j.s[J::beta_dot];
    oe = j.s[axial ? J::omega2 : J::omega_e];
    of = j.s[axial ? J::omega3 : J::omega_f];
    ye = j.s[axial ? J::y2 : J::y_e];
    yf = j.s[axial ? J::y3 : J::y_f];
  }
};

template <class T> inline T along(const T (&a)[3], const T& x, const T& y, const T& z) {
  T sum = a[0] * x;
  add_product(sum, a[1], y);
  add_product(sum, a[2], z);
  return sum;
}

// The sums over j of x_j y_{k-j} of one order.
template <class T> struct Sums {
  T g1{}, g1n{}, g2{}, g2n{}, g3{}, g3n{}; // Gamma x Omega: positive and negative parts
  T y1{}, y1n{}, y2{}, y2n{}, y3{}, y3n{}; // Omega_i Omega_j, or (I Omega) x Omega
  T aa{}, bb{}, ra{}, rb{}, sa{}, sb{}, qd{}, qa{}, qb{};
};

/// Numbers whose sums of products are one operation: dot(a, b, n) = sum of a[j] b[-j], j < n.
template <class T>
concept HasSumOfProducts = requires(const T* a) {
  dot(a, a, 1);
};

// Products of the state with itself: known up to and including order k.
template <Effects E, class T> struct StateProducts {
  static constexpr bool two_rows = E.sliding && E.axial;
  T *o1, *o2, *o3, *g1, *g2, *g3, *k1, *k2, *k3, *al, *be;
  explicit StateProducts(const Jet<T>& j)
      : o1(j.s[0]), o2(j.s[1]), o3(j.s[2]), g1(j.s[3]), g2(j.s[4]), g3(j.s[5]), k1(j.s[6]),
        k2(j.s[7]), k3(j.s[8]), al(Plane<E.axial, T>(j).al), be(Plane<E.axial, T>(j).be) {}
  void operator()(Sums<T>& s, int a, int b) const {
    each(s, [a, b](T& sum, const T* x, const T* y) { add_product(sum, x[a], y[b]); });
  }
  template <class Add> void each(Sums<T>& s, const Add& add) const {
    if constexpr (!two_rows) {
      add(s.g1, g2, o3);
      add(s.g1n, g3, o2);
    }
    add(s.g2, g3, o1);
    add(s.g2n, g1, o3);
    add(s.g3, g1, o2);
    add(s.g3n, g2, o1);
    if constexpr (E.full_inertia) {
      add(s.y1, k2, o3);
      add(s.y1n, k3, o2);
      add(s.y2, k3, o1);
      add(s.y2n, k1, o3);
      add(s.y3, k1, o2);
      add(s.y3n, k2, o1);
    } else {
      add(s.y1, o2, o3);
      add(s.y2, o3, o1);
      add(s.y3, o1, o2);
    }
    if constexpr (E.sliding) {
      add(s.aa, al, al);
      add(s.bb, be, be);
    }
  }
};

// Series that start from the state of order k by linear combination.
template <Effects E, class T> inline void linear_series(const Model<T>& c, const Jet<T>& j, int k) {
  using J = Jet<T>;
  const auto at = [&](int name) -> T& { return j.s[name][k]; };
  if constexpr (E.full_inertia)
    for (int i = 0; i < 3; ++i)
      at(J::kin1 + i) = along(c.inertia[i], at(0), at(1), at(2));
  if constexpr (E.lever() && !E.axial) {
    at(J::alpha) = along(c.p, at(3), at(4), at(5));
    at(J::beta) = along(c.q, at(3), at(4), at(5));
  }
  if constexpr (E.sliding && !E.axial) {
    at(J::omega_e) = along(c.e, at(0), at(1), at(2));
    at(J::omega_f) = along(c.f, at(0), at(1), at(2));
  }
}

// Y_k from the sums of order k; kept as a series only for the sliding tip.
template <Effects E, class T>
inline void free_acceleration(const Model<T>& c, const Jet<T>& j, const Sums<T>& s, int k,
                              T (&y)[3]) {
  using J = Jet<T>;
  T* const* x = j.s;
  if constexpr (E.full_inertia) {
    const T t1 = s.y1 - s.y1n, t2 = s.y2 - s.y2n, t3 = s.y3 - s.y3n;
    for (int i = 0; i < 3; ++i)
      y[i] = along(c.inverse[i], t1, t2, t3);
  } else {
    y[0] = c.euler[0] * s.y1;
    y[1] = c.euler[1] * s.y2;
    y[2] = c.euler[2] * s.y3;
  }
  if constexpr (E.gyrostat)
    for (int i = 0; i < 3; ++i)
      y[i] -= along(c.spin[i], x[0][k], x[1][k], x[2][k]);
  if constexpr (E.sliding && E.axial) {
    x[J::y2][k] = y[1];
    x[J::y3][k] = y[2];
  } else if constexpr (E.sliding) {
    x[J::y_e][k] = along(c.e, y[0], y[1], y[2]);
    x[J::y_f][k] = along(c.f, y[0], y[1], y[2]);
  }
}

// Q_k and D_k.  The sums hold the terms j < k; the terms with index k are added here.
template <Effects E, class T>
inline void vertical_acceleration(const Model<T>& c, const Jet<T>& j, Sums<T>& s, T& d0_inverse,
                                  int k) {
  using J = Jet<T>;
  const Plane<E.axial, T> v(j);
  add_product(s.ra, v.ad[k], v.oe[0]);
  add_product(s.rb, v.bd[k], v.of[0]);
  add_product(s.sa, v.ye[k], v.al[0]);
  add_product(s.sb, v.yf[k], v.be[0]);
  T* d = j.s[J::d];
  T* q = j.s[J::q];
  d[k] = c.c_alpha * s.aa;
  add_product(d[k], c.c_beta, s.bb);
  const T plane = E.axial ? T((s.rb + s.sb) - (s.ra + s.sa)) : T((s.rb + s.sb) + (s.ra + s.sa));
  T r = plane - s.qd;
  if constexpr (E.gravity) {
    sub_product(r, c.g_alpha, s.aa);
    sub_product(r, c.g_beta, s.bb);
  }
  if (k == 0) {
    d[0] = d[0] + Lanes<T>::all(typename Lanes<T>::Real(1));
    d0_inverse = Lanes<T>::all(typename Lanes<T>::Real(1)) / d[0];
  } else {
    sub_product(r, q[0], d[k]);
  }
  q[k] = r * d0_inverse;
  add_product(s.qa, q[k], v.al[0]);
  add_product(s.qb, q[k], v.be[0]);
}

// Omega_{k+1} and Gamma_{k+1}.
template <Effects E, class T>
inline void next_state(const Model<T>& c, const Jet<T>& j, const Sums<T>& s, const T (&y)[3],
                       const T& rate, int k) {
  T* const* x = j.s;
  T o1 = y[0], o2 = y[1], o3 = y[2];
  if constexpr (E.lever()) {
    const Plane<E.axial, T> v(j);
    T a{}, b{};
    if constexpr (E.sliding) {
      a = c.c_alpha * s.qa;
      b = c.c_beta * s.qb;
    }
    if constexpr (E.gravity) {
      // axial: alpha is Gamma_3 and q is Gamma_1'' here, the sign of L is in g_alpha
      add_product(a, c.g_alpha, v.al[k]);
      add_product(b, c.g_beta, v.be[k]);
    }
    if constexpr (E.axial) {
      o2 += a;
      o3 -= b;
    } else {
      o1 -= a * c.ae[0] + b * c.af[0];
      o2 -= a * c.ae[1] + b * c.af[1];
      o3 -= a * c.ae[2] + b * c.af[2];
    }
  }
  x[0][k + 1] = o1 * rate;
  x[1][k + 1] = o2 * rate;
  x[2][k + 1] = o3 * rate;
}

/// Taylor coefficients 1 .. order of Omega and Gamma, from coefficients 0.
///
/// Shape     j.s[0..2] = Omega, j.s[3..5] = Gamma, each order + 2 long; the other series of j are scratch,
///           and (sliding) w[k] = coefficients of Lh.Gamma' for section_jets
/// Source    body.hpp; [JorbaZou2005] for the method
template <Effects E, class T> void jets(const Model<T>& c, const Jet<T>& j, int order) {
  using J = Jet<T>;
  using Real = typename Lanes<T>::Real;
  T* const* x = j.s;
  const StateProducts<E, T> state(j);
  const Plane<E.axial, T> v(j);
  T d0_inverse{};
  if constexpr (E.sliding && E.axial)
    x[J::w][0] = x[J::gamma2][0] * x[J::omega3][0] - x[J::gamma3][0] * x[J::omega2][0];
  // otherwise w[0] is set below, when Gamma' is known
  for (int k = 0; k < order; ++k) {
    const T rate = Lanes<T>::all(Real(1) / Real(k + 1));
    linear_series<E>(c, j, k);
    Sums<T> s;
    if constexpr (E.sliding) x[J::d][k] = T{}; // so that the term q_0 d_k below is 0
    const auto sliding_products = [&](const auto& add) {
      if constexpr (E.sliding) {
        add(s.ra, v.ad, v.oe);
        add(s.rb, v.bd, v.of);
        add(s.sa, v.ye, v.al);
        add(s.sb, v.yf, v.be);
        add(s.qd, x[J::q], x[J::d]);
        add(s.qa, x[J::q], v.al);
        add(s.qb, x[J::q], v.be);
      }
    };
    if constexpr (HasSumOfProducts<T>) {
      const auto add = [k](T& sum, const T* p, const T* q) { sum = dot(p, q + k, k); };
      state.each(s, add);
      sliding_products(add);
    } else {
      for (int a = 0; a < k; ++a) {
        const int b = k - a;
        state(s, a, b);
        sliding_products([a, b](T& sum, const T* p, const T* q) { add_product(sum, p[a], q[b]); });
      }
    }
    state(s, k, 0);
    const T g2 = s.g2 - s.g2n, g3 = s.g3 - s.g3n;
    const T g1 = E.sliding && E.axial ? x[J::w][k] : T(s.g1 - s.g1n);
    if constexpr (E.sliding && E.axial) {
      v.ad[k] = g3;
      v.bd[k] = g2;
    } else if constexpr (E.sliding) {
      v.ad[k] = along(c.p, g1, g2, g3);
      v.bd[k] = along(c.q, g1, g2, g3);
      if (k == 0) x[J::w][0] = along(c.lever, g1, g2, g3);
    }
    T y[3];
    free_acceleration<E>(c, j, s, k, y);
    if constexpr (E.sliding) {
      vertical_acceleration<E>(c, j, s, d0_inverse, k);
      x[J::w][k + 1] = x[J::q][k] * rate;
    }
    next_state<E>(c, j, s, y, rate, k);
    x[3][k + 1] = g1 * rate;
    x[4][k + 1] = g2 * rate;
    x[5][k + 1] = g3 * rate;
  }
  linear_series<E>(c, j, order);
}

} // namespace KOV_ISA
} // namespace kov::flow
