#pragma once
// The closed answer of a stratum against that of the equation at some points of it: two roads to one
// answer, of which one has no parameters.

#include "strata/leaf.hpp"

namespace kov::strata {

/// Is this group one of those that the bound speaks of?
/// Example allows(GroupBound::torus_normaliser_or_T, {GroupType::T, 4})  // -> yes
/// Example allows(GroupBound::torus_normaliser_or_T, {GroupType::S4, {}})  // -> no
[[nodiscard]] bool allows(GroupBound bound, const GaloisGroup& g);

/// A point at which the verdict or the group is another one; unset: none was found.  r in the
/// parameters that are left.
/// Cost  the recognition of one or two equations without parameters
[[nodiscard]] std::optional<std::string> disagreement(const Leaf& leaf, const MFraction& r,
                                                      std::size_t z, const Region& region,
                                                      const Budget& budget);

} // namespace kov::strata
