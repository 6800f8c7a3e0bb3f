#pragma once
// Coordinates in which the kinetic term has constant coefficients.
//
// Polar, parabolic, elliptic, ... coordinates q of a flat space: functions X(q) whose second covariant
// derivatives vanish are looked for among polynomials of degree 2 in the coordinates and function
// symbols.  With as many as there are degrees of freedom, X and P with p_i = sum_a P_a dX_a/dq_i are
// canonical, and H is written in them by elimination.
//
// Source  docs/theory/canonical.md (5)

#include "canonical/form.hpp"

namespace kov {

/// Names for the new variables: of each degree of freedom a coordinate, a momentum, and one for a
/// square root that the potential may need.  They are variables of the ring of the form.
struct FlatNames {
  std::vector<std::size_t> coordinates, momenta;
  std::size_t root = 0;
};

/// Unset: the kinetic term has constant coefficients, no coordinates were found, or H is not a
/// function of them that is rational or has one square root.
[[nodiscard]] std::optional<Form> in_flat_coordinates(const Form& form, const FlatNames& names,
                                                      const Budget& budget);

} // namespace kov
