#pragma once
// The question in the user's variables, and where that leaves much open in those of a canonical change.
//
// Source  docs/theory/classify.md (11), docs/theory/canonical.md

#include "canonical/simplify.hpp"
#include "classify/stated.hpp"

namespace kov {

/// Something is known of some set, or of almost all parameters.
[[nodiscard]] bool decides_something(const SystemClassification& c);

/// The composition for the system as it is written.
[[nodiscard]] SystemClassification classify_in_these_variables(const System& s,
                                                               const ClassifyOptions& options,
                                                               const StatedSolutions& stated);

/// The results for change.system, as statements about the old system: integrals as functions of its
/// variables where these are short, exclusions as they are, with what the new variables mean.
[[nodiscard]] SystemClassification said_of_the_old(SystemClassification c, const System& old,
                                                   const CanonicalChange& change);

} // namespace kov
