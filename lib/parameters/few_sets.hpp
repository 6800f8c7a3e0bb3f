#pragma once
// The parameters with one answer, as a reader wants them: few conditions, the sets may overlap.
//
// Source  docs/theory/classify.md (7)

#include "parameters/conditions.hpp"
#include "parameters/set.hpp"

namespace kov {

/// Fewer sets with the same union: inequations that the union does not need are dropped, and what
/// lies in another set.  Where that is too hard the sets stay as they are.
/// assumed: vanish nowhere, and need not be dropped.  known: what signs and reality say is empty needs no set:
/// for real a, b where b != 0 nobody is told that a^2 + b^2 != 0.
/// Given   const Ring ring = make_ring({"a", "b"});
/// Given   const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b");
/// Given   const Set all(ring, {0, 1});
/// Given   const Set axis = all.where_zero(a).where_nonzero(b), other = all.where_zero(b);
/// Example in_few_words({axis, other}).front().inequations().size()  // -> 0
[[nodiscard]] std::vector<Set> in_few_words(std::vector<Set> all,
                                            const std::vector<MPoly>& assumed = {},
                                            const Assumptions& known = {});

} // namespace kov
