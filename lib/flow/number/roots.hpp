#pragma once
// Zeros of a polynomial b_0 + b_1 x + ... on [0, 1], all of them or an honest "a tangency closer than delta".
//
// Two bounds decide most intervals without looking further (x in [0, 1]):
//   |b_0| > sum_{k>=1} |b_k|         no zero;
//   |b_1| > sum_{k>=2} k |b_k|       strictly monotone: a zero if and only if the ends differ in sign.
// Where neither does, the interval is halved (Taylor shift).  At width 2^-max_depth what is left is a zero of
// even order up to |b| 2^-max_depth: it counts once if the ends differ in sign and not at all otherwise.
// The sign at the start is given by the caller, who carries it from the end of the step before: so no
// crossing is counted twice or lost when a step ends on the section to within rounding.

#include "flow/number/lanes.hpp"

namespace kov::flow {

inline constexpr int max_degree = 256;
inline constexpr int max_depth = 24;

inline namespace KOV_ISA {

template <class R> struct Root {
  R x{};                ///< in [0, 1]
  bool falling = false; ///< the polynomial goes from + to -
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
};

template <class R> R size_of(const R& x) { return x < R(0) ? R(R(0) - x) : x; }

// b is destroyed.
template <class R>
void isolate(R* b, int degree, const R& start, const R& width, int depth, Isolation<R>& r) {
  R rest(0), bend(0), end = b[0];
  for (int k = 1; k <= degree; ++k) {
    const R a = size_of(b[k]);
    rest += a;
    if (k > 1) bend += R(k) * a;
    end += b[k];
  }
  if (!(size_of(b[0]) + rest > r.noise)) return; // 0 as far as anybody can tell: the sign stays
  const bool apart = size_of(b[0]) > rest;
  const bool monotone = degree >= 1 && size_of(b[1]) > bend;
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
///           order up to 2^-max_depth of the interval
template <class R>
int sign_changes(R* b, int degree, const R& noise, bool& above, bool falling, bool rising,
                 Root<R>* out, int capacity, int& tangencies) {
  root_search::Isolation<R> r{out, capacity, 0, 0, falling, rising, noise, above};
  root_search::isolate(b, degree, R(0), R(1), 0, r);
  above = r.above;
  tangencies += r.tangencies;
  return r.found;
}

} // namespace KOV_ISA
} // namespace kov::flow
