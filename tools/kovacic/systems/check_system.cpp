// kovacic check on a system file: claims, then one verdict per manifold and set of values, and of
// several manifolds the one that they give together.  All of it is lib/study; here it is asked for in
// a child process, piece by piece, so that a limit or a crash costs one piece only.

#include "commands.hpp"
#include "decide/afterwards.hpp"
#include "equations/second_opinion.hpp"
#include "study/expect.hpp"
#include "symbol/given_text.hpp"
#include "systems/case_file.hpp"
#include "systems/mechanics.hpp"
#include "systems/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <sstream>

namespace kov::cli {
namespace {

using study::Headline;

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
    options_.check.decide = settings_.solver_options(); // its clock begins here
    options_.check.decide.ask_the_judge = true;
    options_.check.only_manifold = settings_.manifold;
    options_.order = std::max(settings_.order, 1);
    if (!document_) read();
    if (what == "plan") return plan();
    if (what == "claims") return claims(rounds_.at(round));
    if (what == "together") return all_together(rounds_.at(round), words, manifold);
    return study(rounds_.at(round), manifold, what == "manifold");
  }

private:
  struct Round {
    ParameterValues values;
    study::FileStudy file;
  };

  void read() {
    document_ = settings_.document(path_);
    base_ = parameter_values(settings_);
    for (const ParameterValues& values : study::rounds(read_system(*document_, base_), base_))
      rounds_.push_back({values, study::FileStudy(*document_, values)});
  }

  std::vector<const SystemExpectation*> expectations_of(Round& round) {
    std::vector<const SystemExpectation*> all;
    for (const auto& x : round.file.system().expectations)
      if (x.where == round.values || (round.values == base_ && x.where.empty())) all.push_back(&x);
    return all;
  }

  Report plan() {
    Json all = Json::array();
    for (Round& round : rounds_) {
      const System& s = round.file.system();
      Json one{
          {"result", json_of_round(s)}, {"manifolds", Json::array()}, {"expected", Json::array()}};
      for (const ManifoldSpec* m : study::manifolds_to_check(s, options_.check))
        one["manifolds"].push_back({{"name", m->name}, {"title", title_of_manifold(s, m->name)}});
      for (const SystemExpectation* x : expectations_of(round))
        one["expected"].push_back(study::describe(*x));
      all.push_back(std::move(one));
    }
    return {exit_decided, "", all, {}};
  }

  Report claims(Round& round) {
    const System& s = round.file.system();
    Report report{exit_decided, "", json_of_claims(s, round.file.claims(options_.check)), {}};
    const bool none = !settings_.no_manifolds.empty(); // that could be studied
    if (s.manifolds.empty())
      report.text = heading(s.file, s.title) + "\n" + (none ? "  UNDECIDED\n" : "") +
                    labelled("note", "no [[manifold]] is given; " +
                                         (none ? settings_.no_manifolds
                                               : "kovacic find-manifolds proposes some"));
    return report;
  }

  // with_claims: not after a limit ended their job.
  Report study(Round& round, std::size_t index, bool with_claims) {
    const study::CurveStudy& m = round.file.manifold(index, options_, with_claims);
    const System& s = round.file.studied(options_.check);
    Report answer{exit_decided, text_of(s, m, detail_of(round)), {{"manifold", json_of(s, m)}}, {}};
    answer.json["headline"] = nlohmann::json(m.headline);
    std::vector<NamedCertificate> proofs;
    if (!settings_.certificate.empty())
      do_part(answer, "the certificates", [&] { proofs = study::certificates(s, m); });
    if (settings_.second_opinion)
      do_part(answer, "the second opinion", [&] { ask_monodromy(s, m.first, answer, proofs); });
    if (!settings_.certificate.empty()) file_certificates(settings_, s, proofs, answer);
    answer.json["unmet"] = Json::array(); // null: the expectation is about another one
    for (const SystemExpectation* x : expectations_of(round))
      answer.json["unmet"].push_back(x->manifold.empty() || x->manifold == m.name()
                                         ? Json(study::unmet(*x, {&m, 1}))
                                         : Json(nullptr));
    return answer;
  }

  // Behind the verdict: a limit or an error costs this part only.
  static void do_part(Report& answer, const char* part, const std::function<void()>& work) {
    const std::string missing = failure_or_limit_of(part, work);
    if (missing.empty()) return;
    answer.json.at("manifold")["failed"].push_back(missing);
    answer.text += labelled("failed", missing);
  }

  // "together ROUND 1 MANIFOLD...": of those manifolds on which the work came to its end.
  Report all_together(Round& round, std::istream& others, std::size_t with_claims) {
    const std::vector<std::size_t> all{std::istream_iterator<std::size_t>(others), {}};
    const SystemClassification c = round.file.together(all, options_, with_claims != 0);
    Headline whole = study::headline(round.file.tree());
    const System& s = round.file.studied(options_.check);
    if (whole.verdict != Verdict::non_integrable &&
        all.size() < study::manifolds_to_check(s, options_.check).size())
      whole.verdict = Verdict::undecided;
    const Detail detail = detail_of(round);
    return {exit_decided,
            detail == Detail::nothing ? "" : text_of(s, c, whole.verdict, detail),
            {{"together", json_of_together(c)}, {"headline", nlohmann::json(whole)}},
            {}};
  }

  // Rounds after the first are there for what the file expects of them.
  [[nodiscard]] Detail detail_of(const Round& round) const {
    if (settings_.verbose > 0 || settings_.trace) return Detail::whole;
    const bool only_expected =
        &round != &rounds_.front() && settings_.certificate.empty() && !settings_.second_opinion;
    return only_expected ? Detail::nothing : settings_.quiet ? Detail::headline : Detail::brief;
  }

  void ask_monodromy(const System& s, const ManifoldReport& m, Report& answer,
                     std::vector<NamedCertificate>& proofs) const {
    Json& all = answer.json.at("manifold")["second_opinion"] = Json::array();
    for (const SecondOpinion& o :
         second_opinion(s, m, options_.check.decide.budget, !settings_.certificate.empty())) {
      answer.text += labelled("monodromy", o.json.at("text").get<std::string>());
      all.push_back(o.json);
      if (!o.proof.json.empty() || !o.proof.none.empty()) proofs.push_back(o.proof);
    }
  }

  const Settings& settings_;
  std::string path_;
  std::optional<Entry> document_;
  ParameterValues base_;
  study::StudyOptions options_;
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
    if (!plan.limit.empty()) return {plan.text, plan.json, {}, plan.exit}; // no answer
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
    const std::size_t begin = report_.text.size();
    std::vector<Expected> expected;
    for (const Json& name : plan.at("expected"))
      expected.push_back({name, false, "the file has no such manifold", false});
    std::string studied;
    std::vector<Headline> each;
    for (std::size_t k = 0; k < plan.at("manifolds").size() && !interrupted(); ++k) {
      const Report m =
          worker_.ask((with_claims ? "manifold " : "alone ") + number + " " + std::to_string(k));
      take(m, plan.at("manifolds").at(k), result, expected);
      each.push_back(headline_in(m));
      if (m.limit.empty()) studied += " " + std::to_string(k);
    }
    Headline whole = study::headline(each);
    if (each.size() > 1 && !interrupted())
      whole = together(number + (with_claims ? " 1" : " 0") + studied, whole, result, begin);
    const bool nothing = each.empty() && !settings_.no_manifolds.empty();
    const bool more = whole.verdict == Verdict::undecided ||
                      (whole.verdict == Verdict::no_obstruction && !settings_.quiet);
    if (nothing || (more && report_.text.size() > begin && !interrupted()))
      report_.text += labelled("next", next_step());
    put(result, whole);
    result["seconds"] =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (settings_.verbose > 0)
      report_.text +=
          fmt::format("  time      {:.1f} ms\n", 1000 * result["seconds"].get<double>());
    if (!each.empty()) report_.exit = worse(report_.exit, exit_of(settings_, whole));
    report_.expected.insert(report_.expected.end(), expected.begin(), expected.end());
    report_.json.push_back(std::move(result));
  }

  static Headline headline_in(const Report& r) {
    if (r.limit.empty()) return r.json.at("headline").get<Headline>();
    Headline h;
    h.complete = false;
    return h;
  }

  [[nodiscard]] std::string next_step() const {
    return (is_given(path_) ? "the same command with classify" : "kovacic classify " + path_) +
           ", which looks for solutions and first integrals by itself";
  }

  // One verdict on the file, above those on its manifolds; `each` is what is known without it.
  Headline together(const std::string& what, const Headline& each, Json& result,
                    std::size_t begin) {
    const Report r = worker_.ask("together " + what);
    if (r.limit.empty()) {
      report_.text.insert(begin, r.text);
      result["together"] = r.json.at("together");
      auto whole = r.json.at("headline").get<Headline>();
      whole.refused = each.refused;
      whole.complete = each.complete;
      return whole;
    }
    Headline whole = each;
    whole.complete = false;
    if (whole.verdict != Verdict::non_integrable) whole.verdict = Verdict::undecided;
    if (r.exit != exit_internal || whole.verdict != Verdict::non_integrable)
      report_.exit = worse(report_.exit, r.exit);
    report_.text.insert(begin,
                        path_ + "  [all manifolds together]\n  UNDECIDED\n" + limit_lines(r.limit));
    result["together"] = {{"reason", r.limit}};
    return whole;
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
    if (!m.limit.empty()) report_.exit = worse(report_.exit, m.exit);
    if (m.json.is_object() && m.json.contains("manifold")) { // also what Ctrl-C left of it
      report_.text += m.text;
      result["manifolds"].push_back(m.json.at("manifold"));
    } else {
      report_.text +=
          planned.at("title").get<std::string>() + "\n  UNDECIDED\n" + limit_lines(m.limit);
      result["manifolds"].push_back({{"name", planned.at("name")},
                                     {"verdict", to_string(Verdict::undecided)},
                                     {"reasons", {m.limit}}});
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

} // namespace kov::cli
