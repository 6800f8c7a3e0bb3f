#pragma once
// Has a conjunction of polynomial conditions a real point?  Z3's decision procedure for nonlinear
// real arithmetic (nlsat), as an oracle: what it refutes is a trusted step.

#include "exact/truth.hpp"
#include "strata/conditions.hpp"

namespace kov::strata {

/// no       Z3 has refuted the conjunction over the reals
/// yes      it has found a point
/// unknown  its limit was reached
/// Cost     at most `milliseconds`
[[nodiscard]] Truth has_real_point(const std::vector<Condition>& conditions, unsigned milliseconds);

} // namespace kov::strata
