#pragma once
// "Some x1 +- x2 +- x3 is in a + c Z" solved for E, where the squares of the x_i are functions of E.
//
// Source  docs/theory/spectrum.md, 3

#include "spectrum/spectrum.hpp"

namespace kov::spectrum {

/// E satisfies the condition exactly if it solves one of the equations for some integer N.  Empty: not
/// solved (three of the numbers depend on E, or none, or every E is possible).
/// Given   SumIn some; some.squares = {a}; some.classes = {{Rational(1, 2), 1}};
/// Example to_string(*solve_for_energy(some, 1).at(0).value)  // -> (4*N^2 + 4*N + 1)/4
[[nodiscard]] std::vector<Series> solve_for_energy(const SumIn& condition, std::size_t energy);

} // namespace kov::spectrum
