#pragma once
// A proved theorem as one certificate, kovacic-theorem/1 (docs/theory/theorem_certificates.md): each
// step by its data, accepted by the judge before it is handed out.

#include "theorem/prove.hpp"

#include <map>

namespace kov {

/// The steps on trust of a certificate, as its judge counts them, each with the node that it stands for.
using StepsOnTrust = std::vector<std::pair<std::string, Trusted>>;

/// Theorems of the literature that a certificate uses for a step, by the id of the step.
using TheoremsOfSteps = std::map<std::string, std::vector<const LiteratureTheorem*>>;

struct TheoremBundle {
  std::string json{};
  std::string none{}; ///< why there is none: the first step that has no rule or no data
  StepsOnTrust on_trust{};
  std::vector<std::string> carried{};    ///< steps that were on trust: it proves them
  TheoremsOfSteps by_points{};           ///< by Darboux points, in whole or in part
  std::size_t open = 0;                  ///< regions of which it says nothing
  std::vector<IntegralClass> excluded{}; ///< the class of its statement
};

/// Among the ids of refused steps: no symmetry of the family is used.
inline const std::string all_symmetries = "symmetries of the family";

/// A theorem about strata of complex parameters as a certificate, not judged yet; refused: steps that the judge
/// has refused before, by their ids, and why: they are on trust.   Errors  DomainError, OutOfBudget
[[nodiscard]] TheoremBundle bundle_of_strata(TheoremResult& t, const std::string& directory,
                                             const std::map<std::string, std::string>& refused,
                                             const ProveOptions& options);

/// Its text is empty where there is none.  A case is studied again where what a search has found does not reach all of
/// its region.  Reads the files of the steps again.  `directory` ends in '/' or is empty.
/// Errors  OutOfBudget; InputError: a file that cannot be read; InternalError: the judge refuses it
[[nodiscard]] TheoremBundle theorem_bundle(TheoremResult& t, const std::string& directory,
                                           const ProveOptions& options);

} // namespace kov
