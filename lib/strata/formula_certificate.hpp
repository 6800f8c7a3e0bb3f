#pragma once
// A certificate for an equation without parameters that a closed formula decides and no engine: the
// rule for classical equations of kovacic-strata/1 (strata_certificates.md 7.8), on one stratum.

#include "decide/certificate.hpp"
#include "decide/decide.hpp"

#include <optional>

namespace kov::strata {

/// A tree of one leaf: the change of variable to Whittaker's, Bessel's, Riemann's or Lame's
/// equation and the numbers that the criterion asks for.  It says whether the identity component is
/// abelian.
/// Unset where r is not over Q, or the format has no rule for the change.
/// Requires  d.because is ByFormula, and d.places
/// Throws    OutOfBudget
///
/// n(n+1)/z^2 - 1, Bessel's equation of an immense order:
/// Given   const Integer n = pow(Integer(10), 20);
/// Given   const RationalFunction r(Poly(Rational(n * (n + Integer(1)))) - Poly::z() * Poly::z(),
///             Poly::z() * Poly::z());
/// Given   Options options; options.want_certificate = true; options.budget.max_degree = 1000;
/// Example formula_certificate(decide({r, 0}, options))->refusal.empty()  // -> yes
[[nodiscard]] std::optional<Judged> formula_certificate(const Decision& d,
                                                        const Budget& budget = {});

} // namespace kov::strata
