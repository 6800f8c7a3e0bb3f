#pragma once
// Which part of the normal variational equations a symplectic leaf sees.
//
// Source  docs/theory/mechanics.md (9.7)

#include "variation/normal.hpp"

namespace kov {

/// A block that is a quotient: these unknowns of the normal system, on which it depends, are 0, and
/// so are the differentials of these integrals.
struct Restriction {
  std::vector<std::string> unknowns;
  std::vector<Elimination> integrals;
};

/// Adds the numerator and the denominator of a fraction, unless constant: where it is 0 or has no value.
void add_divisors(std::vector<MPoly>& divisors, const MFraction& f);

/// Do the unknowns of a block take all values on the tangent vectors of the symplectic leaf in the
/// restriction?  Always, where the field is not Hamiltonian or the coordinates are canonical.  Else
/// a minor is needed of the matrix of the rows df P, f of the block or of the restriction, that is
/// not 0 on the curve; it goes to `divisors`.  false: no, or too many rows.
[[nodiscard]] bool seen_on_the_leaf(const VectorField& v, const InvariantManifold& m,
                                    const NormalSystem& n, const Restriction& to,
                                    const std::vector<std::string>& unknowns,
                                    std::vector<MPoly>& divisors);

} // namespace kov
