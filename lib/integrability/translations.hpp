#pragma once
// Equations of an invariant manifold that suit the translations among the symmetries.
//
// Source  docs/theory/mechanics.md (5)

#include "integrability/report.hpp"

namespace kov {

/// The same set: of its equations only one changes along each Hamiltonian field with constant
/// components that belongs to a proved integral.  The variation of that one is then a block by
/// itself.
/// Given   const System pair = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['x', 'y'], momenta = ['u', 'v'], hamiltonian = '(u^2 + v^2)/2 + "
///             "(x - y)^4'}\nintegral = [{name = 'P', value = 'u + v'}]", "pair.toml"));
/// Given   const MFraction x = MFraction::variable(pair.ring(), "x");
/// Given   const MFraction y = MFraction::variable(pair.ring(), "y");
/// Given   ManifoldSpec m; m.equations = {{x, "x = 0"}, {y, "y = 0"}};
/// Given   const auto claims = decide_claims(pair, {});
/// Example adapted_to_translations(pair, m, claims).equations.at(1).text  // -> -x + y = 0
[[nodiscard]] ManifoldSpec adapted_to_translations(const System& s, ManifoldSpec m,
                                                   const std::vector<ClaimReport>& claims);

} // namespace kov
