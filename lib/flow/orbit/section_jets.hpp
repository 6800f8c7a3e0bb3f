#pragma once
// The section function and its Taylor coefficients.
//
// In Andoyer's variables (paper, eq. (ADvariables)) with N = M - B, |N| = G and Gamma.N = F2, put
//   S = F2 N_3 - (N.N) Gamma_3 = (N x (N x Gamma))_3,       C = N_2 Gamma_1 - N_1 Gamma_2.
// Substituting the map gives  S = r G cos g,  C = r sin g  with r = sqrt(G^2-L^2) sqrt(1-F2^2/G^2) >= 0, so
//   g = pi/2   <=>  S = 0 and C > 0,      and there  dS/dt = -r G dg/dt :
// the paper's section "g = pi/2, dg/dt > 0" is: the polynomial S falls through 0 while C > 0.
// Likewise g = 3pi/2 is S = 0 with C < 0, and there dS/dt = +r G dg/dt.
// If the chart degenerates (|L| = G or |F2| = G), r = 0: S and C vanish together and the angle g does not
// exist, but S is still a polynomial in the state and has an ordinary zero when an orbit passes such a
// pole, so that nothing special happens to the search; C only decides on which half the pole was passed.
// The formula with N instead of M is for the gyrostat, whose bracket is that of N.

#include "flow/orbit/jets.hpp"

namespace kov::flow {
inline namespace KOV_ISA {

/// M at order k (without B), from the state and, for the sliding tip, the sums of w alpha and w beta.
template <Effects E, class T>
inline void momentum_series(const Model<T>& c, const Jet<T>& j, const T& wa, const T& wb, int k) {
  using J = Jet<T>;
  T* const* x = j.s;
  for (int i = 0; i < 3; ++i) {
    T m = E.full_inertia ? along(c.inertia[i], x[0][k], x[1][k], x[2][k])
                         : T(c.inertia[i][i] * x[i][k]);
    if constexpr (E.sliding && E.axial) {
      if (i == 1) sub_product(m, c.m_lambda2, wa); // w alpha = -Gamma_1' Gamma_3
      if (i == 2) add_product(m, c.m_lambda2, wb);
    } else if constexpr (E.sliding) {
      m += c.m_lambda2 * (wa * c.e[i] + wb * c.f[i]);
    }
    x[J::m1 + i][k] = m;
  }
}

// The sums of one order.  A pair (a, b = k - a) is one step, so that squares are done once and the other
// products twice; nine independent sums keep the processor busy.
template <Effects E, class T> struct SectionSums {
  T wa{}, wa2{}, wb{}, wb2{}, s1{}, s2{}, s3{}, last{}, last2{};
  T *w, *al, *be, *m1, *m2, *m3, *mm, *vertical;
  SectionSums(const Jet<T>& j, int axis)
      : w(j.s[Jet<T>::w]), al(Plane<E.axial, T>(j).al), be(Plane<E.axial, T>(j).be),
        m1(j.s[Jet<T>::m1]), m2(j.s[Jet<T>::m2]), m3(j.s[Jet<T>::m3]), mm(j.s[Jet<T>::m_squared]),
        vertical(j.s[3 + axis]) {}
  void vertical_speed(int a, int b) {
    if constexpr (E.sliding) {
      add_product(wa, w[a], al[b]);
      add_product(wb, w[a], be[b]);
    }
  }
  void pair(int a, int b) {
    vertical_speed(a, b);
    if constexpr (E.sliding) {
      add_product(wa2, w[b], al[a]);
      add_product(wb2, w[b], be[a]);
    }
    add_product(s1, m1[a], m1[b]);
    add_product(s2, m2[a], m2[b]);
    add_product(s3, m3[a], m3[b]);
    add_product(last, mm[a], vertical[b]);
    add_product(last2, mm[b], vertical[a]);
  }
  void all_pairs(int k) requires HasSumOfProducts<T> {
    const int n = (k - 1) / 2;
    if (n < 1) return;
    const auto sum = [&](const T* x, const T* y) { return dot(x + 1, y + (k - 1), n); };
    if constexpr (E.sliding) {
      wa = sum(w, al);
      wb = sum(w, be);
      wa2 = sum(al, w);
      wb2 = sum(be, w);
    }
    s1 = sum(m1, m1);
    s2 = sum(m2, m2);
    s3 = sum(m3, m3);
    last = sum(mm, vertical);
    last2 = sum(vertical, mm);
  }
};

/// Taylor coefficients 0 .. order of N = M - B and of S for the chart axis `axis` (inner label), after jets().
///
/// Shape     results in j.s[Jet::m1 + i] and j.s[Jet::section]
/// Cost      3 (fixed tip) or 5 products of series of length order
template <Effects E, class T>
void section_jets(const Model<T>& c, const Jet<T>& j, int order, int axis) {
  using J = Jet<T>;
  T* const* x = j.s;
  T* m = x[J::m1 + axis];
  T casimir{};
  for (int k = 0; k <= order; ++k) {
    SectionSums<E, T> s(j, axis);
    if constexpr (HasSumOfProducts<T>)
      s.all_pairs(k);
    else
      for (int a = 1; 2 * a < k; ++a)
        s.pair(a, k - a);
    T square = s.s1 + s.s2 + s.s3;
    square = square + square;
    const int half = k / 2;
    if (k % 2 == 0 && k > 0) { // the middle term
      s.vertical_speed(half, half);
      add_product(square, s.m1[half], s.m1[half]);
      add_product(square, s.m2[half], s.m2[half]);
      add_product(square, s.m3[half], s.m3[half]);
      add_product(s.last, s.mm[half], s.vertical[half]);
    }
    s.vertical_speed(0, k); // the ends, now that order k of M can be known
    if (k > 0) s.vertical_speed(k, 0);
    momentum_series<E>(c, j, T(s.wa + s.wa2), T(s.wb + s.wb2), k);
    if constexpr (E.gyrostat)
      for (int i = 0; k == 0 && i < 3; ++i)
        x[J::m1 + i][0] -= c.gyro[i];
    const T ends = s.m1[0] * s.m1[k] + s.m2[0] * s.m2[k] + s.m3[0] * s.m3[k];
    s.mm[k] = k == 0 ? ends : T(square + (ends + ends));
    add_product(s.last, s.mm[0], s.vertical[k]);
    if (k > 0) add_product(s.last, s.mm[k], s.vertical[0]);
    if (k == 0) casimir = s.m1[0] * x[3][0] + s.m2[0] * x[4][0] + s.m3[0] * x[5][0];
    x[J::section][k] = casimir * m[k] - (s.last + s.last2);
  }
}

} // namespace KOV_ISA
} // namespace kov::flow
