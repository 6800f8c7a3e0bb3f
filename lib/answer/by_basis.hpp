#pragma once
// The answer to a whole equation whose homogeneous one has solutions y1, y2 in functions with a name.
//
//   right side        y_p = y2 int(y1 f/W) - y1 int(y2 f/W), W = y1 y2' - y1' y2
//   initial values    c1 = (v0 y2' - v1 y2)/W, c2 = (v1 y1 - v0 y1')/W at the point
//   Riccati           y = -(u1' + c u2')/(a (u1 + c u2))
//
// Source  DLMF 9.2, 10.5, 10.28, 14.2 for the Wronskians; others are left as they are

#include "elementary/whole.hpp"

#include <vector>

namespace kov::answer {

/// Sets the missing members of `answer`; nothing is put into the equation here.
/// Requires  two solutions of the linear homogeneous equation
void answer_by_basis(elementary::WholeAnswer& answer, const elementary::WholeEquation& equation,
                     const std::vector<Expression>& basis);

} // namespace kov::answer
