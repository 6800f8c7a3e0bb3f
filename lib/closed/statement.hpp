#pragma once
// Does a statement hold on a region?  docs/theory/strata.md, 10

#include "closed/arithmetic.hpp"
#include "parameters/parametrised_set.hpp"

namespace kov::strata {

/// yes, no: at every point of the region.  The squares are in the parameters that are left.
/// Given   Assumptions integral; integral.require_integral(a, true);
/// Given   const ParametrisedSet integers(ring, integral);
/// Example holds_on(SumIn{{a * a}, {{0, 1}}}, integers)  // -> Truth::yes
/// Example holds_on(SumIn{{a * a}, {{Rational(1, 2), 1}}}, integers)  // -> Truth::no
/// Example holds_on(SumIn{{a}, {{0, 1}}}, integers)  // -> Truth::unknown
[[nodiscard]] Truth holds_on(const Assertion& s, const ParametrisedSet& region);

/// p is known to vanish nowhere on the region, without the oracle for real numbers.
[[nodiscard]] bool is_plainly_nonzero(const MPoly& p, const ParametrisedSet& region);

/// The rational number x >= 0 with this square, if it is one for all parameters.
[[nodiscard]] std::optional<Rational> constant_root(const MFraction& square);
/// The value of a function that depends on no parameter.
[[nodiscard]] std::optional<Rational> constant_value(const MFraction& f);

} // namespace kov::strata
