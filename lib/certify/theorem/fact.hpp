#pragma once
// What a step of a certificate of a theorem says (theorem_certificates.md 1), and the theorems of
// the literature that it may use (9).

#include "certify/system/certificate.hpp"
#include "certify/theorem/place.hpp"

#include <set>

namespace kov::certify {

enum class FactKind : std::uint8_t { not_integrable, integrals, symmetry };

/// First integrals of a family, as they are shown.
struct ClaimedIntegrals {
  const Family* family = nullptr;
  std::vector<std::pair<std::string, PhaseFunction>> claims;
  std::vector<PhaseFunction> level;
};

struct TheoremFact {
  FactKind kind = FactKind::not_integrable;
  const Family* family = nullptr; ///< null: the system of a certificate, known by `target` alone
  Conditions region;
  std::vector<std::string> classes; ///< of first integrals that are excluded
  std::vector<ClaimedIntegrals> integrals;
  std::set<std::string> used;   ///< theorems of the literature
  std::vector<std::string> way; ///< the phase curve, and the maps from it to the family
  std::optional<Target> target;
  std::shared_ptr<const PhaseSystem> system; ///< of the target
  std::shared_ptr<const Map> map;            ///< of a symmetry
};

inline constexpr const char* real_analytic = "real-analytic on the whole real phase space";
inline constexpr const char* near_origin = "meromorphic near the origin";
inline constexpr const char* on_leaves = "meromorphic on the leaves with F2 = 0";
/// In the name of a class about one leaf (system_certificates.md 7).
inline constexpr const char* on_one_leaf = "independent on the symplectic leaf";
inline constexpr const char* rigid_level = "M1*Gamma1 + M2*Gamma2 + M3*Gamma3";

struct NamedTheorem {
  std::string id, title;
  /// how it is settled ("checked", "part of the statement", "NOT CHECKED"), and what it says
  std::vector<std::pair<std::string, std::string>> hypotheses;
};
[[nodiscard]] const std::vector<NamedTheorem>& named_theorems();
/// The family of [Ziglin1983], as JSON.
[[nodiscard]] const std::string& symmetric_heavy_top();

/// The lines of section 10.
[[nodiscard]] std::vector<std::string>
theorem_statement(const TheoremFact& last, const std::vector<const TheoremFact*>& parts,
                  const std::vector<const TheoremFact*>& symmetries);

/// FAMILY, with S1 and S2.
[[nodiscard]] Family read_family(const Node& n, Arithmetic& a);

} // namespace kov::certify
