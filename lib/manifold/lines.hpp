#pragma once
// Straight lines of the configuration space of two degrees of freedom, through the origin or not.
//
// q2 = m q1 + n with p2 = k p1, or q1 = n with p1 = k p2, is invariant where polynomials in m, n, k and
// the parameters vanish.
//
// Source  docs/theory/mechanics.md (4)

#include "system/vector_field.hpp"

#include "exact/budget.hpp"

namespace kov {

/// x_dependent = slope x_free + offset and p_dependent = ratio p_free, for coordinates x1, x2.
struct Line {
  std::size_t dependent = 1; ///< 1: x2 = slope x1 + offset; 0: x1 = offset
  MFraction slope, offset, ratio;
};

/// Lines with m, n and k rational in the parameters and the algebraic constants of degree 2, as they
/// are for generic parameters, and equations between parameters where there are others.
/// If a coefficient is free (a potential that depends on one coordinate, or on the distance), the
/// values 0 and 1 are taken.
struct Lines {
  std::vector<Line> lines;
  std::vector<std::vector<MPoly>> special; ///< in each list all have to vanish
  std::vector<MPoly> wanted;               ///< with a square root of one of them there may be more
};
/// Nothing for fields that are not of dimension 4 or contain function symbols.
/// Errors  OutOfBudget
[[nodiscard]] Lines find_lines(const VectorField& v, const Budget& budget = {});

} // namespace kov
