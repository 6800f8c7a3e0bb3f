#pragma once
// Equations of an invariant manifold that suit the translations among the symmetries.
//
// Source  docs/theory/mechanics.md (5)

#include "integrability/check.hpp"

namespace kov {

/// The same set: of its equations only one changes along each Hamiltonian field with constant
/// components that belongs to a proved integral.  The variation of that one is then a block by
/// itself.
[[nodiscard]] ManifoldSpec adapted_to_translations(const System& s, ManifoldSpec m,
                                                   const std::vector<ClaimReport>& claims);

} // namespace kov
