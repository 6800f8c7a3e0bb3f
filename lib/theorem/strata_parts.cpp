#include "theorem/strata_parts.hpp"

#include "exact/lists.hpp"
#include "system/in_ring.hpp"
#include "theorem/place.hpp"
#include "theorem/setting.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace kov {
namespace {

Json json_truth(bool x) { return json_text(x ? "yes" : "no"); }
Json json_texts(const std::vector<std::string>& all) {
  auto list = mapped<Json>(all, [&](const std::string& one) { return json_text(one); });
  return json_list(std::move(list));
}

System system_in_bundle(const Theorem& t, const std::string& directory) {
  System s = system_of(t, directory);
  return is_of_strata(t) ? s : with_real_parameters(std::move(s));
}

std::optional<std::size_t> linear_parameter(const MPoly& f) {
  std::optional<std::size_t> last; // as `solve` of lib/parameters does
  for (const std::size_t i : used_variables(f))
    if (degree(f, i) == 1 && is_constant(coefficients(f, i)[1])) last = i;
  return last;
}

} // namespace

Json json_class(const IntegralClass& c) {
  if (c.near == IntegralClass::Near::level)
    throw DomainError("there is no rule for first integrals that are " + sentence(c));
  std::vector<std::string> symbols;
  for (const auto& [coordinate, symbol] : c.through)
    add_once(symbols, symbol);
  return Json{Json::Object{{"kind", json_text(std::string(word_of(c.kind)))},
                           {"near", json_text(std::string(word_of(c.near)))},
                           {"on_leaf", json_truth(c.on_leaf)},
                           {"liouville", json_truth(c.liouville)},
                           {"functions", json_texts(c.functions)},
                           {"without", json_texts(c.without)},
                           {"through", json_texts(symbols)},
                           {"frame", json_text(c.frame)}}};
}

long total_degree(const MPoly& f) {
  long most = 0;
  for (long t = 0; t < f.length(); ++t) {
    const auto e = f.exponents(t);
    most = std::max(most, std::accumulate(e.begin(), e.end(), 0L));
  }
  return most;
}

const NodeResult& cover_of_all(const TheoremResult& t) {
  const NodeResult& root = t.nodes.front();
  if (root.node.kind != NodeKind::cover || !root.node.place.at.empty() ||
      !root.node.place.conditions.empty())
    throw DomainError("the first step is not a cover of all parameters");
  return root;
}

StrataParts::StrataParts(const TheoremResult& t, std::string directory, const Budget& budget)
    : theorem(t), directory(std::move(directory)), budget(budget),
      family(families.emplace_back(system_in_bundle(t.theorem, this->directory), t.theorem.system)),
      proof(family.proof(budget)) {}

StrataParts::StrataParts(const StrataParts& of, const System& s, const std::string& name)
    : theorem(of.theorem), directory(of.directory), budget(of.budget),
      family(families.emplace_back(s, name)), proof(family.proof(budget)) {}

void StrataParts::take(StrataParts& other) {
  std::ranges::move(other.steps, std::back_inserter(steps));
  other.steps.clear();
  for (auto f = other.families.begin(); f != other.families.end();) {
    const auto one = f++;
    if (std::ranges::find(families, one->name(), &BundleFamily::name) == families.end())
      families.splice(families.end(), other.families, one);
  }
}

void StrataParts::put_step(const std::string& id, const char* rule, Json::Object members,
                           Json::Object more) {
  Json::Object step{{"id", json_text(id)}, {"rule", json_text(rule)}};
  std::ranges::move(members, std::back_inserter(step));
  std::ranges::move(more, std::back_inserter(step));
  steps.push_back(Json{std::move(step)});
}

void StrataParts::put_place(const std::string& id, const std::string& of, const BundleFamily& x,
                            const PartPlace& there, const PlaceMap& map, const certify::Target& y) {
  put_step(id, "place",
           {{"of", json_text(of)},
            {"system", json_text(x.name())},
            {"at", there.values},
            {"region", json_conditions(there.region)}},
           map_members(x, there, map, y, budget));
}

void StrataParts::put_cover(const std::string& id, const std::vector<Json::Object>& symmetries,
                            Json tree) {
  std::vector<std::string> words;
  for (const Json::Object& step : symmetries) {
    words.push_back("symmetry-" + std::to_string(words.size() + 1));
    put_step(words.back(), "symmetry", step);
  }
  put_step(id, "cover",
           {{"system", json_text(family.name())},
            {"symmetries", json_texts(words)},
            {"parts", json_texts(parts)},
            {"tree", std::move(tree)}});
}

std::string StrataParts::text(Json (BundleFamily::*json)()) {
  auto systems = mapped<Json>(families, json);
  return certify::to_string(Json{Json::Object{{"format", json_text("kovacic-theorem/1")},
                                              {"title", json_text(theorem.theorem.title)},
                                              {"systems", json_list(std::move(systems))},
                                              {"steps", json_list(std::move(steps))}}});
}

// Equations that are linear in a parameter, with a number before it, are solved.
PartPlace StrataParts::solved(const Assumptions& r) const {
  Substitution put;
  std::vector<Condition> region = family.moved(r.conditions);
  for (std::size_t k = 0; k < region.size();) {
    const MFraction there = substitute(region[k].p, put);
    const auto i = is_zero(there) || region[k].sign != Sign::zero ? std::nullopt
                                                                  : linear_parameter(there.num());
    if (!i) {
      ++k;
      continue;
    }
    put_in(put, *i, there.num());
    region.erase(region.begin() + static_cast<long>(k));
    k = 0;
  }
  return family.placed(put, std::move(region));
}
// f = 0 is solved for parameter i.
void StrataParts::put_in(Substitution& put, std::size_t i, const MPoly& f) {
  const auto line = coefficients(f, i);
  const MFraction value = -MFraction(line[0]) / MFraction(line[1]);
  for (auto& [j, known] : put)
    known = substitute(known, Substitution{{i, value}});
  put[i] = value;
}
PartPlace StrataParts::place_of(const NodeResult& n) const {
  const Place& p = n.node.place;
  if (!p.as.empty() || !p.roots.empty() || !p.of.empty() || !p.time.empty())
    throw DomainError("a change of variables beside strata");
  return family.placed(p, system_of(theorem.theorem, directory, p.at));
}

void StrataParts::add_region(const std::string& id, std::vector<Condition> conditions,
                             bool excludes) {
  const RegionOfPart r{parts.size(), std::nullopt, std::move(conditions)};
  if (excludes) excluded.push_back(r);
  regions.push_back(r);
  parts.push_back(id);
}

bool StrataParts::is_covered(const std::vector<Condition>& region,
                             const std::vector<RegionOfPart>& by) const {
  Budget little = budget;
  constexpr double most_work = 1e8;
  if (!little.work_end || meter() + most_work < *little.work_end) little.give(most_work);
  try {
    return tree_of_regions(family.proof(little), family.known_where(region), by, little)
        .has_value();
  } catch (const OutOfBudget&) {
    budget.check();
    return false;
  }
}

} // namespace kov
