#pragma once
// "Every sum of residues vanishes" as polynomial equations in S and the inverse moments a, b, c.
//
// The sums are complex numbers r_+ + Y^k r_-, with Y = e^(-pi nu), 0 < Y < 1, real.  Real and
// imaginary parts are polynomials in Y, S and the moments.  A factor that has one sign for all 0 <
// Y < 1, 0 < a < b < c, 0 < F < G is dropped: that Y depends on a, b, c is never used, so that what
// is proved for an independent Y in (0, 1) holds for the true one.  Sums and differences over the
// two orbits separate the equations by parity.

#include "splitting/cone.hpp"
#include "splitting/residue_sums.hpp"

namespace kov {

struct VanishingConditions {
  Ring ring;                          ///< a, b, c, A, B, C, u, v, and the parameters of H1
  std::vector<std::size_t> direction; ///< the small parameters S
  std::vector<MPoly> equations;
  std::vector<std::string> dropped; ///< the factors of one sign
  /// Factors of the sums in parameters of H1 that are neither small nor moments, nor known to be
  /// positive: dropped as well, so that the equations say something where these are not 0.
  std::vector<MPoly> nonzero = {};
};

/// Errors  DomainError when Y, a level or a root, or a parameter without a sign that is not small, is left in an
///         equation
[[nodiscard]] VanishingConditions vanishing_conditions(const SplittingData& d);

/// a, b = a + u, c = a + u + v with a, u, v > 0.
[[nodiscard]] Cone moment_cone(const Ring& ring);

} // namespace kov
