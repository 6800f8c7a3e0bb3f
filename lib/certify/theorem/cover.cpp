// The last step of a theorem, which puts the others together, and the steps that it takes on trust or leaves
// open: theorem_certificates.md 8, 14, 15.

#include "certify/equation/facts.hpp"
#include "certify/theorem/rules.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr std::size_t max_word = 40, max_step_text = 4000;

// Integrals of a class are of each one that contains it: that one is not named beside it.
void add_least(const IntegralClass& c, std::vector<IntegralClass>& all) {
  const auto is_part = [](const IntegralClass& inner, const IntegralClass& outer) {
    return inner == outer || (inner.through.empty() && contains(outer, inner) == Truth::yes);
  };
  if (std::ranges::any_of(all, [&](const auto& known) { return is_part(known, c); })) return;
  std::erase_if(all, [&](const auto& known) { return is_part(c, known); });
  all.push_back(c);
}

// The points here lie in a part, by what is shown of each of its conditions, with the symmetries put in.
void need_in_part(const Node& n, ConditionSet& given, Derivation& d) {
  Keys k(n);
  if (k.at("node").text() != "part") n.fail("an unknown node");
  const TheoremFact& f = *d.parts[read_index(k.at("part"), d.parts.size(), "no such part")];
  const auto word = k.at("word").items(), shown = k.at("shown").items();
  need(word.size() <= max_word, "no such part");
  Conditions region =
      f.regions[f.several ? read_index(k.at("region"), f.regions.size(), "no such region") : 0];
  for (const Node& w : word) {
    const TheoremFact& s = *d.symmetries[read_index(w, d.symmetries.size(), "no such symmetry")];
    d.led.insert(&f);
    for (const IntegralClass& c : f.classes)
      static_cast<void>(s.map->carried(c));
    region = s.map->before(region);
    region.insert(region.end(), s.regions.front().begin(), s.regions.front().end());
  }
  if (shown.size() != region.size()) n.fail("each condition of the part must be shown");
  SetProof proof(given, d.nodes());
  for (std::size_t i = 0; i < shown.size(); ++i)
    proof.show(region[i], shown[i]);
  k.done();
}

Said said_in_regions(Keys& step, FactKind kind, Derivation& d) {
  Said f{kind, &d.family(step), {}};
  f.several = true;
  for (const Node& n : step.at("regions").items())
    f.regions.push_back(f.family->region(n));
  if (f.regions.empty()) step.at("regions").fail("a region is expected");
  return f;
}

} // namespace

Said rule::cover(Keys& step, Derivation& d) {
  const Family& x = d.family(step);
  const auto about_x = [&](const Node& n) {
    const TheoremFact& f = d.fact(n);
    need(f.family == &x, "a step is about another system");
    return &f;
  };
  for (const Node& n : step.at("symmetries").items()) {
    d.symmetries.push_back(about_x(n));
    need_kind(d.symmetries.back()->kind == FactKind::symmetry);
  }
  Said all{FactKind::not_integrable, &x, {{}}};
  for (const Node& n : step.at("parts").items()) {
    const TheoremFact* f = d.parts.emplace_back(about_x(n));
    need_kind(f->kind != FactKind::symmetry && f->kind != FactKind::leaves);
    for (const IntegralClass& c : f->classes)
      add_least(c, all.classes);
  }
  need(!all.classes.empty() ||
           std::ranges::any_of(d.parts,
                               [](const auto* f) { return f->kind == FactKind::integrable; }),
       "nothing says that it is not integrable");
  ConditionSet given = x.where(x.assumptions, d.arithmetic());
  SetProof(given, d.nodes()).absent(step.at("tree"), [&](const Node& n, ConditionSet& here) {
    need_in_part(n, here, d);
  });
  return all;
}

Said rule::trusted(Keys& step, Derivation& d) {
  const Node says = step.at("says");
  const bool is_integrable = says.text() == "integrable";
  if (!is_integrable && says.text() != "not integrable")
    says.fail("a trusted step says something else");
  Said f =
      said_in_regions(step, is_integrable ? FactKind::integrable : FactKind::not_integrable, d);
  f.trusted = step.at("step").text();
  if (f.trusted.empty() || f.trusted.size() > max_step_text)
    step.at("step").fail("the name of the step is expected");
  f.trusts.insert({d.id(), f.trusted});
  if (!is_integrable) f.classes = {read_class(step.at("class"))};
  return f;
}

Said rule::open(Keys& step, Derivation& d) { return said_in_regions(step, FactKind::open, d); }

} // namespace kov::certify
