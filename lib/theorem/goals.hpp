#pragma once
// The findings of a classification as a theorem: each stratum a node, with the values that it was found by.

#include "study/classification.hpp"
#include "theorem/prove.hpp"

namespace kov {

/// The theorem about `system_file`, a path as beside() finds it: claims for integrable strata, cases along
/// the invariant sets that exclude, steps on trust for what `prove` has no rule for, and what is open.
/// s: the system that was classified, as its file has it.
/// Errors  DomainError: what the format has no words for
[[nodiscard]] Theorem goals(const System& s, const SystemClassification& c,
                            const std::string& system_file);
/// Goals as the text of a theorem file about `system_file`, for people.  Each case is studied again, from what the
/// text names; a case or claims that are not found so are words there, nodes of kind trusted.
/// Errors  those of prove
[[nodiscard]] std::string theorem_file(Theorem goals, const std::string& system_file,
                                       ProveOptions options);

/// The strata that are excluded, and of which this file says nothing: there exponent differences exclude at some
/// of their values, and leave others open.
[[nodiscard]] std::vector<const ClassifiedStratum*>
beside_the_theorem(const SystemClassification& c);

} // namespace kov
