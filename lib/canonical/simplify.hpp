#pragma once
// The same system in variables in which other rooms know more of it.
//
// Source  docs/theory/canonical.md

#include "canonical/change.hpp"

namespace kov {

/// Tried one after the other: an exchange of coordinates and momenta that makes H quadratic in the
/// momenta, flat coordinates, the completed square, an origin with fewer terms.  Unset: nothing was
/// found that makes H simpler.  What is returned has passed is_canonical().
/// Given   const System shifted = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q'], momenta = ['p'], hamiltonian = '(p + q^2)^2/2 + (q - 1)^4'}",
///             "shifted.toml"));
/// Example simplified(shifted)->system.field.hamiltonian.value()  // -> (2*q1^4 + p1^2)/2
/// Example in_words(*simplified(shifted))  // -> {q1 = q - 1, p1 = q^2 + p}
[[nodiscard]] std::optional<CanonicalChange> simplified(const System& s, const Budget& budget = {});

} // namespace kov
