#pragma once
// Which combination of the two unknowns of a block gives an equation of second order with few apparent
// singularities.
//
//   Y_z = A Y,  y = c Y with constant c:   y is cyclic where D(c) = det(c, c A) is not 0, and r has an apparent
//   singularity at each zero of D(c) that is not a singularity of A.  D is quadratic in c:
//   D = c1^2 a12 + c1 c2 (a22 - a11) - c2^2 a21.  The number of zeros is that of poles, so that fewer are left where
//   D has a zero at the poles of A: where c is a left eigenvector of the leading part there.
//
// Source  docs/theory/mechanics.md (6)

#include "algebraize/function_field.hpp"
#include "variation/normal.hpp"

namespace kov {

/// Combinations (c1, c2), polynomials in the parameters without a common factor, neither of them 0, for which
/// D vanishes, before common factors are divided out, at all places over a factor of its denominator, at
/// infinity to a higher order than for other c.  Few or none.
/// Cost  three rows of a remainder for each factor of the denominator, one gcd
/// Example  for dM1, dM3 of a symmetric top with L = (L1, 0, L3):  {L1, L3}
[[nodiscard]] std::vector<std::array<MPoly, 2>>
cyclic_combinations(const FunctionField& f, std::size_t z, const LinearSystem& s,
                    const std::vector<std::size_t>& block);

} // namespace kov
