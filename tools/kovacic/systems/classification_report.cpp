#include "systems/classification_report.hpp"

#include "study/headline_words.hpp"

#include <algorithm>
#include <optional>

namespace kov::cli {

std::string reason_of(const ExclusionReason& o) {
  return "along " + o.solution + (o.level.empty() ? "" : " (" + sentence(o.level) + ")") + ": " +
         o.reason;
}

std::string headline(const SystemClassification& c) {
  return c.status() == Verdict::undecided ? "OPEN" : study::headline(c.status());
}

std::string where_text(const SystemClassification& c, const ClassifiedStratum& s) {
  const std::string text = joined(conditions(c, s.where), ", ", " and ");
  return text.empty() ? "all parameters" : text;
}

namespace {

Json integral_json(const FoundIntegral& f) {
  return {{"value", to_string(f)}, {"kind", kind_of(f)}};
}

Json exclusion_json(const ExclusionReason& o) {
  return {{"solution", o.solution},
          {"criterion", to_string(o.rule)},
          {"order", o.order},
          {"level", text_or_null(sentence(o.level))},
          {"reason", o.reason},
          {"integrals_class", sentence(o.integrals)},
          {"not_checked", text_or_null(o.unchecked)}};
}

Json stratum_json(const SystemClassification& c, const ClassifiedStratum& s) {
  return {{"conditions", conditions(c, s.where)},
          {"status", to_string(s.status)},
          {"integrals", list_of(s.integrals, integral_json)},
          {"fields", s.fields},
          {"by", list_of(s.by, exclusion_json)},
          {"open_after", s.open_after}};
}

} // namespace

Json strata_json(const SystemClassification& c) {
  return list_of(c.strata, [&](const ClassifiedStratum& s) { return stratum_json(c, s); });
}

namespace {

bool same(const ExclusionReason& a, const ExclusionReason& b, ExcludedFor what) {
  if (a.unchecked != b.unchecked) return false;
  return what == ExcludedFor::the_same_curve
             ? a.solution == b.solution && a.order == b.order
             : reason_of(a) == reason_of(b) && a.integrals == b.integrals;
}

} // namespace

std::vector<Alike> alike(const SystemClassification& c, StratumStatus status) {
  std::vector<Alike> all;
  std::vector<std::vector<Set>> where;
  for (const ClassifiedStratum& s : c.strata) {
    if (s.status != status) continue;
    std::size_t i = 0;
    while (i < all.size() && !(integrals_text(*all[i].first) == integrals_text(s) &&
                               all[i].first->open_after == s.open_after))
      ++i;
    if (i == all.size()) {
      all.push_back({&s, {}});
      where.emplace_back();
    }
    where[i].push_back(s.where);
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].where = texts_of(c, std::move(where[i]));
  return all;
}

std::vector<ExcludedTogether> excluded_together(const SystemClassification& c, ExcludedFor what) {
  std::vector<ExcludedTogether> all;
  for (const ClassifiedStratum& s : c.strata) {
    if (s.status != StratumStatus::excluded) continue;
    const ExclusionReason& by = s.by.front();
    std::size_t i = 0;
    while (i < all.size() && !same(*all[i].by, by, what))
      ++i;
    if (i == all.size()) all.push_back({&by, {}});
    all[i].places.push_back(s.where);
  }
  return all;
}

} // namespace kov::cli
