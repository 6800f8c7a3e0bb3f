#pragma once
// How fast a small deviation v(t) of one orbit grows: chaos, in numbers.
//
//   lyapunov   (1/t) log |v(t)/v(0)|, or the same over the last half, quarter or eighth of the time if that is far more
//              certain (an orbit that has come to a sink).  Its error: the spread over blocks of the time, or what the
//              next shorter part of the time says if that is more, and log |v| = 2 for the direction of v
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
    double time = 0, later = 0, square = 0;
    Slope s;
    s.rate = rate(begin, time);
    for (int k = begin; k < used_; ++k) {
      const double d = logs_[k] - times_[k] * s.rate;
      square += d * d;
    }
    const double spread = n > 1 ? std::sqrt(square * n / (n - 1.0)) / time : std::abs(s.rate);
    const double change = n > 1 ? std::abs(s.rate - rate(begin + n / 2, later)) : 0;
    s.error = (change > spread ? change : spread) + 2 / time;
    return s;
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

  static constexpr int most_blocks = 32;
  double first_ = 0, last_ = 0, most_ = 0, t_ = 0, log_integral_ = 0, y_ = 0, y_integral_ = 0;
  double times_[most_blocks]{}, logs_[most_blocks]{};
  int used_ = 0;
  long in_block_ = 0, length_ = 16;
};

} // namespace KOV_ISA
} // namespace kov::flow
