#pragma once
// The Taylor expansion of a fundamental matrix at an ordinary point, and its values with proven
// radii.
//
// The coefficients are exact complex numbers: each is what the recurrence
//   den_0 (k+1) Y_{k+1} = sum_j num_j Y_{k-j} - sum_{j>=1} den_j (k+1-j) Y_{k+1-j}
// gives for the exact numbers before it, rounded once, with the radius of that one rounding set
// aside.  So the residual of the polynomial in the differential equation is known, term by term,
// and Gronwall's inequality turns it into a bound of the error.  Radii never enter the recurrence:
// nothing can explode.  docs/theory/monodromy.md 1, 2

#include "exact/budget.hpp"
#include "monodromy/ball_matrix.hpp"
#include "monodromy/local_system.hpp"

namespace kov::monodromy {

/// Y(end) for every end, where Y' = A Y, Y(centre) = 1.
///
/// Requires centre and ends exact (dyadic), the segments from the centre to the ends free of
///          singularities
/// Shape    the absolute error of every entry is about 2^-bits or better; the radius is proven
/// Errors   Imprecise; OutOfBudget
/// Cost     (bits / log2(R/|h|)) terms, linear in bits each while the coefficients are small
[[nodiscard]] std::vector<BallMatrix> values(const EmbeddedSystem& s, const ComplexBall& centre,
                                             const std::vector<ComplexBall>& ends, long bits,
                                             const Budget& budget = {});

} // namespace kov::monodromy
