#pragma once
// Power series solutions straight from the definition, for comparison.

#include "exact/rational_function.hpp"

#include <stdexcept>

namespace kov::testing {

/// f(z0 + t) modulo t^n.  Requires no pole at z0.
inline Poly series_at(const RationalFunction& f, const NfElem& z0, long n) {
  const Poly num = truncate(taylor_shift(f.num(), z0), n);
  const Poly den = truncate(taylor_shift(f.den(), z0), n);
  if (is_zero(den.coeff(0))) throw std::invalid_argument("a pole at the point of expansion");
  return truncate(num * inverse_series(den, n), n);
}

/// y modulo t^n with y'' + p y' + q y = 0, y(0) = y0, y'(0) = y1, for series p, q.
inline Poly solution_series(const Poly& p, const Poly& q, const NfElem& y0, const NfElem& y1,
                            long n) {
  std::vector<NfElem> y{y0, y1};
  for (long k = 0; k + 2 < n; ++k) {
    NfElem sum;
    for (long j = 0; j <= k; ++j) {
      sum += p.coeff(j) * NfElem(k - j + 1) * y[static_cast<std::size_t>(k - j + 1)];
      sum += q.coeff(j) * y[static_cast<std::size_t>(k - j)];
    }
    y.push_back(-sum / NfElem((k + 2) * (k + 1)));
  }
  return Poly::from_coefficients(y);
}

/// exp of a series without constant term: E' = f' E.
inline Poly exponential_series(const Poly& f, long n) {
  std::vector<NfElem> e{NfElem(1)};
  for (long k = 1; k < n; ++k) {
    NfElem sum;
    for (long j = 1; j <= k; ++j)
      sum += NfElem(j) * f.coeff(j) * e[static_cast<std::size_t>(k - j)];
    e.push_back(sum / NfElem(k));
  }
  return Poly::from_coefficients(e);
}

/// The integral without constant term.
inline Poly integral_series(const Poly& f) {
  Poly sum(f.field());
  for (long i = 0; i <= degree(f); ++i)
    sum += Poly::monomial(f.coeff(i) / NfElem(i + 1), i + 1);
  return sum;
}

} // namespace kov::testing
