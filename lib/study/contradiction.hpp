#pragma once
// Two theorems that cannot both hold: complete integrals of a class, where none are.  The one place in
// which they are looked for.
//
// Each condition is needed: the integrals lie in the class (logarithms do not), they are integrals on
// all levels (Goryachev and Chaplygin's is one on one), the sets meet in a point that the file admits
// (not in complex points of a real family), and nothing that excludes is NOT CHECKED.

#include "study/classification.hpp"
#include "study/exclusion.hpp"

namespace kov::study {

/// As many independent integrals as are needed, on a set of parameters.
struct Integrable {
  ParameterSet where;
  IntegralClass integrals;
  std::string by; ///< which, for the message
};

/// The claims of a file that are proved, for all parameters; unset: they are not complete, or that is
/// not known (only canonical coordinates without function symbols are looked at).
[[nodiscard]] std::optional<Integrable> known_integrals(const System& s,
                                                        const std::vector<ClaimReport>& claims);
/// Proved: both hold at one point.  Both are said of this system, and not of a part of its parameters.
/// What is too hard to tell is not a contradiction.
[[nodiscard]] bool contradict(const System& s, const Exclusion& e, const Integrable& i);
/// Errors  Contradiction
void refuse_contradiction(const System& s, const Exclusion& e, const Integrable& i);

} // namespace kov::study
