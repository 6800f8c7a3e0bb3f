#pragma once
// Case 2: an irreducible group that permutes two lines; v = y1 y2 has v^2 in K(z), v not in K(z),
// and omega^2 - phi omega + phi'/2 + phi^2/2 - r = 0 with phi = v'/v.
//
// The pair of lines is unique, hence defined over K, unless the group is the quaternion group,
// which permutes two lines in three ways.  If one of the three is defined over K it is found;
// otherwise the three are conjugate over a cubic extension, and v1 v2 v3, a product of six
// solutions, is a rational function over K (docs/theory/descent.md (7)).

#include "kovacic/outcome.hpp"
#include "kovacic/trace.hpp"
#include "linode/singularities.hpp"

namespace kov::kovacic {

/// Imprimitive, ImprimitiveTriple or nothing.
///
/// Requires case1 found no line: the group is irreducible
/// Throws   OutOfBudget
/// Source   [Kovacic1986] §4.1; docs/theory/descent.md (7)
/// Given    const Singularities s = singularities(RationalFunction(16*z - 3, 16*z*z));
/// Example  std::get<Imprimitive>(*case2(s, {}, nullptr)).phi  // -> 1/(2*z)
[[nodiscard]] std::optional<Outcome> case2(const Singularities& s, const Budget& budget,
                                           Trace* trace);

} // namespace kov::kovacic
