// The step "case": the verdict of a system file.

#include "integrability/conclude.hpp"
#include "integrability/parameters.hpp"
#include "linode/singularities.hpp"
#include "study/study.hpp"
#include "theorem/bundle_place.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"

#include "decide/words.hpp"
#include "exact/algebraic.hpp"
#include "exact/error.hpp"
#include "strata/certificate.hpp"
#include "strata/words.hpp"
#include "symbol/author_words.hpp"

#include <algorithm>

namespace kov {
namespace {

std::string difference(const Singularity& s, const std::string& z) {
  if (s.kind == PlaceKind::ramified) return "irregular, ramified";
  if (s.kind == PlaceKind::irregular) return "irregular";
  if (s.delta) return to_string(*s.delta);
  return "sqrt(" + to_string(RationalFunction(s.delta_squared), z) + ")";
}

std::vector<std::string> row_of(const Singularity& s, const std::string& z) {
  const std::string place =
      s.at_infinity ? "infinity" : to_string(RationalFunction(s.place), z) + " = 0";
  return {place, std::to_string(s.order), difference(s, z),
          s.log == Truth::yes  ? "yes"
          : s.log == Truth::no ? "no"
                               : "not asked"};
}

// The roots of the places, as numbers for the eye.
PolePicture picture_of(const Singularities& all, const std::string& z, const std::string& where) {
  PolePicture picture{"Singular points of r in the " + z + "-plane" + where +
                          "; at each the exponent difference, filled: a logarithm",
                      "Re " + z,
                      "Im " + z,
                      {},
                      false};
  for (const Singularity& s : all.finite) {
    if (!s.place.field()->is_rational() || s.degree() > 24) continue;
    std::vector<Integer> c;
    Integer common(1);
    for (long i = 0; i <= s.degree(); ++i)
      common = lcm(common, to_rational(s.place.coeff(i)).den());
    for (long i = 0; i <= s.degree(); ++i)
      c.push_back((to_rational(s.place.coeff(i)) * Rational(common)).num());
    for (const QQbar& root : roots(c)) {
      const ComplexBall x = enclosure(root, 64);
      Ball re, im;
      acb_get_real(re.raw(), x.raw());
      acb_get_imag(im.raw(), x.raw());
      picture.points.push_back(
          {lower_bound(re), lower_bound(im), difference(s, z), s.log == Truth::yes});
    }
  }
  return picture;
}

void show_decision(NodeResult& n, const Decision& d, const std::string& where = {}) {
  if (is_zero(d.r)) return;
  const Singularities s = singularities(d.r);
  Grid exponents{"Exponent differences" + where, {"place", "order", "difference", "logarithm"}, {}};
  for (const Singularity& one : s.finite)
    exponents.rows.push_back(row_of(one, d.variable));
  exponents.rows.push_back(row_of(s.infinity, d.variable));
  n.tables.push_back(std::move(exponents));
  n.pictures.push_back(picture_of(s, d.variable, where));
  n.formulas.push_back({"group", d.group ? describe(*d.group) : "not determined"});
}

std::string answer(Truth abelian) {
  return abelian == Truth::yes ? "abelian" : abelian == Truth::no ? "not abelian" : "undecided";
}

void show_strata(NodeResult& n, const strata::StrataAnswer& a, const std::string& where = {}) {
  Grid grid{"Strata of the parameters" + where + ", with the identity component of the group",
            {"stratum", "group", "identity component", "because"},
            {}};
  for (const strata::Stratum& s : a.strata)
    grid.rows.push_back({to_string(s.conditions), strata::group_text(s.leaf),
                         answer(s.leaf.abelian), strata::reason(s.leaf)});
  for (const std::string& u : a.unvisited)
    grid.rows.push_back({u, "", "undecided", "a limit was reached"});
  n.tables.push_back(std::move(grid));
}

// "c", or what comes after it in the alphabet, so that no name c0, c1, ... is taken.
std::string free_letter(const Ring& ring, std::size_t indices) {
  for (char letter = 'c'; letter <= 'z'; ++letter) {
    const auto taken = [&](std::size_t k) {
      return ring->find(letter + std::to_string(k)).has_value();
    };
    bool is_free = true;
    for (std::size_t k = 0; k < indices; ++k)
      is_free = is_free && !taken(k);
    if (is_free) return {letter};
  }
  return "coefficient";
}

// r(z) whole: a long numerator by powers of z, with names for the coefficients.
void show_equation(NodeResult& n, const MFraction& r, const Ring& ring, std::size_t z) {
  constexpr std::size_t fits_a_line = 160;
  const std::string label = "r(" + ring->name(z) + ")";
  const std::string whole = to_factored_string(r);
  if (whole.size() <= fits_a_line || degree(r.num(), z) < 1) {
    n.formulas.push_back({label, whole});
    return;
  }
  const auto coefficient = coefficients(r.num(), z);
  const std::string letter = free_letter(ring, coefficient.size());
  std::string top;
  for (std::size_t k = coefficient.size(); k-- > 0;) {
    if (is_zero(coefficient[k])) continue;
    top += (top.empty() ? "" : " + ") + letter + std::to_string(k) +
           (k == 0   ? ""
            : k == 1 ? "*" + ring->name(z)
                     : "*" + ring->name(z) + "^" + std::to_string(k));
  }
  const std::string bottom = to_factored_string(MFraction(r.den()));
  n.formulas.push_back({label, "(" + top + ")" + (bottom == "1" ? "" : "/(" + bottom + ")")});
  for (std::size_t k = coefficient.size(); k-- > 0;)
    if (!is_zero(coefficient[k]))
      n.formulas.push_back(
          {letter + std::to_string(k), to_factored_string(MFraction(coefficient[k]))});
}

void show_block(NodeResult& n, const System& s, const BlockReport& b) {
  if (b.ode) {
    n.formulas.push_back({"change of variable", b.ode->change});
    show_equation(n, b.ode->r, s.ring(), b.ode->z);
  }
  if (b.decision) show_decision(n, *b.decision);
  if (b.strata) show_strata(n, *b.strata);
  for (const EnergyResult& e : b.energies) {
    if (e.strata) {
      n.formulas.push_back({"energy", sentence(e.at)});
      show_strata(n, *e.strata, " where " + sentence(e.at));
    }
    if (!e.decision || e.decision->abelian == Truth::unknown) continue;
    n.formulas.push_back({"energy", sentence(e.at)});
    if (e.r) n.formulas.push_back({"r there", to_string(*e.r)});
    show_decision(n, *e.decision, " where " + sentence(e.at));
  }
}

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
using study::Verdict;

SystemStudy studied(const Entry& document, const ParameterValues& where, const NodeResult& n,
                    const ProveOptions& options) {
  study::StudyOptions how;
  how.check.decide = options.decide;
  how.check.decide.want_certificate = true;
  how.check.only_manifold = n.node.manifold;
  how.order = n.node.order;
  std::vector<std::string> names;
  for (const ManifoldSpec& m : read_system(document, where).manifolds)
    names.push_back(m.name);
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

// Of several manifolds together, or of several orders: each set by one of them.
void conclude_together(NodeResult& n, const System& s, const SystemClassification& c,
                       const std::string& along) {
  n.says = Conclusion::not_integrable;
  n.excluded = c.excluded;
  n.curve = along + " in " + n.node.file;
  n.trusted.insert(n.trusted.end(), c.trusted.begin(), c.trusted.end());
  for (const LiteratureTheorem* t : c.theorems)
    n.theorems.push_back(used(*t));
  n.headline = "NON-INTEGRABLE (" + along + ")";
  n.statement = assumptions_of(s) + "The system of " + n.node.file + " is not integrable with " +
                first_integrals(c.excluded) + " (" + along + ")";
}

// The obstruction of a higher order.
void conclude_higher(NodeResult& n, const System& s, const CurveStudy& m) {
  const ExclusionReason& by = m.higher->excluded->by;
  const std::string at_order = " at order " + std::to_string(by.order);
  const std::string along =
      " (" + by.theorems.front()->name + ", along the manifold " + name_in_words(m.name()) + ")";
  const std::string except = m.higher->exceptions.empty() ? "" : ", " + exceptions(*m.higher);
  n.theorems.push_back(used(morales_ramis_simo()));
  n.theorems.back().integrals = by.integrals;
  if (!by.unchecked.empty())
    n.theorems.back().hypotheses.push_back({by.unchecked, Settled::open, ""});
  n.trusted.insert(n.trusted.end(), by.trusted.begin(), by.trusted.end());
  n.headline = "NON-INTEGRABLE" + at_order + except + along;
  n.statement = assumptions_of(s) + "The system of " + n.node.file + " is " + statement(by) +
                (by.level.empty() ? "" : ", " + sentence(by.level)) + except + along +
                (except.empty() ? "" : ". In the exceptions nothing follows about integrability");
  if (!except.empty()) return;
  n.says = Conclusion::not_integrable;
  n.excluded = {by.integrals};
  n.curve = name_in_words(m.name()) + " in " + n.node.file;
}

// What follows, in words and as the headline of a report.
void conclude(NodeResult& n, const System& s, const CurveStudy& all_orders) {
  const ManifoldReport& m = all_orders.first;
  if (!m.by) return; // a limit came before the theorem
  if (all_orders.together)
    return conclude_together(n, s, *all_orders.together,
                             "along the manifold " + name_in_words(m.name) + ", set by set");
  if (all_orders.higher && all_orders.higher->excluded) return conclude_higher(n, s, all_orders);
  const std::string subject = assumptions_of(s) + "The system of " + n.node.file + " is ";
  const std::string by = " (" + m.by->id() + ", along the manifold " + name_in_words(m.name) + ")";
  add_once(n.trusted, trusted_steps(m));
  n.theorems.push_back(*m.by);
  if (m.verdict == VerdictKind::non_integrable) {
    n.says = Conclusion::not_integrable;
    n.excluded = {m.by->integrals};
    n.curve = name_in_words(m.name) + " in " + n.node.file;
    if (!m.by->integrals.without.empty() && !n.node.place.as.empty()) // they name coordinates
      n.excluded.front().frame = "of " + n.node.file;
    n.headline = "NON-INTEGRABLE" + by;
    n.statement = subject + statement(m) + by;
    if (m.by->integrals.near != IntegralClass::Near::curve || !m.by->integrals.without.empty())
      n.summary += "; for first integrals that are " + sentence(m.by->integrals);
  } else if (m.verdict == VerdictKind::no_obstruction) {
    n.headline = "NO OBSTRUCTION" + by + ": nothing follows about integrability";
    n.statement = subject + "not obstructed by the first variational equation" + by +
                  ": nothing follows about integrability";
    n.summary += " (the test passes; nothing follows about integrability)";
  } else {
    const std::string except = exceptions(m);
    if (except.empty())
      throw DomainError("the parameters where the system is not integrable could not be named");
    n.headline = "NON-INTEGRABLE " + except + by;
    n.statement = subject + "not integrable with first integrals that are " +
                  sentence(m.by->integrals) + ", " + except + by +
                  ". In the exceptions nothing follows about integrability";
  }
}

std::string as_written(const std::vector<Equation>& equations) {
  std::string text;
  for (const Equation& e : equations)
    text += (text.empty() ? "" : ", ") + e.text;
  return text;
}

// The equations of a manifold and the levels on it, as written.
void show_manifold(NodeResult& n, const System& s, const std::string& name) {
  for (const ManifoldSpec& m : s.manifolds) {
    if (m.name != name) continue;
    n.formulas.push_back({"manifold " + name, as_written(m.equations)});
    if (!m.levels.empty()) n.formulas.push_back({"levels on " + name, as_written(m.levels)});
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

void show_curve(NodeResult& n, const System& s, const CurveStudy& m) {
  show_manifold(n, s, m.name());
  n.checks.push_back({"the manifold " + m.name() + " is invariant", m.first.manifold.has_value()});
  for (const BlockReport& b : m.first.blocks)
    show_block(n, s, b);
  for (NamedCertificate& c : certificates(s, m)) // what has none is a trusted step
    if (!c.json.empty()) n.certificates.push_back(std::move(c.json));
}

// Not integrable along one manifold is not integrable; otherwise all of them have to be decided.
const CurveStudy& that_decides(const SystemStudy& study) {
  return *std::max_element(
      study.manifolds.begin(), study.manifolds.end(),
      [](const CurveStudy& a, const CurveStudy& b) { return weight(a) < weight(b); });
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
    if (by_several && !other.first.failure) show_curve(n, study.system, other);
  }
  n.summary = by_several ? to_string(verdict) + ": " + statement(*study.together) : found(m);
  if (m.first.failure && !by_several) {
    n.summary = m.first.failure->message;
    return;
  }
  if (!by_several) show_curve(n, study.system, m);
  if (!expected(n.node, verdict)) return unexpected(n, verdict);
  n.status = NodeStatus::proved;
  if (by_several)
    conclude_together(n, study.system, *study.together, "by all its manifolds together");
  else
    conclude(n, study.system, m);
}

std::string text_of(const ParameterValues& values) {
  std::string text;
  for (const auto& [name, value] : values)
    text += (text.empty() ? "" : ", ") + name + " = " + value;
  return text;
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
  return std::any_of(sample.begin(), sample.end(), [&](const auto& value) {
    const auto i = s.ring()->find(value.first);
    return i && std::find(levels.begin(), levels.end(), *i) != levels.end();
  });
}

// What the verdict at the sample says about the verdict for the family.
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
  const std::string text = text_of(n.node.sample);
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

} // namespace

namespace {

// Does a certificate say "not integrable" of all its points?
bool has_certificate_of_all(const NodeResult& n) {
  return std::any_of(n.certificates.begin(), n.certificates.end(), [](const std::string& json) {
    try {
      static_cast<void>(target_of(json));
      return true;
    } catch (const Error&) {
      return false;
    }
  });
}

// Inequations under which the identity component is not abelian along a manifold, besides what is assumed: that
// they hold for some level is shown in the certificate.
std::vector<std::vector<std::string>> generic_levels(const SystemStudy& study) {
  std::vector<std::vector<std::string>> all;
  for (const CurveStudy& m : study.manifolds)
    for (const BlockReport& b : m.first.blocks) {
      if (!b.strata) continue;
      for (const strata::Stratum& x : b.strata->strata) {
        const bool only_inequations =
            std::all_of(x.conditions.begin(), x.conditions.end(),
                        [](const Condition& c) { return c.sign == Sign::nonzero; });
        if (x.leaf.abelian != Truth::no || !only_inequations || x.conditions.empty()) continue;
        all.emplace_back();
        for (const Condition& c : x.conditions)
          all.back().push_back(to_string(c));
      }
    }
  return all;
}

void prove_at_generic_levels(NodeResult& n, const Entry& document, const SystemStudy& study,
                             const ProveOptions& options) {
  for (const std::vector<std::string>& conditions : generic_levels(study)) {
    NodeResult trial;
    trial.node = n.node;
    const SystemStudy again =
        studied(with_conditions(document, conditions), n.node.where, trial, options);
    if (again.manifolds.empty()) continue;
    take(trial, again);
    if (trial.status != NodeStatus::proved || trial.says != Conclusion::not_integrable ||
        !has_certificate_of_all(trial))
      continue;
    n = std::move(trial);
    return;
  }
}

void prove_by_file(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  const Entry document = document_of(n.node, directory);
  const SystemStudy study = studied(document, n.node.where, n, options);
  show_setting(n, study.system);
  if (study.manifolds.empty()) throw DomainError(n.node.file + " has no manifold");
  take(n, study);
  if (is_of_stratum(n.node) && !has_certificate_of_all(n))
    prove_at_generic_levels(n, document, study, options);
  if (!n.node.sample.empty()) take_sample(n, study, document, options);
}

} // namespace

void prove_case(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  if (n.node.step.empty() || !options.found) return prove_by_file(n, directory, options);
  NodeResult trial = n;
  try {
    prove_by_file(trial, directory, options);
  } catch (const InternalError&) {
    throw;
  } catch (const Error&) { // it stays on trust
  }
  const bool is_found =
      trial.status == NodeStatus::proved && trial.says == Conclusion::not_integrable;
  is_found ? void(n = std::move(trial)) : prove_trusted(n, options);
}

} // namespace kov
