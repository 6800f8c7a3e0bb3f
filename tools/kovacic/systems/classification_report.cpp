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

Json json_of(const SystemClassification& c, const ClassifiedStratum& s) {
  Json integrals = Json::array();
  for (const FoundIntegral& f : s.integrals)
    integrals.push_back({{"value", to_string(f)},
                         {"kind", f.hamiltonian ? "hamiltonian"
                                  : f.casimir   ? "casimir"
                                                : "integral"}});
  Json by = Json::array();
  for (const ExclusionReason& o : s.by)
    by.push_back({{"solution", o.solution},
                  {"criterion", to_string(o.rule)},
                  {"order", o.order},
                  {"level", o.level.empty() ? Json(nullptr) : Json(sentence(o.level))},
                  {"reason", o.reason},
                  {"integrals_class", sentence(o.integrals)},
                  {"not_checked", o.unchecked.empty() ? Json(nullptr) : Json(o.unchecked)}});
  return {{"conditions", conditions(c, s.where)},
          {"status", to_string(s.status)},
          {"integrals", integrals},
          {"fields", s.fields},
          {"by", by},
          {"open_after", s.open_after}};
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
