#pragma once
// Polynomial solutions of c2 P'' + c1 P' + c0 P = 0 over K, from the top coefficient down.

#include "exact/budget.hpp"
#include "exact/poly.hpp"

#include <optional>

namespace kov {

/// The monic polynomial solution of exact degree d with the fewest choices, if there is one.
/// If the solutions of degree d form an affine space, any one of them is returned.
///
/// Cost  O(d (deg c2 + deg c1 + deg c0)) operations in K
/// Throws OutOfBudget
/// Example polynomial_solution(1 - z*z, -2*z, 12, 3)  // -> z^3 - 3/5*z
/// Example polynomial_solution(1 - z*z, -2*z, 12, 2)  // -> none
[[nodiscard]] std::optional<Poly> polynomial_solution(const Poly& c2, const Poly& c1,
                                                      const Poly& c0, long d,
                                                      const Budget& budget = {});

} // namespace kov
