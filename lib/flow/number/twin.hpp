#pragma once
// Twice the digits of double: the unevaluated sum of two doubles (or of two packs of doubles), 31 decimal digits.
//
// Error-free transformations: [Dekker1971], [Knuth, TAOCP 2, 4.2.2]; the operations below are the usual
// "accurate" ones, with relative errors of a few 2^-104.  They need the compiler to leave sums alone
// (-ffp-contract=off and no -ffast-math), and use the processor's fused product if it has one.

#include "flow/number/lanes.hpp"

#include <concepts>

namespace kov::flow {

/// hi + lo, |lo| <= ulp(hi)/2.  P: double or a pack.
template <class P> struct Twin {
  P hi{}, lo{};
  // inlined always: the linker must not share them between instruction sets
  [[gnu::always_inline]] constexpr Twin() = default;
  [[gnu::always_inline]] constexpr Twin(const P& high, const P& low = P{}) : hi(high), lo(low) {}
  [[gnu::always_inline]] explicit operator double() const requires std::same_as<P, double> {
    return hi;
  }
};
using Twin1 = Twin<double>;

inline namespace KOV_ISA {

template <class P> inline P product_error(const P& a, const P& b, const P& product) {
#if defined(__FMA__)
  return multiply_add(a, b, P(-product));
#else
  const double split = 134217729.0; // 2^27 + 1 [Dekker1971]
  const P ca = a * split, cb = b * split;
  const P ah = ca - (ca - a), bh = cb - (cb - b);
  const P al = a - ah, bl = b - bh;
  return ((ah * bh - product) + ah * bl + al * bh) + al * bl;
#endif
}

template <class P> inline Twin<P> two_sum(const P& a, const P& b) {
  const P s = a + b;
  const P back = s - a;
  return {s, (a - (s - back)) + (b - back)};
}
template <class P> inline Twin<P> quick_two_sum(const P& a, const P& b) { // |a| >= |b|
  const P s = a + b;
  return {s, b - (s - a)};
}

template <class P> inline Twin<P> operator+(const Twin<P>& a, const Twin<P>& b) {
  Twin<P> s = two_sum(a.hi, b.hi);
  const Twin<P> t = two_sum(a.lo, b.lo);
  s = quick_two_sum(s.hi, P(s.lo + t.hi));
  return quick_two_sum(s.hi, P(s.lo + t.lo));
}
template <class P> inline Twin<P> operator-(const Twin<P>& a) { return {P(-a.hi), P(-a.lo)}; }
template <class P> inline Twin<P> operator-(const Twin<P>& a, const Twin<P>& b) { return a + (-b); }
template <class P> inline Twin<P> operator*(const Twin<P>& a, const Twin<P>& b) {
  const P p = a.hi * b.hi;
  P e = product_error(a.hi, b.hi, p);
  e = e + (multiply_add(a.hi, b.lo, P(a.lo * b.hi)));
  return quick_two_sum(p, e);
}
template <class P> inline Twin<P> operator/(const Twin<P>& a, const Twin<P>& b) {
  const P q1 = a.hi / b.hi;
  Twin<P> r = a - Twin<P>{q1} * b;
  const P q2 = r.hi / b.hi;
  r = r - Twin<P>{q2} * b;
  const P q3 = r.hi / b.hi;
  return quick_two_sum(q1, q2) + Twin<P>{q3};
}
template <class P> inline Twin<P>& operator+=(Twin<P>& a, const Twin<P>& b) { return a = a + b; }
template <class P> inline Twin<P>& operator-=(Twin<P>& a, const Twin<P>& b) { return a = a - b; }

// Comparisons give a truth value for each lane.
template <class P> inline auto operator<(const Twin<P>& a, const Twin<P>& b) {
  const P d = (a.hi - b.hi) + (a.lo - b.lo);
  return d < P{};
}
template <class P> inline auto operator>(const Twin<P>& a, const Twin<P>& b) { return b < a; }
template <class P> inline auto operator==(const Twin<P>& a, const Twin<P>& b) {
  return (a.hi == b.hi) & (a.lo == b.lo);
}

template <class C, class P>
inline Twin<P> choose(const C& condition, const Twin<P>& a, const Twin<P>& b) {
  return {condition ? a.hi : b.hi, condition ? a.lo : b.lo};
}

template <class P> inline void add_product(Twin<P>& acc, const Twin<P>& a, const Twin<P>& b) {
  const P p = a.hi * b.hi;
  P e = product_error(a.hi, b.hi, p);
  e = e + multiply_add(a.hi, b.lo, P(a.lo * b.hi));
  Twin<P> s = two_sum(acc.hi, p);
  acc = quick_two_sum(s.hi, P(s.lo + (acc.lo + e)));
}
template <class P> inline void sub_product(Twin<P>& acc, const Twin<P>& a, const Twin<P>& b) {
  add_product(acc, Twin<P>(-a), b);
}

template <class P> inline P log2_estimate(const Twin<P>& x) { return log2_estimate(x.hi); }
template <> inline Twin1 unit_roundoff<Twin1>() { return {2.5e-32}; }

template <class P> struct Lanes<Twin<P>> {
  static constexpr int size = Lanes<P>::size;
  using Real = Twin1;
  using Step = P;
  static Twin1 get(const Twin<P>& x, int lane) {
    return {Lanes<P>::get(x.hi, lane), Lanes<P>::get(x.lo, lane)};
  }
  static void set(Twin<P>& x, int lane, const Twin1& value) {
    Lanes<P>::set(x.hi, lane, value.hi);
    Lanes<P>::set(x.lo, lane, value.lo);
  }
  static Twin<P> all(const Twin1& value) {
    return {Lanes<P>::all(value.hi), Lanes<P>::all(value.lo)};
  }
};

} // namespace KOV_ISA
} // namespace kov::flow
