#pragma once
// Every search takes a Budget; check() is called in each loop that can be long.

#include "exact/error.hpp"

#include <chrono>
#include <cstdio>
#include <optional>
#include <stop_token>
#include <string>

namespace kov {

/// What a search may spend; by default no time limit.
/// Example Budget small; small.max_degree = 10; small.check_degree(11)  // -> throws OutOfBudget
/// Example Budget::of_seconds(60).check()  // -> done
struct Budget {
  using Clock = std::chrono::steady_clock;

  long max_degree = 100000;    ///< largest degree of a polynomial unknown
  long max_families = 1000000; ///< largest number of families that one case may look at
  double max_work = 1e8;       ///< products of terms in one search among polynomials (work.hpp)
  std::optional<Clock::time_point> deadline;
  double seconds = 0; ///< what the deadline was made from, for the message
  std::stop_token stop;

  [[nodiscard]] static Budget of_seconds(double s) {
    Budget b;
    b.seconds = s;
    b.deadline = Clock::now() +
                 std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
    return b;
  }

  /// Throws OutOfBudget when the time is over or the caller asked to stop.  Cost: one clock
  /// reading.
  void check() const {
    if (stop.stop_requested()) throw OutOfBudget("stopped on request");
    if (deadline && Clock::now() > *deadline) throw OutOfBudget(time_limit(seconds));
  }
  [[nodiscard]] static std::string time_limit(double seconds) {
    return "time limit of " + number(seconds) + " s reached";
  }
  [[nodiscard]] static std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", x);
    return text;
  }
  /// Throws OutOfBudget for a degree above max_degree.
  void check_degree(long degree) const {
    if (degree > max_degree)
      throw OutOfBudget("degree limit: a polynomial of degree up to " + std::to_string(degree) +
                        " would be needed, the limit is " + std::to_string(max_degree));
  }
};

} // namespace kov
