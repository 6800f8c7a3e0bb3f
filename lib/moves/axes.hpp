#pragma once
// A rigid body whose axes of inertia are not those of its coordinates, turned until they are.
//
// Source  docs/theory/moves.md (2)

#include "canonical/change.hpp"

namespace kov {

/// The system in the coordinates M' = R M, Gamma' = R Gamma: R turns axes of inertia into those of the
/// coordinates and, where two moments are equal, the linear part of H in Gamma into one of them.  Unset: these are
/// the axes, the system is none on e(3)*, or R has entries that are not rational functions of the parameters.
/// Errors  OutOfBudget
/// Given   const System tilted = read_system(parse_document("system = {kind = 'euler-poisson', "
///             "coordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3'], hamiltonian = "
///             "'41*M1^2/50 - 12*M1*M2/25 + 17*M2^2/25 + 3*M3^2/2 + G3'}", "tilted.toml"));
/// Example on_principal_axes(tilted)->system.field.hamiltonian.value()  // -> (M11^2 + 2*M21^2 + 3*M3^2 + 2*G3)/2
/// Example in_words(*on_principal_axes(tilted))[0]  // -> M11 = (3*M1 + 4*M2)/5
[[nodiscard]] std::optional<CanonicalChange> on_principal_axes(const System& s,
                                                               const Budget& budget = {});

} // namespace kov
