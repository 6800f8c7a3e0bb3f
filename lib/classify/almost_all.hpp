#pragma once
// "For almost all parameters the system is not integrable", from matrices at one point.
//
// Source  docs/theory/classify.md (10)

#include "integrability/report.hpp"
#include "study/classification.hpp"

namespace kov {

/// Matrices of numbers at a point of the parameters, along solutions that exist for all of them:
/// what does not commute there does so on a set of measure zero only.  Unset where nothing is seen.
/// solutions: those that are not invariant sets for generic parameters are left out
/// levels: the parameters that label them
/// Errors  none of limits: unset
[[nodiscard]] std::optional<AlmostAll> almost_all(const System& s,
                                                  const std::vector<ManifoldSpec>& solutions,
                                                  const std::vector<ClaimReport>& claims,
                                                  const std::vector<std::size_t>& levels,
                                                  const CheckOptions& options);

} // namespace kov
