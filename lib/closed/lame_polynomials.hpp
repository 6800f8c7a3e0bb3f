#pragma once
// The polynomials that belong to Lame's equation
//
//   y_tt = (n(n+1) wp(t; g2, g3) + B) y,      with x = wp(t), f = 4x^3 - g2 x - g3:
//   f y'' + f'/2 y' - (n(n+1) x + B) y = 0,
//
// for given n, with B, g2, g3 in a field R: numbers (NfElem) or rational functions of parameters
// (MFraction).  All are polynomials in B, g2, g3 (no denominators but numbers), homogeneous for the
// weights 1, 2, 3, so that they hold for every value of the parameters.
//
// Source  [Halphen1888], [Poole1936] IX, [Brioschi1877]; derived in docs/theory/lame.md

#include "exact/budget.hpp"
#include "exact/multivariate.hpp"
#include "exact/number_field.hpp"

#include <vector>

namespace kov {

/// B, g2, g3.
template <class R> struct LameParameters {
  R b;
  R g2;
  R g3;
};

/// The determinant of Brioschi, monic in B: there is no logarithm at infinity for n = m - 1/2
/// exactly when Q_m(B, g2, g3) = 0.  Requires m >= 1.   Cost  O(m) operations in R
/// Given   const Ring ring = make_ring({"B", "g2", "g3"});
/// Given   const LameParameters<MFraction> p{MFraction::variable(ring, 0),
///             MFraction::variable(ring, 1), MFraction::variable(ring, 2)};
/// Example brioschi(2, p)  // -> (4*B^2 - 3*g2)/4
template <class R> [[nodiscard]] R brioschi(long m, const LameParameters<R>& p);

/// n >= 0 an integer: X(x) = product of two solutions, a polynomial of degree n, monic; ascending.
/// w^2 = X_t^2 - 2 X X_tt + 4 (n(n+1) x + B) X^2 is constant, of degree 2n+1 in B.
/// Cost    O(n^2) operations in R.  Throws InternalError if w^2 is not constant
/// Example lame_hermite(1, p)  // -> {{-B, 1}, 4*B^3 - B*g2 - g3}
template <class R> struct LameHermite {
  std::vector<R> x;
  R w_squared;
};
template <class R> [[nodiscard]] LameHermite<R> lame_hermite(long n, const LameParameters<R>& p);

/// Polynomials in B, g2, g3 that vanish together exactly when the m-th symmetric power (m even, 2
/// <= m <= 12) has a solution F(y1, y2) != 0 that is a polynomial in x; {1} if there never is one.
/// Requires  n >= -1/2, not in (1/2)Z
/// Cost      O(m d^2) operations in R, d = m n/2 the degree in x
template <class R>
[[nodiscard]] std::vector<R> invariant_conditions(const Rational& n, long m,
                                                  const LameParameters<R>& p,
                                                  const Budget& budget = {});

} // namespace kov
