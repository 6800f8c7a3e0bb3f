#pragma once
// Which part of the normal variational equations a symplectic leaf sees.
//
// Source  docs/theory/mechanics.md (9.7)

#include "variation/normal.hpp"

namespace kov {

/// Do these unknowns of the normal system take all values on the tangent space of the symplectic
/// leaf?  Always, where the field is not Hamiltonian or the coordinates are canonical.  Else a minor
/// of the matrix (df_i P) is needed that is not 0 on the curve; it goes to `divisors`.
[[nodiscard]] bool seen_on_the_leaf(const VectorField& v, const InvariantManifold& m,
                                    const NormalSystem& n, const std::vector<std::string>& unknowns,
                                    std::vector<MPoly>& divisors);

} // namespace kov
