// kovacic solve --batch: one JSON object per line in, one per line out, in the same order; several
// lines at a time.  A run that was killed goes on behind its last whole line (--resume).

#include "batch/kept_answers.hpp"
#include "commands.hpp"
#include "equation/assumptions.hpp"
#include "equation/question.hpp"
#include "equations/answer.hpp"
#include "exact/lists.hpp"
#include "output/json_text.hpp"
#include "output/progress.hpp"
#include "process/reproducer.hpp"
#include "proofs/certificate_file.hpp"
#include "symbol/pasted.hpp"
#include "symbol/suggest.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <deque>
#include <fcntl.h>
#include <filesystem>
#include <map>
#include <memory>
#include <poll.h>
#include <sched.h>
#include <set>
#include <unistd.h>
#include <utility>

namespace kov::cli {
namespace {

constexpr std::size_t max_line = std::size_t{16} << 20;
constexpr std::size_t max_skipped = std::size_t{128} << 20; // /dev/zero has no end

// A line without its end.  Of lines beyond the limit only the length is kept, up to max_skipped.
struct InputLine {
  std::string text;
  std::size_t length = 0;
  long number = 0;
};

// The lines of a file descriptor, read in pieces, so that nobody waits for a line that is not
// there yet.
class Lines {
public:
  explicit Lines(int input) : input_(input) {}

  // The next line, if it is there as a whole.
  std::optional<InputLine> next() {
    while (at_ < size_) {
      const char c = buffer_[at_++];
      any_ = true;
      if (c == '\n' || line_.length == max_skipped) return taken();
      ++line_.length;
      if (line_.length <= max_line) line_.text += c;
    }
    if (ended_ && any_) return taken();
    return std::nullopt;
  }
  // Waits for more, unless the input has ended.
  void read_more() {
    const ssize_t got = ::read(input_, buffer_.data(), buffer_.size());
    if (got < 0 && errno == EINTR) return;
    ended_ = got <= 0;
    at_ = 0;
    size_ = ended_ ? 0 : static_cast<std::size_t>(got);
  }
  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] int descriptor() const { return input_; }

private:
  InputLine taken() {
    InputLine line = std::exchange(line_, {});
    any_ = false;
    line.number = ++number_;
    if (!line.text.empty() && line.text.back() == '\r') line.text.pop_back();
    return line;
  }

  int input_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 16);
  std::size_t at_ = 0;
  std::size_t size_ = 0;
  bool ended_ = false;
  bool any_ = false; // the line has begun
  InputLine line_;
  long number_ = 0;
};

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r\v\f") == std::string::npos;
}

std::string too_long(std::size_t length) {
  return "a line of " + (length < max_skipped ? "" : std::string("more than ")) +
         std::to_string(length) + " bytes is too long (limit 16 MiB)";
}

[[noreturn]] void refuse(const std::string& message, const std::string& hint = {},
                         long column = 0) {
  throw InputError("the line", column > 0 ? 1 : 0, column, 1, message, hint);
}

// Gives the id of an answer back byte for byte: a JSON reader rounds numbers of more than 64 bits.
void restore_id(std::string& answer, std::string_view line) {
  const std::string_view id = member(line, "id");
  const Json read = Json::parse(id, nullptr, false);
  const auto at = answer.find("\"id\":");
  if (id.empty() || read.is_discarded() || at == std::string::npos) return;
  const std::string dumped = dump(read);
  if (answer.compare(at + 5, dumped.size(), dumped) == 0) answer.replace(at + 5, dumped.size(), id);
}

// What differs from run to run.
void remove_time(std::string& answer) {
  const std::string_view seconds = member(answer, "seconds");
  if (seconds.empty()) return;
  answer.replace(static_cast<std::size_t>(seconds.data() - answer.data()), seconds.size(), "null");
}

// The id of a line that is not JSON as a whole, as far as it can be read.
Json salvaged_id(std::string_view text) {
  auto at = text.find("\"id\"");
  if (at == std::string_view::npos) return nullptr;
  at = text.find_first_not_of(" \t", at + 4);
  if (at == std::string_view::npos || text[at] != ':') return nullptr;
  at = text.find_first_not_of(" \t", at + 1);
  if (at == std::string_view::npos) return nullptr;
  const bool quoted = text[at] == '"';
  auto end = quoted ? text.find('"', at + 1) : text.find_first_of(",} \t", at);
  if (!quoted) end = std::min(end, text.size());
  if (end == std::string_view::npos || end - at > 1000) return nullptr;
  Json id = Json::parse(text.substr(at, end - at + (quoted ? 1 : 0)), nullptr, false);
  return id.is_string() || id.is_number() ? id : Json(nullptr);
}

// One JSON object; a key that occurs twice is an error (which of the two would be meant?).
Json parse_line(std::string_view text, const std::function<void(const Json&)>& identify) {
  std::set<std::string> keys;
  std::string twice;
  const auto watch = [&](int depth, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::key && depth == 1) {
      const auto key = value.get<std::string>();
      if (!keys.insert(key).second && twice.empty()) twice = key;
    }
    if (depth > 64) refuse("the JSON is nested more than 64 deep");
    return true;
  };
  Json j;
  try {
    j = Json::parse(text, watch);
  } catch (const Json::parse_error& e) {
    std::string what = e.what();
    if (const auto at = what.find(": "); at != std::string::npos) what = what.substr(at + 2);
    const auto column = static_cast<long>(std::min(e.byte, text.size()));
    identify(salvaged_id(text));
    refuse("this is not JSON: " + printable(what).substr(0, 200), "", std::max(1L, column));
  } catch (const Json::exception&) {
    identify(salvaged_id(text));
    refuse("this is not JSON that can be read: a number is too large");
  }
  if (!j.is_object()) refuse("a JSON object is expected", R"(e.g. {"id": 1, "r": "z"})");
  if (j.contains("id")) identify(j.at("id"));
  if (!twice.empty()) refuse("the key '" + twice + "' occurs twice");
  return j;
}

std::optional<std::string> text_at(const Json& line, const char* key) {
  if (!line.contains(key) || line.at(key).is_null()) return std::nullopt;
  const Json& value = line.at(key);
  if (!value.is_string())
    refuse(std::string("'") + key + "' must be a string", "write it between quotes");
  return value.get<std::string>();
}

std::vector<std::string> names(const Json& line, const char* key) {
  std::vector<std::string> all;
  if (!line.contains(key) || line.at(key).is_null()) return all;
  const Json& value = line.at(key);
  if (!value.is_array())
    refuse(std::string("'") + key + "' must be an array of names", R"(e.g. ["n", "nu"])");
  for (const Json& name : value) {
    if (!name.is_string()) refuse(std::string("'") + key + "' must be an array of names");
    all.push_back(name.get<std::string>());
  }
  return all;
}

// Keys that are not ours are the user's own (a source, a comment), unless they look like something
// that the answer would depend on.
void refuse_keys(const Json& line) {
  static const std::vector<std::string> known{"id",     "r",        "p",          "q",
                                              "ode",    "minpoly",  "parameters", "assumptions",
                                              "assume", "variable", "unknown",    "set"};
  static const std::map<std::string, std::string> meant{{"where", "write: set"},
                                                        {"values", "write: set"},
                                                        {"e", "write: ode"},
                                                        {"equation", "write: ode"},
                                                        {"conditions", "write: assumptions"}};
  for (const auto& [key, value] : line.items()) {
    if (is_among(key, known)) continue;
    const auto hint = meant.find(key);
    const auto near = key.size() < 5 ? std::nullopt : nearest(key, known);
    if (hint != meant.end() || near)
      refuse("unknown key '" + printable(key).substr(0, 100) + "'",
             near ? "did you mean '" + *near + "'?" : hint->second);
  }
}

// One text or a list of texts.
std::vector<std::string> one_or_more(const Json& line, const char* key) {
  if (line.contains(key) && line.at(key).is_string()) return {line.at(key).get<std::string>()};
  return names(line, key);
}

Question read_line(std::string_view job, const std::function<void(const Json&)>& identify) {
  const Json line = parse_line(job, identify);
  Question q;
  if (line.contains("id")) q.id = line.at("id");
  refuse_keys(line);
  EquationText given;
  given.parameters = names(line, "parameters");
  given.variable = text_at(line, "variable").value_or("");
  if (line.contains("variable") && line.at("variable") == "") refuse("'variable' is empty");
  given.unknown = text_at(line, "unknown").value_or("");
  const Json set = line.value("set", Json::object());
  if (!set.is_object()) refuse("'set' must be an object", R"(e.g. {"a": "1/2"})");
  for (const auto& [name, value] : set.items())
    given.set.emplace_back(
        name,
        pasted_formula(value.is_string() ? value.get<std::string>() : value.dump(), "set").formula);
  const EquationTexts texts{text_at(line, "r"), text_at(line, "ode"), text_at(line, "p"),
                            text_at(line, "q"), text_at(line, "minpoly")};
  if (!texts.r && !texts.p && !texts.q && !texts.ode)
    refuse("the line has no equation", "give r, or p and q, or ode");
  static_cast<AskedEquation&>(q) = asked_equation(texts, std::move(given), Door::keys);
  const auto known = settable_names(q.text);
  for (const char* key : {"assumptions", "assume"})
    for (const std::string& text : one_or_more(line, key))
      if (is_prose(text, known)) // said, not used
        q.ignored.push_back(text);
      else
        add_assumptions(q.text, assumed_texts({text}, key));
  return q;
}

// Puts the certificates of one answer into files: named by the id, if that can be a name, else by
// the number of the line, which is added to a name that another answer has.
void keep_certificate(const Settings& settings, std::string_view job, Solver::Line& answer,
                      long number, std::set<std::string>& used) {
  const Json question = Json::parse(job);
  const Json id = question.contains("id") ? question.at("id") : Json();
  const std::string name = id.is_string() && !id.get<std::string>().empty() ? id.get<std::string>()
                           : id.is_number()                                 ? id.dump()
                                            : "line-" + std::to_string(number);
  std::string plain = file_name(name).substr(0, 180); // room for the number
  while (used.contains(plain) || used.contains(plain + ".loops"))
    plain += "-line-" + std::to_string(number);
  Json paths;
  if (!answer.certificate.empty()) {
    used.insert(plain);
    paths["certificate_file"] = file_certificate(settings, plain, answer.certificate);
  }
  if (!answer.loops_certificate.empty()) {
    used.insert(plain + ".loops");
    paths["loops_certificate_file"] =
        file_certificate(settings, plain + ".loops", answer.loops_certificate);
  }
  answer.text.back() = ','; // more keys at the end of the object
  answer.text += dump(paths).substr(1);
}

// Answers that wait for an earlier one, together with their questions: beyond this no further
// line is read.
constexpr std::size_t max_waiting = std::size_t{256} << 20;

long cores() {
  cpu_set_t set;
  return ::sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

// Several lines at the same time, their answers in the order of the lines.
class Batch {
public:
  Batch(const Settings& settings, BatchArguments arguments, int in, std::FILE* out,
        KeptAnswers kept)
      : settings_(settings), arguments_(std::move(arguments)), lines_(in), out_(out),
        kept_(std::move(kept)), progress_(size_of_file(arguments_.path)),
        used_(std::move(kept_.certificates)), exit_(kept_.exit) {
    const long jobs = settings.jobs > 0 ? settings.jobs : cores();
    for (long i = 0; i < jobs; ++i)
      solvers_.push_back({std::make_unique<Solver>(read_line, settings), nullptr});
  }

  // Throws InputError for what ends the run.
  int run() {
    for (;;) {
      const bool hungry = give();
      if (!print_what_is_ready()) return exit_interrupted;
      if (waiting_.empty() && lines_.ended()) return ended();
      std::vector<const Worker*> at_work;
      for (const Seat& seat : solvers_)
        if (seat.entry != nullptr) at_work.push_back(&seat.solver->worker());
      const bool more = hungry && !lines_.ended();
      if (!Worker::wait(at_work, more ? lines_.descriptor() : -1)) return exit_interrupted;
      if (more && readable(lines_.descriptor())) lines_.read_more();
      collect();
    }
  }

private:
  struct Entry {
    InputLine line;
    std::optional<Solver::Line> answer;
  };
  struct Seat {
    std::unique_ptr<Solver> solver;
    Entry* entry; // what it works at; nullptr: nothing
  };

  static std::uintmax_t size_of_file(const std::string& path) {
    std::error_code unknown; // of a pipe
    const auto size = std::filesystem::file_size(path, unknown);
    return unknown ? 0 : size;
  }

  [[nodiscard]] int ended() const {
    if (kept_.ids.empty()) return exit_;
    throw InputError(settings_.output, 0, 0, 1, "there are more answers than questions",
                     "it belongs to another batch");
  }

  // A line that an earlier run has answered.
  bool is_answered(const InputLine& line) {
    if (kept_.ids.empty()) return false;
    const Json question = Json::parse(line.text, nullptr, false);
    if (question.is_object() && question.value("id", Json()) != kept_.ids.front())
      throw InputError(settings_.output, 0, 0, 1,
                       "the answer to line " + std::to_string(line.number) + " of " +
                           arguments_.path + " has the id " + dump(kept_.ids.front()) + " there",
                       "it belongs to another batch, so that nothing is added to it");
    kept_.ids.pop_front();
    progress_.found(line.length + 1);
    return true;
  }

  static bool readable(int input) {
    pollfd p{input, POLLIN, 0};
    return ::poll(&p, 1, 0) > 0;
  }

  // Of the idle ones one whose process runs already.
  Seat* idle() {
    Seat* found = nullptr;
    for (Seat& seat : solvers_)
      if (seat.entry == nullptr && (found == nullptr || seat.solver->worker().started())) {
        found = &seat;
        if (seat.solver->worker().started()) break;
      }
    return found;
  }

  // Lines to idle solvers; true if more lines could be used.
  bool give() {
    while (bytes_ < max_waiting && !endless_) {
      Seat* seat = idle();
      if (seat == nullptr) return false;
      auto line = lines_.next();
      if (!line) return true;
      if (is_blank(line->text) && line->length <= max_line) continue;
      if (is_answered(*line)) continue;
      bytes_ += line->text.size();
      Entry& entry = waiting_.emplace_back(Entry{*std::move(line), std::nullopt});
      endless_ = entry.line.length >= max_skipped;
      if (entry.line.length > max_line) {
        entry.answer = {dump({{"id", nullptr}, {"error", too_long(entry.line.length)}}), exit_input,
                        "", ""};
        bytes_ += size_of(*entry.answer);
        continue;
      }
      seat->entry = &entry;
      seat->solver->begin(entry.line.text);
    }
    return false;
  }

  void collect() {
    for (Seat& seat : solvers_) {
      if (seat.entry == nullptr) continue;
      auto answer = seat.solver->finished();
      if (!answer) continue;
      bytes_ += size_of(*answer);
      seat.entry->answer = std::move(answer);
      seat.entry = nullptr;
    }
  }

  // False: interrupted.
  bool print_what_is_ready() {
    bool any = false;
    for (; !waiting_.empty() && waiting_.front().answer; waiting_.pop_front()) {
      Entry& entry = waiting_.front();
      if (entry.answer->exit == exit_interrupted) return false;
      bytes_ -= entry.line.text.size() + size_of(*entry.answer);
      print(entry.line, *entry.answer);
      any = true;
    }
    if (any && std::fflush(out_) != 0) not_written();
    return true;
  }
  static std::size_t size_of(const Solver::Line& answer) {
    return answer.text.size() + answer.certificate.size() + answer.loops_certificate.size();
  }

  void print(const InputLine& line, Solver::Line& answer) {
    exit_ = worse(exit_, answer.exit);
    progress_.answered(line.length + 1, answer.exit == exit_decided);
    if (answer.exit == exit_internal) leave_reproducer(answer.text, line.text);
    if (!answer.certificate.empty() || !answer.loops_certificate.empty())
      keep_certificate(settings_, line.text, answer, line.number, used_);
    std::string& text = answer.text;
    if (arguments_.no_times) remove_time(text);
    restore_id(text, line.text);
    text += '\n';
    if (std::fwrite(text.data(), 1, text.size(), out_) != text.size()) not_written();
    if (line.length >= max_skipped) {
      std::fflush(out_);
      throw InputError(arguments_.path, line.number, 0, 1, "this line does not end",
                       "the rest is not read");
    }
  }

  [[noreturn]] void not_written() const {
    throw InputError(out_ == stdout ? "standard output" : settings_.output, 0, 0, 1,
                     "not everything could be written");
  }

  const Settings& settings_;
  BatchArguments arguments_;
  Lines lines_;
  std::FILE* out_;
  KeptAnswers kept_; // those whose questions were not met yet
  Progress progress_;
  std::vector<Seat> solvers_;
  std::deque<Entry> waiting_;  // in the order of the lines; a deque does not move its elements
  std::size_t bytes_ = 0;      // of what waits
  bool endless_ = false;       // the last line has no end: nothing is read behind it
  std::set<std::string> used_; // names of certificates
  int exit_;
};

// Behind the whole lines that are there, or in the place of what is there.
std::FILE* open_output(const Settings& settings, const BatchArguments& arguments,
                       const KeptAnswers& kept) {
  if (settings.output.empty() || settings.output == "-") return stdout;
  if (arguments.resume && std::filesystem::exists(settings.output))
    std::filesystem::resize_file(settings.output, kept.bytes);
  std::FILE* out = std::fopen(settings.output.c_str(), arguments.resume ? "ab" : "wb");
  if (out == nullptr) throw InputError(settings.output, 0, 0, 1, "the file cannot be written");
  return out;
}

} // namespace

int batch(const Settings& settings, const BatchArguments& arguments) {
  const std::string& path = arguments.path;
  if (path != "-" && is_directory(path))
    return report(settings, InputError(path, 0, 0, 1, "this is a directory, a file is expected"));
  const int in = path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (in < 0) return report(settings, InputError(path, 0, 0, 1, "the file cannot be opened"));
  std::FILE* out = stdout;
  int exit = exit_decided;
  try {
    KeptAnswers kept = arguments.resume ? kept_answers(settings.output) : KeptAnswers{};
    out = open_output(settings, arguments, kept);
    exit = Batch(settings, arguments, in, out, std::move(kept)).run();
  } catch (const InputError& e) {
    exit = report(settings, e);
  } catch (const std::filesystem::filesystem_error& e) {
    exit = report(settings, InputError(settings.output, 0, 0, 1, e.code().message()));
  }
  if (in != STDIN_FILENO) ::close(in);
  if (out != stdout) std::fclose(out);
  if (exit == exit_interrupted) complain(settings, "interrupted");
  return exit;
}

} // namespace kov::cli
