#pragma once
// The function h on the curve of a dihedral equation with u^n = h, u = y1/y2.

#include "galois/dihedral.hpp"

namespace kov {

/// a with h = a + b s and dh/h = n eta (dihedral_torsion.md 9); unset: there is none.
/// Requires n a multiple of the denominators of all residues, which are rational
/// Throws   OutOfBudget
/// Cost     one linear recurrence of the degree of the poles of h
/// Given    const RationalFunction r = RationalFunction(-3, 16*z*z) -
///              RationalFunction(3, 16*(z - 1)*(z - 1)) + RationalFunction(11, 72*z*(z - 1));
/// Given    const Classification known = classify(r);
/// Example  *torsion_function(*known.curve, 3)  // -> (2*z - 1)/2
[[nodiscard]] std::optional<RationalFunction>
torsion_function(const DihedralCurve& c, const Integer& n, const Budget& budget = {});

} // namespace kov
