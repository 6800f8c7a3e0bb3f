#pragma once
// Straight lines q = s d through the origin of the configuration space on which a natural system with
// any number of degrees of freedom moves: Darboux points, homothetic solutions.
//
// The potential may contain roots r, r^2 a quadratic form of q: on the line they are s rho.
//
// Source  docs/theory/mechanics.md (4)

#include "system/vector_field.hpp"

#include "exact/budget.hpp"

namespace kov {

struct Directions {
  /// q_i = d_i q_c, q_i' = d_i q_c' and r = rho q_c, to be proved invariant.
  std::vector<std::vector<Equation>> lines;
  std::vector<MPoly> wanted; ///< with a square root of one of them there may be more
};

/// Directions that are rational over the parameters and the algebraic constants of degree 2, as far
/// as factors of the equations show them.  One member of a family that the flow of a linear integral moves.
/// Nothing for fields that are not second-order equations q'' = f(q) in canonical coordinates.
/// Errors  OutOfBudget
/// Given   const Ring ring = make_ring({"x", "y", "z", "u", "v", "w", "a"});
/// Given   const auto var = [&](const char* n) { return MFraction::variable(ring, n); };
/// Given   VectorField f; f.ring = ring, f.coordinates = {0, 1, 2, 3, 4, 5}, f.parameters = {6};
/// Given   const MFraction x = var("x"), y = var("y"), z = var("z"), a = var("a");
/// Given   f.components = {var("u"), var("v"), var("w"), -y*z, -a*x*z, -a*x*y};
/// Example find_directions(f, {}).lines.size()  // -> 3
/// Example find_directions(f, {}).wanted  // -> {a}
[[nodiscard]] Directions find_directions(const VectorField& v,
                                         const std::vector<MFraction>& integrals,
                                         const Budget& budget = {});

} // namespace kov
