#pragma once
// The findings of a classification, as a theorem file: each stratum a node that `prove` checks again.

#include "study/classification.hpp"
#include "theorem/theorem.hpp"

namespace kov {

/// The text of a theorem file about `system_file`, a path as the theorem file writes it: claims for
/// integrable strata, cases along the invariant sets that exclude, steps on trust for what `prove` has
/// no rule for, and what is open.  s: the system that was classified, as its file has it.
/// Errors  DomainError: what the format has no words for
[[nodiscard]] std::string theorem_file(const System& s, const SystemClassification& c,
                                       const std::string& system_file);

/// The strata that are excluded, and of which this file says nothing: there exponent differences exclude at some
/// of their values, and leave others open.
[[nodiscard]] std::vector<const ClassifiedStratum*>
beside_the_theorem(const SystemClassification& c);

} // namespace kov
