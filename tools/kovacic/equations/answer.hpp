#pragma once
// One question, one answer, whatever happens in between.

#include "equation/question.hpp"
#include "process/settings.hpp"

#include <chrono>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

namespace kov::cli {

/// What the child reads a job into.
struct Question : AskedEquation {
  Json id = {};                          ///< null, or what names the equation in the answer
  std::vector<std::string> ignored = {}; ///< assumptions that were not understood
};

struct Answer {
  int exit = exit_decided;         ///< of Exit
  Json result;                     ///< format kovacic-result/1; null after an input error
  std::string certificate;         ///< its text, as the judge accepted it; may be empty
  std::string loops_certificate;   ///< of the second opinion, likewise
  std::optional<InputError> error; ///< exit_input
  std::string internal;            ///< exit_internal: what went wrong
};

/// Answers questions in a worker process under the limits of the settings.
class Solver {
public:
  /// Runs in the child.  May throw InputError; calls `identify` as soon as the id is known.
  using Read = std::function<Question(std::string_view job,
                                      const std::function<void(const Json&)>& identify)>;

  Solver(Read read, const Settings& settings);

  /// Never throws for anything that the question causes.
  [[nodiscard]] Answer answer(std::string_view job);
  /// The same as one line of JSON, the way `--batch` prints it.
  struct Line {
    std::string text;
    int exit = exit_decided;
    std::string certificate;
    std::string loops_certificate;
  };
  void begin(std::string_view job);
  /// If it is there: for several solvers at once (see Worker).
  [[nodiscard]] std::optional<Line> finished();
  [[nodiscard]] const Worker& worker() const { return worker_; }

private:
  Read read_;
  const Settings& settings_;
  Worker worker_;
  std::chrono::steady_clock::time_point start_; ///< of the job
};

/// What a command that writes its own text (the mechanics commands) came to.
struct TextAnswer {
  int exit = exit_decided;
  std::string text;
  std::string limit = {}; ///< exit_undecided because a limit ended the work
  std::string early;      ///< and this was known by then; also where it was interrupted or crashed
  std::optional<InputError> error; ///< exit_input
  std::string internal;            ///< exit_internal
};

/// Answers jobs one after the other in a worker process under the limits of the settings: a limit,
/// an error or a crash is a value here, as in Solver, and costs one job.
class TextWorker {
public:
  /// Runs in the child, where what it keeps from job to job lives as long as the child.  Returns an
  /// exit code.
  using Serve =
      std::function<int(std::string_view job, std::ostream& out, const Worker::Early& early)>;

  TextWorker(const Settings& settings, Serve serve);
  [[nodiscard]] TextAnswer ask(std::string_view job);

private:
  const Settings& settings_;
  Worker worker_;
};

/// One job.
[[nodiscard]] TextAnswer limited(const Settings& settings,
                                 const std::function<int(std::ostream&)>& work);
/// The same for work that says early what it knows.
[[nodiscard]] TextAnswer
limited(const Settings& settings,
        const std::function<int(std::ostream&, const Worker::Early&)>& work);

/// An EquationText that is known beforehand (single questions).
[[nodiscard]] Solver::Read fixed_question(std::function<Question()> question);

/// The exit code with --exit-verdict taken into account.
[[nodiscard]] int exit_code(const Settings& settings, const Answer& answer);

/// One line, without line breaks; broken UTF-8 is replaced.
[[nodiscard]] std::string dump(const Json& j);
/// A page of it.
[[nodiscard]] std::string indented(const Json& j);

} // namespace kov::cli
