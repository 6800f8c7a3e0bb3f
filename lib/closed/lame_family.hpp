#pragma once
// Lame's equation recognised in y'' = r(z) y whose coefficients depend on parameters.
//
// With f = 4x^3 - g2 x - g3 and r = N/P^2, P = f/4:  256 N - 4 f f'' + 3 f'^2 = 16 f (alpha x + B).
// The place with exponent difference n + 1/2 is infinity or a rational root of the denominator; it
// goes to infinity by z = c + 1/x, and the sum of the other three to 0.  Equations that depend on
// (z - c)^2 only are tried in w = (z - c)^2, a finite extension that does not change the identity
// component.
//
// Source  docs/theory/recognition.md 3-5

#include "closed/lame_polynomials.hpp"
#include "exact/budget.hpp"

#include <optional>
#include <vector>

namespace kov {

/// y_tt = (alpha wp(t; g2, g3) + B) y, an identity over Q(parameters).
struct LameFamilyForm {
  MFraction alpha; ///< n(n+1)
  LameParameters<MFraction> parameters;
  std::size_t z = 0;
  MFraction map;        ///< x as a function of z
  bool squared = false; ///< the equation was one in (z - c)^2
  /// The identity holds for all parameter values where these are not 0 and r is defined.
  std::vector<MPoly> generic;
};

/// Unset for other equations, and for places that are rational for special parameters only.
/// Cost  one factorisation of the denominator; a few operations with polynomials of degree <= 8
/// Throws OutOfBudget
/// Given  const Ring ring = make_ring({"z", "a", "b"});
/// Given  const MFraction x = MFraction::variable(ring, "z"), a = MFraction::variable(ring, "a"),
///            b = MFraction::variable(ring, "b"), f = pow(x, 3) - x, df = derivative(f, 0);
/// Given  const MFraction r = derivative(df, 0) / (Rational(4) * f) -
///            Rational(3, 16) * df * df / (f * f) + (a * x + b) / (Rational(4) * f);
/// Example recognize_lame(r, 0)->alpha  // -> a
/// Example recognize_lame(r, 0)->parameters  // -> {b, 4, 0}
[[nodiscard]] std::optional<LameFamilyForm> recognize_lame(const MFraction& r, std::size_t z,
                                                           const Budget& budget = {});

} // namespace kov
