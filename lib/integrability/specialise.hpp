#pragma once
// A system at special values of its parameters, which may depend on the other parameters.

#include "integrability/report.hpp"

namespace kov {

/// The values with those of functions that become numbers: sqrt(a*x^2 + 1) is 1 at a = 0, as if 1 were
/// written in the file.  A constant k with k^2 = a is 0 there.
[[nodiscard]] Substitution with_functions(const System& s, Substitution values);

/// The parameters of `values` replaced everywhere that check_manifold looks at, and removed from
/// the list of parameters.
/// Errors  DomainError: something has no value there, or the relations have several solutions
/// Given   const System free = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q'], momenta = ['p'], parameters = ['a'], "
///             "hamiltonian = 'p^2/2 + a*q^2'}", "free.toml"));
/// Given   const Substitution three{{free.ring()->index("a"), MFraction(free.ring(), 3)}};
/// Example at_values(free, three).field.components  // -> {p, -6*q}
[[nodiscard]] System at_values(const System& s, const Substitution& values);
[[nodiscard]] ManifoldSpec at_values(const ManifoldSpec& spec, const Substitution& values);
[[nodiscard]] std::vector<ClaimReport> at_values(std::vector<ClaimReport> claims,
                                                 const Substitution& values);

} // namespace kov
