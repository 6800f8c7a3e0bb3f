#pragma once
// Has a conjunction of polynomial conditions a real point?  Z3's decision procedure for nonlinear
// real arithmetic (nlsat), as an oracle: what it refutes is a trusted step.

#include "exact/budget.hpp"
#include "exact/truth.hpp"
#include "parameters/conditions.hpp"

#include <string>
#include <vector>

namespace kov {

/// no       Z3 has refuted the conjunction over the reals
/// yes      it has found a point
/// unknown  its limit of steps was reached, which follows from budget.max_work
/// Errors   OutOfBudget: the deadline, or the caller asked to stop
/// Given    const Condition positive{a.num(), Sign::positive};
/// Given    const Condition negative{(-a).num(), Sign::positive};
/// Example  has_real_point({positive, negative})  // -> Truth::no
[[nodiscard]] Truth has_real_point(const std::vector<Condition>& conditions,
                                   const Budget& budget = {});

} // namespace kov
