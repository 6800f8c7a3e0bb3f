#pragma once
// One particular solution, with known integrals and without them.
//
// Source  docs/theory/classify.md (7)

#include "integrability/report.hpp"

namespace kov {

/// check_manifold(); where the zero level of a known integral leaves it undecided, what couples that
/// level to the others may not be abelian, and the same is asked without integrals.
[[nodiscard]] ManifoldReport study_curve(const System& s, const ManifoldSpec& m,
                                         const std::vector<ClaimReport>& claims,
                                         const CheckOptions& options);

} // namespace kov
