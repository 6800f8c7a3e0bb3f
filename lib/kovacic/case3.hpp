#pragma once
// Case 3: a finite primitive group.  v is the product of the 4, 6 or 12 lines of one orbit.
//
//   group         n    v                                         found as
//   tetrahedral   6    rational (the six lines are one orbit)    n = 6, all exponents integral
//   tetrahedral   4    v^3 rational (two orbits of four lines)   n = 4, for the shorter polynomial
//   octahedral    6    v^2 rational, v not                       n = 6, some exponent in 1/2 + Z
//   icosahedral  12    rational                                  n = 12
//
// The orbits of length 6 and 12 are unique, hence defined over K.  The two orbits of length four
// may be conjugate over a quadratic extension of K, so that n = 4 alone over K would miss the
// group; n = 6 cannot (docs/theory/descent.md (8)).

#include "kovacic/outcome.hpp"
#include "kovacic/trace.hpp"
#include "linode/singularities.hpp"

namespace kov::kovacic {

/// Algebraic or nothing (then the group is SL(2, C)).
///
/// Requires case1 and case2 found nothing
/// Throws   OutOfBudget
/// Source   [Kovacic1986] §5.1; docs/theory/descent.md (8)
/// Given    const RationalFunction r = RationalFunction(-3, 16*z*z) -
///              RationalFunction(2, 9*(z - 1)*(z - 1)) + RationalFunction(3, 16*z*(z - 1));
/// Example  std::get<Algebraic>(*case3(singularities(r), {}, nullptr)).group
///          // -> Primitive::tetrahedral
[[nodiscard]] std::optional<Outcome> case3(const Singularities& s, const Budget& budget,
                                           Trace* trace);

} // namespace kov::kovacic
