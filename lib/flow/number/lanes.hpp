#pragma once
// Several orbits at once: a pack of N doubles is one GCC/Clang vector, and every lane has its own time,
// step and orbit; lanes never exchange values, so an orbit's result does not depend on its companions.
// Any other number type (long double, MPFR, ...) is a pack of one lane.
//
// This header is compiled once for each instruction set, in a namespace of its own (KOV_ISA), so that
// the linker cannot merge code for a newer processor into the code for an older one.

#include <cmath>
#include <cstring>
#include <type_traits>

#if defined(__FMA__)
#include <immintrin.h>
#endif

#ifndef KOV_ISA
#define KOV_ISA any
#endif

namespace kov::flow {
inline namespace KOV_ISA {

using Pack4 = double __attribute__((vector_size(32)));
using Pack8 = double __attribute__((vector_size(64)));
using Bits4 = long long __attribute__((vector_size(32)));
using Bits8 = long long __attribute__((vector_size(64)));

template <class T> struct Lanes {
  static constexpr int size = 1;
  using Real = T;
  using Step = double; ///< the type of the step and of its logarithm, one per lane
  using Bits = long long;
  static const T& get(const T& x, int) { return x; }
  static void set(T& x, int, const T& value) { x = value; }
  static T all(const T& value) { return value; }
};

template <class P, class B, int N> struct PackLanes {
  static constexpr int size = N;
  using Real = double;
  using Step = P;
  using Bits = B;
  static double get(const P& x, int lane) { return x[lane]; }
  static void set(P& x, int lane, double value) { x[lane] = value; }
  static P all(double value) { return P{} + value; }
};
template <> struct Lanes<Pack4> : PackLanes<Pack4, Bits4, 4> {};
template <> struct Lanes<Pack8> : PackLanes<Pack8, Bits8, 8> {};

/// a b + c, with one rounding where the processor has it.  The kernels are compiled without contraction and say
/// themselves where products are fused, so that packs of 1, 4 and 8 lanes round alike.
template <class T> inline T multiply_add(const T& a, const T& b, const T& c) { return a * b + c; }
#if defined(__FMA__)
inline double multiply_add(double a, double b, double c) { return __builtin_fma(a, b, c); }
inline Pack4 multiply_add(const Pack4& a, const Pack4& b, const Pack4& c) {
  return _mm256_fmadd_pd(a, b, c);
}
inline Pack8 multiply_add(const Pack8& a, const Pack8& b, const Pack8& c) {
#if defined(__AVX512F__)
  return _mm512_fmadd_pd(a, b, c);
#else
  Pack4 x[2], y[2], z[2];
  std::memcpy(x, &a, sizeof a);
  std::memcpy(y, &b, sizeof b);
  std::memcpy(z, &c, sizeof c);
  for (int i = 0; i < 2; ++i)
    z[i] = _mm256_fmadd_pd(x[i], y[i], z[i]);
  Pack8 out;
  std::memcpy(&out, z, sizeof out);
  return out;
#endif
}
#endif

/// acc += a b and acc -= a b.  Number types with an addition in place overload them.
template <class T> inline void add_product(T& acc, const T& a, const T& b) {
  if constexpr (Lanes<T>::size > 1 || sizeof(T) == sizeof(double))
    acc = multiply_add(a, b, acc);
  else
    acc += a * b;
}
template <class T> inline void sub_product(T& acc, const T& a, const T& b) {
  if constexpr (Lanes<T>::size > 1 || sizeof(T) == sizeof(double))
    acc = multiply_add(T(-a), b, acc);
  else
    acc -= a * b;
}

/// condition ? a : b in each lane.
template <class C, class T> inline T choose(const C& condition, const T& a, const T& b) {
  return condition ? a : b;
}
template <class T> inline T larger(const T& a, const T& b) { return choose(a < b, b, a); }
template <class T> inline T smaller(const T& a, const T& b) { return choose(a < b, a, b); }
template <class T> inline T absolute(const T& a) {
  if constexpr (std::is_same_v<typename Lanes<T>::Real, double>) {
    typename Lanes<T>::Bits
        bits; // clearing the bit of the sign is one instruction instead of three
    std::memcpy(&bits, &a, sizeof a);
    bits &= 0x7fffffffffffffffLL;
    T out;
    std::memcpy(&out, &bits, sizeof a);
    return out;
  } else {
    return choose(a < T{}, T(-a), a);
  }
}

/// Half the distance from 1 to the next number.
template <class R> inline R unit_roundoff() {
  return R(sizeof(R) > 8 ? 5.4e-20 : 1.1102230246251565e-16);
}

/// log2 of a positive double to 1e-2 (absolute); 0 gives about -1023.  S: double or a pack.
template <class S> inline S log2_estimate(const S& x) {
  using B = typename Lanes<S>::Bits;
  B bits;
  std::memcpy(&bits, &x, sizeof x);
  // The exponent as a double without an integer conversion: put its 11 bits under 2^52.
  const B high = ((bits >> 52) & 0x7ffLL) | 0x4330000000000000LL;
  const B low = (bits & 0x000fffffffffffffLL) | 0x3ff0000000000000LL;
  S exponent, m;
  std::memcpy(&exponent, &high, sizeof x);
  std::memcpy(&m, &low, sizeof x);
  exponent = exponent - (4503599627370496.0 + 1023.0);
  m = m - 1.0;
  return exponent + m * (1.3444 - m * 0.3444);
}

inline double log2_estimate(const long double& x) {
  int e = 0;
  const long double m = std::frexp(x, &e);
  return x > 0 ? e + 2.0 * (static_cast<double>(m) - 1.0) : -16500.0;
}

/// 2^x to 1e-3 (relative), for x clipped to [-1000, 1000].
template <class S> inline S exp2_estimate(S x) {
  using B = typename Lanes<S>::Bits;
  const S zero{};
  x = x < zero - 1000.0 ? zero - 1000.0 : x;
  x = x > zero + 1000.0 ? zero + 1000.0 : x;
  const double magic = 6755399441055744.0; // 1.5 * 2^52: the sum holds round(x) in its low bits
  const S shifted = x + magic;
  const S f = x - (shifted - magic);
  B bits;
  std::memcpy(&bits, &shifted, sizeof x);
  const B power = ((bits & 0xfffLL) + 1023LL) << 52;
  S scale;
  const B clean = power & 0x7ff0000000000000LL;
  std::memcpy(&scale, &clean, sizeof x);
  return scale * (1.0 + f * (0.69315 + f * (0.24023 + f * 0.0558)));
}

} // namespace KOV_ISA
} // namespace kov::flow
