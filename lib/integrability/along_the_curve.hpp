#pragma once
// The coupling of a block of order one to the direction of the phase curve.
//
// Source  docs/theory/mechanics.md (9)

#include "integrability/study.hpp"

namespace kov {

/// The normal unknowns y of a field without a bracket along a curve that its manifold is, and one
/// coordinate w that moves along it: y' = C y, w' = c y + c_w w.  The last unknown is w.
struct ExtendedSystem {
  LinearSystem system;
  std::vector<MPoly> divisors; ///< must be units of the function field
};
/// Unset: there is a bracket, the manifold is larger than the curve, or no coordinate moves.
/// Given   const System plane = read_system(parse_document("system = {kind = 'vector-field', "
///             "coordinates = ['x', 'y'], field = {x = 'x*(1 - x - y)', y = 'x*y'}}", "plane.toml"));
/// Given   ManifoldSpec axis; axis.equations = {{MFraction::variable(plane.ring(), "y"), "y = 0"}};
/// Given   ManifoldReport on_it; on_it.manifold = std::get<InvariantManifold>(
///             prove_invariant(plane.field, axis));
/// Given   on_it.normal = normal_system(plane.field, *on_it.manifold, {});
/// Example extended_system(plane, on_it)->system.a.at(1).at(0)  // -> -x
[[nodiscard]] std::optional<ExtendedSystem> extended_system(const System& s,
                                                            const ManifoldReport& report);

/// Pairs of an unknown y_i and the last one, coupled, such that the zero level of all others is a
/// subsystem: a subsystem of the variational equation of order two.
/// Example pairs_with_the_curve(*extended_system(plane, on_it), *on_it.manifold).size()  // -> 1
[[nodiscard]] std::vector<std::vector<std::size_t>>
pairs_with_the_curve(const ExtendedSystem& e, const InvariantManifold& m);

} // namespace kov
