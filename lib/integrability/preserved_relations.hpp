#pragma once
// Gradients of function symbols in the form that certificates ask for.

#include "system/vector_field.hpp"

namespace kov {

/// The same field, in which d_j R = 0 is an identity for each relation R, and not only modulo the
/// relations (rule (S1) of docs/theory/system_certificates.md): where it is not, the gradient of the
/// last function s in R becomes that of the implicit function, -(d_j R without s)/(dR/ds).  So
/// r^2 = h has d_j r = d_j h/(2 r), and not r d_j h/(2 h).
/// Given   const System root = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q'], momenta = ['p'], hamiltonian = 'p^2 + sqrt(q + 1)'}", "root.toml"));
/// Example with_preserved_relations(root.field).functions.size()  // -> 1
[[nodiscard]] VectorField with_preserved_relations(VectorField v);

} // namespace kov
