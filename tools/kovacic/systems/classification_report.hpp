#pragma once
// A classification as text, as JSON and as a page.

#include "exact/joined.hpp"
#include "study/classification.hpp"
#include "systems/mechanics.hpp"

namespace kov {
struct TheoremResult;
}

namespace kov::cli {

/// As LaTeX ("tex") or HTML: a theorem with its steps.  proved: what `prove` made of its theorem file, with
/// the curve, the change of variable and r(z) of each step; null: the steps are told in short.
[[nodiscard]] std::string classification_page(const System& s, const SystemClassification& c,
                                              const std::string& format,
                                              const TheoremResult* proved = nullptr);

/// INTEGRABLE, NON-INTEGRABLE, ...
[[nodiscard]] std::string headline(const SystemClassification& c);
/// Conditions, status, integrals, reasons of each stratum, and what was tried.
[[nodiscard]] Json strata_json(const SystemClassification& c);

/// "along q1 = 0 (E = 1): the equation is ..."
[[nodiscard]] std::string reason_of(const ExclusionReason& o);
/// "a = 0, b != 1", or "all parameters"
[[nodiscard]] std::string where_text(const SystemClassification& c, const ClassifiedStratum& s);
/// Strata of one status with the same integrals, perhaps at special values of the parameters in them, or on which
/// the same was tried.
struct Alike {
  const ClassifiedStratum* first;
  std::vector<std::string> where;
  bool special = false; ///< integrable, and a limit of a set that is named before
};
[[nodiscard]] std::vector<Alike> alike(const SystemClassification& c, StratumStatus status);
/// Strata that are excluded for one reason, or along one curve at one order.
enum class ExcludedFor : std::uint8_t { the_same_reason, the_same_curve };
struct ExcludedTogether {
  const ExclusionReason* by;
  std::vector<Set> places; ///< texts_of makes few words of them, which takes its time
};
[[nodiscard]] std::vector<ExcludedTogether> excluded_together(const SystemClassification& c,
                                                              ExcludedFor what);

} // namespace kov::cli
