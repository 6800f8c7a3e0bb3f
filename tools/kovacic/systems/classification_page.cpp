#include "systems/classification_page.hpp"
#include "commands.hpp"
#include "exact/lists.hpp"
#include "report/render_theorem.hpp"
#include "symbol/given_text.hpp"
#include "systems/classification_report.hpp"
#include "systems/study_report.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"
#include "theorem/theorem.hpp"

#include <algorithm>
#include <optional>

namespace kov::cli {
namespace {

Grid integrable_sets(const SystemClassification& c) {
  Grid g{"Integrable", {"parameters", "first integrals"}, {}};
  for (const ClassifiedStratum& s : c.strata)
    if (s.status == StratumStatus::integrable)
      g.rows.push_back({where_text(c, s), integrals_text(s)});
  return g;
}

// Which solution, at which order, excludes what.
Grid excluded_sets(const SystemClassification& c) {
  Grid g{"Not integrable", {"parameters", "solution", "by"}, {}};
  for (const ExcludedTogether& e : excluded_together(c, ExcludedFor::the_same_curve))
    g.rows.push_back({joined(texts_of(c, e.places), "; or "), e.by->solution,
                      to_string(e.by->rule) +
                          (e.by->order > 1 ? " (order " + std::to_string(e.by->order) + ")" : "")});
  return g;
}

Grid open_sets(const SystemClassification& c) {
  Grid g{"Open", {"parameters", "what was tried"}, {}};
  for (const ClassifiedStratum& s : c.strata)
    if (s.status == StratumStatus::open)
      g.rows.push_back({where_text(c, s), joined(s.open_after, "; ")});
  return g;
}

bool proves_something(const SystemClassification& c) {
  return c.almost_all || std::ranges::any_of(c.strata, [](const auto& s) {
           return s.status != StratumStatus::open;
         });
}

// What is not decided is a step that is open.
std::optional<NodeResult> what_is_open(const SystemClassification& c) {
  Grid sets = open_sets(c);
  if (sets.rows.empty() || !proves_something(c)) return std::nullopt; // the whole is open
  NodeResult n;
  n.node.id = "open";
  n.node.kind = NodeKind::open_part;
  n.node.title = "What is open";
  n.statement = "nothing is decided here";
  n.status = NodeStatus::open;
  n.tables.push_back(std::move(sets));
  return n;
}

NodeResult root(const System& s, const SystemClassification& c) {
  NodeResult n;
  n.node.kind = NodeKind::case_file; // it has a verdict
  n.node.expect = "";                // and none is expected
  n.headline = headline(c);
  n.node.id = "theorem";
  n.node.title = "The theorem";
  n.statement = statement(c);
  n.statement.pop_back(); // the renderers end sentences themselves
  n.status = proves_something(c) ? NodeStatus::proved : NodeStatus::open;
  if (s.field.hamiltonian) n.formulas.push_back({"H", to_string(*s.field.hamiltonian)});
  if (!c.assumptions.empty()) n.formulas.push_back({"assumed", joined(c.assumptions, ", ")});
  for (const std::string& constant : c.constants)
    n.formulas.push_back({"where", constant});
  for (const std::string& variable : c.variables)
    if (variable.find(" = ") != std::string::npos) n.formulas.push_back({"where", variable});
  for (const std::string& note : sentences(c.notes))
    n.formulas.push_back({"note", note});
  if (Grid g = integrable_sets(c); !g.rows.empty()) n.tables.push_back(std::move(g));
  if (Grid g = excluded_sets(c); !g.rows.empty()) n.tables.push_back(std::move(g));
  if (Grid g = open_sets(c); n.status == NodeStatus::open && !g.rows.empty())
    n.tables.push_back(std::move(g));
  return n;
}

void add_theorems(NodeResult& n, const ExclusionReason& by) {
  for (const LiteratureTheorem* t : by.theorems)
    n.theorems.push_back(used(*t));
}

// " for b = 1", so that titles tell the steps apart; long sets stand in the table of the step.
std::string briefly(const std::vector<std::string>& where) {
  constexpr std::size_t longest = 30;
  return where.size() > 1 || where.front().size() > longest ? "" : " for " + where.front();
}

// The search expands the derivative of each integral that it returns, and their brackets.
NodeResult integrable(const SystemClassification& c, const ClassifiedStratum& s,
                      std::size_t number) {
  NodeResult n;
  const std::string where = where_text(c, s);
  n.node.id = "integrable-" + std::to_string(number);
  n.node.title = "Integrable" + briefly({where});
  n.statement = "integrable: as many independent first integrals" +
                std::string(c.liouville ? " in involution" : "") + " as needed";
  n.status = NodeStatus::proved;
  n.formulas.push_back({"parameters", where});
  for (const FoundIntegral& f : s.integrals) {
    if (f.hamiltonian) continue;
    const std::string text = to_string(f);
    n.formulas.push_back({"first integral", text});
    n.checks.push_back({"its derivative along the field vanishes: " +
                            (f.logarithms.empty() ? brief(f.value, 60) : text),
                        true});
  }
  for (const std::string& y : s.fields)
    n.checks.push_back(
        {"it commutes with the field, and the integrals are constant along it: " + y, true});
  return n;
}

NodeResult exclusion(const SystemClassification& c, const ExcludedTogether& e, std::size_t number) {
  const std::vector<std::string> all = texts_of(c, e.places);
  NodeResult n;
  n.node.id = "excluded-" + std::to_string(number);
  n.node.title = "Not integrable" + briefly(all) + ", along " + e.by->solution;
  n.statement = statement(*e.by);
  n.summary = e.by->reason;
  n.status = NodeStatus::proved;
  if (!e.by->unchecked.empty())
    n.node.hypotheses.push_back({.text = e.by->unchecked, .by = {}, .checked = false});
  if (!e.by->level.empty()) n.formulas.push_back({"level", sentence(e.by->level)});
  Grid g{"Excluded", {"parameters"}, {}};
  for (const std::string& where : all)
    g.rows.push_back({where});
  n.tables.push_back(std::move(g));
  add_theorems(n, *e.by);
  return n;
}

// "the minor of x, u has the coefficient m - 1 at y*v": of what the certificate shows.
std::string minor_in_words(const Json& minor, const System& s) {
  std::string columns, monomial;
  for (const Json& column : minor.at("columns"))
    columns += (columns.empty() ? "" : ", ") + column.get<std::string>();
  const Json& exponents = minor.at("monomial");
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    const std::string e = exponents[i].get<std::string>();
    if (e != "0")
      monomial += (monomial.empty() ? "" : "*") + s.field.name(i) + (e == "1" ? "" : "^" + e);
  }
  return "the minor of " + columns + " has the coefficient " +
         minor.at("value").get<std::string>() + (monomial.empty() ? "" : " at " + monomial) +
         ", which vanishes nowhere on the set";
}

// What "integrable" means there, and by which minors the judge sees it; what it does not see is on trust.
void tell_integrability(NodeResult& n, const Json& step, const System& s, bool liouville) {
  n.statement = liouville ? "On this set the system is integrable: these first integrals are in "
                            "involution and independent, and as many as half the rank of the "
                            "bracket beside its Casimir functions"
                          : "On this set the system is integrable: the fields commute with it and "
                            "with one another, the first integrals are constant along all of "
                            "them, and together they are as many as there are variables";
  n.summary.clear();
  const std::pair<const char*, const char*> shown[] = {
      {"independent", "the gradients of the integrals are independent"},
      {"rank", liouville ? "the rank of the bracket" : "the fields are independent"}};
  for (const auto& [key, what] : shown)
    if (step.at(key).is_object())
      n.checks.push_back({std::string(what) + ": " + minor_in_words(step.at(key), s), true});
}

// The steps as they were proved, each with what the search found there.
void take_steps(TheoremResult& t, const System& s, const TheoremResult& proved, bool liouville) {
  const Json bundle = Json::parse(proved.bundle);
  for (const NodeResult& n : proved.nodes) {
    if (n.node.kind == NodeKind::cover) continue;
    NodeResult& step = t.nodes.emplace_back(n);
    if (n.node.kind == NodeKind::case_file) step.summary = n.node.step;
    for (const Json& accepted : bundle.at("steps"))
      if (accepted.at("id") == n.node.id && accepted.at("rule") == "integrable")
        tell_integrability(step, accepted, s, liouville);
  }
}

void put_steps(TheoremResult& t, const SystemClassification& c) {
  for (const ClassifiedStratum& x : c.strata)
    if (x.status == StratumStatus::integrable) t.nodes.push_back(integrable(c, x, t.nodes.size()));
  for (const ExcludedTogether& e : excluded_together(c, ExcludedFor::the_same_reason))
    t.nodes.push_back(exclusion(c, e, t.nodes.size()));
  if (auto open = what_is_open(c)) t.nodes.push_back(*std::move(open));
}

} // namespace

TheoremResult as_theorem(const System& s, const SystemClassification& c,
                         const TheoremResult* proved) {
  TheoremResult t;
  t.theorem.file = s.file;
  t.theorem.title = s.title.empty() ? s.file : s.title;
  t.theorem.cite = s.cite;
  t.theorem.system = s.file.substr(folder_of(s.file).size());
  t.files = input_files(t.theorem);
  t.program = program_version() + " with " + libraries();
  t.seconds = c.seconds;
  t.nodes.push_back(root(s, c));
  if (proved != nullptr) {
    take_steps(t, s, *proved, c.liouville);
    t.bundle = proved->bundle;
    t.bundle_open = proved->bundle_open;
  } else {
    put_steps(t, c);
  }
  std::ranges::copy_if(c.trusted, std::back_inserter(t.nodes.front().trusted),
                       [known = t.trusted_steps()](const Trusted& step) {
                         return !is_among(sentence(step), known); // else a step has it
                       });
  for (std::size_t i = 1; i < t.nodes.size(); ++i)
    t.nodes.front().node.needs.push_back(t.nodes[i].node.id);
  t.found = true;
  for (NodeResult& n : t.nodes)
    for (std::string* text : {&n.statement, &n.summary, &n.node.title})
      *text = in_written_names(s, *text);
  settle_statuses(t);
  return t;
}

std::string classification_page(const System& s, const SystemClassification& c,
                                const std::string& format, const TheoremResult* proved) {
  const TheoremResult theorem = as_theorem(s, c, proved);
  return format == "tex" ? report::theorem_tex(theorem) : report::theorem_html(theorem);
}

} // namespace kov::cli
