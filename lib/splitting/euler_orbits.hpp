#pragma once
// The doubly asymptotic solutions of the Euler top, as rational functions of z = e^(lambda t).
//
// 0 < a < b < c are the inverse moments, alpha^2 = b - a, beta^2 = c - b, delta^2 = c - a,
// lambda = G alpha beta, nu = b/(alpha beta).
// On 2 H0 = b G^2 the saddles M = (0, +-G, 0) are joined by
//
//   M = G (beta/delta sech, -sigma tanh, sigma alpha/delta sech)(lambda t),  sigma = +-1,
//   sech = 2z/(z^2 + 1),  tanh = (z^2 - 1)/(z^2 + 1)
//
// (and by their images under t -> t + i pi/lambda, which is the same as M1, M3 -> -M1, -M3), with
//   e^(i g)/p = z^(i nu) f(z),   f = delta (z^2 + 1)/(G ((alpha - i beta) z^2 - (alpha + i beta)))
// up to a constant phase.  Both are checked, not believed: check_orbit.
//
// Source  [Ziglin1980]; re-derived in docs/theory/splitting.md

#include "splitting/andoyer_chart.hpp"

namespace kov {

/// The chart with the constants of the orbits: alpha, beta, delta, b, z and `more`.
struct OrbitSpace {
  AndoyerChart chart;
  SurdField field; ///< i, delta, s; and p on the orbit is eliminated by the caller
  MFraction a, b, c, lambda, nu;
};
[[nodiscard]] OrbitSpace orbit_space(const std::vector<std::string>& more);

struct DoublyAsymptotic {
  int sign = 1;    ///< sigma
  Triple momentum; ///< M(z)
  MFraction phase; ///< f(z)
};
[[nodiscard]] DoublyAsymptotic doubly_asymptotic(const OrbitSpace& o, int sign);

/// Euler's equations, the levels, the limits z -> 0 and infinity, and the equation for g.
[[nodiscard]] CheckedIdentities check_orbit(const OrbitSpace& o, const DoublyAsymptotic& orbit);

/// A function that is polynomial in M and trigonometric in g, on the orbit: the coefficient of
/// e^(i k g) becomes z^(i k nu) times this rational function of z.   Requires a mode of
/// fourier_modes.
[[nodiscard]] MFraction mode_on_orbit(const OrbitSpace& o, const DoublyAsymptotic& orbit,
                                      const MFraction& mode, long k);

} // namespace kov
