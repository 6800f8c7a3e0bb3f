#pragma once
// Two independent solutions as formulas, where the group is reducible or dihedral.
//
//   one line y       y and y int y^-2
//   two lines        those of solutions.hpp, or sqrt(v) exp(+- w/2 int 1/v) where w is not in K
//   dihedral         F^(1/4) exp(+- w/2 int 1/sqrt F), and F^(1/4) h^(+- 1/(2n)) where it is finite
//
// Source  docs/theory/second_solution.md, with proofs

#include "galois/solutions.hpp"

#include <optional>
#include <string>

namespace kov {

/// Each is verified by exact arithmetic before it is written down.
struct Basis {
  std::string first, second;
};

/// Unset: A4, S4, A5, SL2, the quaternion group where its three quadratics are conjugate, and where
/// nothing is known.
/// found: solutions(c, r).  gauge: the solutions are written with the factor exp(int gauge); those
/// of y'' + p y' + q y = 0 with gauge = -p/2.
/// Throws   OutOfBudget
/// Given    const RationalFunction euler(-1, 4*z*z), root(4*z - 3, 16*z*z);
/// Given    const Classification with_log = classify(euler), dihedral = classify(root);
/// Example  basis(with_log, euler, solutions(with_log, euler))->second  // -> z^(1/2)*log(z)
/// Example  basis(dihedral, root, solutions(dihedral, root))->first  // -> z^(1/4)*exp(sqrt(z))
/// Example  basis(with_log, euler, solutions(with_log, euler), "z", {-1, 2*z})->second  // -> log(z)
[[nodiscard]] std::optional<Basis> basis(const Classification& c, const RationalFunction& r,
                                         const std::vector<LiouvillianSolution>& found,
                                         const std::string& variable = "z",
                                         const RationalFunction& gauge = {},
                                         const Budget& budget = {});

} // namespace kov
