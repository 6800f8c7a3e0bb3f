#pragma once
// Special values of a parameter that only labels the level (the energy): where singular places of r
// merge the group may be easier to find, and one level with a non-abelian identity component proves
// non-integrability.  The paper's 1 + A - h^2 = 0 is such a value.

#include "integrability/study.hpp"

namespace kov {

/// Decides the block at levels, until one is not abelian; `generic` are the blocks at the generic
/// level.
/// Errors  OutOfBudget: `block` keeps what was found before
void study_levels(const Study& study, const ReduceSpec& reduce,
                  const std::vector<BlockReport>& generic, BlockReport& block);

/// The values of parameter `h` at which two singular places of r meet or one goes to infinity, as
/// irreducible polynomials that use h: factors of the leading coefficients, the discriminants and
/// the resultants of the factors of den(r).
/// Given   const Ring ring = make_ring({"z", "h"});
/// Given   const MFraction x = MFraction::variable(ring, "z"), h = MFraction::variable(ring, "h");
/// Example merging_locus(MFraction(ring, 1) / (x * (x - h)), 0, 1)  // -> {h}
[[nodiscard]] std::vector<MPoly> merging_locus(const MFraction& r, std::size_t z, std::size_t h);

} // namespace kov
