#pragma once
// The divisor E of a dihedral equation has infinite order: by p-curvatures and one prime of good
// reduction, without arithmetic in a Jacobian.
//
// If G were finite, N' the order of E, then B_p != 0 gives p | N' for every good prime p that does
// not divide 2L; and the part of N' prime to q is at most (1 + sqrt q)^(2g) for every prime q of
// good reduction.  Primes p with a larger product leave the infinite group only.
//
// Source  docs/theory/dihedral_torsion.md, 7

#include "exact/budget.hpp"
#include "exact/modular.hpp"
#include "linode/singularities.hpp"

#include <optional>
#include <vector>

namespace kov {

struct DihedralCurve;

/// The primes of the argument.
struct InfiniteTorsion {
  PrimeIdeal good;                 ///< q: C' has good reduction there
  Integer bound;                   ///< >= (1 + sqrt q)^(2g)
  std::vector<PrimeIdeal> nonzero; ///< p != q with B_p != 0; their product is larger than the bound
};

/// Unset where the p-curvatures of the first primes vanish: then the group is finite, or nothing
/// is said.
/// Requires every exponent difference rational, and the curve of the equation of s
/// Throws   OutOfBudget
/// Cost     p-curvatures of about g primes, those below about 10 g
[[nodiscard]] std::optional<InfiniteTorsion>
infinite_by_curvatures(const DihedralCurve& c, const Singularities& s, const Budget& budget = {});

} // namespace kov
