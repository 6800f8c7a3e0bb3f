// kovacic classify FILE: for which parameters is the system integrable?

#include "classify/classify.hpp"
#include "classify/stage.hpp"
#include "decide/afterwards.hpp"
#include "study/proof_tree.hpp"

#include "commands.hpp"
#include "output/page_width.hpp"
#include "output/render.hpp"
#include "proofs/certificate_file.hpp"
#include "symbol/given_text.hpp"
#include "systems/classification_report.hpp"
#include "systems/classification_theorem.hpp"
#include "systems/mechanics.hpp"
#include "systems/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <sstream>

namespace kov::cli {
namespace {

// The rest is for the answer, when the work has to end by itself, and for the proof of a certificate.
constexpr double part_of_the_search = 0.95, part_before_a_proof = 0.85;
constexpr double least_part_of_another_run = 0.1;

void put_wide(std::ostream& out, const std::string& name, const std::string& text) {
  out << "  " << fmt::format("{:<12}", name) << wrapped(text, 14) << '\n';
}
void put_below(std::ostream& out, const std::string& text) {
  out << "              " << wrapped(text, 16) << '\n';
}

constexpr std::size_t five_lines = 430, two_lines = 170;
constexpr long most_open = 10;         // lines
constexpr long most_lines = 36;        // with all reasons; fewer lines follow
constexpr std::size_t most_shown = 12; // of the strata with one status, of the reasons to exclude
const std::string too_few = "first integrals, too few: ";

// The beginning of what would fill a page.
std::string beginning(const std::string& text, bool all) {
  if (all || text.size() <= five_lines) return text;
  return text.substr(0, five_lines) + " ... (--verbose shows the rest)";
}

// Many sets with long conditions fill pages, and the theorem says "elsewhere".
std::string some_of(const std::vector<std::string>& sets, bool all) {
  std::string text;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::string next = (i == 0 ? "" : "; or ") + sets[i];
    if (!all && text.size() + next.size() > five_lines) {
      if (i == 0) return beginning(next, all);
      return text + "; or " + std::to_string(sets.size() - i) + " more (--verbose names them)";
    }
    text += next;
  }
  return text;
}

// The integrals of a stratum; those that would fill the screen by what they are.
std::string shown_integrals(const ClassifiedStratum& x, bool verbose) {
  ClassifiedStratum brief = x;
  std::size_t long_ones = 0;
  long degree = 0;
  if (!verbose)
    long_ones = std::erase_if(brief.integrals, [&](const FoundIntegral& f) {
      const bool is_long = !f.hamiltonian && to_string(f).size() > five_lines;
      if (is_long) degree = std::max(degree, f.degree);
      return is_long;
    });
  std::string text = integrals_text(brief);
  if (long_ones > 0)
    text += (text.empty() ? "" : ", ") +
            (long_ones == 1 ? std::string("one") : std::to_string(long_ones)) +
            fmt::format(" of degree {} in the momenta (--verbose shows {})", degree,
                        long_ones == 1 ? "it" : "them");
  return text;
}

// A line for a set of parameters and what is said of it, or, in a system without parameters, one line.
void put_set(const SystemClassification& c, const std::string& status, const std::string& where,
             std::vector<std::string> said, std::ostream& out) {
  if (!c.no_parameters || where != "all parameters")
    put_wide(out, status, where);
  else if (!said.empty()) {
    put_wide(out, status, said.front());
    said.erase(said.begin());
  }
  for (const std::string& line : said)
    put_below(out, line);
}

void print_all(const SystemClassification& c, StratumStatus status, bool verbose,
               std::ostream& out) {
  auto all = alike(c, status);
  const std::size_t special = std::ranges::count_if(all, &Alike::special);
  if (!verbose && special > 1) std::erase_if(all, std::mem_fn(&Alike::special));
  const std::size_t shown = verbose ? all.size() : std::min(all.size(), most_shown);
  for (std::size_t i = 0; i < shown; ++i) {
    std::vector<std::string> said;
    if (const std::string with = shown_integrals(*all[i].first, verbose); !with.empty())
      said.push_back((status == StratumStatus::open ? too_few : "with ") + with);
    for (const std::string& tried : all[i].first->open_after)
      said.push_back(beginning(tried, verbose));
    put_set(c, to_string(status), some_of(all[i].where, verbose), std::move(said), out);
  }
  if (shown < all.size())
    put_wide(out, to_string(status),
             std::to_string(all.size() - shown) + " more (--verbose names them)");
  if (!verbose && special > 1)
    put_wide(out, to_string(status),
             std::to_string(special) +
                 " special sets among these, with other integrals (--verbose names them)");
}

// Where nothing is decided, and what was found and tried on the first of these sets.
std::string open_in_brief(const SystemClassification& c) {
  std::ostringstream out;
  const auto all = alike(c, StratumStatus::open);
  std::string tried = joined(all.front().first->open_after, "; ");
  if (tried.size() > two_lines) tried = tried.substr(0, two_lines) + " ...";
  std::vector<std::string> said;
  for (const Alike& a : all)
    if (said.empty() && !a.first->integrals.empty())
      said.push_back((all.size() == 1 ? "" : "where " + some_of(a.where, false) + ": ") + too_few +
                     shown_integrals(*a.first, false));
  said.push_back((tried.empty() ? "" : "tried: " + tried + "; ") +
                 "--verbose lists all that was tried");
  put_set(c, "open", some_of(places(c, {StratumStatus::open}), false), std::move(said), out);
  return out.str();
}

// One set as it is; of several, which would fill a page, where they are.
std::string open_sets(const SystemClassification& c, bool verbose) {
  std::ostringstream out;
  print_all(c, StratumStatus::open, verbose, out);
  const std::string full = out.str();
  return verbose || std::ranges::count(full, '\n') <= most_open ? full : open_in_brief(c);
}

// The strata that one equation excludes, together.
std::string excluded_in_full(const SystemClassification& c,
                             const std::vector<ExcludedTogether>& all, bool verbose) {
  std::ostringstream out;
  const std::size_t shown = verbose ? all.size() : std::min(all.size(), most_shown);
  for (std::size_t i = 0; i < shown; ++i) {
    put_set(c, "excluded", some_of(texts_of(c, all[i].places), verbose), {reason_of(*all[i].by)},
            out);
  }
  if (shown < all.size())
    put_wide(out, "excluded",
             "more sets, for " + std::to_string(all.size() - shown) +
                 " further reasons (--verbose names them)");
  return out.str();
}

// The strata that are excluded along the same curve, at the same order; the theorem says "elsewhere".
std::string excluded_in_brief(const SystemClassification& c) {
  std::ostringstream out;
  bool all_named = true;
  bool carried = false;
  for (const ExcludedTogether& e : excluded_together(c, ExcludedFor::the_same_curve)) {
    if (e.by->carried) {
      carried = true; // how many there are says nothing
      continue;
    }
    const auto texts = texts_of(c, e.places);
    const std::string where = joined(texts, "; or ");
    const bool named = where.size() <= two_lines;
    all_named = all_named && named;
    put_set(c, "excluded",
            named               ? where
            : texts.size() == 1 ? "one set with many conditions"
                                : std::to_string(texts.size()) + " sets",
            {"along " + e.by->solution +
             (e.by->order > 1 ? ", at order " + std::to_string(e.by->order) : "")},
            out);
  }
  if (carried) {
    all_named = false;
    put_wide(out, "excluded", "all sets that a symmetry or a rotation maps to one of these");
  }
  put_wide(out, "more",
           all_named ? "--verbose says why each set is excluded"
                     : "--verbose names each set and says why it is excluded");
  return out.str();
}

long lines_of(const std::string& text) { return std::ranges::count(text, '\n'); }

// With all reasons, unless that would be too long beside what is there already: two lines at least for each.
std::string excluded_sets(const SystemClassification& c, long before, bool verbose) {
  const auto all = excluded_together(c, ExcludedFor::the_same_reason);
  const auto least = static_cast<long>(2 * std::min(all.size(), most_shown));
  if (!verbose && before + least > most_lines) return excluded_in_brief(c);
  const std::string full = excluded_in_full(c, all, verbose);
  return verbose || before + lines_of(full) <= most_lines ? full : excluded_in_brief(c);
}

// The limit that ended a part of the work, four times as large; empty: another run says the same.
std::string larger_limit(const SystemClassification& c, const Settings& settings) {
  if (!c.complete)
    return settings.timeout > 0 ? fmt::format("--timeout {:g}", 4 * settings.timeout) : "";
  const auto ends_by_work = [](const std::vector<std::string>& texts) {
    return std::ranges::any_of(texts, [](const std::string& text) {
      return text.find("work limit of ") != std::string::npos;
    });
  };
  const bool is_limited = ends_by_work(sentences(c.notes)) ||
                          std::ranges::any_of(c.strata, [&](const ClassifiedStratum& x) {
                            return ends_by_work(x.open_after);
                          });
  if (!is_limited) return "";
  std::string more = fmt::format("{:g}", 4 * settings.max_work);
  if (const auto plus = more.find("e+0"); plus != std::string::npos) more.replace(plus, 3, "e");
  return "--max-work " + more;
}

// What to type where something is open.
std::string next_step(const System& s, const SystemClassification& c, const Settings& settings) {
  const std::string more = larger_limit(c, settings);
  if (settings.given)
    return (more.empty() ? "" : "the same command with " + more + "; ") +
           "kovacic new writes a file that can name a [[manifold]] and be drawn (kovacic "
           "section)";
  return (more.empty() ? "" : "kovacic classify " + s.file + " " + more + ", ") +
         "a [[manifold]] in the file, or kovacic section for a picture";
}

// "along q1 = 0 [no certificate: another Hamiltonian]": the reasons stand with what is excluded.
std::string in_short(const std::string& step) {
  const auto at = step.rfind(" [no certificate: ");
  std::string text = step.substr(0, at), why = at == std::string::npos ? "" : step.substr(at);
  text = text.substr(0, text.find("; along "));
  if (text.starts_with("along ")) text = text.substr(0, text.find(": "));
  if (why.size() > two_lines) why = why.substr(0, two_lines) + " ...]";
  return text + why;
}

// What Z3 says of many sets is counted, unless all is asked for.
std::string trusted_text(const std::vector<Trusted>& all, bool verbose) {
  constexpr long few = 2;
  const long by_z3 = std::ranges::count_if(all, [](const Trusted& t) { return t.by_z3(); });
  std::vector<std::string> told;
  for (const Trusted& t : all)
    if (verbose || by_z3 <= few || !t.by_z3())
      told.push_back(verbose ? sentence(t) : in_short(sentence(t)));
  std::vector<std::string> each;
  for (const std::string& text : told) {
    const auto times = std::ranges::count(told, text);
    add_once(each, text + (times > 1 ? " (" + std::to_string(times) + " times)" : ""));
  }
  if (!verbose && by_z3 > few)
    each.push_back("that " + std::to_string(by_z3) + " sets have no real points (Z3)");
  return std::to_string(all.size()) + (all.size() == 1 ? " step: " : " steps: ") +
         beginning(joined(each, "; "), verbose);
}

std::string text_of(const System& s, const SystemClassification& c, const Settings& settings) {
  const bool quiet = settings.quiet, verbose = settings.verbose > 0;
  const bool open = c.status() == Verdict::undecided;
  std::ostringstream out;
  out << heading(s.file, s.title) << "\n  " << painted(headline(c), meaning_of(c.status())) << '\n';
  put_wide(out, open ? "so far" : "theorem", statement(c));
  if (!c.assumptions.empty()) put_wide(out, "assumed", joined(c.assumptions, ", "));
  for (const std::string& constant : c.constants)
    put_wide(out, "where", constant);
  for (const std::string& root : named_roots(s))
    put_wide(out, "function", root);
  const bool are_told =
      std::ranges::any_of(c.excluded, [](const IntegralClass& x) { return !x.frame.empty(); });
  if (!are_told && !c.variables.empty()) // else the theorem names them
    put_wide(out, "where", joined(c.variables, ", "));
  for (const std::string& note : sentences(c.notes))
    put_wide(out, "note", note);
  if (!quiet) {
    if (c.almost_all) {
      put_wide(out, "almost all", "proved at " + c.almost_all->at);
      put_below(out, reason_of(c.almost_all->by));
    }
    print_all(c, StratumStatus::integrable, verbose, out);
    out << open_sets(c, verbose);
    out << excluded_sets(c, lines_of(out.str()), verbose);
  }
  if (open) put_wide(out, "next", next_step(s, c, settings));
  if (!c.theorems.empty()) put_wide(out, "by", joined(theorem_names(c.theorems), ", "));
  if (!c.trusted.empty()) put_wide(out, "trusted", trusted_text(c.trusted, verbose));
  if (verbose)
    for (const Spent& spent : c.spent)
      put_wide(out, "spent",
               fmt::format("{:.2g} units ({:.1f} ms)  {}", spent.work, 1000 * spent.seconds,
                           spent.task));
  return with_written_roots(s, out.str());
}

Json almost_all(const SystemClassification& c) {
  if (!c.almost_all) return nullptr;
  const ExclusionReason& by = c.almost_all->by;
  return {{"at", c.almost_all->at},
          {"solution", by.solution},
          {"level", text_or_null(sentence(by.level))},
          {"reason", by.reason},
          {"integrals_class", sentence(by.integrals)},
          {"trusted", sentences(by.trusted)}};
}

Json as_json(const System& s, const SystemClassification& c, const study::Headline& h) {
  Json j{{"format", "kovacic-classification/1"},
         {"file", s.file},
         {"status", status_word(c.status())},
         {"verdict", to_string(h.verdict)},
         {"statement", statement(c)},
         {"almost_all", almost_all(c)},
         {"integrals_class", c.excluded.empty() ? Json(nullptr) : Json(integrals_class(c))},
         {"assumptions", c.assumptions},
         {"constants", c.constants},
         {"variables", c.variables},
         {"theorems", theorem_names(c.theorems)},
         {"trusted", sentences(c.trusted)},
         {"notes", sentences(c.notes)},
         {"strata", strata_json(c)},
         {"complete", c.complete},
         {"work", std::llround(meter())},
         {"seconds", c.seconds}};
  put_written_names(s, j);
  return j;
}

} // namespace

namespace {

/// What is told while the work goes on.  Words for many strata cost much: they may take a tenth of the
/// work, and else the last ones are told again, with the stage that begins.
class SoFarReports {
public:
  template <class Write> const Report& next(const SystemClassification& c, Write write) {
    const double begin = meter();
    if (!last_ || writing_ < part_ * (begin - start_)) {
      last_ = write();
      writing_ += meter() - begin;
    }
    last_->at_work = c.at_work;
    return *last_;
  }

private:
  static constexpr double part_ = 0.1;
  double start_ = meter();
  double writing_ = 0;
  std::optional<Report> last_;
};

/// One run; a second one without the stage that has ended the first before its time (a crash, the memory).
class Classification {
public:
  Classification(const Settings& settings, const ClassifyArguments& arguments)
      : settings_(settings), arguments_(arguments), format_(settings.format) {}

  Report run() {
    const auto start = Budget::Clock::now();
    Report report = run_for(settings_.timeout, {});
    const bool crashed = report.exit == exit_internal;
    if (crashed && !proves_something(report.json))
      return {exit_internal, "", nullptr}; // it was told
    if (report.json.is_object() && report.json.contains("is_searched"))
      return without_proof(report);
    const bool cut_short = !report.limit.empty(); // a second run leaves something out
    if (cut_short && report.exit != exit_interrupted)
      if (const std::string stage = report.at_work; !stage.empty())
        if (const auto left = time_for_another(start))
          if (Report again = run_for(*left, {stage});
              again.exit != exit_internal && again.json.contains("strata"))
            report = std::move(again);
    if (!report.limit.empty()) {
      if (!report.json.contains("strata")) report = nothing_known(report);
      tell_limit(report);
    }
    if (cut_short) report.json["complete"] = false;
    if (crashed) report.exit = exit_internal; // what is proved is shown all the same
    return report;
  }

private:
  // The limit came after the search: nothing more is open by it.
  Report without_proof(Report report) const {
    report.json.erase("is_searched");
    if (!asks_for_proofs()) return report;
    report.json["certificate"] = {{"file", nullptr}, {"none", report.limit}};
    std::ostringstream out;
    if (format_ == "text") put_wide(out, "certificate", "no certificate: " + report.limit);
    report.text += out.str();
    return report;
  }

  static bool proves_something(const Json& report) {
    if (!report.is_object() || !report.contains("strata")) return false;
    const Json& strata = report.at("strata");
    return std::ranges::any_of(
        strata, [](const Json& s) { return s.at("status") != to_string(StratumStatus::open); });
  }

  // 0: without a limit.  Unset: nothing that is worth a run.
  [[nodiscard]] std::optional<double> time_for_another(Budget::Clock::time_point start) const {
    if (!(settings_.timeout > 0)) return 0;
    const std::chrono::duration<double> spent = Budget::Clock::now() - start;
    const double left = settings_.timeout - spent.count();
    return left > least_part_of_another_run * settings_.timeout ? std::optional(left)
                                                                : std::nullopt;
  }

  Report run_for(double seconds, const std::vector<std::string>& skip) {
    Settings inner = settings_;
    inner.timeout = seconds;
    return supervised(inner, arguments_.file, [&](const FileWorker::SoFar& so_far) {
      const System s = read_system(inner.document(arguments_.file), parameter_values(inner));
      ClassifyOptions options;
      options.check.decide = inner.solver_options();
      options.check.decide.budget =
          inner.search_budget(can_be_proved_again() ? part_before_a_proof : part_of_the_search);
      options.check.decide.budget.give_by_default();
      options.check.decide.ask_the_judge = true;
      if (arguments_.degree > 0) options.degree = options.degree_at_points = arguments_.degree;
      if (settings_.order > 0) options.order = settings_.order;
      options.search_solutions = !arguments_.only_file;
      options.skip = skip;
      SoFarReports reports;
      options.so_far = [&](SystemClassification c) {
        if (format_ == "tex" || format_ == "html")
          c.notes.push_back({ClassificationNote::What::unfinished});
        so_far(reports.next(c, [&] { return report_of(s, c); }));
      };
      SystemClassification c = classify_system(s, options);
      Report report = report_of(s, c);
      if (can_be_proved_again() && (proves_something(report.json) || asks_for_proofs())) {
        report.json["is_searched"] = true; // a limit of what follows does not cost the answer
        so_far(report);
        report.json.erase("is_searched");
        prove_again(settings_, arguments_, s, c, report,
                    [&](const TheoremResult* proved) { return report_of(s, c, proved); });
      }
      return report;
    });
  }

  // The system is read again, as it is.
  [[nodiscard]] bool can_be_proved_again() const {
    return parameter_values(settings_).empty() && settings_.assume.empty() &&
           (is_given(arguments_.file) || std::filesystem::is_regular_file(arguments_.file));
  }
  [[nodiscard]] bool asks_for_proofs() const {
    return !arguments_.as_theorem.empty() || !settings_.certificate.empty();
  }

  // A limit came before the first stage, perhaps while the file was read: all parameters are open.
  Report nothing_known(const Report& stopped) const {
    System s;
    s.file = arguments_.file;
    Report report = report_of(s, SystemClassification{});
    report.exit = stopped.exit;
    report.limit = stopped.limit;
    report.json["strata"].push_back({{"conditions", Json::array()},
                                     {"status", to_string(StratumStatus::open)},
                                     {"integrals", Json::array()},
                                     {"fields", Json::array()},
                                     {"by", Json::array()},
                                     {"open_after", Json::array()}});
    std::ostringstream out;
    if (format_ == "text")
      put_wide(out, to_string(StratumStatus::open),
               "everything (the limit came before the search)");
    report.text += out.str();
    return report;
  }

  Report report_of(const System& s, const SystemClassification& c,
                   const TheoremResult* proved = nullptr) const {
    const study::Headline h = study::headline(c);
    return {h.verdict == Verdict::undecided ? exit_undecided : exit_decided,
            format_ == "tex" || format_ == "html" ? classification_page(s, c, format_, proved)
                                                  : text_of(s, c, settings_),
            as_json(s, c, h)};
  }

  // The answer is that of a moment before the limit.
  void tell_limit(Report& report) const {
    const bool of_time = report.limit.starts_with("time"); // of the first run: the whole is told
    const std::string note = (of_time ? Budget::time_limit(settings_.timeout) : report.limit) +
                             ": what was proved before is shown, and the rest counts as open";
    report.json["notes"].push_back(note);
    if (format_ != "text") return;
    std::ostringstream out;
    put_wide(out, "note", note);
    report.text += out.str();
  }

  const Settings& settings_;
  const ClassifyArguments& arguments_;
  std::string format_;
};

} // namespace

namespace {

constexpr double seconds_of_a_unit = 1e-8;

std::string time_of(double work) {
  const double seconds = seconds_of_a_unit * work;
  return seconds < 0.1 ? "" : fmt::format("{:.2g} s", seconds);
}

std::string plan(const Settings& settings) {
  Budget budget;
  budget.max_work = settings.max_work;
  budget.give_by_default();
  std::ostringstream out;
  out << fmt::format(
             "At most about {} in all; --max-work {:.0e} is four times as much.  A part that ends "
             "leaves its time to the rest.\n",
             time_of(budget.work), 4 * budget.max_work)
      << "\nThe question in parts, each with at most:\n";
  for (const auto& [what, part] : parts_of_the_whole())
    out << fmt::format("  {:>7}  {}\n", time_of(part * budget.work), what);
  out << "\nOne round, on the parameters that are open, if it had all of this time; each step with "
         "at "
         "most\n(no time: what is known, or some hundredths of a second):\n";
  double left = budget.work;
  for (const Stage& stage : strategy()) {
    out << fmt::format("  {:>7}  {}\n", time_of(stage.part * left), stage.name);
    left -= stage.part < 1 ? stage.part * left : 0;
  }
  return out.str();
}

} // namespace

namespace {

// Before the search, not after it.  A file that the user has not named is not replaced by another one.
void need_places_to_write(const Settings& settings, const ClassifyArguments& arguments) {
  constexpr std::size_t most = std::size_t{16} << 20;
  if (is_given(arguments.file) && !arguments.as_theorem.empty())
    if (const std::string path = system_file_beside(arguments.as_theorem);
        std::filesystem::exists(path) &&
        read_text(path, most) != read_text(for_children(arguments.file), most))
      throw InputError(path, 0, 0, 1, "there is another file where the system is to be written",
                       "remove it, or give the theorem file another name");
  for (const std::string& path : {arguments.as_theorem, settings.certificate}) {
    if (path.empty()) continue;
    const auto folder = std::filesystem::path(path).parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder))
      throw InputError(path, 0, 0, 1, "there is no directory " + folder.string());
    if (std::filesystem::is_directory(path))
      throw InputError(path, 0, 0, 1, "a directory, and one file is written");
    if (!is_given(arguments.file) && !std::filesystem::is_regular_file(arguments.file))
      throw InputError(arguments.file, 0, 0, 1, "a pipe is read once, and this is read again",
                       "write the system into a file first");
    if (!parameter_values(settings).empty())
      throw InputError(path, 0, 0, 1, "it would be about the file without the values of --set",
                       "write them into the file: [set]");
    if (!settings.assume.empty())
      throw InputError(path, 0, 0, 1, "it would be about the file without what --assume says",
                       "write it into the file: [assume]");
  }
}

} // namespace

int classify(const Settings& settings, const ClassifyArguments& arguments) {
  if (arguments.plan) {
    write_output(settings, plan(settings));
    return exit_decided;
  }
  need_places_to_write(settings, arguments);
  const Report report = Classification(settings, arguments).run();
  write_output(settings, settings.format == "json" && report.json.is_object()
                             ? indented(report.json)
                             : report.text);
  return report.exit;
}

} // namespace kov::cli
