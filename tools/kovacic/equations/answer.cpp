#include "equations/answer.hpp"

#include "answer/notation.hpp"
#include "answer/solve.hpp"
#include "decide/afterwards.hpp"
#include "decide/words.hpp"
#include "equation/assumptions.hpp"
#include "equation/understood.hpp"
#include "equations/present_strata.hpp"
#include "equations/recognized.hpp"
#include "equations/second_opinion.hpp"
#include "equations/whole.hpp"
#include "exact/tried.hpp"
#include "strata/certificate.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <sstream>
#include <utility>

namespace kov::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// A message of the child, early or final: one letter, then JSON in one line; a certificate may
// follow as it is, in further lines, and behind a separator, which no JSON contains, the one of the
// second opinion.
constexpr char separator = '\x1e';
constexpr char tag_decided = 'd';
constexpr char tag_undecided = 'u';
constexpr char tag_disagreement = 'm'; // of two methods, or of our checker: a mistake of ours
constexpr char tag_input = 'i';
constexpr char tag_internal = 'x';

constexpr const char* the_rest = "the rest of the answer";

std::string message(char tag, const Json& body, std::string_view certificate = {},
                    std::string_view loops = {}) {
  std::string text = tag + dump(body);
  if (!certificate.empty() || !loops.empty()) text.append(1, '\n').append(certificate);
  if (!loops.empty()) text.append(1, separator).append(loops);
  return text;
}

struct Parts {
  std::string_view json, certificate, loops;
};

Parts parts(std::string_view message) {
  const auto end = std::min(message.find('\n'), message.size());
  const std::string_view proofs = message.substr(std::min(end + 1, message.size()));
  const auto first = std::min(proofs.find(separator), proofs.size());
  return {message.substr(1, end - 1), proofs.substr(0, first),
          proofs.substr(std::min(first + 1, proofs.size()))};
}

std::string memory_limit(const Settings& settings) {
  return "memory limit of " + std::to_string(settings.memory) + " MiB reached";
}

// An early message says only what is known: the rest of the result is open.
Json completed(std::string_view early) {
  Json result = unread_result(nullptr);
  if (!early.empty()) result.update(Json::parse(early));
  return result;
}

bool proves_something(const Json& result) {
  const Json strata = result.value("strata", Json::array());
  return !result.at("group").is_null() || result.at("abelian") != "undecided" ||
         std::ranges::any_of(strata, [](const Json& s) { return s.at("abelian") != "undecided"; });
}

// Why a job did not come to its end.
struct Stop {
  std::string why = "budget";
  std::string detail;
  bool error = false; ///< of the program: told beside the verdict
};

// The answer of a job that was stopped: what its last early message says, and what is missing.
std::string stopped(std::string_view early, const Stop& stop, double seconds,
                    const Settings& settings) {
  const auto& [why, detail, error] = stop;
  if (early.empty()) early = "u";
  const auto [json, certificate, loops] = parts(early);
  Json result = completed(json);
  result["seconds"] = seconds;
  if (!proves_something(result)) {
    set_undecided(result, why, detail);
    return message(tag_undecided, result);
  }
  if (!result.contains("strata"))
    result["no_solutions"] = settings.wants_solutions() ? detail : to_string(SolutionsMissing{});
  if (error) result["failed"].push_back(detail);
  Json open = result.at("undecided");
  if (early.front() == tag_undecided && open.is_null()) open = {{"why", why}, {"detail", detail}};
  if (!settings.certificate.empty() && certificate.empty() && !result.contains("no_certificate")) {
    result["no_certificate"] = detail;
    open = {{"why", why}, {"detail", "no certificate: " + detail}};
  }
  result["undecided"] = open;
  return message(open.is_null() ? tag_decided : tag_undecided, result, certificate);
}

Json packed_error(const InputError& e, const Json& id) {
  return {{"id", id},
          {"file", e.file()},
          {"line", e.line()},
          {"column", e.column()},
          {"length", e.length()},
          {"message", e.message()},
          {"hint", e.hint()},
          {"source", e.source_line()}};
}

InputError unpacked_error(const Json& j) {
  return {j.at("file"),    j.at("line"), j.at("column"), j.at("length"),
          j.at("message"), j.at("hint"), j.at("source")};
}

char tag_of(const Decision& d) {
  if (!d.undecided) return tag_decided;
  return d.undecided->why == Unable::Why::methods_disagree ? tag_disagreement : tag_undecided;
}

int exit_of(char tag) {
  return tag == tag_decided ? exit_decided : tag == tag_undecided ? exit_undecided : exit_internal;
}

// Runs in the child.
class Job {
public:
  Job(const Solver::Read& read, const Settings& settings, const Worker::Early& early)
      : read_(read), settings_(settings), early_(early) {}

  std::string run(std::string_view job) {
    try {
      return decide_it(job);
    } catch (const InputError& e) {
      return message(tag_input, packed_error(e, id_));
    } catch (const FreeParameters& e) {
      return undecided("parameter", e.what());
    } catch (const OutOfBudget& e) {
      return undecided("budget", e.what());
    } catch (const std::bad_alloc&) {
      return undecided("budget", memory_limit(settings_));
    } catch (const Contradiction& e) {
      return internal(e.what());
    } catch (const std::exception& e) {
      if (!has_proved()) return internal(e.what());
      return stopped(said_, {"internal", failure_of(the_rest, e.what()), true},
                     seconds_since(start_), settings_);
    }
  }

private:
  std::string decide_it(std::string_view job) {
    const Question question = read_(job, [&](const Json& id) {
      id_ = id;
      say(message(tag_undecided, {{"id", id}}));
    });
    id_ = question.id;
    read_as_ = question.read_as;
    notes_ = question.notes;
    given_ = question.given;
    if (given_.empty() && question.text.ode) given_ = written(*question.text.ode);
    check_names(question.text);
    check_assumptions(question.text);
    try {
      question_ = answer::given_equation(question.text);
    } catch (const InputError&) { // the reader says it better
    }
    if (question.text.change)
      unknown_ = question.text.change->unknown;
    else if (question.text.ode)
      unknown_ = equation_names(question.text).unknown;
    try {
      return decided(question);
    } catch (const FreeParameters&) {
      open_ = unread_result(id_);
      put_reading(open_);
      return by_strata(question);
    }
  }

  // How pasted text was understood.
  void put_reading(Json& result) const {
    if (question_) result["equation"] = given_.empty() ? written(question_->ode) : given_;
    for (const auto& [name, value] :
         question_ ? question_->values : std::map<std::string, Expression>{})
      result["set"][name] = written(value);
    if (!read_as_.empty()) result["read_as"] = read_as_;
    const bool with_parameters = result.contains("strata") && is_transformed(result);
    if (!given_.empty() && (is_another_equation(notes_) || with_parameters))
      result["given"] = given_json(given_, notes_);
    auto notes = notes_;
    if (result.contains("given")) // which says these
      std::erase_if(notes, [&](const ReadingNote& n) {
        using What = ReadingNote::What;
        return (n.what == What::homogeneous && result.at("given").contains("right_side")) ||
               (n.what == What::riccati && result.at("given").contains("substitution")) ||
               (n.what == What::variable && result.at("given").contains("change"));
      });
    if (!notes.empty()) result["notes"] = sentences(notes);
    if (!unknown_.empty() && (result.contains("given") || unknown_ != "y"))
      result["unknown"] = unknown_;
  }

  void say(std::string early) {
    said_ = std::move(early);
    early_(said_);
  }

  // So that the certificate costs little beside the answer.
  static bool is_small(const RationalFunction& r) {
    return is_zero(r) || degree(r.num()) + degree(r.den()) <= 60;
  }

  std::string decided(const Question& question) {
    Options options = settings_.solver_options();
    const GivenEquation equation = read_equation(question.text, options.budget);
    options.variable = equation.variable;
    options.ask_the_judge = !settings_.in_a_batch && is_small(equation.normal_form.r);
    open_ = open_result(id_, equation);
    put_reading(open_);
    if (equation.form != GivenEquation::Form::r) put_original_form(open_, equation, options.budget);
    what_ = answer::in_its_variable(equation);
    if (may_move(options))
      do_part(open_, "the choice of a variable",
              [&] { what_ = answer::in_small_numbers(equation); });
    say(message(tag_undecided, open_));
    options.proved = [this](const Decision& d) {
      say(message(tag_of(d), closed(d, nullptr), d.certificate));
    };
    const Decision decision = answer::decided(what_, options);
    Json recognized;
    do_part(open_, "the search for a classical equation", [&] {
      std::set<std::string> taken = names_of_question(open_);
      if (unknown_ == "y") taken.erase("y"); // the classical equation is one for y, too
      recognized = recognized_json(decision, taken, options.budget);
    });
    Json result = closed(decision, recognized);
    answer::Solutions shown;
    if (wants_solutions() && question_ && !result.contains("refused_by_checker"))
      do_part(result, "the search for special functions", [&] {
        const answer::Style style{
            settings_.complex, !settings_.in_a_batch || settings_.special_functions, {}};
        try {
          shown = answer::solutions_of(*question_, equation, decision, what_.gauge, style,
                                       options.budget);
          put_answer(result, shown);
        } catch (const OutOfBudget&) { // the answer itself is there
        }
      });
    whole(result, question, shown);
    if (!question.ignored.empty()) result["assumptions_ignored"] = question.ignored;
    const SecondOpinion second = add_what_was_asked_for(result, decision, options);
    return message(tag_of(decision), result, decision.certificate, second.proof.json);
  }

  // An equation of the first order has its own: those of the one that is decided for it say nothing.
  [[nodiscard]] bool wants_solutions() const {
    using What = ReadingNote::What;
    return settings_.wants_solutions() && std::ranges::none_of(notes_, [](const ReadingNote& n) {
             return n.what == What::first_order || n.what == What::bernoulli;
           });
  }

  // The equation with its right side, its initial values, or in the unknown of Riccati's.
  static void whole(Json& result, const Question& question, const answer::Solutions& shown) {
    if (question.whole)
      do_part(result, "the solutions of the whole equation", [&] {
        const auto answer = answer::whole_of(question, shown.y);
        put_whole(result, question.whole->unknown, answer);
        for (const Expression& value : question.whole->conditions)
          result["whole"]["values"].push_back(written(value));
        if (const auto& y = answer.with_values ? answer.with_values : answer.general)
          result["solutions"] = {answer::for_programs(parse_expression(*y, "a solution"))};
      });
  }

  // Each costs itself only.
  SecondOpinion add_what_was_asked_for(Json& result, const Decision& decision,
                                       const Options& options) const {
    if (settings_.polynomial_of_y)
      do_part(result, "the polynomial of y", [&] {
        result["polynomial_of_y"] =
            polynomial_json(decision, what_.gauge, settings_.max_print << 20, options.budget);
      });
    SecondOpinion second;
    if (settings_.second_opinion)
      do_part(result, "the second opinion", [&] {
        second = second_opinion(decision.r, decision, options.budget, options.want_certificate);
        result["second_opinion"] = second.json;
      });
    return second;
  }

  // Where the equation is over a smaller field, or its numbers are small: the answer is written in
  // the variable z - c.  Certificates, steps and matrices are those of the given equation.
  [[nodiscard]] bool may_move(const Options& options) const {
    return !options.want_certificate && !options.want_trace && !options.only_case &&
           options.method == Method::automatic && !settings_.second_opinion;
  }

  // The original equation is printed last.
  Json closed(const Decision& decision, const Json& recognized) const {
    Json open = open_;
    open.erase("original");
    Json result = closed_result(std::move(open), decision, seconds_since(start_),
                                settings_.max_print << 20, settings_.solver_options().budget);
    result["recognized"] = recognized;
    if (open_.contains("original")) {
      Json original = open_.at("original");
      original["identity_component_abelian"] = result.at("abelian");
      if (!is_zero(what_.gauge))
        do_part(result, "the solutions of the given equation", [&] {
          if (Json given = basis_json(decision, what_.gauge, settings_.max_print << 20,
                                      settings_.solver_options().budget);
              !given.is_null())
            original["solutions"] = std::move(given);
        });
      result["original"] = std::move(original);
    }
    return result;
  }

  // All parameters at once.
  std::string by_strata(const Question& question) {
    strata::StrataLimits limits;
    limits.decide = settings_.solver_options();
    std::optional<answer::Style> style;
    if (wants_solutions()) style = {settings_.complex, true, {}};
    const auto shown = [&](const answer::Family& f) {
      if (f.first_is_left_out)
        std::erase_if(notes_,
                      [](const ReadingNote& n) { return n.what == ReadingNote::What::variable; });
      Json result = family_result(id_, f, unknown_);
      put_reading(result);
      return result;
    };
    const auto tell = [&](const Json& result) { say(message(tag_of_family(result), result)); };
    const answer::Family family =
        answer::decide_family(question.text, limits, style, [&](const answer::Family& f) {
          if (style) tell(shown(f));
        });
    Json result = shown(family);
    if (result.contains("refused_by_checker")) return message(tag_disagreement, result);
    const auto first =
        std::ranges::find_if(family.parts, [](const auto& p) { return p.answer.has_value(); });
    std::string proof;
    if (limits.decide.want_certificate && first != family.parts.end() && first->answer->tree) {
      tell(result);
      proof = certificate_of(*first->answer, limits, result);
      if (family.parts.size() > 1 && !result.contains("no_certificate"))
        result["no_certificate"] =
            "of all values: what is written is about one equation, that where " +
            answer::in_words(family.parts.front().part);
    }
    const bool shown_first = first != family.parts.end() && first->solutions;
    whole(result, question, shown_first ? first->solutions->general : answer::Solutions{});
    if (!question.ignored.empty()) result["assumptions_ignored"] = question.ignored;
    if (settings_.polynomial_of_y)
      result["polynomial_of_y"] = {{"missing", "parameters have no values"}};
    if (settings_.second_opinion)
      result["second_opinion"] = {{"text", "no monodromy matrices: parameters have no values"}};
    return message(tag_of_family(result), result, proof);
  }

  static char tag_of_family(const Json& result) {
    return result.contains("refused_by_checker") ? tag_disagreement
           : result.at("undecided").is_null()    ? tag_decided
                                                 : tag_undecided;
  }

  // Is the identity component decided on some stratum, or on a part of one?
  static bool says_something(const strata::StrataAnswer& answer) {
    const auto all = answer.told_apart();
    return std::ranges::any_of(all, [](const auto& x) { return x.leaf.abelian != Truth::unknown; });
  }

  // The certificate, or nothing; the result says why.
  static std::string certificate_of(const strata::StrataAnswer& answer,
                                    const strata::StrataLimits& limits, Json& result) {
    std::string missing;
    std::optional<strata::StrataCertificate> c;
    try {
      const std::string failed = failure_of("the certificate", [&] {
        try {
          c = strata::certificate(answer, limits.decide.budget);
        } catch (const InvalidArgument& e) { // a name that the format does not have
          missing = e.what();
        }
      });
      missing += failed;
    } catch (const OutOfBudget& limit) {
      missing = limit.what();
    }
    if (c && missing.empty() && !c->refusal.empty()) missing = strata::objection(*c);
    if (c && missing.empty() && !c->says_anything && says_something(answer))
      missing = "the format has no rule for the strata that are decided";
    if (!missing.empty()) result["no_certificate"] = missing;
    if (!c || !missing.empty() || !c->says_anything) return {};
    for (const strata::Uncertified& u : c->trusted)
      result["certificate_trusts"].push_back(sentence(u.told));
    return c->json;
  }

  // What was proved before stays.
  std::string undecided(const std::string& why, const std::string& detail) {
    if (has_proved()) return stopped(said_, {why, detail}, seconds_since(start_), settings_);
    Json result = open_.is_null() ? unread_result(id_) : open_;
    put_reading(result);
    set_undecided(result, why, detail);
    result["seconds"] = seconds_since(start_);
    return message(tag_undecided, result);
  }

  [[nodiscard]] bool has_proved() const {
    return !said_.empty() && proves_something(completed(parts(said_).json));
  }
  [[nodiscard]] std::string internal(const std::string& what) const {
    return message(tag_internal, {{"id", id_}, {"message", what}});
  }

  const Solver::Read& read_;
  const Settings& settings_;
  const Worker::Early& early_;
  Clock::time_point start_ = Clock::now();
  Json id_;
  std::vector<std::string> read_as_;
  std::vector<ReadingNote> notes_;
  std::string given_, unknown_;
  std::optional<answer::Given> question_;
  Json open_;
  answer::Decidable what_; // what is decided
  std::string said_;       // the last early message
};

std::string crash_text(const Reply& reply) {
  return "the solver process ended with " + reply.detail;
}

// Why a job was not answered.
std::string limit_text(const Reply& reply, const Settings& settings) {
  switch (reply.end) {
  case Reply::End::out_of_memory:
    return memory_limit(settings);
  case Reply::End::killed:
    return "the solver process was ended from outside by " + reply.detail +
           ": by a user, or by the system where memory is short";
  case Reply::End::interrupted:
    return "interrupted";
  case Reply::End::crashed:
    return crash_text(reply);
  default:
    return Budget::time_limit(settings.timeout);
  }
}

// The final message of a job that was answered or stopped by a limit.
std::string final_message(const Reply& reply, const Settings& settings, double seconds) {
  if (reply.end == Reply::End::answered) return reply.answer;
  const std::string why = limit_text(reply, settings);
  if (reply.end != Reply::End::crashed)
    return stopped(reply.early, {"budget", why}, seconds, settings);
  return stopped(reply.early, {"internal", failure_of(the_rest, why), true}, seconds, settings);
}

bool early_proof(const Reply& reply) {
  return !reply.early.empty() && proves_something(completed(parts(reply.early).json));
}

} // namespace

namespace {

std::string dumped(const Json& j) { return j.dump(-1, ' ', false, Json::error_handler_t::replace); }

bool is_plain(char c) { return c >= ' ' && c != '"' && c != '\\' && c != '\x7f'; } // and ASCII

void append_text(std::string& out, const std::string& s) {
  if (std::ranges::all_of(s, is_plain))
    out.append(1, '"').append(s).append(1, '"');
  else
    out += dumped(s);
}

void append(std::string& out, const Json& j) {
  const char* before = j.is_object() ? "{" : "[";
  if (j.is_string()) {
    append_text(out, j.get_ref<const std::string&>());
  } else if (j.empty() || !j.is_structured()) {
    out += dumped(j);
  } else if (j.is_object()) {
    for (const auto& [key, value] : j.get_ref<const Json::object_t&>()) {
      append_text(out.append(std::exchange(before, ",")), key);
      append(out += ':', value);
    }
    out += '}';
  } else {
    for (const Json& value : j)
      append(out.append(std::exchange(before, ",")), value);
    out += ']';
  }
}

} // namespace

std::string dump(const Json& j) {
  std::string out;
  append(out, j);
  return out;
}

std::string indented(const Json& j) {
  return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Solver::Solver(Read read, const Settings& settings)
    : read_(std::move(read)), settings_(settings),
      worker_([this](std::string_view job,
                     const Worker::Early& early) { return Job(read_, settings_, early).run(job); },
              settings.process_limits()) {}

namespace {

Answer read_answer(const std::string& text) {
  const auto [json, proof, loops] = parts(text);
  const Json body = Json::parse(json);
  Answer a;
  switch (text.front()) {
  case tag_input:
    a.exit = exit_input;
    a.error = unpacked_error(body);
    break;
  case tag_internal:
    a.exit = exit_internal;
    a.internal = body.at("message").get<std::string>();
    break;
  default:
    a.exit = exit_of(text.front());
    a.result = body;
    a.certificate = proof;
    a.loops_certificate = loops;
    if (a.exit == exit_internal) a.internal = body.at("reason").get<std::string>();
  }
  return a;
}

Solver::Line parse_reply(const std::string& text) {
  const auto [json, proof, loops] = parts(text);
  const char tag = text.front();
  if (tag != tag_internal && tag != tag_input)
    return {std::string(json), exit_of(tag), std::string(proof), std::string(loops)};
  const Json body = Json::parse(json);
  if (tag == tag_internal)
    return {dump({{"id", body.at("id")},
                  {"error", "internal error: " + body.at("message").get<std::string>()}}),
            exit_internal, "", ""};
  const InputError e = unpacked_error(body);
  std::string text_of_error = e.message();
  if (e.column() > 0)
    text_of_error += " (column " + std::to_string(e.column()) + " of " + e.file() + ")";
  Json j = {{"id", body.at("id")}, {"error", text_of_error}};
  if (!e.hint().empty()) j["hint"] = e.hint();
  return {dump(j), exit_input, "", ""};
}

} // namespace

Answer Solver::answer(std::string_view job) {
  const auto start = Clock::now();
  const Reply reply = worker_.ask(job);
  const bool crashed = reply.end == Reply::End::crashed;
  const bool interrupted = reply.end == Reply::End::interrupted;
  Answer a;
  if (early_proof(reply) || (!crashed && !interrupted))
    a = read_answer(final_message(reply, settings_, seconds_since(start)));
  else if (crashed)
    a.exit = exit_internal, a.internal = crash_text(reply);
  if (interrupted) a.exit = exit_interrupted;
  return a;
}

namespace {

Solver::Line line_of(const Reply& reply, const Settings& settings, double seconds) {
  if (reply.end == Reply::End::interrupted) return {"", exit_interrupted, "", ""};
  if (reply.end != Reply::End::crashed || early_proof(reply))
    return parse_reply(final_message(reply, settings, seconds));
  const Json early = completed(reply.early.empty() ? "" : parts(reply.early).json);
  return {dump({{"id", early.at("id")}, {"error", "internal error: " + crash_text(reply)}}),
          exit_internal, "", ""};
}

} // namespace

void Solver::begin(std::string_view job) {
  start_ = Clock::now();
  worker_.begin(job);
}

std::optional<Solver::Line> Solver::finished() {
  const auto reply = worker_.finished();
  if (!reply) return std::nullopt;
  return line_of(*reply, settings_, seconds_since(start_));
}

TextAnswer limited(const Settings& settings, const std::function<int(std::ostream&)>& work) {
  return limited(settings, [&](std::ostream& out, const Worker::Early&) { return work(out); });
}

TextAnswer limited(const Settings& settings,
                   const std::function<int(std::ostream&, const Worker::Early&)>& work) {
  TextWorker worker(settings, [&](std::string_view, std::ostream& out, const Worker::Early& early) {
    return work(out, early);
  });
  return worker.ask("");
}

TextWorker::TextWorker(const Settings& settings, Serve serve)
    : settings_(settings),
      worker_(
          [serve = std::move(serve), &settings](std::string_view job, const Worker::Early& early) {
            std::string said;
            try {
              std::ostringstream out;
              const int exit = serve(job, out, [&](std::string_view text) {
                said = text;
                early(said);
              });
              return message(tag_decided, {{"exit", exit}, {"text", out.str()}});
            } catch (const InputError& e) {
              return message(tag_input, packed_error(e, nullptr));
            } catch (const OutOfBudget& e) {
              return message(tag_undecided, {{"limit", e.what()}, {"early", said}});
            } catch (const std::bad_alloc&) {
              return message(tag_undecided, {{"limit", memory_limit(settings)}, {"early", said}});
            } catch (const std::exception& e) {
              return message(tag_internal, {{"message", e.what()}});
            }
          },
          settings.process_limits()) {}

TextAnswer TextWorker::ask(std::string_view job) {
  const Reply reply = worker_.ask(job);
  TextAnswer a;
  if (reply.end == Reply::End::interrupted) {
    a.exit = exit_interrupted;
    a.early = reply.early;
    if (!reply.answer.empty()) { // what the job had when Ctrl-C ended it
      const Json body = Json::parse(std::string_view(reply.answer).substr(1));
      if (reply.answer.front() == tag_decided) a.early = body.at("text").get<std::string>();
      if (reply.answer.front() == tag_undecided) a.early = body.at("early").get<std::string>();
    }
  } else if (reply.end == Reply::End::crashed) {
    a.exit = exit_internal;
    a.internal = crash_text(reply);
    a.early = reply.early;
  } else if (reply.end != Reply::End::answered) {
    a.exit = exit_undecided;
    a.limit = limit_text(reply, settings_);
    a.early = reply.early;
  } else {
    const Json body = Json::parse(std::string_view(reply.answer).substr(1));
    switch (reply.answer.front()) {
    case tag_input:
      a.exit = exit_input;
      a.error = unpacked_error(body);
      break;
    case tag_undecided:
      a.exit = exit_undecided;
      a.limit = body.at("limit").get<std::string>();
      a.early = body.at("early").get<std::string>();
      break;
    case tag_internal:
      a.exit = exit_internal;
      a.internal = body.at("message").get<std::string>();
      break;
    default:
      a.exit = body.at("exit").get<int>();
      a.text = body.at("text").get<std::string>();
    }
  }
  return a;
}

Solver::Read fixed_question(std::function<Question()> question) {
  return [question = std::move(question)](std::string_view,
                                          const std::function<void(const Json&)>& identify) {
    Question q = question();
    identify(q.id);
    return q;
  };
}

int exit_code(const Settings& settings, const Answer& answer) {
  if (!settings.exit_verdict || answer.exit == exit_input || answer.exit >= exit_internal)
    return answer.exit;
  const std::string abelian = answer.result.at("abelian").get<std::string>();
  return abelian == "no" ? exit_not_abelian : abelian == "yes" ? exit_abelian : 0;
}

} // namespace kov::cli
