#pragma once
// The parameters with one answer, as a reader wants them: few conditions, the sets may overlap.
//
// Source  docs/theory/classify.md (7)

#include "parameters/conditions.hpp"
#include "study/difference.hpp"

namespace kov {

/// The points at which all of the conditions hold.
struct ParameterPlace {
  ParameterSet where;
  std::vector<DifferenceCondition> special;
};

/// Fewer places with the same union: inequations that the union does not need are dropped, and what
/// lies in another place.  Where that is too hard the places stay as they are.
/// assumed: vanish nowhere, and need not be dropped.  known: what signs and reality say is empty needs no place:
/// for real a, b where b != 0 nobody is told that a^2 + b^2 != 0.
/// Given   const Ring ring = make_ring({"a", "b"});
/// Given   const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b");
/// Given   const ParameterSet all(ring, {0, 1});
/// Given   const ParameterPlace axis{all.where_zero(a).where_nonzero(b), {}}, other{all.where_zero(b), {}};
/// Example in_few_words({axis, other}).front().where.inequations().size()  // -> 0
[[nodiscard]] std::vector<ParameterPlace> in_few_words(std::vector<ParameterPlace> all,
                                                       const std::vector<MPoly>& assumed = {},
                                                       const Assumptions& known = {});

} // namespace kov
