#pragma once
// Zeros of a polynomial b_0 + b_1 x + ... on [0, 1], all of them or an honest "a tangency closer than delta".
//
// Bounds decide nearly all intervals without looking further (x in [0, 1]): with q = b_0 + ... + b_5 x^5 between the
// least and the largest of its Bernstein coefficients, and q' between those of its own,
//   |q| > sum_{k>=6} |b_k|           no zero;
//   |q'| > sum_{k>=6} k |b_k|        strictly monotone: a zero if and only if the ends differ in sign.
// If neither holds, the interval is halved (Taylor shift).  At width 2^-max_depth what is left is a
// zero of even order up to |b| 2^-max_depth: it counts once if the ends differ in sign and not at
// all otherwise.  Two sign changes between which b stays within noise are a touch, too.
// The sign at the start is given by the caller, who carries it from the end of the step before: so no
// crossing is counted twice or lost when a step ends on the section to within rounding.

#include "flow/number/lanes.hpp"

namespace kov::flow {

inline constexpr int max_degree = 256;
inline constexpr int max_depth = 24, touch_depth = 12;

inline namespace KOV_ISA {

template <class R> struct Root {
  R x;          ///< in [0, 1]
  bool falling; ///< the polynomial goes from + to -
};

/// Bounds of b_0 + ... + b_5 x^5 and of its derivative on [0, 1].
template <class T> struct Hull {
  static constexpr int degree = 5;
  T low, high, least_slope, most_slope;

  /// b: destroyed
  explicit Hull(T (&b)[degree + 1]) {
    using L = Lanes<T>;
    using Real = typename L::Real;
    const T fifth = L::all(Real(1) / Real(5)), tenth = L::all(Real(1) / Real(10));
    b[1] = b[1] * fifth; // b_k over 5 choose k, and the triangle of sums
    b[2] = b[2] * tenth;
    b[3] = b[3] * tenth;
    b[4] = b[4] * fifth;
    for (int i = 1; i <= degree; ++i)
      for (int k = degree; k >= i; --k)
        b[k] += b[k - 1];
    low = high = b[0];
    least_slope = most_slope = b[1] - b[0];
    for (int k = 1; k <= degree; ++k) {
      low = smaller(low, b[k]);
      high = larger(high, b[k]);
      if (k == 1) continue;
      const T slope = b[k] - b[k - 1];
      least_slope = smaller(least_slope, slope);
      most_slope = larger(most_slope, slope);
    }
    const T five = L::all(Real(5));
    least_slope = least_slope * five;
    most_slope = most_slope * five;
  }
};

/// The zero of a monotone b in [0, 1], given that the signs at the ends differ (falling: + to -).
/// Newton's steps inside a shrinking bracket, to the last bit of R.
template <class R> R monotone_zero(const R* b, int degree, bool falling) {
  R low(0), high(1);
  R slope(0); // of the chord, as the first guess
  for (int k = 1; k <= degree; ++k)
    slope += b[k];
  R x = b[0] == R(0) || slope == R(0) ? R(0) : R(R(0) - b[0] / slope);
  for (int i = 0; i < 2 && degree > 8; ++i) { // two steps with the first terms only are nearly free
    R value = b[5], rate(0);
    for (int k = 4; k >= 0; --k) {
      rate = rate * x + value;
      value = value * x + b[k];
    }
    x = x - value / rate;
  }
  if (!(x > low)) x = R(0);
  if (!(x < high)) x = R(1);
  for (int i = 0; i < 200; ++i) {
    R value = b[degree], rate(0);
    for (int k = degree - 1; k >= 0; --k) {
      rate = rate * x + value;
      value = value * x + b[k];
    }
    if (value == R(0)) return x;
    ((value > R(0)) == falling ? low : high) = x;
    R next = rate == R(0) ? x : R(x - value / rate);
    if (!(next > low) || !(next < high)) {
      if (next == x) return x;
      const R middle = (low + high) / R(2);
      // A Newton step out of the bracket by rounding alone means that x is the zero already.
      if (!(middle > low) || !(middle < high)) return x;
      next = middle;
    }
    const R move = next > x ? R(next - x) : R(x - next);
    const R from = x;
    x = next;
    if (from + move * move == from && move < R(1) / R(1024))
      return x; // the next move is below the last bit
  }
  return x;
}

namespace root_search {

template <class R> struct Isolation {
  Root<R>* out;
  int capacity, found = 0, tangencies = 0;
  bool falling, rising; ///< which changes are wanted
  R noise;              ///< what is smaller is 0
  bool above;           ///< sign at the start of what is left to search
  bool hidden = false;  ///< a part longer than 2^-touch_depth was within noise
};

// |b| in the middle between two zeros.
template <class R> R size_between(const R* b, int degree, const R& x, const R& y) {
  const R middle = (x + y) / R(2);
  R value = b[degree];
  for (int k = degree - 1; k >= 0; --k)
    value = value * middle + b[k];
  return value < R(0) ? R(R(0) - value) : value;
}

template <class R> R size_of(const R& x) { return x < R(0) ? R(R(0) - x) : x; }

// A first look at b on [0, 1].
template <class R> struct Look {
  R size, end; ///< the sum of all |b_k|, b(1)
  bool apart, monotone;
  Look(const R* b, int degree) : size(size_of(b[0])), end(b[0]) {
    R tail(0), bend(0), first[Hull<R>::degree + 1]{};
    first[0] = b[0];
    for (int k = 1; k <= degree; ++k) {
      const R a = size_of(b[k]);
      size += a;
      end += b[k];
      if (k <= Hull<R>::degree) {
        first[k] = b[k];
      } else {
        tail += a;
        bend += R(k) * a;
      }
    }
    const Hull<R> hull(first);
    const R rounding = size * R(1e-10);
    tail += rounding;
    bend += rounding;
    apart = hull.low > tail || R(R(0) - hull.high) > tail;
    monotone = hull.least_slope > bend || R(R(0) - hull.most_slope) > bend;
  }
};

// b is destroyed.
template <class R>
void isolate(R* b, int degree, const R& start, const R& width, int depth, Isolation<R>& r) {
  const Look<R> look(b, degree);
  const bool apart = look.apart, monotone = look.monotone;
  const R& end = look.end;
  if (!(look.size > r.noise)) { // 0 as far as anybody can tell: the sign stays
    r.hidden = r.hidden || depth <= touch_depth;
    return;
  }
  if (!apart && !monotone && depth < max_depth) {
    R half[max_degree + 1];
    R scale(1);
    for (int k = 0; k <= degree; ++k, scale = scale / R(2))
      half[k] = b[k] * scale;
    for (int k = 0; k <= degree; ++k)
      b[k] = half[k];
    const R w = width / R(2);
    isolate(half, degree, start, w, depth + 1, r);
    for (int i = 0; i < degree; ++i) // Taylor shift by 1
      for (int k = degree - 1; k >= i; --k)
        b[k] += b[k + 1];
    isolate(b, degree, R(start + w), w, depth + 1, r);
    return;
  }
  const bool end_above = end > R(0) || (end == R(0) && r.above); // 0 decides nothing yet
  if (!apart && !monotone && end_above == r.above) ++r.tangencies;
  if (end_above == r.above) return;
  if ((r.above ? r.falling : r.rising) && r.found < r.capacity) {
    // A start sign that only the carried value has (b[0] itself is rounding) lands on the start.
    const bool straddles = (b[0] > R(0)) == r.above;
    const R x = straddles ? monotone_zero(b, degree, r.above) : R(0);
    r.out[r.found++] = {R(start + width * x), r.above};
  }
  r.above = end_above;
}

} // namespace root_search

/// The sign changes of b on [0, 1] of the wanted kinds, in order, given the sign at the start.
///
/// Shape     b has degree + 1 coefficients and is destroyed; at most `capacity` roots are written
/// Noise     where |b| <= noise the sign stays what it was (a polynomial that is 0 has no sign changes)
/// Returns   how many were written; `above` becomes the sign at the end; `tangencies` counts zeros of even
///           order up to 2^-max_depth of the interval, and, as far as 2^-touch_depth, up to noise (times less_certain); `hidden`: b is within noise on a longer part
template <class R>
int sign_changes(R* b, int degree, const R& noise, bool& above, bool falling, bool rising,
                 Root<R>* out, int capacity, int& tangencies, bool* hidden = nullptr,
                 double less_certain = 1) {
  R whole[max_degree + 1];
  for (int k = 0; k <= degree; ++k)
    whole[k] = b[k];
  root_search::Isolation<R> r{out, capacity, 0, 0, true, true, noise, above};
  root_search::isolate(b, degree, R(0), R(1), 0, r);
  above = r.above;
  tangencies += r.tangencies;
  const R touch = noise * R(less_certain);
  int kept = 0;
  for (int i = 0; i < r.found; ++i) {
    if (i + 1 < r.found &&
        !(root_search::size_between(whole, degree, out[i].x, out[i + 1].x) > touch)) {
      if (!(out[i + 1].x - out[i].x > R(1.0 / (1 << touch_depth)))) {
        ++tangencies;
        ++i;
        continue;
      }
      r.hidden = true;
    }
    if (out[i].falling ? falling : rising) {
      out[kept++] = out[i];
    }
  }
  if (hidden != nullptr) *hidden = r.hidden;
  return kept;
}

} // namespace KOV_ISA
} // namespace kov::flow
