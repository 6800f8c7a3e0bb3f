#pragma once
// A share of the time that is left.

#include "exact/budget.hpp"

namespace kov {

/// The budget of something that may take this part of the time that is left; its other limits.
/// Example part_of_the_time(Budget{}, 0.5).deadline.has_value()  // -> no
[[nodiscard]] Budget part_of_the_time(Budget budget, double part);

} // namespace kov
