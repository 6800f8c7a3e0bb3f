#pragma once
// Parts of a system that do not meet, at rest: H = H_1(x) + H_2(y), y = y_0 where H_2 is critical.

#include "system/vector_field.hpp"

namespace kov {

/// The coordinates fall into parts of which none occurs in the motion of another.  Equations of places with
/// rational values where one of them rests; nothing if there is one part.
/// Cost    a Groebner basis for each part
/// Errors  OutOfBudget
/// Given   const Ring ring = make_ring({"x", "u", "y", "v"});
/// Given   const auto var = [&](const char* n) { return MFraction::variable(ring, n); };
/// Given   VectorField f; f.ring = ring, f.coordinates = {0, 1, 2, 3};
/// Given   f.components = {var("u"), -var("x")*var("x"), var("v"), MFraction(ring, Rational(1))};
/// Example parts_at_rest(f).size()  // -> 1
/// Example parts_at_rest(f)[0][1].text  // -> u = 0
[[nodiscard]] std::vector<std::vector<Equation>> parts_at_rest(const VectorField& v,
                                                               const Budget& budget = {});

} // namespace kov
