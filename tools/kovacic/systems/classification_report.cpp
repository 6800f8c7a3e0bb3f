#include "systems/classification_report.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"
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

namespace {

// The integrals of the general stratum are those of the special one up to constants.
bool are_those_of(const ClassifiedStratum& general, const ClassifiedStratum& special) {
  const auto has_logarithms = [](const FoundIntegral& f) { return !f.logarithms.empty(); };
  if (general.integrals.size() != special.integrals.size() || !general.fields.empty() ||
      !special.fields.empty() || std::ranges::any_of(general.integrals, has_logarithms) ||
      std::ranges::any_of(special.integrals, has_logarithms))
    return false;
  const Ring& ring = special.where.ring();
  const auto is_elsewhere = [&](const FoundIntegral& f) { return f.value.ring() != ring; };
  if (std::ranges::any_of(general.integrals, is_elsewhere) ||
      std::ranges::any_of(special.integrals, is_elsewhere)) // in other variables
    return false;
  const Substitution here = solve(special.where).values;
  const auto is_multiple = [&](const FoundIntegral& f, const FoundIntegral& g) {
    if (f.hamiltonian || g.hamiltonian) return f.hamiltonian == g.hamiltonian;
    const MFraction value = substitute(f.value, here), other = substitute(g.value, here);
    if (is_zero(value) || is_zero(other)) return false;
    const auto used = used_variables(other / value);
    return std::ranges::all_of(
        used, [&](std::size_t i) { return is_among(i, special.where.parameters()); });
  };
  return std::ranges::all_of(special.integrals, [&](const FoundIntegral& f) {
    return std::ranges::any_of(general.integrals,
                               [&](const FoundIntegral& g) { return is_multiple(f, g); });
  });
}

bool same_answer(const ClassifiedStratum& first, const ClassifiedStratum& s) {
  if (integrals_text(first) == integrals_text(s) && first.open_after == s.open_after) return true;
  if (first.status != StratumStatus::integrable || !(first.where.ring() == s.where.ring()))
    return false;
  return tried<DomainError>([&] { return are_those_of(first, s); });
}

bool lies_in_the_closure(const ClassifiedStratum& special, const ClassifiedStratum& general) {
  const auto equations = general.where.equations();
  return special.where.equations().size() > equations.size() &&
         std::ranges::all_of(equations, [&](const MPoly& f) { return special.where.vanishes(f); });
}

} // namespace

std::vector<Alike> alike(const SystemClassification& c, StratumStatus status) {
  std::vector<const ClassifiedStratum*> strata;
  for (const ClassifiedStratum& s : c.strata)
    if (s.status == status) strata.push_back(&s);
  if (status == StratumStatus::integrable) // the general ones first
    std::ranges::stable_sort(
        strata, {}, [](const ClassifiedStratum* s) { return s->where.equations().size(); });
  std::vector<Alike> all;
  std::vector<std::vector<Set>> where;
  for (const ClassifiedStratum* s : strata) {
    std::size_t i = 0;
    while (i < all.size() && !same_answer(*all[i].first, *s))
      ++i;
    if (i == all.size()) {
      const bool special =
          status == StratumStatus::integrable && std::ranges::any_of(all, [&](const Alike& a) {
            return lies_in_the_closure(*s, *a.first);
          });
      all.push_back({s, {}, special});
      where.emplace_back();
    }
    where[i].push_back(s->where);
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
