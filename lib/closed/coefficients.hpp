#pragma once
// Polynomials in one variable over R = Q(parameters) or a number field, as ascending coefficients:
// what the rooms below offer for one of the two only.

#include "exact/multivariate.hpp"
#include "exact/number_field.hpp"

#include <utility>
#include <vector>

namespace kov {

[[nodiscard]] inline NfElem scaled(const Rational& c, const NfElem& a) { return NfElem(c) * a; }
[[nodiscard]] inline MFraction scaled(const Rational& c, const MFraction& a) { return c * a; }

/// Ascending; the last one need not be different from 0.
/// Given   using C = Coefficients<NfElem>;
template <class R> using Coefficients = std::vector<R>;

[[nodiscard]] inline Coefficients<MFraction> in_z(const MPoly& f, std::size_t z) {
  const std::vector<MPoly> c = coefficients(f, z);
  return Coefficients<MFraction>(c.begin(), c.end());
}

/// to += c x^at
template <class R> void add(Coefficients<R>& to, std::size_t at, const R& c) {
  if (is_zero(c)) return;
  if (to.size() <= at) to.resize(at + 1);
  to[at] = to[at] + c;
}

/// a b
template <class R>
[[nodiscard]] Coefficients<R> product(const Coefficients<R>& a, const Coefficients<R>& b) {
  Coefficients<R> c;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!is_zero(a[i]))
      for (std::size_t j = 0; j < b.size(); ++j)
        add(c, i + j, R(a[i] * b[j]));
  return c;
}

/// da/dx
template <class R> [[nodiscard]] Coefficients<R> derivative(const Coefficients<R>& a) {
  Coefficients<R> c;
  for (std::size_t i = 1; i < a.size(); ++i)
    add(c, i - 1, scaled(Rational(static_cast<long>(i)), a[i]));
  return c;
}

/// a + factor b
template <class R>
[[nodiscard]] Coefficients<R> sum(Coefficients<R> a, const Coefficients<R>& b,
                                  const Rational& factor) {
  for (std::size_t i = 0; i < b.size(); ++i)
    add(a, i, scaled(factor, b[i]));
  return a;
}

/// Removes leading zeros.
template <class R> [[nodiscard]] Coefficients<R> trimmed(Coefficients<R> a) {
  while (!a.empty() && is_zero(a.back()))
    a.pop_back();
  return a;
}

/// a(x + c)
/// Example shifted(C{0, 0, 1}, NfElem(1))  // -> {1, 2, 1}
template <class R> [[nodiscard]] Coefficients<R> shifted(Coefficients<R> a, const R& c) {
  for (std::size_t i = 0; i + 1 < a.size(); ++i)
    for (std::size_t j = a.size() - 1; j-- > i;)
      a[j] = a[j] + c * a[j + 1];
  return a;
}

/// Quotient and remainder.  Requires b trimmed and not empty.
/// Example divided(C{-1, 0, 1}, C{-1, 1})  // -> {{1, 1}, {}}
template <class R>
[[nodiscard]] std::pair<Coefficients<R>, Coefficients<R>> divided(Coefficients<R> a,
                                                                  const Coefficients<R>& b) {
  Coefficients<R> q;
  a = trimmed(std::move(a));
  while (a.size() >= b.size()) {
    const R c = a.back() / b.back();
    const std::size_t at = a.size() - b.size();
    add(q, at, c);
    for (std::size_t i = 0; i < b.size(); ++i)
      a[at + i] = a[at + i] - c * b[i];
    a.pop_back(); // it is 0 now
    a = trimmed(std::move(a));
  }
  return {std::move(q), std::move(a)};
}

} // namespace kov
