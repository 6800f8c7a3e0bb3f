#pragma once
// Ctrl-C sets a flag for the duration of a computation, which then keeps what it has; a second
// Ctrl-C kills.

#include <atomic>
#include <csignal>

namespace kov::cli {

class Interrupt {
public:
  Interrupt() {
    raised() = false;
    before_ = std::signal(SIGINT, &handle);
  }
  ~Interrupt() { std::signal(SIGINT, before_); }
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  [[nodiscard]] const std::atomic<bool>* flag() const { return &raised(); }

private:
  static std::atomic<bool>& raised() {
    static std::atomic<bool> flag{false};
    return flag;
  }
  static void handle(int) {
    raised() = true;
    std::signal(SIGINT, SIG_DFL);
  }
  void (*before_)(int) = SIG_DFL;
};

} // namespace kov::cli
