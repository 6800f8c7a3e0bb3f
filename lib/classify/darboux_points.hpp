#pragma once
// Homogeneous potentials of degree k in two coordinates, and kinetic energies p.M p/2 with constant
// masses: which parameters pass the table of Morales-Ruiz and Ramis at all Darboux points at once.
//
// A proper Darboux point d, M V'(d) = d, gives Lambda = lambda - 1, lambda the eigenvalue of
// M V''(d) besides k - 1.  The values at all points are bound by sum 1/Lambda_i = const, so that finitely
// many choices from the table are left, and each is a system of polynomial equations.
//
// Source  docs/theory/classify.md (3, 4)

#include "study/exclusion.hpp"

namespace kov {

/// The multisets of `points` values Lambda != 0 with 1 + Lambda in the table for degree k and sum
/// of 1/Lambda equal to `sum`, each ascending.
/// Requires k not in {-2, 0, 2}.  Errors  OutOfBudget
/// Example eigenvalue_choices(3, 3, -1).size()  // -> 4
/// Example eigenvalue_choices(4, 4, -1).size()  // -> 5
/// Example eigenvalue_choices(-1, 1, -1)  // -> {{-1}}
[[nodiscard]] std::vector<std::vector<Rational>>
eigenvalue_choices(long k, long points, const Rational& sum, const Budget& budget = {});

/// H = p.M p/2 + A(q).p + V(q), two coordinates, M constant, A and V rational: the parameters that
/// are excluded by the parts of V of highest and of lowest degree, as far as A is lower (higher) than
/// they are.  Nothing for other systems.
/// Errors  OutOfBudget
[[nodiscard]] std::vector<Exclusion> exclusions_by_darboux_points(const System& s,
                                                                  const Budget& budget = {});
/// Exclusions where such a part, and not all of V, has a multiple Darboux point: for rational first
/// integrals only, so that it comes after what excludes more.
/// Example exclusions_by_multiple_points_of_parts(kepler).empty()  // -> yes
/// Given   const System kepler = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['x', 'y'], momenta = ['u', 'v'], hamiltonian = "
///             "'(u^2 + v^2)/2 - 1/(x^2 + y^2)^2'}", "kepler.toml"));
[[nodiscard]] std::vector<Exclusion> exclusions_by_multiple_points_of_parts(const System& s);

} // namespace kov
