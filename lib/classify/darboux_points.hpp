#pragma once
// Homogeneous potentials of degree k >= 3 in two coordinates: which parameters pass the table of
// Morales-Ruiz and Ramis at all Darboux points at once.
//
// A proper Darboux point d, V'(d) = d, gives Lambda = lambda - 1, lambda the eigenvalue of V''(d)
// besides k - 1.  The values at all points are bound by sum 1/Lambda_i = const, so that finitely
// many choices from the table are left, and each is a system of polynomial equations.
//
// Source  docs/theory/classify.md (3, 4)

#include "classify/exclusion.hpp"

namespace kov {

/// The multisets of `points` values Lambda != 0 with 1 + Lambda in the table for degree k and sum
/// of 1/Lambda equal to `sum`, each ascending.
/// Requires k >= 3.  Errors  OutOfBudget
/// Example eigenvalue_choices(3, 3, -1).size()  // -> 4
/// Example eigenvalue_choices(4, 4, -1).size()  // -> 5
[[nodiscard]] std::vector<std::vector<Rational>>
eigenvalue_choices(long k, long points, const Rational& sum, const Budget& budget = {});

/// H = c p^2 + V(q), two coordinates, V polynomial of degree >= 3: the parameters that are excluded
/// by the part of V of highest degree.  Nothing for other systems.
/// Errors  OutOfBudget
[[nodiscard]] std::vector<Exclusion> exclusions_by_darboux_points(const System& s,
                                                                  const Budget& budget = {});

} // namespace kov
