#pragma once
// Andoyer-Deprit variables (l, g, h; L, G, F) of a rigid body, exactly.
//
//   M     = (p sin l, p cos l, L),              p = sqrt(G^2 - L^2) > 0,  G = |M|
//   Gamma = (F/G^2) M + (s/G) (e1 cos g + e2 sin g),  s = sqrt(G^2 - F^2) > 0,  F = M . Gamma
//   e1    = (L sin l, L cos l, -p)/G,  e2 = (cos l, -sin l, 0):
//           orthonormal, e1, e2 orthogonal to M
//
// on Gamma^2 = 1.  Sines, cosines and roots are variables of the ring with their relations and
// their gradients.  The angle h is a rotation about Gamma: M and Gamma do not depend on it.
//
// Inverse: L = M3, G = |M|, F = M . Gamma, l = atan2(M1, M2),
//          g = atan2(G (M2 Gamma1 - M1 Gamma2), M3 F - G^2 Gamma3)
// where atan2 takes the quadrant from the signs of both arguments (arctan of the quotient does
// not).
//
// Source  [Deprit1967]; signs as in [PrzybylskaMaciejewski2024], where {M1, M2} = -M3

#include "splitting/checked.hpp"
#include "splitting/surds.hpp"
#include "system/vector_field.hpp"

#include <array>

namespace kov {

using Triple = std::array<MFraction, 3>;

[[nodiscard]] inline MFraction dot(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct AndoyerChart {
  Ring ring;
  VectorField phase; ///< (l, g, h, L, G, F) with its canonical bracket
  SurdField field;   ///< i, p, s, cos l, cos g
  Triple momentum, gamma, e1, e2;

  [[nodiscard]] MFraction variable(const std::string& name) const {
    return MFraction::variable(ring, name);
  }
};

/// The chart over a ring that also holds the names in `more`.
[[nodiscard]] AndoyerChart andoyer_chart(const std::vector<std::string>& more);

/// The brackets of e(3), the Casimirs and the inverse formulas: everything that "canonical
/// coordinates on the leaves of e(3)*" means.   Cost  some ten milliseconds
[[nodiscard]] CheckedIdentities check_andoyer(const AndoyerChart& chart);

/// Coefficients of e^(i k g), k = -n ... n, of a function that is polynomial in sin g, cos g.
/// Errors  DomainError for another function
[[nodiscard]] std::map<long, MFraction> fourier_modes(const AndoyerChart& chart,
                                                      const MFraction& f);

} // namespace kov
