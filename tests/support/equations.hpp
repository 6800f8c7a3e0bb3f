#pragma once
// Equations with known groups, for the tests.

#include "exact/rational_function.hpp"

namespace kov::testing {

/// omega' + omega^2: y = exp(int omega) is a solution.
[[nodiscard]] RationalFunction from_omega(const RationalFunction& omega);

/// The r whose solutions have y1 y2 = v, v^2 = f, and Wronskian w:
/// r = w^2/(4 f) + phi'/2 + phi^2/4, phi = f'/(2f).
[[nodiscard]] RationalFunction from_square(const RationalFunction& f, const NfElem& w_squared);

/// Riemann's equation with squared exponent differences at 0, 1, infinity.
[[nodiscard]] RationalFunction riemann(const NfElem& at0, const NfElem& at1, const NfElem& at_inf);

/// Lame's equation y_tt = (alpha wp + B) y over C(wp), alpha = n(n+1).
[[nodiscard]] RationalFunction lame(const NfElem& alpha, const NfElem& B, const NfElem& g2,
                                    const NfElem& g3);

/// z -> f(z): r(f) f'^2 - (Schwarzian of f)/2.
[[nodiscard]] RationalFunction pull_back(const RationalFunction& r, const RationalFunction& f);

/// The equation of (a y + y')/sqrt(r + a' - a^2): the same projective group, and apparent
/// singularities.  Requires r + a' - a^2 != 0.
[[nodiscard]] RationalFunction gauge(const RationalFunction& r, const RationalFunction& a);

} // namespace kov::testing
