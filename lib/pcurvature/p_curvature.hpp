#pragma once
// The p-curvature of y'' = r y as a proof that G = SL(2, C).
//
// For Y' = A Y, A = (0 1; r 0), put A_1 = A, A_(k+1) = A_k' + A_k A.  Modulo p the matrix A_p has
// trace 0, A_p^2 = B_p I.  If r is integral at a prime above p >= 7, then
//
//   case 1  =>  B_p is a square in Fbar_p(z);
//   case 2  =>  B_p becomes a square after adjoining a square root that is branched at reductions
//               of admissible places only: Delta in 1/2 + Z, or odd order >= 3 (infinity: odd
//               o <= 1);
//   finite primitive  =>  B_p = 0.
//
// So one prime with B_p != 0 and an odd place that is not admissible leaves SL(2, C) only.
//
// Source  docs/theory/p_curvature.md, with the proof

#include "exact/modular.hpp"
#include "linode/singularities.hpp"

#include <optional>

namespace kov {

/// A prime whose p-curvature proves G = SL(2, C).
struct PCurvatureProof {
  PrimeIdeal prime;
  long odd_places =
      0; ///< degree of the odd part of B_p outside the admissible places (infinity counts 1)
};

/// B_p times the square den^(2p).  Requires p odd and r integral at p (unset otherwise).
/// Cost  p steps on polynomials of degree <= p deg r
/// Source  docs/theory/p_curvature.md
/// Example degree(*p_curvature(z, {7, 0}))  // -> 7
[[nodiscard]] std::optional<NmodPoly> p_curvature(const RationalFunction& r,
                                                  const PrimeIdeal& prime);

/// Tries the first good primes from 7 on; nothing found proves nothing.
/// Throws  OutOfBudget
/// Example sl2_by_p_curvature(singularities(z))->prime.p  // -> 7
/// Example sl2_by_p_curvature(singularities(z*z + 3)).has_value()  // -> no
[[nodiscard]] std::optional<PCurvatureProof>
sl2_by_p_curvature(const Singularities& s, int primes = 3, const Budget& budget = {});

} // namespace kov
