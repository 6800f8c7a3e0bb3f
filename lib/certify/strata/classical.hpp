#pragma once
// The closed criteria of classical equations: for which numbers the identity component is abelian
// (docs/theory/strata_certificates.md 7.8).  Here are the criteria alone; that an equation is one
// of these is checked in classical.cpp.

#include "certify/strata/certificate.hpp"
#include "exact/truth.hpp"
#include "proof/algebra/arithmetic.hpp"

#include <functional>

namespace kov::certify {

/// The `by` of a leaf that rests on a criterion: whittaker, bessel, riemann or lame.
[[nodiscard]] bool is_classical_rule(const std::string& name);

/// The criterion as text: "sqrt((nu^2)/(1)) + 1/2 is an integer".  It says the same for both roots,
/// and has no names but those of the certificate.
[[nodiscard]] std::string criterion(const ByClassical& leaf);

/// Facts known about the parameters on a stratum.
struct ParameterFacts {
  /// Is it an integer at every point, or at none?  It is not asked for constants.
  std::function<Truth(const Fraction&)> integral;
  std::function<bool(const MPoly&)> is_rational;
  std::function<bool(const MPoly&)> positive; ///< at every point
  std::size_t z = 0;                          ///< the variable
};
/// Does the criterion hold at every point, or at none?  Unknown where neither follows.
/// Requires  the numbers that the family has
[[nodiscard]] Truth criterion_holds(const ByClassical& leaf, const ParameterFacts& facts,
                                    Arithmetic& a);

/// Nothing for another family, if there are two such numbers, or if one is irrational everywhere.
[[nodiscard]] std::optional<OneDifference> one_difference(const ByClassical& leaf, Arithmetic& a);

/// f + c
[[nodiscard]] Fraction shifted(const Fraction& f, const Rational& c, Arithmetic& a);

} // namespace kov::certify
