#pragma once
// The work is done in a child process, so that a time limit holds inside any library call, the
// memory has a ceiling, and a crash costs one answer and not the run.

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace kov::cli {

struct ProcessLimits {
  double seconds = 0;               ///< per job; 0 = none
  std::size_t megabytes = 4 * 1024; ///< address space of the child; 0 = none
};

/// How a job ended.
struct Reply {
  /// killed: by a signal from outside, e.g. of the kernel that is short of memory
  enum class End : std::uint8_t { answered, timeout, out_of_memory, killed, crashed, interrupted };
  Reply() = default;
  explicit Reply(End how) : end(how) {}

  End end = End::answered;
  std::string answer; ///< answered; and interrupted, if the job could still say what it had
  std::string early;  ///< the last early message of a job that was not answered
  std::string detail; ///< of an end by a signal: "signal 11 (Segmentation fault)"
};

/// A child process that answers jobs one after the other, and is replaced when it dies.
class Worker {
public:
  using Early = std::function<void(std::string_view)>;
  /// Runs in the child.  What it passes to Early arrives even if the job is ended from outside.
  using Serve = std::function<std::string(std::string_view job, const Early& early)>;

  Worker(Serve serve, ProcessLimits limits);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker();

  /// Cost  one fork for the first job and after each death; then two small messages per job.
  [[nodiscard]] Reply ask(std::string_view job);

  /// The same in two steps, for several workers at once: begin() after the reply to the last job.
  void begin(std::string_view job);
  /// The reply, if it is there or the time is over; does not wait for a job that goes on.
  [[nodiscard]] std::optional<Reply> finished();
  [[nodiscard]] bool started() const { return pid_ >= 0; }

  /// Waits until finished() of one of the workers, all of them at work, may have news, or `input`
  /// (a file descriptor; -1: none) something to read; false: interrupted by Ctrl-C.
  [[nodiscard]] static bool wait(const std::vector<const Worker*>& at_work, int input);

  /// Called twice a second while ask() waits, with the seconds since it began and the last early message;
  /// with less than 0 seconds when the wait is over.
  using Waiting = std::function<void(double seconds, std::string_view early)>;
  static void while_waiting(Waiting show);

private:
  void start();
  void stop();
  [[noreturn]] void child(int channel) const;
  std::optional<Reply> next_message();
  [[nodiscard]] std::string early() const;
  [[nodiscard]] std::string last_words();
  Reply ended();

  struct Notice;
  using Clock = std::chrono::steady_clock;

  Serve serve_;
  ProcessLimits limits_;
  Notice* notice_; ///< shared with the child
  pid_t pid_ = -1;
  Clock::time_point deadline_;             ///< of the job, if there is a limit
  std::optional<Clock::time_point> began_; ///< of a job that is waited for
  std::optional<Reply> lost_;              ///< of a job that could not be given to the child
  std::string early_;                      ///< what the job has said too long for the notice
  int channel_ = -1;
};

/// In a worker: set by Ctrl-C or SIGTERM, which asks the job to end with what it has; it has two seconds.
[[nodiscard]] std::stop_token stopped_by_hand();

/// Makes Ctrl-C and SIGTERM end the current job (Reply::End::interrupted) instead of the program.
void catch_interrupts();

} // namespace kov::cli
