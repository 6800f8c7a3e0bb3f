#pragma once
// The common parts of all integrations of many orbits, whatever moves: how long a step may be, the
// sum that keeps the low half of the state, and the watch over the sign of the section.

#include "flow/number/roots.hpp"

#include <cmath>

namespace kov::flow {

/// Why an orbit ended; `broken`: a number that is none; `singular`: the steps shrink to nothing, as they do before a
/// collision or where the field is not defined; `idle`: it rests, or lies in the section; `escaped`: far beyond all
/// scales, in steps that do not shrink.
enum class Ended : unsigned char {
  time,
  crossings,
  steps,
  stopped,
  broken,
  singular,
  idle,
  escaped,
  lost ///< its integrals: what it does is not a motion of the system any more
};

inline namespace KOV_ISA {

/// log2 of the longest step in units of ||x_1||^-1 and (2 ||x_2||)^(-1/2).  Where x turns at the
/// rate w, the terms of its series add up to e^(w h), and their rounding to u e^(w h), u being the
/// unit roundoff.  So w h is at most 1, or what makes that e epsilon if epsilon is larger than u.
inline double log2_reach(double log2_tolerance, double log2_roundoff) {
  const double spare = log2_tolerance - log2_roundoff;
  return spare > 0 ? std::log2(1 + spare * 0.6931471805599453) : 0;
}

/// x + low is the state: the increment is added without rounding away its low half (Kahan, Babuska).
template <class T> inline void add_compensated(T& x, T& low, const T& increment) {
  const T d = low + increment;
  const T sum = x + d;
  const T back = sum - x;
  low = (x - (sum - back)) + (d - back);
  x = sum;
}

/// x_1 h + ... + x_p h^p.
template <class T> inline T increment(const T* x, int p, const T& h) {
  T d = x[p];
  for (int k = p - 1; k >= 1; --k)
    d = multiply_add(d, h, x[k]);
  return d * h;
}

/// The value of one lane of a series at dt.
template <class T>
inline typename Lanes<T>::Real value_at(const T* x, int p, int lane,
                                        const typename Lanes<T>::Real& dt) {
  using L = Lanes<T>;
  typename L::Real v = L::get(x[p], lane);
  for (int k = p - 1; k >= 0; --k)
    v = multiply_add(v, dt, L::get(x[k], lane));
  return v;
}

/// The sign of the section function S along the orbits, from step to step.
template <class T> class SectionWatch {
public:
  using L = Lanes<T>;
  using Real = typename L::Real;

  SectionWatch(bool falling, bool rising) : falling_(falling), rising_(rising) {}

  /// A new orbit begins in the lane.
  void forget(int lane) { L::set(above_, lane, Real(0)); }

  /// Follows S over a step; calls closer(lane, sign before) in the lanes where a wanted sign change, or doubt, is, or
  /// where all terms of S together are smaller than `small`.
  template <class F> void step(const T* s, int p, const T& h, const T& small, const F& closer) {
    const T one = L::all(Real(1)), zero{};
    constexpr int few = Hull<T>::degree;
    T power = h, first = absolute(s[0]), rest = first, tail{}, bend{}, end = s[0], b[few + 1]{};
    b[0] = s[0];
    for (int k = 1; k <= few && k <= p; ++k) {
      b[k] = s[k] * power;
      rest += absolute(b[k]);
      end += b[k];
      power = power * h;
    }
    for (int k = few + 1; k <= p; ++k) {
      const T term = s[k] * power, a = absolute(term);
      tail += a;
      add_product(bend, L::all(Real(k)), a);
      end += term;
      power = power * h;
    }
    rest += tail;
    const Hull<T> hull(b);
    const T below = -one;
    const T sign0 = choose(s[0] > zero, one, below);
    const T slow = L::all(Real(1e-10)) * rest; // as in sign_changes_in
    const T leaves = choose(s[1] > zero, one, below);
    const T begun = choose(first > slow, sign0, leaves);
    const T before = choose(above_ == zero, begun, above_);
    const T sign1 = choose(end > zero, one, choose(end < zero, below, before)); // 0 decides nothing
    // 1 where a crossing, or doubt, remains
    const T same_start = choose(sign0 == above_, one, zero);
    T boring = choose(sign1 == above_, one, zero);
    // a single sign change that nobody asked for needs no place
    if (!rising_) boring = choose(above_ < zero, one, boring);
    if (!falling_) boring = choose(above_ > zero, one, boring);
    tail += slow; // and what rounding makes of the bounds
    bend += slow;
    const T apart = choose(larger(hull.low, T(-hull.high)) > tail, same_start, zero);
    const T monotone = choose(larger(hull.least_slope, T(-hull.most_slope)) > bend, boring, zero);
    const T large = choose(rest < small, zero, one);
    const T look = choose((apart + monotone) * large > zero, zero, one);
    for (int lane = 0; lane < L::size; ++lane)
      if (!(L::get(look, lane) == Real(0))) closer(lane, L::get(above_, lane));
    above_ = sign1;
  }

  /// The wanted sign changes in one lane.  `noise` says below what S is taken for 0, as on an invariant plane where it
  /// vanishes identically, if its terms in this step have the size that it is given.
  template <class Noise>
  int sign_changes_in(int lane, const T* s, int p, const Real& h, const Real& sign_before,
                      const Noise& noise, Root<Real>* roots, int capacity, int& tangencies,
                      bool* hidden = nullptr, double less_certain = 1) const {
    Real b[max_degree + 1];
    Real power(1), scale(0);
    for (int k = 0; k <= p; ++k) {
      b[k] = L::get(s[k], lane) * power;
      scale += root_search::size_of(b[k]);
      power = power * h;
    }
    bool above = sign_before > Real(0);
    const Real small = noise(scale);
    if (sign_before ==
        Real(0)) { // a new orbit; one that starts on the section has crossed it already
      const bool off = root_search::size_of(b[0]) > Real(4) * small;
      above = (off ? b[0] : b[1]) > Real(0);
    }
    return sign_changes(b, p, small, above, falling_, rising_, roots, capacity, tangencies, hidden,
                        less_certain);
  }

private:
  bool falling_, rising_;
  T above_{}; ///< 1, -1; 0: not known yet
};

} // namespace KOV_ISA
} // namespace kov::flow
