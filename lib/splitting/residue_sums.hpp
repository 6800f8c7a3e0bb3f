#pragma once
// Residues in t of h_k = z^(i k nu) R(z), z = e^(lambda t), in the strip 0 <= Im t <= 2 pi/lambda.
//
// t -> z maps the strip to the z-plane cut along the positive axis, 0 <= arg z <= 2 pi.  The poles
// of R are z = +i (arg pi/2) and z = -i (arg 3 pi/2), dt = dz/(lambda z), and with X = e^(pi nu)
//
//   sum of residues in t  =  X^(-k/2) (r_+ + X^(-k) r_-),
//                    r_+-  =  Res_{z=+-i} z^(i k nu) R/(lambda z) / z0^(i k nu).
//
// The principal branch (arg z = -pi/2 at -i) has X^(+k) instead: with it, and with dz for dt, come
// the sums that [PrzybylskaMaciejewski2024] prints (principal_sum); they are not what the criterion
// needs.

#include "splitting/euler_orbits.hpp"
#include "splitting/perturbation.hpp"

namespace kov {

struct StripResidues {
  long k = 0;
  int sign = 1;                 ///< which orbit
  MFraction mode;               ///< R(z)
  long pole_order = 0;          ///< at z = +-i
  MFraction upper, lower;       ///< r_+, r_-
  MFraction upper_dz, lower_dz; ///< the same for dz in the place of dt
};

/// r_+ + X^(-k) r_-, with Y = 1/X a variable of the ring; the positive factor X^(-k/2) is left out.
[[nodiscard]] MFraction strip_sum(const OrbitSpace& o, const StripResidues& r);
/// The sum on the principal branch of the residues of h_k(z) dz, without X^(-k/2).
[[nodiscard]] MFraction principal_sum(const OrbitSpace& o, const StripResidues& r);

/// Residues of z^(i k nu) R(z).   Errors  DomainError when R has other poles than 0, +-i
[[nodiscard]] StripResidues residues(const OrbitSpace& o, const MFraction& rational, long k,
                                     int sign);

/// Everything from the perturbation to the residues of h_1, ..., h_n on both orbits.
struct SplittingData {
  EulerPerturbation perturbation;
  OrbitSpace space;
  MFraction first;                     ///< H1 in (l, g; L, G, F)
  std::map<long, MFraction> modes;     ///< h_k e^(-i k g)
  std::vector<StripResidues> residues; ///< k > 0, both orbits
  CheckedIdentities checks;
};
[[nodiscard]] SplittingData splitting_data(const EulerPerturbation& p, const Budget& budget = {});

} // namespace kov
