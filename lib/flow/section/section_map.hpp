#pragma once
// The common part of the search and the proof of fixed points: from (l, L/G) to a state on the
// level with its derivatives, and back; the variational kernels.

#include "flow/number/double_ball.hpp" // dot
#include "flow/number/dual.hpp"
#include "flow/orbit/andoyer.hpp"
#include "flow/orbit/kernel_table.hpp"

#include <memory>
#include <vector>

namespace kov::flow {
inline namespace KOV_ISA {

template <class R> inline constexpr const auto& sets_of<Dual<R>> = coarse_sets;

/// The section map's coordinates and their derivatives.
template <class R> struct SectionImage {
  Dual<R> l, y; ///< derivatives with respect to the start's (l, L/G)
  R time{};
  R g_size{}; ///< G on arrival
};

template <class R> Body<Dual<R>> dual_body(const Body<R>& b) {
  Body<Dual<R>> out;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      out.inertia[i][k] = Dual<R>(b.inertia[i][k]);
    out.lever[i] = Dual<R>(b.lever[i]);
    out.gyrostat[i] = Dual<R>(b.gyrostat[i]);
  }
  out.mass = Dual<R>(b.mass);
  out.gravity = Dual<R>(b.gravity);
  out.sliding = b.sliding;
  return out;
}

/// H at (l, y, G) and dH/dG.
template <class R>
Dual<R> energy_in_size(const Body<Dual<R>>& b, const Levels<Dual<R>>& f, const SectionRule& rule,
                       const R& l, const R& y, const R& size) {
  return integrals(b, section_point(b, f, rule, Dual<R>(l), Dual<R>(y), Dual<R>(size, R(1), R(0))))
      .energy;
}

/// The state over (l, y) with its derivatives; `size` solves H = h (or encloses the solution).
template <class R>
State<Dual<R>> lifted(const Body<Dual<R>>& b, const Levels<Dual<R>>& f, const SectionRule& rule,
                      const R& l, const R& y, const R& size) {
  const Dual<R> ld(l, R(1), R(0)), yd(y, R(0), R(1));
  const R by_size = energy_in_size(b, f, rule, l, y, size).d[0];
  const Dual<R> e = integrals(b, section_point(b, f, rule, ld, yd, Dual<R>(size))).energy;
  const Dual<R> sized(size, R(R(0) - e.d[0] / by_size), R(R(0) - e.d[1] / by_size));
  return section_point(b, f, rule, ld, yd, sized);
}

/// S and C (section_jets.hpp) of a state.
template <class T> struct SectionFunctions { T s, c; };
template <class T>
SectionFunctions<T> section_functions(const Body<T>& b, const State<T>& x, int axis) {
  const Vec<T> n = minus(momentum(b, x), b.gyrostat);
  const int i = (axis + 1) % 3, k = (axis + 2) % 3;
  return {dot(n, x.gamma) * n[axis] - dot(n, n) * x.gamma[axis],
          n[k] * x.gamma[i] - n[i] * x.gamma[k]};
}

/// (l, L/G) of a state on the section; l is the value in (about - pi, about + pi], so that no cut
/// is near `about`.
template <class T>
void chart(const Body<T>& b, const State<T>& x, int axis, const T& about, T& l, T& y) {
  using std::atan2;
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Vec<T> n = minus(momentum(b, x), b.gyrostat);
  const T c = cos(about), s = sin(about);
  const T &across = n[(axis + 1) % 3], &along = n[(axis + 2) % 3]; // ~ sin l, cos l
  l = about + atan2(across * c - along * s, along * c + across * s);
  y = n[axis] / sqrt(dot(n, n));
}

/// Taylor coefficients of an orbit with its derivatives.
template <class R> class VariationalJet {
public:
  using T = Dual<R>;
  VariationalJet(const Body<T>& body, const Effects& want, int order)
      : body_(body), order_(order), set_(coarse_index(want)),
        model_(model_of(body, coarse_sets[set_])), storage_(storage_size<T>(order)) {
    for (int i = 0; i < Jet<T>::count; ++i)
      jet_.s[i] = storage_.data() + static_cast<std::ptrdiff_t>(i) * (order + 2);
  }
  /// Coefficients 1 .. order at x.
  void expand(const State<T>& x, int order) {
    for (int i = 0; i < 3; ++i) {
      jet_.s[inner(i)][0] = x.omega[i];
      jet_.s[3 + inner(i)][0] = x.gamma[i];
    }
    kernel_table<T>.of[set_].jets(model_, jet_, order);
  }
  /// Coefficients of S, after expand().
  const T* section(int axis, int order) {
    kernel_table<T>.of[set_].section(model_, jet_, order, inner(axis));
    return jet_.s[Jet<T>::section];
  }
  /// Coefficient k as a state (Omega_k, Gamma_k).
  [[nodiscard]] State<T> coefficient(int k) const {
    State<T> x;
    for (int i = 0; i < 3; ++i) {
      x.omega[i] = jet_.s[inner(i)][k];
      x.gamma[i] = jet_.s[3 + inner(i)][k];
    }
    return x;
  }
  /// The polynomial of degree `order` at time t.
  [[nodiscard]] State<T> at(const T& t, int order) const {
    State<T> x = coefficient(order);
    for (int k = order - 1; k >= 0; --k) {
      const State<T> c = coefficient(k);
      for (int i = 0; i < 3; ++i) {
        x.omega[i] = x.omega[i] * t + c.omega[i];
        x.gamma[i] = x.gamma[i] * t + c.gamma[i];
      }
    }
    return x;
  }
  [[nodiscard]] int order() const { return order_; }

private:
  [[nodiscard]] int inner(int axis) const { return (axis + 3 - model_.shift) % 3; }
  Body<T> body_;
  int order_;
  std::size_t set_;
  Model<T> model_;
  std::vector<T> storage_;
  Jet<T> jet_{};
};

} // namespace KOV_ISA
} // namespace kov::flow
