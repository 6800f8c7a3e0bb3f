#pragma once
// The zeros of several polynomials as a union of simpler sets.

#include "exact/budget.hpp"
#include "exact/multivariate.hpp"

namespace kov {

/// Sets of equations: a common zero of `equations` at which none of `nonzero` vanishes satisfies one
/// of them (all equations of it).  Nothing is claimed of the converse.
/// Errors  OutOfBudget
/// Given   const Ring ring = make_ring({"a", "b"});
/// Given   const MPoly a = MPoly::variable(ring, "a"), b = MPoly::variable(ring, "b");
/// Example components({a*b, a*a - b}, {})  // -> {{a, b}, {b, a}}
/// Example components({a*b, a - MPoly(ring, 1)}, {a}).size()  // -> 1
[[nodiscard]] std::vector<std::vector<MPoly>> components(const std::vector<MPoly>& equations,
                                                         const std::vector<MPoly>& nonzero,
                                                         const Budget& budget = {});

} // namespace kov
