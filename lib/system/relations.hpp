#pragma once
// The relations between the function symbols and the algebraic constants of a system.
//
// A proof for one of several solutions says nothing of the others: r^2 = x^2 holds for r = x
// and for r = -x, which are two systems.  Where the ideal of the relations is prime its zeros are
// one system, over an algebraic closure with its conjugates.
//
// Source  docs/theory/mechanics.md (1)

#include "system/vector_field.hpp"

namespace kov {

/// A variable of the ring that stands for a root of a polynomial of degree 2 in it.
struct QuadraticConstant {
  std::size_t variable = 0;
  MPoly relation;
};
/// The algebraic constants with a relation of degree 2 in them and the parameters alone.
[[nodiscard]] std::vector<QuadraticConstant> quadratic_constants(const VectorField& v);

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

/// Polynomials g1, g2, ... in the parameters: where not all of them vanish the relations of the
/// functions have as many solutions as for general parameters.  Empty: everywhere.  For
/// r^2 = x^2 + a*y^2 it is a = 0 that is special.
/// Requires !reducible_relations(v)
/// Cost     as above, and discriminants of polynomials in one variable and the parameters
/// Errors   OutOfBudget, also where no line in general position is found
/// Source   docs/theory/mechanics.md (1), "Special values"
/// Given   const Ring with_a = make_ring({"x", "y", "r", "a"});
/// Given   const MFraction X = MFraction::variable(with_a, "x"), Y = MFraction::variable(with_a, "y");
/// Given   const MFraction R = MFraction::variable(with_a, "r"), a = MFraction::variable(with_a, "a");
/// Given   VectorField w; w.ring = with_a, w.coordinates = {0, 1}, w.parameters = {3};
/// Given   w.functions = {{2, "r", {X / R, a * Y / R}}}, w.components = {R, R};
/// Given   w.relations = {(R * R - X * X - a * Y * Y).num()};
/// Example where_relations_fall_apart(w)  // -> {a}
[[nodiscard]] std::vector<MPoly> where_relations_fall_apart(const VectorField& v,
                                                            const Budget& budget = {});

} // namespace kov
