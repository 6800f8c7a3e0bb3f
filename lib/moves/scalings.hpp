#pragma once
// Changes of scale that carry a family of systems into itself.
//
//   x_i -> s^(w_i) x_i,   parameters p_j -> s^(v_j) p_j,   t -> s^e t,   {,} -> s^d {,}
//
// Source  docs/theory/moves.md (4)

#include "system/system.hpp"

namespace kov {

/// A basis of the rational weights: of the variables of the ring, then of the time and of the bracket.
/// Algebraic constants have weight 0.
/// Given   const System quartic = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['x'], momenta = ['u'], parameters = ['a'], "
///             "hamiltonian = 'u^2/2 + a*x^4'}", "quartic.toml"));
/// Example scalings(quartic).size()  // -> 2
[[nodiscard]] Matrix scalings(const System& s);

} // namespace kov
