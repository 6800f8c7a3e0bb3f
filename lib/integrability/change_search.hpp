#pragma once
// The change of variable z = phi(coordinates) that makes a scalar equation algebraic.

#include "integrability/check.hpp"

namespace kov {

/// Tries changes of variable for every cyclic vector of the block (its `scalar`) and keeps in `ode`
/// the equation with the fewest singular places; without one, `note` says what failed.
/// The change of the file if `given`, otherwise those that the system proposes.
/// Errors  OutOfBudget between two changes
void find_change(const System& s, const InvariantManifold& m, const MFraction* given,
                 const Budget& budget, BlockReport& block);

} // namespace kov
