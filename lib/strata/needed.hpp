#pragma once
// Necessary for an abelian identity component where a leaf is undecided: a statement on exponent
// differences.  docs/theory/strata.md, 6 and 7

#include "strata/leaf.hpp"

namespace kov::strata {

/// Unset: the leaf speaks of no difference, or one has no formula.
[[nodiscard]] std::optional<SomeIn> needed(const Leaf& leaf);
[[nodiscard]] std::optional<SomeIn> needed(const Leaf& leaf, const SomeDifference& open);

} // namespace kov::strata
