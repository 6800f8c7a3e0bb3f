#pragma once
// The verdict where exponent differences depend on the parameters and may be rational.
// docs/theory/strata.md, 6 and 7

#include "strata/leaf.hpp"

namespace kov::strata {

/// Requires  Sym^4 has no solution over Q(parameters) for generic exponents.
/// open      the places whose difference is open, at least one
/// torus     why G0 contains a torus on the whole stratum, if that is known
/// log       a logarithm on the whole stratum, if there is one
/// Needs     an open difference equals one of the values for which G0 can be abelian
[[nodiscard]] std::variant<Leaf, Needs>
decide_open_exponents(const Scheme& s, const std::vector<PlaceIndex>& open,
                      const std::optional<Evidence>& torus, const std::optional<Logarithm>& log,
                      const ParametrisedSet& region, const Budget& budget);

} // namespace kov::strata
