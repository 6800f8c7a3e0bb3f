#pragma once
// Which powers of a local monodromy are unipotent, exactly: from the eigenvalues of the residue,
// never from balls.
//
// If X_i = (z - s)^w_i Y_i with integers w turns Y' = A Y into a system with a simple pole at s,
// the local monodromy has the eigenvalues exp(2 pi i rho), rho those of the residue matrix.  If all
// rho are rational and N is a common denominator, its N-th power is unipotent.
// docs/theory/monodromy.md 7

#include "exact/budget.hpp"
#include "monodromy/differential_system.hpp"

#include <optional>

namespace kov::monodromy {

/// The least N >= 1 such that the N-th power of the local monodromy around a root of f is
/// unipotent; the same for each root.  Nothing where no integers w are found or an eigenvalue is
/// not rational, which says nothing.  f is monic, irreducible over the field of the system, of positive degree.
/// Cost     a characteristic polynomial of size n over K[z]/f
[[nodiscard]] std::optional<long> unipotent_power(const DifferentialSystem& s, const Poly& f,
                                                  const Budget& budget = {});
/// The same for a circle around all finite singularities.
[[nodiscard]] std::optional<long> unipotent_power_at_infinity(const DifferentialSystem& s,
                                                              const Budget& budget = {});

} // namespace kov::monodromy
