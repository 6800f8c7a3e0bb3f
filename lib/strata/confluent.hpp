#pragma once
// Two families in which the answer is a condition "v is an integer", for all parameters at once.
// docs/theory/strata.md, 8
//
//   Bessel   r = a/t^2 + b t^(s-2), t = z - c, s >= 1, b != 0: abelian <=> Delta/s - 1/2 in Z,
//            Delta^2 = 1 + 4a  [docs/theory/confluent.md, 2 and 3]
//   Weber    r = a^2 z^2 + b z + c, a != 0: never abelian; Borel <=> (e - 1)/2 in Z,
//            e = (c - b^2/(4 a^2))/a, else SL(2)

#include "strata/leaf.hpp"

namespace kov::strata {

/// Unset: not a member.  The coefficients b, a are known to be nonzero on the stratum.
[[nodiscard]] std::optional<Leaf> bessel_leaf(const Scheme& s, const Region& region);
[[nodiscard]] std::optional<Leaf> weber_leaf(const Scheme& s, const Region& region);

} // namespace kov::strata
