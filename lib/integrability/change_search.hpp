#pragma once
// The change of variable z = phi(coordinates) that makes a scalar equation algebraic.

#include "integrability/report.hpp"

namespace kov {

struct UnknownsOfBlock {
  const LinearSystem& system;
  const std::vector<std::size_t>& members;
};

/// Tries changes of variable for every cyclic vector of the block (its `scalar`) and keeps in `ode`
/// the equation with the fewest singular places; without one, `note` says what failed.
/// The change of the file if `given`, otherwise those that the system proposes.  With `also`, the unknowns and their
/// system, combinations of them with fewer apparent singularities are tried, and added to `scalar`.
/// Errors  OutOfBudget between two changes
void find_change(const System& s, const InvariantManifold& m, const MFraction* given,
                 const Budget& budget, BlockReport& block,
                 const std::optional<UnknownsOfBlock>& also = {});

} // namespace kov
