#pragma once
// Exponentials as coordinates: H contains x, y, ... only through exponentials e1, e2, ... of
// independent linear forms in them.  Then the field is polynomial in e1, e2, ... as well, also
// where some of them are 0, and there it has particular solutions.
//
// Source  docs/theory/classify.md (6.1)

#include "study/exclusion.hpp"

namespace kov {

/// A Hamiltonian system on e = 0, too.
struct ExponentialCoordinates {
  System system; ///< a field, without a bracket; in the ring of the Hamiltonian one
  MFraction hamiltonian;
  std::vector<std::size_t> exponentials;
  std::vector<std::size_t> instead_of; ///< the coordinates that are left out
  std::vector<MPoly> independent;      ///< where not all of these are 0
};
/// Unset: there is no such coordinate, or other functions of one, or a pole where e = 0.
/// Given   const System toda = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['x'], momenta = ['p'], hamiltonian = 'p^2/2 + exp(x)'}", "t.toml"));
/// Example exponential_coordinates(toda)->system.field.components  // -> {-exp_x, p*exp_x}
[[nodiscard]] std::optional<ExponentialCoordinates> exponential_coordinates(const System& s);

/// Exclusions proved along the solutions with e_j = 0 for all j but one.
/// Errors  OutOfBudget
[[nodiscard]] std::vector<Exclusion> exclusions_at_faces(const System& s,
                                                         const CheckOptions& options);

} // namespace kov
