#pragma once
// A system written in a larger ring.

#include "system/system.hpp"

namespace kov {

/// The same system; the names of its ring are the first ones of `ring`.
/// Given   const System free = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q'], momenta = ['p'], hamiltonian = 'p^2/2'}", "free.toml"));
/// Given   auto names = free.ring()->names();
/// Given   names.push_back("E");
/// Example in_ring(free, make_ring(names)).field.components  // -> {p, 0}
[[nodiscard]] System in_ring(const System& s, const Ring& ring);

/// A function of variables that have the same names in s, where the parameters have their values.
/// Errors  InvalidArgument: a name that s has not; DomainError: it has no value there
[[nodiscard]] MFraction in_names_of(const System& s, const MFraction& f);
[[nodiscard]] ManifoldSpec in_names_of(const System& s, ManifoldSpec m);

} // namespace kov
