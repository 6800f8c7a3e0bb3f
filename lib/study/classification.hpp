#pragma once
// The theorem on a system with parameters: the parameters divided into strata, on each of which the
// system is integrable (proved), not integrable (proved), or left open.
//
// Parameters that only label levels are not among them: for fixed parameters an integrable system
// is so on all levels (docs/theory/classify.md, 1).

#include "integrability/verdict.hpp"
#include "integrals/find.hpp"
#include "literature/levels.hpp"
#include "literature/literature.hpp"
#include "literature/trusted.hpp"
#include "parameters/few_sets.hpp"

#include <memory>

namespace kov {

namespace study {
class Evidence; // study.hpp
}
struct SplittingFinding; // moves/splitting.hpp
struct CanonicalChange;  // canonical/change.hpp

enum class StratumStatus : std::uint8_t { integrable, excluded, open };
[[nodiscard]] std::string to_string(StratumStatus s); ///< "integrable", "excluded", "open"

/// The reason why a step of a proof holds (study/proof_tree.hpp); of an exclusion: its criterion.
enum class Rule : std::uint8_t {
  first_order,            ///< the group of the variational equations
  higher_order,           ///< of those of higher order, along an invariant plane
  quadratures,            ///< the same by quadratures
  darboux_points,         ///< the eigenvalues at all of them
  multiple_darboux_point, ///< a logarithm at one
  splitting,              ///< of the separatrices of the free body
  leading_part,           ///< of H, as a system of its own
  known_integrals,        ///< they are complete
  cover                   ///< the sets of the premises, put together
};
/// Example to_string(Rule::leading_part)  // -> leading part
[[nodiscard]] std::string to_string(Rule r);

/// Why the system is not integrable somewhere.
struct ExclusionReason {
  std::string solution; ///< the invariant manifold of the particular solutions
  Levels level = {};    ///< for which of them
  int order = 1;        ///< of the variational equations
  std::string reason;
  IntegralClass integrals = {}; ///< the class of first integrals that is excluded
  std::vector<const LiteratureTheorem*> theorems = {};
  std::string unchecked; ///< a hypothesis that is not proved, as a sentence; or empty
  /// The steps on which it rests besides theorems, exact computation and accepted certificates.
  std::vector<Trusted> trusted = {};
  bool carried = false; ///< from another set of parameters, by a change of variables
  Rule rule = Rule::first_order;
  friend bool operator==(const ExclusionReason&, const ExclusionReason&) = default;
};

struct ClassifiedStratum {
  Set where;
  StratumStatus status = StratumStatus::open;
  /// integrable: independent and in involution (or, without a bracket, independent), as many as
  /// needed together with the fields; open: those that were found beside H
  std::vector<FoundIntegral> integrals = {};
  /// integrable, without a bracket: they commute with the field and with one another, and the
  /// integrals are constant along them
  std::vector<std::string> fields = {};
  std::vector<std::vector<MFraction>> field_components =
      {};                                   ///< the same, in the order of the coordinates
  std::vector<ExclusionReason> by = {};     ///< excluded: each of them is enough
  std::vector<std::string> open_after = {}; ///< open: what was tried
  /// Algebraic constants, by their variables, in which integrals, fields or reasons may be written.
  std::vector<std::size_t> constants = {};
  std::optional<ManifoldSpec> along = {}; ///< excluded: along this invariant set
  /// The study that excludes it; null: it was made elsewhere, or along no set.
  std::shared_ptr<const study::Evidence> from = {};
  std::shared_ptr<const CanonicalChange> change =
      {}; ///< to the system of the study, if it is another
  std::shared_ptr<const SplittingFinding> splitting = {}; ///< that excludes it
  /// The weights of momenta and of Gamma, where the study is of the system of lowest order.
  std::optional<std::pair<long, long>> lowest = {};
};

/// A set of parameters that stays open: not integrable for almost all parameters, all but a set of
/// measure zero that is not determined (docs/theory/classify.md, 10).
struct AlmostAll {
  std::string at; ///< "a = 2, b = 3": where the matrices were computed
  ExclusionReason by;
};

/// One task of the search.
struct Spent {
  std::string task;
  double work = 0; ///< units of the meter (exact/meter.hpp)
  double seconds = 0;
};

/// A part of the file that was not used, or a limit that ended a part of the work.
struct ClassificationNote {
  enum class What : std::uint8_t {
    not_used,          ///< of: an assumption on levels
    used_on_manifolds, ///< the same, used along the file's manifolds only
    manifold,          ///< of: one of the file and why it was not used
    limit,             ///< of: what ended a part of the work
    rest_is_open,      ///< of: what ended the work
    clock,
    constants,  ///< of: what ended the work with algebraic constants
    almost_all, ///< of: what ended the work at points
    unfinished
  };
  What what = What::rest_is_open;
  std::string of = {};
  friend bool operator==(const ClassificationNote&, const ClassificationNote&) = default;
};
[[nodiscard]] std::string sentence(const ClassificationNote& n);
[[nodiscard]] std::vector<std::string> sentences(const std::vector<ClassificationNote>& all);

/// An assumption on independence, which the certificate of integrals does without (theorem_certificates.md 13).
inline const std::string only_declared_relations =
    "the function symbols satisfy no algebraic relations but those declared";

struct SystemClassification {
  std::vector<ClassifiedStratum> strata; ///< disjoint; they cover all parameters
  std::vector<std::string> assumptions;  ///< under which all of this is proved
  /// Algebraic constants that the file does not have: what is said holds for each of the roots.
  std::vector<std::string> constants;
  std::vector<MPoly> nonzero;   ///< those of them that say what does not vanish
  Assumptions known;            ///< all of them as values
  std::vector<MPoly> relations; ///< of the algebraic constants: each set satisfies them
  std::optional<AlmostAll> almost_all;
  std::vector<const LiteratureTheorem*> theorems; ///< that are used
  std::vector<Trusted> trusted;                   ///< steps that no certificate repeats
  std::vector<ClassificationNote> notes;
  /// First integrals that are of all these classes at once are excluded; empty where nothing is.
  std::vector<IntegralClass> excluded;
  bool no_parameters = false; ///< the system has none but those that label levels
  bool liouville = true;      ///< a Hamiltonian system: "integrable" is meant in Liouville's sense
  /// Not empty: class, solutions and long integrals are written in these variables, "X = r*cos_t", the
  /// others by their names (lib/canonical).
  std::vector<std::string> variables = {};
  bool are_curves_old =
      false;                ///< all the same, invariant sets and integrals are those of the system
  std::vector<Spent> spent; ///< on what, in the order in which it was done
  double seconds = 0;
  std::string at_work; ///< on the way: the stage that begins
  /// All of the work that was allowed is done: another run says the same.  False: the clock, or a
  /// request, ended it.
  bool complete = true;

  [[nodiscard]] Verdict status() const;
};
/// The word of a classification: its undecided is "open", as that of a stratum.
[[nodiscard]] std::string status_word(Verdict v);

/// "meromorphic (in the coordinates and s, c)"; empty where nothing is excluded.
[[nodiscard]] std::string integrals_class(const SystemClassification& c);
/// "b = 6", "b = 1, A = B": the strata with one of these, in few pieces.
[[nodiscard]] std::vector<std::string> places(const SystemClassification& c,
                                              const std::vector<StratumStatus>& wanted);
/// The same of these sets, not all of which need to be strata.
[[nodiscard]] std::vector<std::string> texts_of(const SystemClassification& c,
                                                std::vector<Set> all);
/// The theorem as one sentence.
[[nodiscard]] std::string statement(const SystemClassification& c);
/// "not integrable with first integrals that are ...": what one reason proves of its strata.
[[nodiscard]] std::string statement(const ExclusionReason& by);
/// Their names.
[[nodiscard]] std::vector<std::string>
theorem_names(const std::vector<const LiteratureTheorem*>& all);
/// "H, x*v - y*u", of an integrable stratum
[[nodiscard]] std::string integrals_text(const ClassifiedStratum& s);
/// The conditions of a set besides the assumptions, each as text; empty: all parameters.
[[nodiscard]] std::vector<std::string> conditions(const SystemClassification& c, const Set& where);

} // namespace kov
