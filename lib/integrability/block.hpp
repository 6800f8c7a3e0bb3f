#pragma once
// One diagonal block of the reduced normal system: from its matrix to the group of y'' = r(z) y.

#include "integrability/study.hpp"

namespace kov {

/// The diagonal blocks; two of order 1 that are coupled with each other and with nothing else are
/// studied together, because a triangular system of order 2 may have a non-abelian group.
[[nodiscard]] std::vector<std::vector<std::size_t>> blocks_to_study(const LinearSystem& r,
                                                                    const InvariantManifold& m);

/// Scalar equation, change of variable and group of the block with these members of `reduced`.
/// divisors: what was divided by on the way to `reduced`.
/// Errors  OutOfBudget: `block` keeps what was found before
void study_block(const System& s, const InvariantManifold& m, const LinearSystem& reduced,
                 const std::vector<MPoly>& divisors, const std::vector<std::size_t>& members,
                 const CheckOptions& options, BlockReport& block);

/// The same where Liouville's integrability is asked, on the symplectic leaves of the bracket: a
/// block that they do not see is left with a note (docs/theory/mechanics.md 9.7).
void study_on_the_leaf(const Study& study, ManifoldReport& report, std::vector<MPoly> divisors,
                       const std::vector<std::size_t>& members, BlockReport& block);

} // namespace kov
