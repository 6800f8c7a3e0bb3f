#pragma once
// When do the blocks of the reduced normal part say everything about the variational equations?
//
//   "the identity component of VE is abelian  <=>  that of each block is" holds when VE is the
//   direct sum of the blocks and of a part whose group is a vector group.  Otherwise only => holds:
//   what couples a block to the rest may be non-abelian where each diagonal block is not.
//
// The part along the manifold N is a vector group; a complement of it is seen
//   symplectic  the brackets {f_i, f_j} of the equations of N, without the Casimirs among their
//               combinations, form an invertible matrix: N meets the symplectic leaf in a
//               symplectic surface, and the skew-orthogonal complement of its tangent space is one
//               of VE
//   coordinates the coordinate vectors of the unknowns that the equations of N determine span one
//
// docs/theory/mechanics.md (9)

#include "variation/normal.hpp"

namespace kov {

struct WholeVariation {
  std::string missing; ///< a clause that names the coupling not studied; empty: everything is
  std::vector<MPoly> divisors; ///< must be units of the function field for this to hold
};

/// `studied`: the sets of unknowns of the reduced system that were looked at together.
[[nodiscard]] WholeVariation whole_variation(const VectorField& v, const InvariantManifold& m,
                                             const NormalSystem& n, const ReducedSystem& r,
                                             const std::vector<std::vector<std::size_t>>& studied);

} // namespace kov
