#pragma once
// Strata on which the reduction to y'' = r y breaks down: the whole way again with the parameters
// of the stratum put in.  Another unknown may still be a cyclic vector there.

#include "integrability/study.hpp"

namespace kov {

using SpecialStudies = std::vector<std::shared_ptr<const ManifoldReport>>;

/// Decides the strata of the block with these unknowns on which the reduction is not valid, by
/// doing it again there.  A stratum is abelian only if each block that is new there (not in
/// `generic`) is.  The studies on which the answer then rests are added to `studies`.
void decide_special_strata(const Study& study, const std::vector<BlockReport>& generic,
                           const std::vector<std::string>& unknowns, strata::StrataAnswer& answer,
                           SpecialStudies& studies);

} // namespace kov
