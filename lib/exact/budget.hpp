#pragma once
// Every search takes a Budget; check() is called in each loop that can be long.

#include "exact/error.hpp"
#include "exact/meter.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <stop_token>
#include <string>

namespace kov {

/// The limits of a search; by default there is no limit of the whole work, and none of time.  What
/// is found depends on the work alone: time only ends what is running.
/// Example Budget small; small.max_degree = 10; small.check_degree(11)  // -> throws OutOfBudget
/// Example Budget::of_seconds(60).check()  // -> done
/// Example Budget little; little.give(100); charge(101); little.check()  // -> throws OutOfBudget
struct Budget {
  using Clock = std::chrono::steady_clock;

  long max_degree = 100000;       ///< largest degree of a polynomial unknown
  long max_families = 1000000;    ///< largest number of families that one case may look at
  double max_work = 1e8;          ///< products of terms in one search among polynomials (work.hpp)
  std::optional<double> work_end; ///< the meter's reading at which all ends, in the thread at work
  double work = 0;                ///< what work_end was made from, for the message
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

  /// From now on.
  void give(double units) {
    work = units;
    work_end = meter() + units;
  }
  /// Gives the usual work of a question with many searches, in the whole: one to two minutes of a
  /// processor of 2024. (Seconds at least: a small limit of one search is none of the rest.)
  void give_by_default() { give(70 * std::max(max_work, 1e7)); }

  /// Throws OutOfBudget when the work is done, the time is over or the caller asked to stop.  Cost:
  /// one clock reading.
  void check() const {
    if (is_spent()) throw OutOfBudget(work_limit(work));
    if (stop.stop_requested()) throw OutOfBudget("stopped on request");
    if (deadline && Clock::now() > *deadline) throw OutOfBudget(time_limit(seconds));
  }
  [[nodiscard]] bool is_spent() const { return work_end && meter() > *work_end; }
  /// Ended by the clock, or on request: then an answer says less than the work would allow.
  [[nodiscard]] bool is_cut_short() const {
    return stop.stop_requested() || (deadline && Clock::now() > *deadline);
  }
  [[nodiscard]] static std::string work_limit(double units) {
    char text[40];
    std::snprintf(text, sizeof text, "%.2g", units);
    return "work limit of " + std::string(text) + " reached";
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
