#pragma once
// Can arithmetic conditions hold together?  Decided where the numbers that they are about are linear
// functions of one number t: a condition then depends on whether t is rational, and on t modulo a
// period but for small |t|, so that finitely many t stand for all of them.
//
// Source  docs/theory/strata.md, 10.10

#include "closed/arithmetic.hpp"
#include "parameters/parametrised_set.hpp"

namespace kov::strata {

/// Proved: at no point of the region do all of these hold.  no: there may be such points.
/// Cost    some hundred values of t; more than a few thousand are not tried, and nothing is proved
/// Given   const Assertion a_in_z = SumIn{{a * a}, {{0, 1}}};
/// Given   const Assertion a_in_halves = SumIn{{a * a}, {{Rational(1, 2), 1}}};
/// Example proved_empty({{a_in_z}, {a_in_halves}}, everywhere)  // -> yes
/// Example proved_empty({{a_in_z}, {AllRational{{a * a}}, false}}, everywhere)  // -> yes
/// Example proved_empty({{a_in_z, false}, {AllRational{{a * a}}}}, everywhere)  // -> no
[[nodiscard]] bool proved_empty(const std::vector<Statement>& all, const ParametrisedSet& region);

} // namespace kov::strata
