#pragma once
// The steps that a study has proved: on this set of parameters this holds, because of that.  The headline
// and the exit code are functions of it, and two steps that contradict each other are looked for here.

#include "study/contradiction.hpp"
#include "study/headline.hpp"

#include <set>
#include <variant>

namespace kov::study {

using StepId = std::size_t;

/// No complete set of integrals that are of these classes at once.
struct Excluded {
  std::vector<IntegralClass> integrals;
  bool everywhere = false;        ///< at all parameters that the file admits
  std::optional<Exclusion> set{}; ///< where and why; unset: where the premises exclude
};
/// On all levels the variational equations along the curve exclude nothing.  Proved, and settles nothing.
struct Passes {
  bool elsewhere = false; ///< only where no other step about this curve excludes
};
using Says = std::variant<Excluded, Passes, Integrable>;

struct Step {
  std::string curve; ///< empty: of the whole file
  Rule rule = Rule::first_order;
  Says says;
  std::vector<StepId> premises = {}; ///< earlier ones: no circle
  std::vector<Trusted> trusted = {}; ///< of its own
  std::vector<std::string> unchecked = {};
};

struct ProofTree {
  std::vector<std::string> curves; ///< those that were asked about
  std::vector<Step> steps;
  std::vector<std::string>
      cut_short;                    ///< curves whose study a limit or an error of the program ended
  std::vector<std::string> refused; ///< manifolds that are not invariant
};

/// On what a step rests: its own, and that of all below it.
struct Support {
  std::set<Trusted> trusted;
  std::set<std::string> unchecked;
};
[[nodiscard]] Support support(const ProofTree& t, StepId step);

/// The headline of a classification: what it trusts is that of its sets, and of their cover.
[[nodiscard]] Headline headline(const SystemClassification& c);
/// The headline of one curve, and that of all.  Adding steps never takes anything back.
[[nodiscard]] Headline headline(const ProofTree& t, const std::string& curve);
[[nodiscard]] Headline headline(const ProofTree& t);

/// Errors  Contradiction: two steps of the system exclude each other
void refuse_contradictions(const System& s, const ProofTree& t);

} // namespace kov::study
