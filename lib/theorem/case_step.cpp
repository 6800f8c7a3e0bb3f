// The step "case": the verdict of a system file.

#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "integrability/conclude.hpp"
#include "integrability/parameters.hpp"
#include "study/headline_words.hpp"
#include "study/study.hpp"
#include "theorem/bundle_place.hpp"
#include "theorem/material.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"

#include "decide/words.hpp"
#include "exact/error.hpp"
#include "strata/certificate.hpp"
#include "strata/words.hpp"
#include "symbol/author_words.hpp"

#include <algorithm>

namespace kov {
namespace {

// One level that is not abelian is enough: then other strata may be anything.
std::string reason_of(const strata::StrataAnswer& a) {
  if (a.abelian() == Truth::no)
    return "not abelian on every stratum of the parameters (" + std::to_string(a.strata.size()) +
           ")";
  for (const strata::Stratum& s : a.strata)
    if (s.leaf.abelian == Truth::no)
      return "not abelian where " + to_string(s.conditions) +
             ", and there are such levels: " + strata::reason(s.leaf);
  return "";
}

std::string reason_of(const ManifoldReport& m) {
  std::string text;
  for (const BlockReport& b : m.blocks) {
    if (b.decision) return reason(*b.decision);
    if (b.strata && b.abelian == Truth::no) return reason_of(*b.strata);
    for (const EnergyResult& e : b.energies)
      if (e.decision && e.decision->abelian == Truth::no)
        return sentence(e.at) + ": " + reason(*e.decision);
    for (const EnergyResult& e : b.energies)
      if (e.strata && e.strata->abelian() == Truth::no)
        return "at the energy " + sentence(e.at) +
               " not abelian on every stratum of the other parameters";
    if (!b.missing.empty()) text = note(b.missing);
  }
  for (const std::string& r : reasons(m))
    if (text.empty()) text = r;
  return text;
}

} // namespace

namespace {

using study::CurveStudy;
using study::SystemStudy;

SystemStudy studied(const Entry& document, const ParameterValues& where, const NodeResult& n,
                    const ProveOptions& options) {
  study::StudyOptions how;
  how.check.decide = options.decide;
  how.check.decide.want_certificate = true;
  how.check.only_manifold = n.node.manifold;
  how.order = n.node.order;
  if (!n.node.found.along.empty()) how.along = n.node.found.along.front();
  auto names = mapped<std::string>(read_system(document, where).manifolds, &ManifoldSpec::name);
  if (!n.node.manifold.empty()) require_known(n.node.manifold, names, "manifold");
  return study::study(document, where, how);
}

std::string found(const CurveStudy& m) {
  if (m.first.failure) return to_string(m.headline.verdict) + ": " + m.first.failure->message;
  const std::string reason =
      m.higher && m.higher->excluded ? m.higher->excluded->by.reason : reason_of(m.first);
  return to_string(m.headline.verdict) + (reason.empty() ? "" : ": " + reason);
}

bool expected(const TheoremNode& node, Verdict v) {
  return node.expect == "any" ? v != Verdict::undecided && v != Verdict::failed
                              : to_string(v) == node.expect;
}

// Found, but not what the file says.
void unexpected(NodeResult& n, Verdict v) {
  if (v != Verdict::undecided && v != Verdict::failed)
    n.summary = "expected " + n.node.expect + ", found " + n.summary;
  if (v == Verdict::non_integrable) n.status = NodeStatus::refuted;
}

// "NON-INTEGRABLE (Morales-Ramis, along the manifold N)"
std::string headline_by(study::HeadlineWords words, const std::string& by) {
  words.because = by;
  return one_line(words);
}

// Not integrable with these first integrals, by what excludes them.
void exclude(NodeResult& n, const System& s, std::vector<IntegralClass> classes,
             const std::string& by) {
  n.says = Conclusion::not_integrable;
  n.excluded = std::move(classes);
  n.headline = headline_by(study::in_words(Verdict::non_integrable, true), by);
  n.statement = assumptions_of(s) + "The " + titled(s) + " is not integrable with " +
                first_integrals(n.excluded) + " (" + by + ")";
}

// The conclusion of several manifolds together, or of several orders: each set by one of them.
void conclude_together(NodeResult& n, const System& s, const SystemClassification& c,
                       const std::string& along) {
  exclude(n, s, c.excluded, along);
  n.curve = along;
  n.trusted.insert(n.trusted.end(), c.trusted.begin(), c.trusted.end());
  for (const LiteratureTheorem* t : c.theorems)
    n.theorems.push_back(used(*t));
}

// The obstruction of a higher order.
void conclude_higher(NodeResult& n, const System& s, const CurveStudy& m) {
  const ExclusionReason& by = m.higher->excluded->by;
  const std::string theorem =
      by.theorems.front()->name + ", along the manifold " + name_in_words(m.name());
  const std::string along = " (" + theorem + ")";
  const std::string except = m.higher->exceptions.empty() ? "" : ", " + exceptions(*m.higher);
  n.theorems.push_back(used(morales_ramis_simo()));
  n.theorems.back().integrals = by.integrals;
  if (!by.unchecked.empty())
    n.theorems.back().hypotheses.push_back({by.unchecked, Settled::open, ""});
  n.trusted.insert(n.trusted.end(), by.trusted.begin(), by.trusted.end());
  n.headline = headline_by(study::in_words(m), theorem);
  n.statement = assumptions_of(s) + "The " + titled(s) + " is " + statement(by) +
                (by.level.empty() ? "" : ", " + sentence(by.level)) + except + along +
                (except.empty() ? "" : ". In the exceptions nothing follows about integrability");
  if (!except.empty()) return;
  n.says = Conclusion::not_integrable;
  n.excluded = {by.integrals};
  n.curve = name_in_words(m.name());
}

// The conclusion, in words and as the headline of a report.
void conclude(NodeResult& n, const System& s, const CurveStudy& all_orders) {
  const ManifoldReport& m = all_orders.first;
  if (!m.by) return; // a limit came before the theorem
  if (all_orders.together)
    return conclude_together(n, s, *all_orders.together,
                             "along the manifold " + name_in_words(m.name) + ", set by set");
  if (all_orders.higher && all_orders.higher->excluded) return conclude_higher(n, s, all_orders);
  const std::string subject = assumptions_of(s) + "The " + titled(s) + " is ";
  const std::string theorem = m.by->id() + ", along the manifold " + name_in_words(m.name);
  const std::string by = " (" + theorem + ")";
  n.headline = headline_by(study::in_words(m), theorem);
  add_each_once(n.trusted, trusted_steps(m));
  n.theorems.push_back(*m.by);
  if (m.verdict == Verdict::non_integrable) {
    n.says = Conclusion::not_integrable;
    n.excluded = {m.by->integrals};
    n.curve = name_in_words(m.name);
    if (!m.by->integrals.without.empty() && !n.node.place.as.empty()) // they name coordinates
      n.excluded.front().frame = "of " + n.node.file;
    n.statement = subject + statement(m) + by;
    if (m.by->integrals.near != IntegralClass::Near::curve || !m.by->integrals.without.empty())
      n.summary += "; for first integrals that are " + sentence(m.by->integrals);
  } else if (m.verdict == Verdict::no_obstruction) {
    n.headline += ": nothing follows about integrability";
    n.statement = subject + "not obstructed by the first variational equation" + by +
                  ": nothing follows about integrability";
    n.summary += " (the test passes; nothing follows about integrability)";
  } else {
    const std::string except = exceptions(m);
    if (except.empty())
      throw DomainError("the parameters where the system is not integrable could not be named");
    n.statement = subject + "not integrable with first integrals that are " +
                  sentence(m.by->integrals) + ", " + except + by +
                  ". In the exceptions nothing follows about integrability";
  }
}

int weight(const CurveStudy& m) {
  switch (m.headline.verdict) {
  case Verdict::non_integrable:
    return 3;
  case Verdict::undecided:
  case Verdict::failed:
    return 2;
  case Verdict::depends:
    return 1;
  default:
    return 0;
  }
}

// Not integrable along one manifold is not integrable; otherwise all of them have to be decided.
const CurveStudy& that_decides(const SystemStudy& study) {
  return *std::ranges::max_element(study.manifolds, [](const CurveStudy& a, const CurveStudy& b) {
    return weight(a) < weight(b);
  });
}

// The manifold that decides, with its material; or all of them.
void take(NodeResult& n, const SystemStudy& study) {
  const CurveStudy& m = that_decides(study);
  const Verdict verdict = study.headline.verdict;
  n.found = study.headline;
  const bool by_several =
      verdict == Verdict::non_integrable && m.headline.verdict != Verdict::non_integrable;
  for (const CurveStudy& other : study.manifolds) {
    if (&other != &m) n.formulas.push_back({"manifold " + other.name(), found(other)});
    if (by_several && !other.first.failure)
      show_curve(n, study.system, other, certificates(study.system, other));
  }
  n.summary = by_several ? to_string(verdict) + ": " + statement(*study.together) : found(m);
  if (m.first.failure && !by_several) {
    n.summary = m.first.failure->message;
    return;
  }
  if (!by_several) show_curve(n, study.system, m, certificates(study.system, m));
  if (!expected(n.node, verdict)) return unexpected(n, verdict);
  n.status = NodeStatus::proved;
  if (by_several)
    conclude_together(n, study.system, *study.together, "by all its manifolds together");
  else
    conclude(n, study.system, m);
}

// Material of the sample, marked as such.
void move_material(NodeResult& n, NodeResult& sample) {
  for (Grid& g : sample.tables) {
    g.caption += ", at the sample";
    n.tables.push_back(std::move(g));
  }
  for (PolePicture& p : sample.pictures) {
    p.caption += ", at the sample";
    n.pictures.push_back(std::move(p));
  }
  for (std::string& c : sample.certificates)
    n.certificates.push_back(std::move(c));
}

// "Not integrable" may rest on one level that was chosen: a sample of a level is not a counterexample.
bool names_a_level(const System& s, const ParameterValues& sample) {
  const auto levels = level_parameters(s);
  return std::ranges::any_of(sample, [&](const auto& value) {
    const auto i = s.ring()->find(value.first);
    return i && is_among(*i, levels);
  });
}

// Compares the verdict at the sample with the verdict for the family.
void compare(NodeResult& n, const SystemStudy& family, const CurveStudy& there,
             const std::string& text) {
  const Verdict whole = family.headline.verdict, here = there.headline.verdict;
  n.formulas.push_back({"the sample by itself", found(there)});
  if (n.status != NodeStatus::proved) return;
  if (here == Verdict::undecided) {
    n.caution = "THE SAMPLE " + text + " BY ITSELF IS UNDECIDED";
    n.summary += "; " + n.caution;
    return;
  }
  const bool same = here == whole;
  if (whole == Verdict::depends) return; // both answers occur
  if (!same && names_a_level(family.system, n.node.sample)) {
    n.summary += "; at the level of the sample " + text + ": " + to_string(here);
    return;
  }
  n.checks.push_back({"the sample " + text + " by itself has the same verdict", same});
  if (same) return;
  n.status = NodeStatus::refuted;
  n.summary = "CONTRADICTION: for all parameters " + to_string(whole) + ", but at the sample " +
              text + " " + found(there);
}

// One set of values from the family, decided by itself: a second opinion with tables.
void take_sample(NodeResult& n, const SystemStudy& family, const Entry& document,
                 const ProveOptions& options) {
  const std::string text =
      joined(n.node.sample, [](const auto& v) { return v.first + " = " + v.second; });
  n.formulas.push_back({"a sample", text});
  ParameterValues values = n.node.where;
  values.insert(values.end(), n.node.sample.begin(), n.node.sample.end());
  NodeResult sample;
  sample.node = n.node;
  sample.node.manifold = that_decides(family).name();
  const SystemStudy study = studied(document, values, sample, options);
  take(sample, study);
  move_material(n, sample);
  compare(n, family, study.manifolds.front(), text);
}

void prove_by_file(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  const Entry document = document_of(n.node, directory);
  const SystemStudy study = studied(document, n.node.where, n, options);
  show_setting(n, study.system);
  if (study.manifolds.empty()) throw DomainError(n.node.file + " has no manifold");
  take(n, study);
  if (!n.node.sample.empty()) take_sample(n, study, document, options);
}

// The studies that the search has kept are written down, and nothing is found again.
void take_found(NodeResult& n) {
  const TheoremNode& node = n.node;
  for (const auto& one : node.found.studies) {
    show_curve(n, one->system(), one->curve(), one->certificates());
    if (one->curve().first.by)
      n.theorems.push_back(*one->curve().first.by);
    else
      n.theorems.push_back(used(morales_ramis_simo()));
  }
  n.status = NodeStatus::proved;
  n.summary = node.step;
  const study::Evidence& first = *node.found.studies.front();
  n.curve = name_in_words(first.curve().name());
  exclude(n, first.system(), {node.integrals},
          n.theorems.front().id() + ", along the manifold " + n.curve);
}

// The curves of other parameters, moved: if the certificate has these, symmetries carry it over.
void take_carried(NodeResult& n) {
  n.status = NodeStatus::proved;
  n.says = Conclusion::not_integrable;
  n.excluded = {n.node.integrals};
  n.trusted = {{Trusted::Step::gap,
                n.node.step + " (moved by a symmetry)"}}; // the certificate's own replace it
  n.summary = n.node.step;
  n.statement =
      "The system is not integrable with " + first_integrals(n.excluded) + " (" + n.node.step + ")";
}

} // namespace

void study_curves(TheoremNode& node, const std::string& directory, const ProveOptions& options) {
  NodeResult n;
  n.node = node;
  const SystemStudy all = studied(document_of(node, directory), {}, n, options);
  for (const CurveStudy& m : all.manifolds)
    node.found.special.push_back(std::make_shared<const study::Evidence>(all.system, m));
}

void study_again(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  NodeResult fresh;
  fresh.node = n.node;
  fresh.node.found.studies.clear();
  fresh.node.found.carried = false;
  fresh.node.found.change.reset();
  prove_case(fresh, directory, options);
  fresh.region = std::move(n.region);
  n = std::move(fresh);
}

void prove_case(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  if (!n.node.found.studies.empty()) return take_found(n);
  if (n.node.found.carried) return take_carried(n);
  prove_or_trust(n, options, [&](NodeResult& x) { prove_by_file(x, directory, options); });
}

} // namespace kov
