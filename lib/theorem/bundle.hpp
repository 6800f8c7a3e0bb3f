#pragma once
// A proved theorem as one certificate, kovacic-theorem/1 (docs/theory/theorem_certificates.md): each
// step by its data, accepted by the judge before it is handed out.

#include "exact/budget.hpp"
#include "theorem/strata.hpp"

namespace kov {

struct TheoremBundle {
  std::string json; ///< accepted; empty: there is none
  std::string none; ///< why there is none: the first step that has no rule or no data
  std::vector<std::string> carried; ///< the steps that are in it
  TheoremsOfSteps by_points;        ///< of steps that Darboux points prove, in whole or in part
  std::size_t open = 0;             ///< regions of which it says nothing
  StepsOnTrust on_trust;
  std::vector<IntegralClass> excluded; ///< the class of its statement
};

/// Reads the files of the steps again.  `directory` ends in '/' or is empty.  again: changes a step of t.
/// Errors  OutOfBudget; InputError: a file that cannot be read; InternalError: the judge refuses it
[[nodiscard]] TheoremBundle theorem_bundle(TheoremResult& t, const std::string& directory,
                                           const StudyAgain& again = {}, const Budget& budget = {});

} // namespace kov
