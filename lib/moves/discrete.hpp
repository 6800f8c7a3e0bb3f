#pragma once
// Signed permutations of phase variables and of parameters that carry a family of systems into itself.
//
// Source  docs/theory/moves.md (2)

#include "moves/equivalence.hpp"

namespace kov {

/// H(phi x; p) = H(x; sigma p), and phi keeps the bracket or changes its sign (then the time runs
/// backwards): at sigma p the system has the integrals f o phi, where f are those at p.
struct FamilySymmetry {
  /// x_i -> sign[i] x_place[i], by positions among the coordinates.
  std::vector<std::size_t> place;
  std::vector<int> sign;
  int bracket = 1;         ///< {phi_i, phi_j} = bracket * {x_i, x_j} o phi
  Substitution parameters; ///< p -> (sigma p): those that change
};

/// All of them: those that move no parameter as well.  None is looked for where there are function symbols,
/// more than six coordinates, or a bracket or a Hamiltonian that is not rational over Q.
/// Errors  OutOfBudget
/// Given   const System even = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['x'], momenta = ['u'], parameters = ['a', 'b'], "
///             "hamiltonian = 'u^2/2 + a*x + b*x^2'}", "even.toml"));
/// Example family_symmetries(even).size()  // -> 4
[[nodiscard]] std::vector<FamilySymmetry> family_symmetries(const System& s,
                                                            const Budget& budget = {});

/// The symmetry as a map of systems, from p to sigma p.
[[nodiscard]] Equivalence equivalence(const System& s, const FamilySymmetry& symmetry);
/// sigma carries what the file assumes into itself: proved.
[[nodiscard]] bool keeps_assumptions(const System& s, const FamilySymmetry& symmetry);

} // namespace kov
