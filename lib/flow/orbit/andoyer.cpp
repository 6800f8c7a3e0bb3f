#include "flow/orbit/andoyer.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {

namespace {

double sum_of_sizes(const Vec<double>& v) {
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

// |m g L.Gamma| at most
double weight(const Body<double>& b, const Levels<double>& f) {
  return b.mass * std::abs(b.gravity) * sum_of_sizes(b.lever) * std::sqrt(f.length);
}

} // namespace

// H >= M^2/(2 tr J) - weight with J = I + m v v^T, |v| <= |L| |Gamma|, for the sliding tip and J =
// I otherwise.
double largest_momentum(const Body<double>& b, const Levels<double>& f) {
  double moments = b.inertia[0][0] + b.inertia[1][1] + b.inertia[2][2];
  const double lever = sum_of_sizes(b.lever);
  if (b.sliding) moments += b.mass * lever * lever * f.length;
  return std::sqrt(2 * moments * (std::abs(f.energy) + weight(b, f))) * 1.01 +
         2 * sum_of_sizes(b.gyrostat);
}

std::vector<double> momentum_sizes(const Body<double>& b, const Levels<double>& f,
                                   const SectionRule& rule, double l, double y) {
  const auto excess = [&](double g) {
    return integrals(b, section_point(b, f, rule, l, y, g)).energy - f.energy;
  };
  const double most = largest_momentum(b, f);
  const double least = std::abs(f.casimir) / std::sqrt(f.length) * (1 + 1e-13);
  std::vector<double> found;
  const int cells = 400;
  const double start = std::max(least, most * 1e-9);
  double low = start, at_low = excess(start);
  for (int i = 1; i <= cells && most > start; ++i) {
    const double high = start + (most - start) * i / cells;
    const double at_high = excess(high);
    if ((at_low > 0) != (at_high > 0)) {
      double a = low, c = high;
      for (int k = 0; k < 100; ++k) {
        const double middle = (a + c) / 2;
        ((excess(middle) > 0) == (at_low > 0) ? a : c) = middle;
      }
      found.push_back(a);
    }
    low = high;
    at_low = at_high;
  }
  return found;
}

} // namespace kov::flow
