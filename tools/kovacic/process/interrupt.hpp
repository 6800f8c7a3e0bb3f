#pragma once
// Ctrl-C, SIGTERM or the end of the time sets a flag for the duration of a computation, which then
// keeps what it has; a second Ctrl-C kills.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>

namespace kov::cli {

/// The signal that asked this process to end, or 0.
inline volatile std::sig_atomic_t ending_signal = 0;

class Interrupt {
public:
  /// seconds: until the flag is set; 0: never
  explicit Interrupt(double seconds = 0) {
    raised() = false;
    before_ = std::signal(SIGINT, &handle);
    before_term_ = std::signal(SIGTERM, &handle);
    if (seconds > 0)
      timer_ = std::jthread([this, seconds](const std::stop_token& done) { wait(seconds, done); });
  }
  ~Interrupt() {
    std::signal(SIGINT, before_);
    std::signal(SIGTERM, before_term_);
  }
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  [[nodiscard]] const std::atomic<bool>* flag() const { return &raised(); }
  [[nodiscard]] bool timed_out() const { return timed_out_; }

private:
  static std::atomic<bool>& raised() {
    static std::atomic<bool> flag{false};
    return flag;
  }
  static void handle(int signal) {
    raised() = true;
    ending_signal = signal;
    if (signal == SIGINT) std::signal(SIGINT, SIG_DFL); // timeout(1) sends SIGTERM twice
  }
  void wait(double seconds, const std::stop_token& done) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any bell;
    bell.wait_for(lock, done, std::chrono::duration<double>(seconds), [] { return false; });
    if (done.stop_requested()) return;
    timed_out_ = true;
    raised() = true;
  }
  void (*before_)(int) = SIG_DFL;
  void (*before_term_)(int) = SIG_DFL;
  std::atomic<bool> timed_out_{false};
  std::jthread timer_; // last: it ends before the rest
};

} // namespace kov::cli
