#include "study/curve.hpp"

#include "integrability/check.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>

namespace kov {
namespace {

bool is_reduced_by_an_integral(const ManifoldReport& report) {
  const auto& all = report.reduced.eliminations;
  return std::ranges::any_of(all, [](const Elimination& e) { return !e.casimir; });
}

bool excludes_something(const ManifoldReport& report) {
  return report.verdict == Verdict::non_integrable ||
         std::ranges::any_of(report.blocks, [](const BlockReport& b) {
           return b.abelian == Truth::no || (b.strata && somewhere_not_abelian(*b.strata));
         });
}

} // namespace

ManifoldReport study_curve(const System& s, const ManifoldSpec& m,
                           const std::vector<ClaimReport>& claims, const CheckOptions& options) {
  ManifoldReport report = check_manifold(s, m, claims, options);
  if (options.stop_at_r || report.failure || report.verdict != Verdict::undecided ||
      excludes_something(report) || !is_reduced_by_an_integral(report))
    return report;
  auto casimirs = claims;
  std::erase_if(casimirs,
                [](const ClaimReport& c) { return c.claim.kind == SystemClaim::Kind::integral; });
  ManifoldReport whole = check_manifold(s, m, casimirs, options);
  return !whole.failure && excludes_something(whole) ? whole : report;
}

} // namespace kov
