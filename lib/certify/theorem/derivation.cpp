#include "certify/theorem/derivation.hpp"

#include "certify/equation/facts.hpp"
#include "certify/theorem/rules.hpp"
#include "exact/joined.hpp"
#include "proof/text/checked.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// A function of the parameters that are not put in.
PhaseFunction read_function(const Family& x, const Node& n, const ParameterFunctions& at) {
  PhaseFunction f = read_function(x, n);
  if (!is_in(f.p, x.parameters(at))) n.fail("a function of the other parameters is expected");
  return f;
}

ParameterFunctions read_at(const Family& x, const Node& n) {
  ParameterFunctions at;
  for (const Node& row : n.items()) {
    const auto pair = row.items(2, "a parameter and its value are expected");
    const auto i = x.system.ring->find(pair[0].text());
    if (!i || !x.is_parameter(*i)) row.fail("a parameter is expected");
    need(at.emplace(*i, PhaseFunction{}).second, "a parameter is put twice");
  }
  for (const Node& row : n.items())
    at[x.system.ring->index(row.items()[0].text())] = read_function(x, row.items()[1], at);
  return at;
}

} // namespace

void Derivation::put_family(const Node& n) {
  Arithmetic a;
  auto f = std::make_unique<Family>(read_family(n, a));
  for (const auto& g : families_)
    if (g->name == f->name) n.fail("a system occurs twice");
  families_.push_back(std::move(f));
}

void Derivation::put_step(const Node& n, bool is_last) {
  Keys k(n);
  id_ = k.at("id").text();
  const std::string name = k.at("rule").text();
  need(!facts_.has(id_), "the id occurs twice");
  need((name == "cover") == is_last, "the last step is a cover, and no other");
  const auto rule = std::ranges::find(rules, name, &TheoremRule::name);
  need(rule != rules.end(), "an unknown rule");
  arithmetic_ = Arithmetic();
  Said f = rule->said(k, *this);
  k.done();
  std::vector<std::string> of = facts_.premises();
  last_ = &facts_.derive(id_, std::move(f));
  if (CheckedSteps::wanted())
    CheckedSteps::add({"kovacic-theorem/1", "rule", name, id_, std::move(of), shown(*last_)});
}

void Derivation::need_all_used(const std::vector<Node>& steps) const {
  for (std::size_t i = 0; i + 1 < steps.size(); ++i)
    need(facts_.is_named(Keys(steps[i]).at("id").text()), "a step is not used");
}

const Family& Derivation::family(Keys& step) const {
  const std::string name = step.at("system").text();
  const auto found =
      std::ranges::find_if(families_, [&](const auto& f) { return f->name == name; });
  need(found != families_.end(), "there is no such system");
  return **found;
}

const Family& Derivation::plain_family(Keys& step) const {
  const Family& f = family(step);
  need(f.is_plain(), "a Hamiltonian system with real parameters is expected");
  return f;
}

StepPlace Derivation::place(Keys& step, const Family& x) const {
  return {&x, read_at(x, step.at("at")), x.region(step.at("region"))};
}

StepPlace Derivation::place_if_told(Keys& step, const Family& x) const {
  const auto at = step.find("at"), region = step.find("region");
  return {&x, at ? read_at(x, *at) : ParameterFunctions{},
          region ? x.region(*region) : Conditions{}};
}

const TheoremFact& Derivation::proved(const Node& id) {
  const TheoremFact& f = fact(id);
  need(f.trusts.empty() && !f.several, "what is on trust is named by the cover only");
  return f;
}

std::size_t read_index(const Node& n, std::size_t size, const char* why) {
  const long i = n.count();
  need(i >= 0 && static_cast<std::size_t>(i) < size, why);
  return static_cast<std::size_t>(i);
}

std::size_t read_coordinate(const PhaseSystem& s, const Node& n) {
  const auto i = s.ring->find(n.text());
  need(i && *i < s.dimension, "a coordinate is expected");
  return *i;
}

void show_value(Keys& k, const StepPlace& x, const MPoly& computed, Sign sign, SetProof& proof,
                const char* why) {
  const MPoly value = read_poly(x.family->system.ring, k.at("value"), x.family->parameters());
  need(is_multiple(value, computed), why);
  proof.show({value, sign}, k.at("by"));
}

PhaseFunction read_function(const Family& y, const Node& n) {
  return read_phase_function(y.system.ring, n);
}

LevelValues read_levels(const StepPlace& here, const std::optional<Node>& n) {
  LevelValues levels;
  if (!n) return levels;
  for (const Node& row : n->items()) {
    const auto pair = row.items(2, "a level and its value are expected");
    const PhaseFunction f = read_function(*here.family, pair[1], here.at);
    need(levels.emplace(pair[0].text(), f).second, "a level is put twice");
  }
  return levels;
}

std::string shown_levels(const LevelValues& levels) {
  std::vector<std::string> said;
  for (const auto& [name, value] : levels)
    said.push_back(name + " = " + to_string(value));
  return "at " + joined(said);
}

FunctionsThere with_levels(FunctionsThere there, const PhaseSystem& y, const PhaseSystem& x) {
  std::vector<std::string> levels;
  for (std::size_t j = y.first_parameter(); j < y.ring->size(); ++j)
    if (const std::string& name = y.ring->name(j);
        there.names.contains(name) && !x.ring->find(name))
      levels.push_back(name);
  for (std::string& text : there.text)
    text += levels.empty() ? "" : ", for some value of " + joined(levels);
  return there;
}

} // namespace kov::certify
