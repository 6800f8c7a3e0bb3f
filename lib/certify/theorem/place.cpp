// The fact of another system, carried over by a map, and the maps from a family to itself:
// theorem_certificates.md 4, 12.

#include "certify/equation/facts.hpp"
#include "certify/theorem/rules.hpp"

namespace kov::certify {

namespace {

// The fact at X.
Said carried_fact(const TheoremFact& of, const Map& map, const StepPlace& here) {
  Said f{of.kind, here.family, {here.conditions()}};
  for (const IntegralClass& c : of.classes)
    f.classes.push_back(map.carried(c));
  f.integrals = of.integrals;
  f.way = of.way;
  return f;
}

Said place_by_values(Keys& step, Derivation& d) {
  const StepPlace here = d.place(step, d.plain_family(step));
  const TheoremFact& of = d.proved(step.at("of"));
  need_kind(of.kind == FactKind::not_integrable || of.kind == FactKind::integrals);
  need(!of.only_stratum && (!of.family || of.family->is_plain()), "another class");
  const Target y =
      of.target ? *of.target
                : target_of(*of.family, of.regions.front(), of.kind == FactKind::not_integrable);
  const Map map(here, y, step, d.arithmetic(), d.nodes());
  Said f = carried_fact(of, map, here);
  // the system has no functions: their values choose nothing
  f.way.insert(f.way.end(), of.there.text.begin(), of.there.text.end());
  for (std::string& text : map.shown())
    f.way.push_back(std::move(text));
  f.shows_way = of.shows_way;
  return f;
}

Said place_by_names(Keys& step, Derivation& d) {
  const StepPlace here = d.place(step, d.family(step));
  const TheoremFact& of = d.proved(step.at("of"));
  need_kind(of.kind == FactKind::not_integrable && of.target.has_value());
  const LevelValues levels = read_levels(here, step.find("levels"));
  const Map map(here, *of.target, levels, step.at("shown"), d.arithmetic(), d.nodes());
  Said f = carried_fact(of, map, here);
  if (!levels.empty()) f.way.push_back(shown_levels(levels));
  f.there = with_levels(of.there, *of.system, here.family->system);
  f.shows_way = true;
  return f;
}

} // namespace

Said rule::place(Keys& step, Derivation& d) {
  return step.find("values") ? place_by_values(step, d) : place_by_names(step, d);
}

Said rule::symmetry(Keys& step, Derivation& d) {
  const Family& x = d.plain_family(step);
  const StepPlace here = d.place_if_told(step, x);
  const bool any = !step.at("adjoined").items().empty();
  auto map = std::make_shared<Map>(here, target_of(x, {}, any), step, d.arithmetic(), d.nodes());
  need(!map->moves_origin(), "the origin moves");
  for (std::size_t i = x.system.first_parameter(); i < x.system.ring->size(); ++i)
    need(map->parameter(i).n == Integer(1), "a number below");
  Said f{FactKind::symmetry, &x, {here.conditions()}};
  f.map = std::move(map);
  return f;
}

} // namespace kov::certify
