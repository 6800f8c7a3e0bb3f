#pragma once
// What ends an integration: Ctrl-C, the time, or somebody who asks.

#include "computation.hpp"

#include <atomic>
#include <chrono>
#include <thread>

namespace kov::python {

/// A flag that the interrupt raises, and the end of the time.
class Stop {
public:
  Stop(const Interrupt& interrupt, const Budget& budget)
      : watcher_([this, &interrupt, deadline = budget.deadline](const std::stop_token& done) {
          while (!done.stop_requested() && !flag_) {
            if (interrupt.raised() || (deadline && Budget::Clock::now() > *deadline)) flag_ = true;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
          }
        }) {}
  [[nodiscard]] const std::atomic<bool>* flag() const { return &flag_; }
  void request() { flag_ = true; }

private:
  std::atomic<bool> flag_{false};
  std::jthread watcher_;
};

} // namespace kov::python
