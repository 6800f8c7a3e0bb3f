#pragma once
// Systems of two degrees of freedom inside one of more (docs/theory/jets.md 1.3).

#include "manifold/invariant_manifold.hpp"

namespace kov::jets {

/// The system on q_l = p_l = 0 for all l but two, which is invariant.
struct Subspace {
  System system;
  ManifoldSpec manifold;           ///< the line, a coordinate axis, inside of it
  std::vector<std::size_t> others; ///< positions l among the coordinates, q_l before p_l
};

/// The invariant subspaces that contain the manifold; of two degrees of freedom: the system itself.
[[nodiscard]] std::vector<Subspace> invariant_subspaces(const System& s, const ManifoldSpec& m);

} // namespace kov::jets
