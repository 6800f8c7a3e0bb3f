#pragma once
// For which parameters there is an equation at all: no denominator is identically 0, and nothing
// vanishes that was divided by.
//
// docs/theory/strata.md, 1

#include "strata/decide_strata.hpp"

namespace kov::strata {

/// There is an equation exactly where all of `nonzero`, and one of each group, are not 0.
struct Domain {
  std::vector<MPoly> nonzero; ///< irreducible
  std::vector<std::vector<MPoly>> not_all_zero;
};

/// Conditions that the assumptions do not imply already.  Empty where every admitted point has an equation.
/// Given   Question airy; airy.r = z / a;
/// Given   const StrataAnswer there = decide_strata(airy);
/// Example domain(there).nonzero  // -> {a}
[[nodiscard]] Domain domain(const StrataAnswer& a);
/// "a != 0", "b != 0 or c != 0"
/// Example in_words(domain(there))  // -> {a != 0}
[[nodiscard]] std::vector<std::string> in_words(const Domain& d);

/// The answer on the domain: without strata that have no equation, and without the conditions that
/// hold on the whole domain or are assumed.
/// Example on_domain(there).strata.size()  // -> 1
/// Example on_domain(there).strata[0].conditions.size()  // -> 0
[[nodiscard]] StrataAnswer on_domain(StrataAnswer a);

} // namespace kov::strata
