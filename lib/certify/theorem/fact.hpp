#pragma once
// The fact that a step of a theorem's certificate states (theorem_certificates.md 1), and the
// theorems of the literature that it may use (9).

#include "certify/system/check.hpp"
#include "certify/theorem/map.hpp"
#include "exact/lists.hpp"
#include "literature/integral_class.hpp"

#include <set>

namespace kov::certify {

/// leaves: of a certificate, whose leaves may be named one by one.
enum class FactKind : std::uint8_t {
  not_integrable,
  integrals,
  symmetry,
  integrable,
  open,
  leaves
};

/// First integrals of a family, as they are shown.
struct ClaimedIntegrals {
  const Family* family = nullptr;
  std::vector<std::pair<std::string, PhaseFunction>> claims;
  std::vector<PhaseFunction> level;
  std::vector<std::vector<PhaseFunction>> fields{}; ///< that commute with the family's
  std::vector<std::string> not_shown{};             ///< what is taken on trust of them
};

/// A leaf of a certificate that says "not abelian".
struct LeafSaid {
  std::vector<AskedCondition> asked; ///< on the way to it
  std::size_t trusted = 0;
  IntegralClass integrals;                   ///< excluded by this leaf
  std::optional<OneDifference> difference{}; ///< of a criterion, in the names of the system
};

/// The conclusion of a rule, with the theorems and the trust of the rule itself.
struct Said {
  FactKind kind;
  const Family* family;            ///< null: the system of a certificate, known by `target` alone
  std::vector<Conditions> regions; ///< it is said of each
  bool several = false;            ///< a part names one of them
  std::string trusted{};           ///< the step that nothing repeats
  bool shows_way = false;          ///< the statement names the curve
  std::vector<IntegralClass> classes{}; ///< of first integrals that are excluded
  std::vector<ClaimedIntegrals> integrals{};
  std::vector<std::string> way{}; ///< the phase curve, and the maps from it to the family
  FunctionsThere there{}; ///< the values of functions along it, of which alone the fact speaks
  std::optional<Target> target{};
  std::shared_ptr<const PhaseSystem> system{}; ///< of the target
  std::shared_ptr<const Map> map{};            ///< of a symmetry
  std::vector<LeafSaid> leaves{}, criteria{};  ///< of a certificate: "not abelian", "where"
  std::set<std::string> used{};                ///< of the literature
  /// The steps that nothing repeats, and what is taken on trust of each.
  std::set<std::pair<std::string, std::string>> trusts{};
  /// The fact is that of a certificate, in the coordinates of its own system.
  bool only_stratum = false;
};

class TheoremFact : public Said {
private:
  friend class Facts;
  TheoremFact(Said said, const std::vector<const TheoremFact*>& premises) : Said(std::move(said)) {
    for (const TheoremFact* f : premises) {
      used.insert(f->used.begin(), f->used.end());
      trusts.insert(f->trusts.begin(), f->trusts.end());
      only_stratum = only_stratum || f->only_stratum;
    }
  }
};

/// The steps so far.  No rule makes a fact: it says something, and the steps that it has looked at are the
/// premises, whose theorems, trust and limits the fact has as well.
class Facts {
public:
  [[nodiscard]] bool has(const std::string& id) const { return all_.contains(id); }
  [[nodiscard]] bool is_named(const std::string& id) const { return named_.contains(id); }
  /// A step before.
  const TheoremFact& premise(const std::string& id) {
    const auto found = all_.find(id);
    need(found != all_.end(), "there is no such step before");
    named_.insert(id);
    premises_.push_back(&found->second);
    return found->second;
  }
  const TheoremFact& derive(const std::string& id, Said said) {
    TheoremFact fact(std::move(said), std::exchange(premises_, {}));
    return all_.emplace(id, std::move(fact)).first->second;
  }
  /// The ids of the premises of the next fact.
  [[nodiscard]] std::vector<std::string> premises() const {
    std::vector<std::string> ids;
    for (const TheoremFact* f : premises_)
      for (const auto& [id, fact] : all_)
        if (&fact == f) add_once(ids, id);
    return ids;
  }

private:
  std::map<std::string, TheoremFact> all_;
  std::set<std::string> named_;
  std::vector<const TheoremFact*> premises_; ///< of the next one
};

/// The rule `certificate` (5).
[[nodiscard]] Said said_by_certificate(const Node& inner);
/// The system of a certificate at the points of a leaf.
[[nodiscard]] Target target_of(const Said& certificate, const LeafSaid& leaf);

[[nodiscard]] inline IntegralClass real_analytic() {
  return {.kind = IntegralClass::Kind::real_analytic, .near = IntegralClass::Near::phase_space};
}
[[nodiscard]] inline IntegralClass near_origin() { return {.near = IntegralClass::Near::origin}; }
[[nodiscard]] inline IntegralClass on_leaves() { return {.near = IntegralClass::Near::level}; }
/// Is one of them about integrals that are independent on one leaf (system_certificates.md 7)?
[[nodiscard]] bool on_one_leaf(const std::vector<IntegralClass>& classes);

struct NamedTheorem {
  std::string id, title;
  /// how it is settled ("checked", "part of the statement", "NOT CHECKED"), and what it says
  std::vector<std::pair<std::string, std::string>> hypotheses;
};
[[nodiscard]] const std::vector<NamedTheorem>& named_theorems();

/// The lines of section 10.  led: to these parts a symmetry leads.
[[nodiscard]] std::vector<std::string>
theorem_statement(const TheoremFact& last, const std::vector<const TheoremFact*>& parts,
                  const std::vector<const TheoremFact*>& symmetries,
                  const std::set<const TheoremFact*>& led);

/// The fact of one step, for a reader.
[[nodiscard]] std::string shown(const TheoremFact& f);

/// The classes of first integrals as JSON (theorem_certificates.md 14).
[[nodiscard]] IntegralClass read_class(const Node& n);

} // namespace kov::certify
