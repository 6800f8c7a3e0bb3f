#pragma once
// The winding number of an orbit on the section: turns per return.
//
// For an angle that goes round (an angle of the picture whose range is more than a turn): its
// advance.  Otherwise that of the points about their centre, counterclockwise, in units in which
// they are as wide as they are high; modulo 1 it is the frequency of the orbit in that of the returns.
// On a regular orbit means with the weight exp(-1/(s (1 - s))) converge faster than every power of
// the number of returns [DasSaikiSanderYorke2017]; what the halves of the orbit say otherwise is
// the bar.

#include <array>
#include <vector>

namespace kov::flow {

struct Winding {
  double turns = 0,
         error =
             -1; ///< error < 0: not known (too few points, or they do not go round their centre)
};

/// points: of one orbit in the order of time; angles with their whole turns.
[[nodiscard]] Winding winding_of(const std::vector<std::array<double, 2>>& points,
                                 const std::array<bool, 2>& angle);

} // namespace kov::flow
