#include "exact/share.hpp"

#include <cmath>

namespace kov {
namespace {

// For the message: clocks are not more exact.
double two_digits(double x) {
  if (!(x > 0)) return 0;
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return std::round(x / unit) * unit;
}

} // namespace

Budget part_of_the_time(Budget budget, double part) {
  const auto now = Budget::Clock::now();
  if (part >= 1 || !budget.deadline || *budget.deadline <= now) return budget;
  const auto given = part * std::chrono::duration<double>(*budget.deadline - now);
  budget.deadline = now + std::chrono::duration_cast<Budget::Clock::duration>(given);
  budget.seconds = two_digits(given.count());
  return budget;
}

} // namespace kov
