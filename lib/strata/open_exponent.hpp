#pragma once
// The verdict where exponent differences depend on the parameters and may be rational.
// docs/theory/strata.md, 6 and 7

#include "strata/judge.hpp"

namespace kov::strata {

/// Requires  Sym^4 has no solution over Q(parameters) for generic exponents.
/// torus     why G0 contains a torus on the whole stratum; empty if that is not known
/// log       some place has a logarithm on the whole stratum
/// Needs     an open difference equals one of the values for which G0 can be abelian
[[nodiscard]] std::variant<Leaf, Needs>
judge_open_exponents(const Scheme& s, const std::vector<const ParametricPlace*>& open,
                     const std::string& torus, bool log, const Region& region,
                     const Budget& budget = {});

} // namespace kov::strata
