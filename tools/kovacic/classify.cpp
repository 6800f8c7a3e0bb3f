// kovacic classify FILE: for which parameters is the system integrable?

#include "classify/classify.hpp"

#include "commands.hpp"
#include "mechanics.hpp"
#include "render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace kov::cli {
namespace {

// What is left for the answer when the work has to end by itself.
constexpr double part_of_the_time = 0.8;

using Strata = std::vector<ClassifiedStratum>;

std::string joined(const std::vector<std::string>& all, const std::string& between) {
  std::string text;
  for (const std::string& one : all)
    text += (text.empty() ? "" : between) + one;
  return text;
}

std::string where_text(const SystemClassification& c, const ClassifiedStratum& s) {
  const std::string text = joined(conditions(c, s), ", ");
  return text.empty() ? "all parameters" : text;
}

std::size_t count(const SystemClassification& c, StratumStatus status) {
  return static_cast<std::size_t>(
      std::count_if(c.strata.begin(), c.strata.end(),
                    [&](const ClassifiedStratum& s) { return s.status == status; }));
}

// "(a), or (b)"
std::string alternatives(const SystemClassification& c, const std::vector<StratumStatus>& wanted) {
  const auto all = places(c, wanted);
  std::string text;
  for (const std::string& one : all)
    text += (text.empty() ? "" : ", or ") + (all.size() > 1 ? "(" + one + ")" : one);
  return text;
}

std::string kind_of(const SystemClassification& c) {
  const std::string first =
      "first integrals " + std::string(c.liouville ? "" : "and commuting vector fields ");
  return first + "that are " + integrals_class(c);
}

// The statement of the theorem, as one sentence.
std::string statement(const SystemClassification& c) {
  switch (c.status()) {
  case ClassificationStatus::integrable:
    return "The system is integrable for all parameters.";
  case ClassificationStatus::non_integrable:
    return "The system is not integrable with " + kind_of(c) + ".";
  case ClassificationStatus::depends:
    return "The system is integrable exactly for " + alternatives(c, {StratumStatus::integrable}) +
           "; elsewhere it is not integrable with " + kind_of(c) + ".";
  default:
    break;
  }
  if (count(c, StratumStatus::excluded) == 0) return "No parameters are excluded.";
  return "If the system is integrable with " + kind_of(c) + ", then " +
         alternatives(c, {StratumStatus::integrable, StratumStatus::open}) + ".";
}

std::string title_of(ClassificationStatus s) {
  switch (s) {
  case ClassificationStatus::integrable:
    return "INTEGRABLE";
  case ClassificationStatus::non_integrable:
    return "NON-INTEGRABLE";
  case ClassificationStatus::depends:
    return "DEPENDS ON THE PARAMETERS";
  default:
    return "OPEN";
  }
}

void put(std::ostream& out, const std::string& name, const std::string& text) {
  out << "  " << fmt::format("{:<12}", name) << wrapped(text, 14) << '\n';
}
void put_below(std::ostream& out, const std::string& text) {
  out << "              " << wrapped(text, 16) << '\n';
}

std::string reason_of(const ExclusionReason& o) {
  return "along " + o.solution + (o.level.empty() ? "" : " (" + o.level + ")") + ": " + o.reason;
}

void print(const SystemClassification& c, const ClassifiedStratum& s, std::ostream& out) {
  put(out, to_string(s.status), where_text(c, s));
  std::string with;
  for (const FoundIntegral& f : s.integrals)
    with += (with.empty() ? "with " : ", ") + (f.hamiltonian ? "H" : to_string(f.value));
  if (!with.empty()) put_below(out, with);
  for (const std::string& tried : s.open_after)
    put_below(out, tried);
}

// The strata that one equation excludes, together.
void print_excluded(const SystemClassification& c, std::ostream& out) {
  std::vector<std::string> told;
  for (const ClassifiedStratum& s : c.strata) {
    if (s.status != StratumStatus::excluded) continue;
    const std::string reason = reason_of(s.by.front());
    if (std::find(told.begin(), told.end(), reason) != told.end()) continue;
    told.push_back(reason);
    std::string where;
    for (const ClassifiedStratum& x : c.strata)
      if (x.status == StratumStatus::excluded && reason_of(x.by.front()) == reason)
        where += (where.empty() ? "" : "; or ") + where_text(c, x);
    put(out, "excluded", where);
    put_below(out, reason);
  }
}

std::string text_of(const System& s, const SystemClassification& c, bool quiet, bool verbose) {
  std::ostringstream out;
  out << s.file << (s.title.empty() ? "" : "  " + s.title) << "\n  " << title_of(c.status())
      << '\n';
  put(out, "theorem", statement(c));
  if (!c.assumptions.empty()) put(out, "assumed", joined(c.assumptions, ", "));
  for (const std::string& note : c.notes)
    put(out, "note", note);
  if (!quiet)
    for (const ClassifiedStratum& x : c.strata)
      if (x.status != StratumStatus::excluded) print(c, x, out);
  if (!quiet) print_excluded(c, out);
  if (!c.theorems.empty()) put(out, "by", joined(c.theorems, ", "));
  if (!c.trusted.empty())
    put(out, "trusted",
        std::to_string(c.trusted.size()) + (c.trusted.size() == 1 ? " step: " : " steps: ") +
            joined(c.trusted, "; "));
  if (verbose)
    for (const auto& [stage, seconds] : c.stages)
      put(out, "time", fmt::format("{:.1f} ms  {}", 1000 * seconds, stage));
  return out.str();
}

Json json_of(const SystemClassification& c, const ClassifiedStratum& s) {
  Json integrals = Json::array();
  for (const FoundIntegral& f : s.integrals)
    integrals.push_back({{"value", to_string(f.value)},
                         {"kind", f.hamiltonian ? "hamiltonian"
                                  : f.casimir   ? "casimir"
                                                : "integral"}});
  Json by = Json::array();
  for (const ExclusionReason& o : s.by)
    by.push_back({{"solution", o.solution},
                  {"order", o.order},
                  {"level", o.level.empty() ? Json(nullptr) : Json(o.level)},
                  {"reason", o.reason},
                  {"integrals_class", to_string(o.integrals)}});
  return {{"conditions", conditions(c, s)},
          {"status", to_string(s.status)},
          {"integrals", integrals},
          {"by", by},
          {"open_after", s.open_after}};
}

Json json_of(const System& s, const SystemClassification& c) {
  Json strata = Json::array();
  for (const ClassifiedStratum& x : c.strata)
    strata.push_back(json_of(c, x));
  return {{"format", "kovacic-classification/1"},
          {"file", s.file},
          {"status", to_string(c.status())},
          {"statement", statement(c)},
          {"integrals_class", c.excluded ? Json(integrals_class(c)) : Json(nullptr)},
          {"assumptions", c.assumptions},
          {"theorems", c.theorems},
          {"trusted", c.trusted},
          {"notes", c.notes},
          {"strata", strata},
          {"seconds", c.seconds}};
}

} // namespace

int classify(const Settings& settings, const ClassifyArguments& arguments) {
  const Report report = supervised(settings, arguments.file, [&] {
    const System s = read_system(arguments.file, parameter_values(settings));
    Settings inner = settings;
    inner.timeout *= part_of_the_time;
    ClassifyOptions options;
    options.check.decide = inner.solver_options();
    options.check.decide.ask_the_judge = true;
    options.degree = arguments.degree;
    options.search_solutions = !arguments.only_file;
    const SystemClassification c = classify_system(s, options);
    return Report{c.status() == ClassificationStatus::open ? exit_undecided : exit_decided,
                  text_of(s, c, settings.quiet, settings.verbose > 0), json_of(s, c)};
  });
  write_output(settings,
               settings.format == "json" && !report.json.is_null()
                   ? report.json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
                   : report.text);
  return report.exit;
}

} // namespace kov::cli
