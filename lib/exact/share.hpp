#pragma once
// A share of the work that is left.

#include "exact/budget.hpp"

namespace kov {

/// The budget of something that may do this part of the work that is left; its other limits.
/// Example part_of_the_work(Budget{}, 0.5).work_end.has_value()  // -> no
[[nodiscard]] Budget part_of_the_work(Budget budget, double part);
/// The budget of something that may do so many units of work, if as many are left.
/// Example at_most(Budget{}, 1000).work  // -> 1000
[[nodiscard]] Budget at_most(Budget budget, double units);

} // namespace kov
