#pragma once
// How fast a small deviation v(t) of one orbit grows: chaos, in numbers.
//
//   lyapunov   (1/t) log |v(t)/v(0)|, or the same over the last half, quarter or eighth of the time if that is far more
//              certain (an orbit that has come to a sink).  Its error: the spread over blocks of the time, short or long,
//              and what the last half says; and for the direction of v, and the power of t by which |v| grows on a
//              regular orbit, log |v| = 1 + log(steps)/2.  Of many chaotic orbits 85 to 99 % lie within two of it
//              (exponent_bars_test.cpp)
//   FLI        the largest log |v(s)/v(0)|, s <= t                                    [FroeschleLegaGonczi1997]
//   MEGNO      <Y>(t), the mean over s <= t of Y(s) = (2/s) int_0^s (|v|'/|v|) r dr;  [CincottaGiordanoSimo2003]
//              2 on a regular orbit, (lyapunov/2) t on a chaotic one.  By parts
//              Y(s) = 2 (log |v(s)| - (1/s) int_0^s log |v|), so that no derivative is needed
//
// Logarithms are natural; |v| in units of the scales of the coordinates (orbits.hpp).

#include "flow/number/lanes.hpp"

#include <cmath>

namespace kov::flow {

struct Indicators {
  double lyapunov = 0, lyapunov_error = 0; ///< per unit of time
  double fli = 0, megno = 0;
};

inline namespace KOV_ISA {

class Growth {
public:
  void begin(double log_norm) {
    *this = Growth();
    last_ = log_norm;
    first_ = log_norm;
  }
  /// After a step of length h the logarithm of |v| is log_norm.
  void step(double h, double log_norm) {
    const double now = log_norm - first_, before = last_ - first_;
    const double old_t = t_;
    t_ += h;
    log_integral_ += h * (now + before) / 2;
    const double y = 2 * (now - log_integral_ / t_);
    y_integral_ += (t_ - old_t) * (y + y_) / 2;
    y_ = y;
    most_ = now > most_ ? now : most_;
    last_ = log_norm;
    ++steps_;
    block(h, now - before);
  }
  [[nodiscard]] Indicators indicators() const {
    Indicators i;
    if (!(t_ > 0)) return i;
    i.fli = most_;
    i.megno = y_integral_ / t_;
    const Slope whole = slope(0);
    i.lyapunov = whole.rate;
    i.lyapunov_error = whole.error;
    for (int begin = used_ / 2; used_ - begin >= 4; begin += (used_ - begin + 1) / 2) {
      const Slope last = slope(begin);
      if (!(4 * last.error < i.lyapunov_error)) continue;
      i.lyapunov = last.rate;
      i.lyapunov_error = last.error;
    }
    return i;
  }

private:
  struct Slope {
    double rate = 0, error = 0;
  };
  double rate(int begin, double& time) const {
    double log = 0;
    time = 0;
    for (int k = begin; k < used_; ++k) {
      time += times_[k];
      log += logs_[k];
    }
    return log / time;
  }
  // Over the blocks from `begin` on.
  Slope slope(int begin) const {
    const int n = used_ - begin;
    double time = 0, later = 0;
    Slope s;
    s.rate = rate(begin, time);
    double spread = n > 1 ? 0 : std::abs(s.rate);
    for (int together = 1; n / together >= 4 || (together == 1 && n > 1); together *= 2) {
      const double one = spread_of(begin, together, s.rate) / time;
      spread = one > spread ? one : spread;
    }
    const double change = n > 1 ? std::abs(s.rate - rate(begin + n / 2, later)) : 0;
    s.error = std::sqrt(change * change + few_blocks * spread * spread) +
              (1 + 0.5 * std::log(1.0 + static_cast<double>(steps_))) / time;
    return s;
  }
  // Of sums of `together` neighbours: an orbit that sticks somewhere for longer than a block has blocks that depend on
  // each other, and long ones tell it.
  double spread_of(int begin, int together, double rate_of_all) const {
    double square = 0;
    const int groups = (used_ - begin) / together;
    for (int g = 0; g < groups; ++g) {
      double d = 0;
      for (int k = used_ - (g + 1) * together; k < used_ - g * together; ++k)
        d += logs_[k] - times_[k] * rate_of_all;
      square += d * d;
    }
    return std::sqrt(square * groups / (groups - 1.0));
  }

  // Blocks of as many steps each; when all are used, neighbours become one.
  void block(double h, double change) {
    if (in_block_ == 0) {
      if (used_ == most_blocks) {
        for (int k = 0; k < most_blocks / 2; ++k) {
          times_[k] = times_[2 * k] + times_[2 * k + 1];
          logs_[k] = logs_[2 * k] + logs_[2 * k + 1];
        }
        used_ = most_blocks / 2;
        length_ *= 2;
      }
      times_[used_] = logs_[used_] = 0;
      ++used_;
    }
    times_[used_ - 1] += h;
    logs_[used_ - 1] += change;
    in_block_ = (in_block_ + 1) % length_;
  }

  static constexpr double few_blocks =
      2.6; ///< a spread of few blocks is uncertain itself, and an orbit may stick somewhere
  static constexpr int most_blocks = 32;
  double first_ = 0, last_ = 0, most_ = 0, t_ = 0, log_integral_ = 0, y_ = 0, y_integral_ = 0;
  double times_[most_blocks]{}, logs_[most_blocks]{};
  int used_ = 0;
  long in_block_ = 0, length_ = 16, steps_ = 0;
};

} // namespace KOV_ISA
} // namespace kov::flow
