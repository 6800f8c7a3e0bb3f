#pragma once
// A system with complex parameters as the cover of a theorem and its certificate see it
// (docs/theory/theorem_certificates.md 11 to 16).

#include "theorem/theorem.hpp"

#include <functional>
#include <map>

namespace kov {

/// The steps on trust of a certificate, as its judge counts them, each with the node that it stands for.
using StepsOnTrust = std::vector<std::pair<std::string, Trusted>>;

/// Theorems of the literature that a certificate uses for a step, by the id of the step.
using TheoremsOfSteps = std::map<std::string, std::vector<const LiteratureTheorem*>>;

struct BundleOfStrata {
  std::string json;
  StepsOnTrust on_trust;
  std::vector<std::string> carried; ///< steps that were on trust, and that it proves
  TheoremsOfSteps by_points;        ///< by Darboux points, in whole or in part
};

/// Studies a case by itself where what a search has found does not reach all of its region.
using StudyAgain = std::function<void(NodeResult&)>;

/// A theorem about strata of complex parameters as a certificate; refused: steps that the judge has
/// refused before, by their ids, and why: they are on trust.   Errors  DomainError, OutOfBudget
[[nodiscard]] BundleOfStrata bundle_of_strata(TheoremResult& t, const std::string& directory,
                                              const std::map<std::string, std::string>& refused,
                                              const StudyAgain& again, const Budget& budget);

/// Among the ids of refused steps: no symmetry of the family is used.
inline const std::string all_symmetries = "symmetries of the family";

/// The id of the step that carries the certificate of a case.
[[nodiscard]] inline std::string certificate_step(const std::string& id) { return id + "-step"; }

/// The regions of a step: one, or those that it lists.
[[nodiscard]] std::vector<Assumptions> regions_of(const NodeResult& n);

} // namespace kov
