#pragma once
// The variational equations along a proved manifold, their normal part, and what linear first
// integrals leave of it.

#include "integrability/study.hpp"
#include "variation/whole.hpp"

namespace kov {

/// Fills in `variational`, `normal` and `reduced`, and the hypothesis on the curve that is not
/// checked.
void linearise(const Study& study, ManifoldReport& report);

/// The divisors on the way to `reduced`, and the polynomials that must not be 0 for the proofs of
/// the integrals used.
[[nodiscard]] std::vector<MPoly> divisors_of(const Study& study, const ManifoldReport& report);

/// The divisors from before there was an equation.
[[nodiscard]] std::vector<MPoly> early_divisors(const ManifoldReport& report);

/// The part of the variational equations that these blocks leave out; a limit is an answer, because
/// "not abelian" of a block needs no knowledge of the rest.
[[nodiscard]] WholeVariation coupling(const System& s, const ManifoldReport& report,
                                      const std::vector<std::vector<std::size_t>>& parts);

} // namespace kov
