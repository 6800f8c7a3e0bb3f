#include "study/proof_tree.hpp"

#include "exact/lists.hpp"

#include <algorithm>

namespace kov::study {
namespace {

void collect(const ProofTree& t, StepId id, Support& all) {
  const Step& s = t.steps.at(id);
  all.trusted.insert(s.trusted.begin(), s.trusted.end());
  all.unchecked.insert(s.unchecked.begin(), s.unchecked.end());
  for (const StepId premise : s.premises)
    collect(t, premise, all);
}

void count(const Support& all, Headline& h) {
  h.trusted = all.trusted.size();
  h.unchecked = all.unchecked.size();
}

Headline of_excluded(const ProofTree& t, StepId id, const Excluded& x) {
  Headline h;
  h.verdict = x.everywhere ? Verdict::non_integrable : Verdict::depends;
  h.excluded = x.integrals;
  count(support(t, id), h);
  return h;
}

// The steps about one curve, if none of them is enough.
Headline in_parts(const ProofTree& t, const std::string& curve) {
  Headline h;
  Support all;
  bool passes = false, elsewhere = false;
  std::vector<IntegralClass> classes;
  for (StepId id = 0; id < t.steps.size(); ++id) {
    const Step& s = t.steps[id];
    if (s.curve != curve || s.rule == Rule::cover) continue;
    collect(t, id, all);
    if (const auto* x = std::get_if<Excluded>(&s.says))
      classes.insert(classes.end(), x->integrals.begin(), x->integrals.end());
    if (const auto* x = std::get_if<Passes>(&s.says)) {
      passes = true;
      elsewhere = elsewhere || x->elsewhere;
    }
  }
  h.excluded = at_once(classes);
  count(all, h);
  if (passes)
    h.verdict = elsewhere || !classes.empty() ? Verdict::depends : Verdict::no_obstruction;
  return h;
}

} // namespace

Headline headline(const SystemClassification& c) {
  Support all;
  all.trusted.insert(c.trusted.begin(), c.trusted.end());
  Headline h;
  for (const ClassifiedStratum& x : c.strata)
    for (const ExclusionReason& by : x.by) {
      h.excluded.push_back(by.integrals);
      all.trusted.insert(by.trusted.begin(), by.trusted.end());
      if (!by.unchecked.empty()) all.unchecked.insert(by.unchecked);
    }
  h.excluded = at_once(h.excluded);
  h.verdict = c.status();
  h.complete = c.complete;
  count(all, h);
  return h;
}

Support support(const ProofTree& t, StepId step) {
  Support all;
  collect(t, step, all);
  return all;
}

Headline headline(const ProofTree& t, const std::string& curve) {
  std::vector<Headline> enough;
  for (StepId id = 0; id < t.steps.size(); ++id)
    if (const auto* x = std::get_if<Excluded>(&t.steps[id].says))
      if (t.steps[id].curve == curve && x->everywhere) enough.push_back(of_excluded(t, id, *x));
  Headline h = enough.empty() ? in_parts(t, curve) : headline(enough);
  if (is_among(curve, t.refused)) {
    h.verdict = Verdict::failed;
    h.refused = 1;
  }
  h.complete = !is_among(curve, t.cut_short);
  return h;
}

Headline headline(const ProofTree& t) {
  std::vector<Headline> each;
  for (const std::string& curve : t.curves)
    each.push_back(headline(t, curve));
  std::optional<Headline> common;
  for (StepId id = 0; id < t.steps.size(); ++id)
    if (const auto* x = std::get_if<Excluded>(&t.steps[id].says))
      if (t.steps[id].curve.empty() && t.steps[id].rule == Rule::cover)
        common = of_excluded(t, id, *x);
  Headline whole = headline(each, common ? &*common : nullptr);
  whole.complete = whole.complete && !is_among("", t.cut_short);
  return whole;
}

void refuse_contradictions(const System& s, const ProofTree& t) {
  for (const Step& a : t.steps)
    if (const auto* known = std::get_if<Integrable>(&a.says))
      for (const Step& b : t.steps)
        if (const auto* x = std::get_if<Excluded>(&b.says); x != nullptr && x->set)
          refuse_contradiction(s, x->set->by, known->integrals, known->where, *x->set);
}

} // namespace kov::study
