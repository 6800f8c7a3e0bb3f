#pragma once
// The field on an invariant subspace of two degrees of freedom, in which lines are looked for as in
// the whole space (lines.hpp).
//
// Source  docs/theory/mechanics.md (4)

#include "system/vector_field.hpp"

namespace kov {

struct FieldOnSubspace {
  VectorField field;           ///< in the ring of the whole, without function symbols
  std::vector<Equation> roots; ///< what the function symbols are there: "r = x - y"
};

/// `solved`: the other coordinates, and some function symbols, on the subspace.  Symbols that are
/// left get the values that their relations leave, where these are rational: one field for each
/// choice.  Nothing unless two coordinates q_i, q_j and their momenta are left.
/// Given   const Ring ring = make_ring({"x", "y", "z", "u", "v", "w", "r"});
/// Given   const auto var = [&](const char* n) { return MFraction::variable(ring, n); };
/// Given   VectorField f; f.ring = ring, f.coordinates = {0, 1, 2, 3, 4, 5};
/// Given   const MFraction y = var("y"), z = var("z"), r = var("r"), one(ring, Rational(1)), o(ring);
/// Given   f.components = {var("u"), var("v"), var("w"), -var("x")*r, y/r - y, -z};
/// Given   f.functions = {{6, {o, y/r, z/r, o, o, o}}}, f.relations = {(r*r - y*y - z*z).num()};
/// Given   const Substitution on_x_y{{2, o}, {5, o}};
/// Example fields_on_subspace(f, on_x_y)[1].roots[0].text  // -> r = -y
/// Example fields_on_subspace(f, on_x_y)[1].field.components  // -> {u, v, x*y, -y - 1}
[[nodiscard]] std::vector<FieldOnSubspace> fields_on_subspace(const VectorField& v,
                                                              const Substitution& solved);

} // namespace kov
