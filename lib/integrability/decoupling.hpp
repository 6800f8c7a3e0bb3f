#pragma once
// Equations of an invariant manifold whose variations fall apart into smaller blocks.
//
// Source  docs/theory/mechanics.md (5)

#include "integrability/study.hpp"

namespace kov {

/// The same set.  Where the equations of a block of the normal part, y' = C y of order > 2, have
/// constant combinations that form smaller blocks, those combinations stand for them: row kernels of
/// polynomials in a constant matrix that commutes with C.  Unset if there are none over the
/// parameters.
/// Cost    k^2 linear unknowns for a block of order k
/// Given   const System three = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['x', 'y', 'z'], momenta = ['u', 'v', 'w'], hamiltonian = "
///             "'(u^2 + v^2 + w^2)/2 + z^4 + x*y*z^2'}", "three.toml"));
/// Given   ManifoldSpec axis; axis.name = "axis";
/// Given   for (const char* name : {"x", "y", "u", "v"}) axis.equations.push_back(
///             {MFraction::variable(three.ring(), name), std::string(name) + " = 0"});
/// Given   axis.levels = {{formula(three, "H - 1"), "H = 1"}};
/// Given   ManifoldReport on_it; on_it.manifold = std::get<InvariantManifold>(
///             prove_invariant(three.field, axis));
/// Given   on_it.normal = normal_system(three.field, *on_it.manifold, {});
/// Example decoupled(three, axis, on_it, {})->equations.at(0).text  // -> x + y = 0
[[nodiscard]] std::optional<ManifoldSpec> decoupled(const System& s, const ManifoldSpec& m,
                                                    const ManifoldReport& report,
                                                    const Budget& budget);

} // namespace kov
