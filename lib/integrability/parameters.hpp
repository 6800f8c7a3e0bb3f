#pragma once
// From a system with free parameters to the question of lib/strata.

#include "integrability/check.hpp"

namespace kov {

/// r, the assumptions on the parameters, and what must not vanish for r to be what it is.
/// Errors  InvalidArgument: r depends on something that is not a parameter
[[nodiscard]] strata::Question strata_question(const System& s, const AlgebraicOde& ode);

/// Parameters of the levels only: the vector field does not contain them, and they may be chosen.
[[nodiscard]] std::vector<std::size_t> level_parameters(const System& s);

/// Decides the strata on which the reduction is not valid by doing it again there.
void decide_special_strata(const System& s, const ManifoldSpec& spec,
                           const std::vector<ClaimReport>& claims, const CheckOptions& options,
                           const std::vector<std::string>& unknowns, strata::StrataAnswer& answer);

[[nodiscard]] strata::StrataLimits strata_limits(const System& s, const AlgebraicOde& ode,
                                                 const CheckOptions& options);

} // namespace kov
