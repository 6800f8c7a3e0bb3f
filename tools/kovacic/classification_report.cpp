#include "classification_report.hpp"

#include <algorithm>
#include <optional>

namespace kov::cli {

std::string joined(const std::vector<std::string>& all, const std::string& between) {
  std::string text;
  for (const std::string& one : all)
    text += (text.empty() ? "" : between) + one;
  return text;
}

std::string reason_of(const ExclusionReason& o) {
  return "along " + o.solution + (o.level.empty() ? "" : " (" + o.level + ")") + ": " + o.reason;
}

std::string where_text(const SystemClassification& c, const ClassifiedStratum& s) {
  const std::string text = joined(conditions(c, s), ", ");
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
                  {"order", o.order},
                  {"level", o.level.empty() ? Json(nullptr) : Json(o.level)},
                  {"reason", o.reason},
                  {"integrals_class", sentence(o.integrals)},
                  {"not_checked", o.unchecked.empty() ? Json(nullptr) : Json(o.unchecked)}});
  return {{"conditions", conditions(c, s)},
          {"status", to_string(s.status)},
          {"integrals", integrals},
          {"fields", s.fields},
          {"by", by},
          {"open_after", s.open_after}};
}

std::vector<ExcludedTogether> excluded_together(const SystemClassification& c) {
  std::vector<ExcludedTogether> all;
  for (const ClassifiedStratum& s : c.strata) {
    if (s.status != StratumStatus::excluded) continue;
    const ExclusionReason& by = s.by.front();
    auto same = std::find_if(all.begin(), all.end(), [&](const ExcludedTogether& e) {
      return reason_of(*e.by) == reason_of(by) && e.by->integrals == by.integrals &&
             e.by->unchecked == by.unchecked;
    });
    if (same == all.end()) same = all.insert(all.end(), {&by, {}});
    same->where.push_back(where_text(c, s));
  }
  return all;
}

} // namespace kov::cli
