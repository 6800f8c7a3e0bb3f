#pragma once
// The second opinion: sums of residues in the strip by validated integration along contours.
//
// Little is shared with residue_sums: M(t) comes from sech and tanh of complex t, Gamma(t, g0) from
//
//   Gamma = (F/G^2) M + (s/2G) (E e^(i g0) + E* e^(-i g0)),
//   E = e^(i G b t) (i sigma (alpha + i beta tanh), -delta sech, -(alpha tanh + i beta))/delta,
//
// a null vector that turns with the body (E' = E x Omega), with t itself in the exponential, so
// that no branch is chosen; H1 from the Euler-Poisson formula, h_k from a discrete Fourier
// transform over g0 (exact for a trigonometric polynomial).  The trapezoidal rule with N points on
// |t - t0| = r is exact up to the terms n = jN - 1 of the Laurent series; those with j < 0 vanish
// because M and Gamma have simple poles, the others are bounded by the maximum on a larger circle
// rho (a ball evaluation over arcs): error <= M rho q/(1 - q), q = (r/rho)^N.

#include "exact/ball.hpp"
#include "splitting/perturbation.hpp"

#include <map>

namespace kov {

struct OrbitPoint {
  Rational a, b, c;                           ///< 0 < a < b < c
  Rational G, F;                              ///< 0 < F < G
  std::map<std::string, Rational> parameters; ///< of H1, without the moments
};

/// (1/(2 pi i)) times the integral of h_k(t) dt around both poles of the strip, times e^(k pi
/// nu/2). Cost  some milliseconds for 50 digits
[[nodiscard]] ComplexBall strip_integral(const EulerPerturbation& p, const OrbitPoint& at, long k,
                                         int sign, long bits);

/// f at the given values of its variables.
[[nodiscard]] ComplexBall evaluate(const MFraction& f, const std::map<std::size_t, ComplexBall>& at,
                                   long bits);

/// alpha, beta, delta, ..., Y of the orbit space at the point, for `evaluate`.
[[nodiscard]] std::map<std::size_t, ComplexBall> values_at(const Ring& ring, const OrbitPoint& at,
                                                           long bits);

} // namespace kov
