#pragma once
// The fact that a step of a theorem's certificate states (theorem_certificates.md 1), and the
// theorems of the literature that it may use (9).

#include "certify/system/check.hpp"
#include "certify/theorem/place.hpp"
#include "literature/integral_class.hpp"

#include <set>

namespace kov::certify {

enum class FactKind : std::uint8_t { not_integrable, integrals, symmetry, integrable, open };

/// First integrals of a family, as they are shown.
struct ClaimedIntegrals {
  const Family* family = nullptr;
  std::vector<std::pair<std::string, PhaseFunction>> claims;
  std::vector<PhaseFunction> level;
  std::vector<std::vector<PhaseFunction>> fields{}; ///< that commute with the family's
  std::vector<std::string> not_shown{};             ///< what is taken on trust of them
};

class TheoremFact {
public:
  FactKind kind;
  const Family* family;            ///< null: the system of a certificate, known by `target` alone
  std::vector<Conditions> regions; ///< it is said of each
  bool several = false;            ///< a part names one of them
  std::string trusted{};           ///< the step that nothing repeats
  bool shows_way = false;          ///< the statement names the curve
  std::vector<IntegralClass> classes; ///< of first integrals that are excluded
  std::vector<ClaimedIntegrals> integrals;
  std::vector<std::string> way; ///< the phase curve, and the maps from it to the family
  FunctionsThere there{}; ///< the values of functions along it, of which alone the fact speaks
  std::optional<Target> target;
  std::shared_ptr<const PhaseSystem> system; ///< of the target
  std::shared_ptr<const Map> map;            ///< of a symmetry

  /// It has the theorems, the trust and the limits of its premises as well, whatever its rule says.
  TheoremFact(FactKind what, const Family* about, const std::vector<const TheoremFact*>& premises,
              std::vector<Conditions> where);

  void use(const std::string& theorem) { used_.insert(theorem); }
  void trust(const std::string& step, const std::string& what) { trusts_.insert({step, what}); }
  void allow_only_stratum() { only_stratum_ = true; }

  [[nodiscard]] const std::set<std::string>& used() const { return used_; } ///< of the literature
  /// The steps that nothing repeats, and what is taken on trust of each.
  [[nodiscard]] const auto& trusts() const { return trusts_; }
  /// The fact is that of a certificate, in the coordinates of its own system.
  [[nodiscard]] bool only_stratum() const { return only_stratum_; }

private:
  std::set<std::string> used_;
  std::set<std::pair<std::string, std::string>> trusts_;
  bool only_stratum_ = false;
};

[[nodiscard]] inline IntegralClass real_analytic() {
  return {.kind = IntegralClass::Kind::real_analytic, .near = IntegralClass::Near::phase_space};
}
[[nodiscard]] inline IntegralClass near_origin() { return {.near = IntegralClass::Near::origin}; }
[[nodiscard]] inline IntegralClass on_leaves() { return {.near = IntegralClass::Near::level}; }
/// Is one of them about integrals that are independent on one leaf (system_certificates.md 7)?
[[nodiscard]] bool on_one_leaf(const std::vector<IntegralClass>& classes);
inline constexpr const char* rigid_level = "M1*Gamma1 + M2*Gamma2 + M3*Gamma3";

struct NamedTheorem {
  std::string id, title;
  /// how it is settled ("checked", "part of the statement", "NOT CHECKED"), and what it says
  std::vector<std::pair<std::string, std::string>> hypotheses;
};
[[nodiscard]] const std::vector<NamedTheorem>& named_theorems();
/// The family of [Ziglin1983], as JSON.
[[nodiscard]] const std::string& symmetric_heavy_top();

/// The lines of section 10.  led: to these parts a symmetry leads.
[[nodiscard]] std::vector<std::string>
theorem_statement(const TheoremFact& last, const std::vector<const TheoremFact*>& parts,
                  const std::vector<const TheoremFact*>& symmetries,
                  const std::set<const TheoremFact*>& led);

/// The classes of first integrals as JSON (theorem_certificates.md 12).
[[nodiscard]] IntegralClass read_class(const Node& n);

/// FAMILY, with S1 and S2.
[[nodiscard]] Family read_family(const Node& n, Arithmetic& a);

} // namespace kov::certify
