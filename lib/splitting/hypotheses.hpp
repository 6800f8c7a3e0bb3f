#pragma once
// The hypotheses of Ziglin's theorem of 1980 for a perturbed Euler top, one by one.
//
//   1  the saddles are hyperbolic, with real eigenvalues +-lambda != 0
//   2  an orbit joins them
//   3  dH0/dG > const > 0 along it
//   4  the orbit has finitely many singular points in the strip 0 <= Im t <= 2 pi/lambda
//   5  H is analytic near the continued orbit, away from those points
//   6  dH0/dG and dH1/dg are single-valued along it
//
// Source  [Ziglin1980]; [PrzybylskaMaciejewski2024] section on non-integrability theorems

#include "splitting/residue_sums.hpp"

namespace kov {

[[nodiscard]] CheckedIdentities check_ziglin_hypotheses(const SplittingData& d);

} // namespace kov
