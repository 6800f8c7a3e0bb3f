#pragma once
// Andoyer's variables on the section, and points of a level on it.
//
// N = M - B = G n with the unit vector n = (sqrt(1-y^2) sin l, sqrt(1-y^2) cos l, y), y = L/G, and on the
// section g = pi/2 (side +1) or 3pi/2 (side -1), with F1 = Gamma.Gamma and s = F2/(G sqrt F1):
//   Gamma = sqrt(F1) ( s n +- sqrt(1-s^2) (cos l, -sin l, 0) )      (paper, eq. (ADvariables) at cos g = 0).
// So (l, y) and G >= |F2|/sqrt F1 give a point, and the energy fixes G.  `axis` is the body axis in the role
// of the third; the others follow cyclically.

#include "flow/number/big_real.hpp"
#include "flow/orbit/body.hpp"

#include <vector>

namespace kov::flow {

/// The section g = pi/2 or 3pi/2: S = 0, where S = F2 N_3 - (N.N) Gamma_3 = |N|^2 sqrt(..) cos g, on the side where
/// C = N_2 Gamma_1 - N_1 Gamma_2 has this sign; at g = pi/2 S falls where g grows, at 3pi/2 it rises.
struct SectionRule {
  bool falling = true, rising = false;
  int side = 1; ///< sign of C
  int axis = 2; ///< chart axis: L is the component of the momentum along this body axis (0, 1, 2)
};

template <class R> struct Levels {
  R energy{};  ///< H
  R length{};  ///< F1 > 0
  R casimir{}; ///< F2
};

template <class R> struct Andoyer {
  R l{};      ///< radian, in [0, 2 pi)
  R y{};      ///< L/G in [-1, 1]
  R g_size{}; ///< G = |N|
};

/// The longitude of a vector, and its height over its length.
template <class R> Andoyer<R> andoyer_of(const Vec<R>& n) {
  using std::atan2;
  using std::sqrt;
  const R size = sqrt(dot(n, n));
  R l = atan2(n[0], n[1]);
  if (l < R(0)) l = l + R(2) * pi_of(R(0));
  return {l, n[2] / size, size};
}

/// A vector along axes of which the third is `axis`.
template <class R> Vec<R> turned_to(const Vec<R>& v, int axis) {
  return {v[(axis + 1) % 3], v[(axis + 2) % 3], v[axis]};
}

template <class R>
State<R> section_point(const Body<R>& b, const Levels<R>& f, const SectionRule& rule, const R& l,
                       const R& y, const R& size) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const int i = (rule.axis + 1) % 3, k = (rule.axis + 2) % 3;
  const R sl = sin(l), cl = cos(l), root = sqrt(f.length);
  const R s = f.casimir / (size * root);
  const R below = sqrt(R(1) - y * y);
  const R across = (rule.side > 0 ? R(1) : R(-1)) * sqrt(R(1) - s * s);
  Vec<R> n{}, gamma{};
  n[i] = below * sl;
  n[k] = below * cl;
  n[rule.axis] = y;
  gamma[i] = root * (s * n[i] + across * cl);
  gamma[k] = root * (s * n[k] - across * sl);
  gamma[rule.axis] = root * s * y;
  const Vec<R> m = plus(scaled(size, n), b.gyrostat);
  return {omega_of(b, m, gamma), gamma};
}

/// A bound of G on the level.
[[nodiscard]] double largest_momentum(const Body<double>& b, const Levels<double>& f);

/// Every G that the level allows at (l, y), ascending; found by a scan of 400 values and bisection, so that two values
/// closer than the scan may be missed.  The general search (starts.hpp) has six equations there: it does not know that
/// over a place of the sphere Gamma is a function of G, and the energy the only equation left.
[[nodiscard]] std::vector<double> momentum_sizes(const Body<double>& b, const Levels<double>& f,
                                                 const SectionRule& rule, double l, double y);

/// G to the precision of R, from one of momentum_sizes (secant steps on H(G) = H).
template <class R>
State<R> refine_point(const Body<R>& b, const Levels<R>& f, const SectionRule& rule, const R& l,
                      const R& y, double size) {
  const auto excess = [&](const R& g) {
    return integrals(b, section_point(b, f, rule, l, y, g)).energy - f.energy;
  };
  R g0 = R(size), g1 = R(size) * (R(1) + R(1) / R(1 << 30));
  R e0 = excess(g0), e1 = excess(g1);
  for (int i = 0; i < 12 && !(e1 == e0); ++i) {
    const R g2 = g1 - e1 * (g1 - g0) / (e1 - e0);
    if (g2 == g1) break;
    g0 = g1;
    e0 = e1;
    g1 = g2;
    e1 = excess(g1);
  }
  return section_point(b, f, rule, l, y,
                       (e0 < R(0) ? R(0) - e0 : e0) < (e1 < R(0) ? R(0) - e1 : e1) ? g0 : g1);
}

} // namespace kov::flow
