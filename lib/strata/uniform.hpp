#pragma once
// An invariant that exists for all parameters, also where places meet: no places have to be told
// apart.
//
// docs/theory/strata.md, 5.5

#include "strata/leaf.hpp"

namespace kov::strata {

/// v of degree 2 or 4, found over Q(parameters), that is defined and not 0 at every point of the
/// region: the identity component is abelian there.  Unset: none was found.
/// Cost    the places over Q(parameters) and one linear system
/// Throws  OutOfBudget
/// Given   const ParametrisedSet there = everywhere.where_nonzero(a.num());
/// Example abelian_for_all(a, 0, there, {})->abelian  // -> Truth::yes
/// Example abelian_for_all(z + a, 0, everywhere, {}).has_value()  // -> no
[[nodiscard]] std::optional<Leaf> abelian_for_all(const MFraction& r, std::size_t z,
                                                  const ParametrisedSet& region,
                                                  const Budget& budget);

} // namespace kov::strata
