#pragma once
// The relations between the function symbols and the algebraic constants of a system.
//
// What is proved of one of several solutions says nothing of the others: r^2 = x^2 holds for r = x
// and for r = -x, which are two systems.  Where the ideal of the relations is prime its zeros are
// one system, over an algebraic closure with its conjugates.
//
// Source  docs/theory/mechanics.md (1)

#include "system/vector_field.hpp"

namespace kov {

/// Why the ideal I of the relations in Q(parameters)[coordinates, functions, constants] is not
/// proved to be prime, as a sentence; nothing where it is proved.
/// Cost    a Groebner basis, and a factorisation in degree dim over the field of a largest set of
///         independent variables
/// Errors  OutOfBudget
/// Given   const Ring ring = make_ring({"x", "r"});
/// Given   const MFraction x = MFraction::variable(ring, "x"), r = MFraction::variable(ring, "r");
/// Given   VectorField v; v.ring = ring, v.coordinates = {0}, v.functions = {{1, "r", {x / r}}};
/// Given   v.components = {r}, v.relations = {(r * r - x * x).num()};
/// Example reducible_relations(v).value()
///         // -> the relations have several solutions: (x - r)*(x + r) = 0
[[nodiscard]] std::optional<std::string> reducible_relations(const VectorField& v,
                                                             const Budget& budget = {});

} // namespace kov
