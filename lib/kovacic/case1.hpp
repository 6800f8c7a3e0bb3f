#pragma once
// Case 1: solutions y with y'/y = omega rational, that is, lines that the group keeps.
//
// There are none, one, two, or infinitely many (group {1} or {+-1}).  Over the field K of the
// equation (docs/theory/descent.md (5)):
//   (a) infinitely many: y^2 is rational and one family holds all solutions;
//   (b) two lines, or one with y^2 rational: exactly when the second symmetric power
//       v''' = 4 r v' + 2 r' v has a rational solution v over K; omega = (v' +- w)/(2v) with the
//       constant w^2 = v'^2 - 2 v v'' + 4 r v^2;
//   (c) one line otherwise: omega is in K(z), so the signs agree at conjugate poles and everything
//       that a family needs lies in the residue fields.
// So no sign is ever chosen at a single root of a place.

#include "kovacic/outcome.hpp"
#include "kovacic/trace.hpp"
#include "linode/singularities.hpp"

namespace kov::kovacic {

/// All lines; nothing when there is none.
///
/// Throws  OutOfBudget
/// Source  [Kovacic1986] §3.1; docs/theory/descent.md (5)
/// Example std::get<ExponentialPair>(*case1(singularities(1), {}, nullptr)).w_squared  // -> 4
/// Example case1(singularities(z), {}, nullptr).has_value()  // -> no
[[nodiscard]] std::optional<Outcome> case1(const Singularities& s, const Budget& budget,
                                           Trace* trace);

/// v'^2 - 2 v v'' + 4 r v^2: for a solution v of the second symmetric power a constant, the square
/// of the Wronskian of its two factors.  Requires v such a solution.
/// Example squared_wronskian(z, RationalFunction(2, z*z))  // -> 9
[[nodiscard]] NfElem squared_wronskian(const RationalFunction& v, const RationalFunction& r);

} // namespace kov::kovacic
