// kovacic check on a system file: claims, then one verdict per manifold and set of values, and of
// several manifolds the one that they give together.

#include "case_file.hpp"
#include "certificate_file.hpp"
#include "classification_report.hpp"
#include "commands.hpp"
#include "decide/afterwards.hpp"
#include "decide/words.hpp"
#include "integrability/certificate.hpp"
#include "integrability/conclude.hpp"
#include "integrability/eigenvalue.hpp"
#include "integrability/expect.hpp"
#include "integrability/matrices.hpp"
#include "integrability/one_level.hpp"
#include "integrability/parameters.hpp"
#include "integrals/stratum.hpp"
#include "jets/words.hpp"
#include "mechanics.hpp"
#include "present_strata.hpp"
#include "second_opinion.hpp"
#include "study/together.hpp"
#include "system/assumed_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <sstream>

namespace kov::cli {
namespace {

constexpr double part_for_eigenvalues = 0.1; // of the time

void put(std::ostringstream& out, const std::string& label, const std::string& text,
         std::size_t indent = 2) {
  const std::size_t column = indent + 10;
  out << std::string(indent, ' ') << label
      << std::string(label.size() < 10 ? 10 - label.size() : 1, ' ') << wrapped(text, column)
      << "\n";
}

enum class Detail : std::uint8_t {
  nothing, ///< where the line about what was expected says it all
  headline,
  brief, ///< equal answers together, no formula that fills a page
  whole
};

// The beginning of what would fill a page.
std::string cut(const std::string& text, Detail detail) {
  constexpr std::size_t five_lines = 430;
  if (detail == Detail::whole || text.size() <= five_lines) return text;
  return text.substr(0, five_lines) + " ... (--verbose shows the rest)";
}

std::string undecided_somewhere(const ManifoldReport& m, Detail detail) {
  const std::string except = cut(exceptions(m), detail);
  const bool depends = m.verdict == VerdictKind::depends;
  if (except.empty())
    return depends ? "DEPENDS ON THE PARAMETERS  (" + m.by->id() + ")" : "UNDECIDED";
  return (depends ? "NON-INTEGRABLE, " : "UNDECIDED IN PART: NON-INTEGRABLE, ") + except + "  (" +
         m.by->id() + ": " + m.statement + "; in the exceptions nothing follows)";
}

std::string headline(const ManifoldReport& m, Detail detail) {
  switch (m.verdict) {
  case VerdictKind::non_integrable:
    return "NON-INTEGRABLE  (" + m.by->id() + ": " + m.statement + ")";
  case VerdictKind::no_obstruction:
    return "NO OBSTRUCTION  (the first-order test of " + m.by->id() +
           " passes; this does not prove integrability)";
  default:
    return undecided_somewhere(m, detail);
  }
}

void put_decision(std::ostringstream& out, const Decision& d, std::size_t indent) {
  std::string group = d.group ? "G = " + describe(*d.group) : "G not determined";
  if (d.component) group += ", identity component " + to_string(*d.component);
  group += d.abelian == Truth::yes  ? ", abelian"
           : d.abelian == Truth::no ? ", not abelian"
                                    : ", abelian or not: undecided";
  put(out, "group", group, indent);
  put(out, "because", reason(d), indent);
  Json steps = Json::object();
  put_trace(steps, d.trace);
  print_trace(out, steps);
}

void print(std::ostringstream& out, const strata::StrataAnswer& a, Detail detail) {
  Json j;
  put_strata(j, a);
  j["trusted"] = Json::array(); // said once for all blocks
  print_strata(out, j, detail == Detail::whole);
}

// r in three lines, or what its poles are.
std::string shape_of(const AlgebraicOde& ode, const std::string& z) {
  constexpr std::size_t three_lines = 260;
  const MPoly numerator = ode.r.num();
  std::string whole = to_factored_string(ode.r);
  if (whole.size() <= three_lines) return whole;
  const std::string below = to_factored_string(MFraction(ode.r.den()));
  return (below.size() <= three_lines ? "N(" + z + ")/(" + below + "), N"
                                      : "a quotient whose numerator is") +
         " of degree " + std::to_string(degree(numerator, ode.z)) + " with " +
         std::to_string(numerator.length()) + " terms (--verbose shows them)";
}

void put_level(std::ostringstream& out, const EnergyResult& e, Detail detail) {
  put(out, "at", e.condition + "  (" + e.why + ")");
  if (e.decision) put_decision(out, *e.decision, 4);
  if (e.strata) print(out, *e.strata, detail);
  if (!e.note.empty()) put(out, "note", cut(e.note, detail), 4);
}

// A level that decides is enough.
bool decides(const EnergyResult& e) {
  return (e.decision && e.decision->abelian == Truth::no) ||
         (e.strata && e.strata->decided() && somewhere_not_abelian(*e.strata));
}

void put_levels(std::ostringstream& out, const std::vector<EnergyResult>& all, Detail detail) {
  const auto one = std::find_if(all.begin(), all.end(), decides);
  if (detail == Detail::whole || one == all.end())
    for (const EnergyResult& e : all)
      put_level(out, e, detail);
  else
    put_level(out, *one, detail);
}

void put_block(std::ostringstream& out, const System& s, const BlockReport& b, Detail detail) {
  if (b.ode) {
    const std::string z = s.ring()->name(b.ode->z);
    put(out, "change", b.ode->change + ", y the variation of " + b.ode->unknown);
    put(out, "equation",
        "y'' = r(" + z + ") y,  r = " +
            (detail == Detail::whole ? to_factored_string(b.ode->r) : shape_of(*b.ode, z)));
  }
  if (b.decision) put_decision(out, *b.decision, 2);
  if (b.strata) print(out, *b.strata, detail);
  if (detail == Detail::whole)
    for (const auto& f : b.special)
      put(out, "merging", "singular places meet where " + to_string(f) + " = 0");
  put_levels(out, b.energies, detail);
  if (!b.note.empty()) put(out, "note", cut(b.note, detail));
}

// On what the verdict rests.
void put_trust(std::ostringstream& out, const ManifoldReport& m) {
  const auto steps = trusted_steps(m);
  if ((m.verdict == VerdictKind::undecided && !m.by) || steps.empty()) return;
  std::string text;
  for (const std::string& step : steps)
    text += (text.empty() ? "" : "; ") + step;
  put(out, "trusted",
      std::to_string(steps.size()) + (steps.size() == 1 ? " step: " : " steps: ") + text);
}

// Which flag sets the first limit among the reasons.
void put_way_out(std::ostringstream& out, const std::vector<std::string>& reasons) {
  for (const std::string& reason : reasons)
    if (const std::string way = way_out("budget", reason); way != way_out("budget", ""))
      return put(out, "more", way);
}

std::string title_of_manifold(const System& s, const std::string& name) {
  std::string title = s.file + "  [" + name + "]";
  for (const auto& [parameter, value] : s.values)
    title += "  " + parameter + " = " + to_string(value);
  return title;
}

void put_manifold(std::ostringstream& out, const System& s, const ManifoldReport& m,
                  Detail detail) {
  const bool undecided = m.failure || m.verdict == VerdictKind::undecided;
  if (detail == Detail::nothing && !undecided) return;
  out << title_of_manifold(s, m.name) << "\n";
  if (m.failure) {
    put(out, "error", m.failure->message);
    return;
  }
  out << "  " << wrapped(headline(m, detail), 2) << "\n";
  if (m.manifold)
    for (const auto& line : m.manifold->rewritten)
      put(out, "note", line);
  if (!m.not_checked.empty() && (m.verdict != VerdictKind::undecided || m.by))
    put(out, "NOT CHECKED", m.not_checked);
  if (detail == Detail::headline && !undecided) return;
  for (const std::string& constant : s.adjoined)
    if (!m.blocks.empty()) put(out, "where", constant);
  for (const auto& e : m.reduced.eliminations)
    put(out, "reduced",
        "the variation of " + e.unknown + " by the linear integral d" + e.integral + " = 0");
  for (const auto& b : m.blocks)
    put_block(out, s, b, detail);
  if (m.blocks.empty())
    for (const auto& r : m.reasons)
      put(out, "because", r);
  else if (m.verdict == VerdictKind::undecided && !m.not_studied.empty())
    put(out, "open", m.reasons.back());
  if (m.matrices && !m.blocks.empty()) put(out, "because", reason(*m.matrices));
  if (m.verdict == VerdictKind::undecided) put_way_out(out, m.reasons);
  put_trust(out, m);
}

std::string text_of(const System& s, const ManifoldReport& m, Detail detail) {
  std::ostringstream out;
  put_manifold(out, s, m, detail);
  return out.str();
}

std::vector<MPoly> in_system(const System& s, const std::vector<MPoly>& list) {
  std::vector<MPoly> all;
  for (const MPoly& p : list)
    all.push_back(transfer(MFraction(p), s.ring()).num());
  return all;
}

// "p = 0 and q = 0"
std::string vanishing(const std::vector<MPoly>& list) {
  std::string all;
  for (const MPoly& p : list)
    all += (all.empty() ? "" : " and ") + to_string(p) + " = 0";
  return all;
}

// "A - B = 0", or "a = b = 0": where nothing follows.
std::string where_nothing_follows(const System& s, const jets::HigherOrders& orders) {
  std::string text;
  for (const auto& given : orders.obstruction->not_all_zero) {
    const auto list = in_system(s, given);
    if (not_excluded(s, list).size() < list.size()) continue; // one of them is not 0
    text += (text.empty() ? "except where " : "; or ") + vanishing(list);
  }
  return text;
}

// The values that the file admits, as far as equations and inequations say.
ParameterSet admitted(const System& s) {
  std::vector<std::size_t> names = s.field.constants;
  names.insert(names.end(), s.field.parameters.begin(), s.field.parameters.end());
  ParameterSet all(s.ring(), names);
  for (const MPoly& p : s.field.relations)
    all = all.where_zero(p);
  for (const Assumption& a : s.assumptions) {
    using Relation = Assumption::Relation;
    if (a.relation == Relation::zero) all = all.where_zero(a.value.num());
    if (a.relation == Relation::nonzero || a.relation == Relation::positive)
      all = all.where_nonzero(a.value.num());
  }
  return all;
}

// p = 0 at all values that the file admits: proved.
bool vanishes_by_assumption(const System& s, const MPoly& p) {
  if (s.assumptions.empty() || is_constant(p)) return false;
  System other = s;
  other.assumptions.push_back({Assumption::Relation::nonzero, MFraction(p), "", 0});
  return contradicts_itself(other) || admitted(other).is_empty();
}

// An obstruction that excludes no value that the file admits is none.
void withdraw_if_void(const System& s, jets::HigherOrders& orders) {
  if (!orders.obstruction) return;
  for (const auto& given : orders.obstruction->not_all_zero) {
    const auto list = in_system(s, given);
    if (!std::all_of(list.begin(), list.end(),
                     [&](const MPoly& p) { return vanishes_by_assumption(s, p); }))
      continue;
    orders.open = "VE_" + std::to_string(orders.obstruction->logarithm.order) +
                  " excludes nothing that the file admits, as " + vanishing(list) + " there";
    return orders.obstruction.reset();
  }
}

void put_higher_orders(std::ostringstream& out, const System& s, const jets::HigherOrders& h) {
  const std::string label = "order " + std::to_string(h.up_to);
  if (!h.obstruction)
    return put(out, label,
               h.open.empty() ? "no obstruction up to VE_" + std::to_string(h.up_to) +
                                    " (no logarithm at infinity; this proves nothing)"
                              : "OPEN: " + h.open);
  const std::string except = where_nothing_follows(s, h);
  put(out, label,
      "NON-INTEGRABLE at order " + std::to_string(h.obstruction->logarithm.order) +
          (except.empty() ? "" : ", " + except) + "  (" + jets::theorem() +
          ": not integrable in Liouville's sense with first integrals that are meromorphic near "
          "the phase curve, " +
          jets::level(*h.obstruction) + ")");
  put(out, "because", jets::reason(h));
  std::string trusted;
  for (const std::string& step : jets::trusted(*h.obstruction))
    trusted += (trusted.empty() ? "" : "; ") + step;
  if (!trusted.empty()) put(out, "trusted", trusted + ", without a certificate");
}

Json json_of_orders(const System& s, const jets::HigherOrders& h) {
  Json j{{"up_to", h.up_to}, {"verdict", h.open.empty() ? "no-obstruction" : "undecided"}};
  if (!h.open.empty()) j["open"] = h.open;
  if (!h.obstruction) return j;
  const std::string except = where_nothing_follows(s, h);
  j["verdict"] = except.empty() ? "non-integrable" : "depends";
  j["order"] = h.obstruction->logarithm.order;
  j["residue"] = to_string(h.obstruction->logarithm.form);
  j["level"] = jets::level(*h.obstruction);
  j["exceptions"] = except;
  j["reason"] = jets::reason(h);
  j["theorem"] = jets::theorem();
  j["trusted"] = jets::trusted(*h.obstruction);
  return j;
}

void put_by_quadratures(std::ostringstream& out, const Exclusion& e) {
  put(out, "order " + std::to_string(e.by.order),
      "NON-INTEGRABLE at order " + std::to_string(e.by.order) + "  (" + e.by.theorems.front() +
          ": not integrable with " + first_integrals({e.by.integrals}) +
          (e.by.level.empty() ? "" : ", " + e.by.level) + ")");
  if (!e.by.unchecked.empty()) put(out, "NOT CHECKED", e.by.unchecked);
  put(out, "because", e.by.reason);
  put(out, "trusted", e.by.trusted.front() + ", without a certificate");
}

Json json_by_quadratures(const Exclusion& e, int up_to) {
  return {{"up_to", up_to},
          {"verdict", "non-integrable"},
          {"order", e.by.order},
          {"level", e.by.level},
          {"exceptions", ""},
          {"without", e.by.integrals.without},
          {"not_checked", e.by.unchecked.empty() ? Json(nullptr) : Json(e.by.unchecked)},
          {"reason", e.by.reason},
          {"theorem", e.by.theorems.front()},
          {"trusted", e.by.trusted}};
}

// What is known of one manifold for the verdict on all of them.
struct Findings {
  VerdictKind verdict = VerdictKind::undecided;
  std::vector<Exclusion> exclusions;
};

// Where nothing is excluded: "depends" only if each manifold is decided for all parameters.
VerdictKind verdict_of(const SystemClassification& c, const std::vector<Findings>& all,
                       bool complete) {
  if (c.status() == ClassificationStatus::non_integrable) return VerdictKind::non_integrable;
  const auto is = [](VerdictKind kind) {
    return [kind](const Findings& f) { return f.verdict == kind; };
  };
  if (!complete || std::any_of(all.begin(), all.end(), is(VerdictKind::undecided)))
    return VerdictKind::undecided;
  return std::all_of(all.begin(), all.end(), is(VerdictKind::no_obstruction)) && c.excluded.empty()
             ? VerdictKind::no_obstruction
             : VerdictKind::depends;
}

std::string headline(VerdictKind verdict, bool excludes) {
  switch (verdict) {
  case VerdictKind::non_integrable:
    return "NON-INTEGRABLE";
  case VerdictKind::no_obstruction:
    return "NO OBSTRUCTION  (the tests pass along all of them; this does not prove integrability)";
  case VerdictKind::depends:
    return "DEPENDS ON THE PARAMETERS";
  default:
    return excludes ? "UNDECIDED IN PART" : "UNDECIDED";
  }
}

std::string text_of(const System& s, const SystemClassification& c, VerdictKind verdict,
                    Detail detail) {
  std::ostringstream out;
  out << title_of_manifold(s, "all manifolds together") << "\n  "
      << wrapped(headline(verdict, !c.excluded.empty()), 2) << "\n";
  if (c.excluded.empty()) return out.str();
  put(out, "theorem", statement(c));
  if (!c.assumptions.empty()) put(out, "assumed", joined(c.assumptions, ", "));
  if (detail == Detail::headline) return out.str();
  for (const ExcludedTogether& e : excluded_together(c))
    put(out, "excluded", joined(e.where, "; or ") + ": " + cut(reason_of(*e.by), detail));
  put(out, "by", joined(c.theorems, ", "));
  return out.str();
}

Json json_of_verdict(const SystemClassification& c, VerdictKind verdict) {
  Json strata = Json::array();
  for (const ClassifiedStratum& x : c.strata)
    strata.push_back(json_of(c, x));
  return {{"verdict", to_string(verdict)},
          {"statement", c.excluded.empty() ? Json(nullptr) : Json(statement(c))},
          {"integrals_class", c.excluded.empty() ? Json(nullptr) : Json(integrals_class(c))},
          {"assumptions", c.assumptions},
          {"theorems", c.theorems},
          {"trusted", c.trusted},
          {"strata", strata}};
}

Json json_of_round(const System& s) {
  Json set = Json::object();
  for (const auto& [name, value] : s.values)
    set[name] = to_string(value);
  Json assumptions = Json::array();
  for (const auto& x : s.assumptions)
    assumptions.push_back(x.text);
  return Json{{"format", "kovacic-result/1"},
              {"input", Json{{"file", s.file}}},
              {"title", s.title},
              {"set", set},
              {"assumptions", assumptions},
              {"claims", Json::array()},
              {"manifolds", Json::array()},
              {"seconds", 0}};
}

int exit_of(const Settings& settings, const Json& manifolds, const std::string& together) {
  // Of the first order; an obstruction of higher order is one where there was none.
  const auto verdict = [](const Json& m) -> std::string {
    if (m.contains("failure")) return "";
    const bool higher = m.contains("higher_orders") && m.at("higher_orders").at("verdict") ==
                                                           to_string(VerdictKind::non_integrable);
    return higher ? to_string(VerdictKind::non_integrable) : m.at("verdict").get<std::string>();
  };
  const auto any = [&](VerdictKind kind) {
    return std::any_of(manifolds.begin(), manifolds.end(),
                       [&](const Json& m) { return verdict(m) == to_string(kind); });
  };
  for (const Json& m : manifolds)
    if (m.contains("failure")) return exit_input;
  const bool obstruction =
      any(VerdictKind::non_integrable) || together == to_string(VerdictKind::non_integrable);
  const bool open = any(VerdictKind::undecided);
  const bool none = !manifolds.empty() && !open && !any(VerdictKind::depends);
  return settings.exit_of(obstruction ? Truth::no
                          : none      ? Truth::yes
                                      : Truth::unknown,
                          obstruction || !open);
}

// The jobs of one file: the plan, and for each set of values ("round") its claims and each of its
// manifolds.  They run in a child process; what a job needs of earlier ones is made again when the
// child is a new one.
class SystemJobs {
public:
  SystemJobs(const Settings& settings, std::string path)
      : settings_(settings), path_(std::move(path)) {}

  Report run(std::string_view job) {
    std::istringstream words{std::string(job)};
    std::string what;
    std::size_t round = 0, manifold = 0;
    words >> what >> round >> manifold;
    options_ = {};
    options_.decide = settings_.solver_options(); // its clock begins here
    options_.decide.ask_the_judge = true;
    options_.only_manifold = settings_.manifold;
    if (!document_) read();
    if (what == "plan") return plan();
    if (what == "claims") return claims(rounds_.at(round));
    if (what == "together") return all_together(rounds_.at(round), words, manifold);
    return study(rounds_.at(round), manifold, what == "manifold");
  }

private:
  struct Round {
    ParameterValues values;
    std::optional<System> system, studied = {};
    std::optional<std::vector<ClaimReport>> claims;
    std::map<std::size_t, Findings> findings = {}; ///< of the manifolds that were studied
  };

  void read() {
    document_ = settings_.document(path_);
    base_ = parameter_values(settings_);
    const System file = read_system(*document_, base_);
    const auto known = [&](const ParameterValues& values) {
      return std::any_of(rounds_.begin(), rounds_.end(),
                         [&](const Round& r) { return r.values == values; });
    };
    for (const auto& x : file.expectations)
      if (base_.empty() && !known(x.where)) rounds_.push_back({x.where, {}, {}, {}, {}});
    if (rounds_.empty()) rounds_.push_back({base_, {}, {}, {}, {}});
  }

  const System& system_of(Round& round) {
    if (!round.system) round.system = read_system_as_assumed(*document_, round.values);
    return *round.system;
  }
  // With the eigenvalues over which the variations along its manifolds fall apart.
  const System& studied(Round& round) {
    if (round.studied) return *round.studied;
    CheckOptions search = options_;
    search.decide.budget = part_of_the_time(options_.decide.budget, part_for_eigenvalues);
    round.studied = with_eigenvalues(system_of(round), search);
    return *round.studied;
  }

  std::vector<const SystemExpectation*> expectations_of(Round& round) {
    std::vector<const SystemExpectation*> all;
    for (const auto& x : system_of(round).expectations)
      if (x.where == round.values || (round.values == base_ && x.where.empty())) all.push_back(&x);
    return all;
  }

  Report plan() {
    Json all = Json::array();
    for (Round& round : rounds_) {
      const System& s = system_of(round);
      require_consistent(s);
      Json one{
          {"result", json_of_round(s)}, {"manifolds", Json::array()}, {"expected", Json::array()}};
      for (const ManifoldSpec* m : manifolds_to_check(s, options_))
        one["manifolds"].push_back({{"name", m->name}, {"title", title_of_manifold(s, m->name)}});
      for (const SystemExpectation* x : expectations_of(round))
        one["expected"].push_back(describe(*x));
      all.push_back(std::move(one));
    }
    return {exit_decided, "", all, {}};
  }

  const std::vector<ClaimReport>& claims_of(Round& round) {
    if (!round.claims) round.claims = decide_claims(system_of(round), options_);
    return *round.claims;
  }

  Report claims(Round& round) {
    const System& s = system_of(round);
    Report report{exit_decided, "", {{"claims", Json::array()}, {"expected", Json::array()}}, {}};
    for (const auto& c : claims_of(round)) {
      report.json.at("claims").push_back(json_of(c));
      std::string where;
      for (const MPoly& g : not_excluded(s, c.result.generic))
        where += (where.empty() ? " where " : ", ") + to_string(g) + " != 0";
      report.json.at("expected")
          .push_back(
              {{"name", title_of(c.claim) + (c.claim.holds ? ": proved" + where : ": refuted")},
               {"found", is_met(c.claim, c.result) ? "" : c.result.detail},
               {"limit", !c.result.open.empty()}});
    }
    if (s.manifolds.empty())
      report.text =
          heading(s.file, s.title) +
          "\n  note      no [[manifold]] in this file; kovacic find-manifolds proposes some\n";
    return report;
  }

  // with_claims: not after a limit ended their job.
  Report study(Round& round, std::size_t index, bool with_claims) {
    const System& s = studied(round);
    static const std::vector<ClaimReport> none;
    CheckReport report;
    report.manifolds.push_back(
        check_manifold(s, *manifolds_to_check(s, options_).at(index),
                       with_claims ? kov::claims_of(s, claims_of(round)) : none, options_));
    ManifoldReport& m = report.manifolds.front();
    if (m.failure && is_fine_without(round.values, m.name)) degenerate(m);
    Findings& findings = round.findings[index] = findings_of(s, m);
    Report answer{exit_decided, text_of(s, m, detail_of(round)), {{"manifold", json_of(s, m)}}, {}};
    std::vector<NamedCertificate> proofs;
    if (!settings_.certificate.empty())
      do_part(answer, "the certificates", [&] { proofs = certificates(s, m); });
    if (settings_.second_opinion)
      do_part(answer, "the second opinion", [&] { ask_monodromy(s, m, answer, proofs); });
    if (settings_.order > 1 && m.manifold && m.verdict != VerdictKind::non_integrable)
      do_part(answer, "the higher orders", [&] {
        ask_higher_orders(s, *manifolds_to_check(s, options_).at(index), answer, proofs, findings);
      });
    if (!settings_.certificate.empty()) file_certificates(s, proofs, answer);
    answer.json["unmet"] = Json::array(); // null: the expectation is about another one
    for (const SystemExpectation* x : expectations_of(round))
      answer.json["unmet"].push_back(
          x->manifold.empty() || x->manifold == m.name ? Json(unmet(*x, report)) : Json(nullptr));
    return answer;
  }

  // Behind the verdict: a limit or an error costs this part only.
  static void do_part(Report& answer, const char* part, const std::function<void()>& work) {
    std::string missing;
    try {
      missing = failure_of(part, work);
    } catch (const OutOfBudget& limit) {
      missing = std::string(part) + ": " + limit.what();
    }
    if (missing.empty()) return;
    answer.json.at("manifold")["failed"].push_back(missing);
    std::ostringstream line;
    put(line, "failed", missing);
    answer.text += line.str();
  }

  static Findings findings_of(const System& s, const ManifoldReport& m) {
    if (m.failure) return {};
    return {m.verdict, exclusions_of_verdict(s, m, free_levels(s))};
  }

  // "together ROUND 1 MANIFOLD...": of those manifolds on which the work came to its end.
  Report all_together(Round& round, std::istream& others, std::size_t with_claims) {
    const System& s = studied(round);
    std::vector<Findings> all;
    std::vector<Exclusion> exclusions;
    for (std::size_t k = 0; others >> k;) {
      if (!round.findings.contains(k)) study(round, k, with_claims != 0); // by another child
      all.push_back(round.findings.at(k));
      std::copy(all.back().exclusions.begin(), all.back().exclusions.end(),
                std::back_inserter(exclusions));
    }
    const SystemClassification c = together(s, exclusions, options_.decide.budget.stop);
    const bool complete = all.size() == manifolds_to_check(s, options_).size();
    const VerdictKind verdict = verdict_of(c, all, complete);
    const Detail detail = detail_of(round);
    return {exit_decided,
            detail == Detail::nothing ? "" : text_of(s, c, verdict, detail),
            {{"together", json_of_verdict(c, verdict)}},
            {}};
  }

  // Rounds after the first are there for what the file expects of them.
  [[nodiscard]] Detail detail_of(const Round& round) const {
    if (settings_.verbose > 0 || settings_.trace) return Detail::whole;
    const bool only_expected =
        &round != &rounds_.front() && settings_.certificate.empty() && !settings_.second_opinion;
    return only_expected ? Detail::nothing : settings_.quiet ? Detail::headline : Detail::brief;
  }

  // Values can turn a curve into points; then they are the reason, and the file is not wrong.
  bool is_fine_without(const ParameterValues& values, const std::string& manifold) const {
    if (values.empty()) return false;
    const System file = read_system(*document_, {});
    for (const auto& spec : file.manifolds)
      if (spec.name == manifold)
        return std::holds_alternative<InvariantManifold>(
            prove_invariant(file.field, spec, options_.decide.budget));
    return false;
  }

  static void degenerate(ManifoldReport& m) {
    m.reasons = {"at these values " + m.failure->message};
    m.failure.reset();
  }

  void ask_monodromy(const System& s, const ManifoldReport& m, Report& answer,
                     std::vector<NamedCertificate>& proofs) const {
    Json& all = answer.json.at("manifold")["second_opinion"] = Json::array();
    std::ostringstream lines;
    for (const SecondOpinion& o :
         second_opinion(s, m, options_.decide.budget, !settings_.certificate.empty())) {
      put(lines, "monodromy", o.json.at("text").get<std::string>());
      all.push_back(o.json);
      if (!o.proof.json.empty() || !o.proof.none.empty()) proofs.push_back(o.proof);
    }
    answer.text += lines.str();
  }

  // Where the first order leaves something open.
  void ask_higher_orders(const System& s, const ManifoldSpec& m, Report& answer,
                         std::vector<NamedCertificate>& proofs, Findings& findings) const {
    auto orders = jets::higher_orders(s, m, {settings_.order, options_.decide});
    withdraw_if_void(s, orders);
    if (auto e = exclusion_of(s, m, orders)) findings.exclusions.push_back(*std::move(e));
    std::ostringstream lines;
    if (answer.text.empty()) lines << title_of_manifold(s, m.name) << "\n";
    if (!orders.obstruction && !orders.open.empty()) {
      const auto q = orders_by_quadratures(s, m, settings_.order, options_.decide.budget);
      if (q.obstruction) {
        const Exclusion e = exclusion_of(m, *q.obstruction);
        put_by_quadratures(lines, e);
        answer.text += lines.str();
        answer.json.at("manifold")["higher_orders"] = json_by_quadratures(e, settings_.order);
        findings.exclusions.push_back(e);
        return;
      }
      if (!q.open.empty()) orders.open += "; " + q.open;
    }
    put_higher_orders(lines, s, orders);
    answer.text += lines.str();
    answer.json.at("manifold")["higher_orders"] = json_of_orders(s, orders);
    if (!orders.obstruction) return;
    const jets::HigherObstruction& o = *orders.obstruction;
    proofs.push_back(
        {m.name + "-order-" + std::to_string(o.logarithm.order), o.certificate, o.no_certificate});
  }

  void file_certificates(const System& s, const std::vector<NamedCertificate>& proofs,
                         Report& answer) const {
    std::string values;
    for (const auto& [name, value] : s.values)
      values += "-" + name + "=" + to_string(value);
    Json& json = answer.json.at("manifold");
    json["certificate_files"] = Json::array();
    std::ostringstream lines;
    for (const NamedCertificate& c : proofs) {
      if (c.json.empty()) {
        json["no_certificate"].push_back(c.name + ": " + c.none);
        put(lines, "no proof", "of " + c.name + ": " + c.none);
        continue;
      }
      const std::string path = file_certificate(
          settings_, std::filesystem::path(s.file).stem().string() + values + "-" + c.name, c.json);
      json["certificate_files"].push_back(path);
      put(lines, "proof", path + "   verify: kovacic verify " + path);
    }
    answer.text += lines.str();
  }

  const Settings& settings_;
  std::string path_;
  std::optional<Entry> document_;
  ParameterValues base_;
  CheckOptions options_;
  std::vector<Round> rounds_;
};

// Asks for one job after the other: what is proved before a limit stays, and what comes after is
// studied.
class SystemCheck {
public:
  SystemCheck(const Settings& settings, const std::string& path)
      : settings_(settings), path_(path),
        worker_(settings, path,
                [jobs = std::make_shared<SystemJobs>(settings, path)](
                    std::string_view job, const FileWorker::SoFar&) { return jobs->run(job); }) {}

  CaseReport run() {
    const Report plan = worker_.ask("plan");
    if (!plan.limit.empty()) return {plan.text, plan.json, {}, plan.exit};
    report_.exit = settings_.nothing_yet();
    report_.json = Json::array();
    for (std::size_t i = 0; i < plan.json.size() && !interrupted(); ++i)
      round(plan.json.at(i), std::to_string(i));
    if (settings_.exit_verdict && report_.exit == exit_undecided) report_.exit = exit_decided;
    return std::move(report_);
  }

private:
  [[nodiscard]] bool interrupted() const { return report_.exit == exit_interrupted; }

  void round(const Json& plan, const std::string& number) {
    const auto start = std::chrono::steady_clock::now();
    Json result = plan.at("result");
    const bool with_claims = claims(number, result);
    std::vector<Expected> expected;
    for (const Json& name : plan.at("expected"))
      expected.push_back({name, false, "the file has no such manifold", false});
    std::string studied;
    for (std::size_t k = 0; k < plan.at("manifolds").size() && !interrupted(); ++k) {
      const Report m =
          worker_.ask((with_claims ? "manifold " : "alone ") + number + " " + std::to_string(k));
      take(m, plan.at("manifolds").at(k), result, expected);
      if (m.limit.empty()) studied += " " + std::to_string(k);
    }
    if (plan.at("manifolds").size() > 1 && !interrupted())
      together(number + (with_claims ? " 1" : " 0") + studied, result);
    result["seconds"] =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (settings_.verbose > 0)
      report_.text +=
          fmt::format("  time      {:.1f} ms\n", 1000 * result["seconds"].get<double>());
    report_.exit =
        worse(report_.exit,
              exit_of(settings_, result.at("manifolds"),
                      result.contains("together") ? result["together"].at("verdict") : Json("")));
    report_.expected.insert(report_.expected.end(), expected.begin(), expected.end());
    report_.json.push_back(std::move(result));
  }

  // One verdict on the file.
  void together(const std::string& what, Json& result) {
    const Report r = worker_.ask("together " + what);
    if (r.limit.empty()) {
      report_.text += r.text;
      result["together"] = r.json.at("together");
      return;
    }
    if (r.exit != exit_internal || !is_decided(result.at("manifolds")))
      report_.exit = worse(report_.exit, r.exit);
    report_.text += path_ + "  [all manifolds together]\n  UNDECIDED\n" + limit_lines(r.limit);
    result["together"] = {{"verdict", to_string(VerdictKind::undecided)}, {"reason", r.limit}};
  }

  static bool is_decided(const Json& manifolds) {
    return std::any_of(manifolds.begin(), manifolds.end(), [](const Json& m) {
      return m.value("verdict", "") == to_string(VerdictKind::non_integrable);
    });
  }

  // Were they decided?  They are expectations in the first round only.
  bool claims(const std::string& number, Json& result) {
    const Report r = worker_.ask("claims " + number);
    if (!r.limit.empty()) {
      report_.exit = worse(report_.exit, r.exit);
      report_.text += path_ + "  the claims\n  UNDECIDED\n" + limit_lines(r.limit);
      expect("the claims", r.limit, true);
      return false;
    }
    result["claims"] = r.json.at("claims");
    report_.text += r.text;
    if (report_.json.empty())
      for (const Json& e : r.json.at("expected"))
        expect(e.at("name"), e.at("found"), e.at("limit"));
    return true;
  }

  // One manifold that is as expected is enough.
  void take(const Report& m, const Json& planned, Json& result, std::vector<Expected>& expected) {
    if (!m.limit.empty()) {
      report_.exit = worse(report_.exit, m.exit);
      report_.text +=
          planned.at("title").get<std::string>() + "\n  UNDECIDED\n" + limit_lines(m.limit);
      result["manifolds"].push_back({{"name", planned.at("name")},
                                     {"verdict", to_string(VerdictKind::undecided)},
                                     {"reasons", {m.limit}}});
    } else {
      report_.text += m.text;
      result["manifolds"].push_back(m.json.at("manifold"));
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
      Expected& x = expected[i];
      if (m.limit.empty() && m.json.at("unmet").at(i).is_null()) continue;
      const std::string unmet = m.limit.empty()
                                    ? m.json.at("unmet").at(i).get<std::string>()
                                    : "[" + planned.at("name").get<std::string>() + "] " + m.limit;
      x.met = x.met || unmet.empty();
      x.limit = !x.met && (x.limit || !m.limit.empty());
      if (!x.found.starts_with('[')) x.found.clear();
      x.found = x.met ? "" : x.found + unmet;
    }
  }

  void expect(const std::string& name, const std::string& found, bool limit) {
    report_.expected.push_back({name, found.empty(), found, limit});
  }

  const Settings& settings_;
  const std::string& path_;
  FileWorker worker_;
  CaseReport report_;
};

} // namespace

CaseReport check_system_file(const Settings& settings, const std::string& path) {
  return SystemCheck(settings, path).run();
}

// What is expected was compared on the way.
CaseReport test_system_file(const Settings& settings, const std::string& path) {
  CaseReport report = check_system_file(settings, path);
  if (report.json.is_object()) // a limit
    report.expected.push_back(
        {.name = "decided", .met = false, .found = report.json.value("reason", "a limit")});
  return report;
}

} // namespace kov::cli
