#pragma once
// A condition on the exponents that an exponential solution needs, for all parameters at once: some choice of
// them leaves a natural number for the degree of its polynomial part.
//
// Source  docs/theory/strata.md, 10.9; local_exponents.md, 3.2

#include "parameters/statement.hpp"
#include "places/scheme.hpp"

namespace kov::strata {

/// There is no exponential solution where the statement fails.  false: there is none anywhere.
/// Unset: nothing follows, or three numbers or more would have to be added up.
/// Given   const Scheme s = std::get<Scheme>(scheme(pow(z, 4) + a * z, 0, everywhere));
/// Example to_string({std::get<SumIn>(*exponential_needs(s))})  // -> a is an even integer
[[nodiscard]] std::optional<std::variant<bool, SumIn>> exponential_needs(const Scheme& s);

} // namespace kov::strata
