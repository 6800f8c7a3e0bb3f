#pragma once
// First derivatives along: a value with its gradient in two variables, over any number type.  Through the
// kernels it gives the solution of the variational equations with the orbit.

#include "flow/number/lanes.hpp"

#include <cmath>
#include <concepts>

namespace kov::flow {

template <class R> struct Dual {
  R v{};    ///< value
  R d[2]{}; ///< derivatives
  Dual() = default;
  Dual(std::same_as<int> auto n) : v(n) {} // no double becomes one
  Dual(const R& value) : v(value) {}
  Dual(const R& value, const R& d0, const R& d1) : v(value), d{d0, d1} {}

  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.v + b.v, a.d[0] + b.d[0], a.d[1] + b.d[1]};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.v - b.v, a.d[0] - b.d[0], a.d[1] - b.d[1]};
  }
  friend Dual operator-(const Dual& a) { return {R(-a.v), R(-a.d[0]), R(-a.d[1])}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.v * b.v, a.v * b.d[0] + a.d[0] * b.v, a.v * b.d[1] + a.d[1] * b.v};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const R q = a.v / b.v;
    return {q, (a.d[0] - q * b.d[0]) / b.v, (a.d[1] - q * b.d[1]) / b.v};
  }
  // by value: which branch a computation takes
  friend bool operator<(const Dual& a, const Dual& b) { return a.v < b.v; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.v > b.v; }
  friend bool operator==(const Dual& a, const Dual& b) { return a.v == b.v; }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
};

template <class R> inline void add_product(Dual<R>& acc, const Dual<R>& a, const Dual<R>& b) {
  add_product(acc.v, a.v, b.v);
  for (int i = 0; i < 2; ++i) {
    add_product(acc.d[i], a.v, b.d[i]);
    add_product(acc.d[i], a.d[i], b.v);
  }
}
template <class R> inline void sub_product(Dual<R>& acc, const Dual<R>& a, const Dual<R>& b) {
  add_product(acc, Dual<R>(-a), b);
}
/// f(a) with f'(a) = slope.
template <class R> Dual<R> chain(const R& value, const R& slope, const Dual<R>& a) {
  return {value, slope * a.d[0], slope * a.d[1]};
}
template <class R> Dual<R> sqrt(const Dual<R>& a) {
  using std::sqrt;
  const R root = sqrt(a.v);
  return chain(root, R(R(1) / (R(2) * root)), a);
}
template <class R> Dual<R> sin(const Dual<R>& a) {
  using std::cos;
  using std::sin;
  return chain(R(sin(a.v)), R(cos(a.v)), a);
}
template <class R> Dual<R> cos(const Dual<R>& a) {
  using std::cos;
  using std::sin;
  return chain(R(cos(a.v)), R(-sin(a.v)), a);
}
template <class R> Dual<R> atan2(const Dual<R>& y, const Dual<R>& x) {
  using std::atan2;
  const R size = x.v * x.v + y.v * y.v;
  Dual<R> a(R(atan2(y.v, x.v)));
  for (int i = 0; i < 2; ++i)
    a.d[i] = (x.v * y.d[i] - y.v * x.d[i]) / size;
  return a;
}

} // namespace kov::flow
