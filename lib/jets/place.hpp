#pragma once
// The solution of an invariant plane, and the first variational equation, at a place over
// y = infinity (docs/theory/jets.md 3).
//
//   potential(y) of degree k >= 3,  sigma = -2/(k - 2),  t the time times a constant:
//   y  = s t^sigma + ... , s = +-1, one free coefficient e,
//   u_i = t^rho_i + ... , rho_1 < rho_2, rho_1 + rho_2 = 1: solutions of the normal equation.
//
// All are series in s with t = s^d.

#include "exact/budget.hpp"
#include "jets/plane.hpp"
#include "jets/series.hpp"

namespace kov::jets {

struct Place {
  int sign = 1;          ///< of y; what follows is about the plane reflected() if it is -1
  long degree = 0;       ///< k
  long ramification = 1; ///< d
  long terms = 0;        ///< of y
  Rational rho1, rho2;
  MFraction time_scale;             ///< t^2 = (time)^2 / time_scale
  Series y, y_t, y_e;               ///< the solution and its derivatives
  Series normal_force, plane_force; ///< of the equations u'' = w u across and along
  Series u1, u2;
  MFraction energy; ///< H on the solution, as a function of e

  [[nodiscard]] Rational difference() const { return rho2 - rho1; }
};

/// terms: so many of y.
/// Errors  NeedsMoreTerms, OutOfBudget
[[nodiscard]] std::variant<Place, OutOfScope> place_at_infinity(const InvariantPlane& plane,
                                                                long terms, const Budget& budget);

/// u'' = w u + f, w = lead/t^2 + ..., t = s^d.
struct SecondOrder {
  Series w;
  Rational lead;
  long d = 1;
  long terms = 0; ///< no more than that of a solution
};
/// A solution with free coefficients 0, but for the first one if u is to begin with s^start; unset:
/// there is none without a logarithm.
[[nodiscard]] std::optional<Series> solution(const SecondOrder& equation, const Series& f,
                                             std::optional<long> start,
                                             const InvariantPlane& plane);

} // namespace kov::jets
