#pragma once
// exp(int w dz) for a rational function w of z and parameters, as a product of powers and an exponential.

#include "exact/multivariate.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kov::strata {

/// prod base^exponent * exp(exponential); the exponents are free of z.
struct LogIntegral {
  std::vector<std::pair<MPoly, MFraction>> powers;
  MFraction exponential;
};

/// Unset where a residue is not the same at all roots of an irreducible factor of the denominator, or that
/// factor is not linear and has a multiple pole.  Checked: the logarithmic derivative is w.
/// Given   const MFraction w = a / z + MFraction(Rational(1)*z);
/// Example to_string(log_integral(w, 0)->exponential)  // -> z^2/2
/// Example log_integral(w, 0)->powers.at(0).second  // -> a
/// Example to_string(log_integral(a / (z * z), 0)->exponential)  // -> -a/z
[[nodiscard]] std::optional<LogIntegral> log_integral(const MFraction& w, std::size_t z);

/// The logarithmic derivative.
[[nodiscard]] MFraction log_derivative(const LogIntegral& y, std::size_t z);

/// Polynomials that must not vanish for the formula to have a value; of each base one coefficient is enough.
struct Defined {
  std::vector<MPoly> denominators;
  std::vector<std::vector<MPoly>> bases; ///< coefficients in z
};
[[nodiscard]] Defined defined_where(const LogIntegral& y, std::size_t z);

} // namespace kov::strata
