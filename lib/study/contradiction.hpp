#pragma once
// Two theorems that cannot both hold: complete integrals of a class, where none are.  The one place in
// which they are looked for.
//
// Each condition is needed: the integrals lie in the class (logarithms do not), they are integrals on
// all levels (Goryachev and Chaplygin's is one on one), the sets meet in a point that the file admits
// (not in complex points of a real family), and nothing that excludes is NOT CHECKED.

#include "study/classification.hpp"
#include "study/exclusion.hpp"
#include "study/pieces.hpp"

namespace kov::study {

/// As many independent integrals as are needed.
struct CompleteIntegrals {
  bool rational = true;    ///< in the coordinates, for all of the function symbols
  bool polynomial = false; ///< with real coefficients: they are of each kind, near each point
  bool liouville = true;   ///< in involution; else with commuting fields
  std::string by;          ///< which, for the message
};
/// On a set of parameters.
struct Integrable {
  Set where;
  CompleteIntegrals integrals;
};
[[nodiscard]] CompleteIntegrals complete_integrals(const System& s,
                                                   const std::vector<FoundIntegral>& integrals);

/// The claims of a file that are proved, for all parameters; unset: they are not complete, or that is
/// not known (only canonical coordinates without function symbols are looked at).
[[nodiscard]] std::optional<Integrable> known_integrals(const System& s,
                                                        const std::vector<ClaimReport>& claims);
/// Does the reason exclude them, where it holds?
[[nodiscard]] bool excludes(const ExclusionReason& by, const CompleteIntegrals& i);
/// Is there a point of the set that the file admits and where these conditions hold?  yes is proved: by
/// values of the parameters, or, where all complex ones are admitted, by the equations.
[[nodiscard]] bool meet(const System& s, const Set& set, const Cut& conditions);

/// Proved: both hold at one point.  Both are said of this system, and not of a part of its parameters.
/// A case that is too hard to decide is not a contradiction.
[[nodiscard]] bool contradict(const System& s, const Exclusion& e, const Integrable& i);
/// The same of two sets, one of them given by its conditions.   Errors  Contradiction
void refuse_contradiction(const System& s, const ExclusionReason& by, const CompleteIntegrals& i,
                          const Set& set, const Cut& conditions);

} // namespace kov::study
