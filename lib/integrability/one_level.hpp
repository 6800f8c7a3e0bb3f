#pragma once
// A level is not a parameter of the system: for fixed parameters one level whose variational
// equation has a non-abelian identity component is enough.
//
// Source  docs/theory/mechanics.md (7); docs/theory/classify.md 8 (a)

#include "literature/levels.hpp"
#include "strata/decide_strata.hpp"
#include "system/system.hpp"

namespace kov {

/// The parameters of which one may choose the value: those that only label levels, and of which so
/// little is assumed that every polynomial has some value != 0 there: p != 0; "real"; one
/// c h + d > 0 or >= 0 with a number c != 0; or strict inequalities in levels alone that have a point.
/// Given   const System open = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q'], momenta = ['p'], parameters = ['h'], hamiltonian = 'p^2 + q'}\n"
///             "assume = {conditions = ['h > 0']}\n"
///             "manifold = [{name = 'N', equations = [], level = ['H = h']}]", "open.toml"));
/// Example free_levels(open).size()  // -> 1
[[nodiscard]] std::vector<std::size_t> free_levels(const System& s);

/// For all other parameters there is a level at which the identity component is not abelian: which,
/// or an empty choice for general ones; several where each serves for some.  Unset: not proved.
/// Source  docs/theory/mechanics.md (7), "One level is enough"
[[nodiscard]] std::optional<std::vector<LevelChoice>>
level_that_decides(const System& s, const strata::StrataAnswer& answer);

} // namespace kov
