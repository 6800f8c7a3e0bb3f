#include "flow/scene/point_errors.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

constexpr double safety = 2;

// Crossings before that are looked at, too: a difference may vanish by chance, and on a regular orbit it does so slowly.
std::size_t memory(std::size_t i) { return std::min(i, 4 + i / 4); }

double modulo_turn(double angle) {
  const double turn = 2 * pi_of(0.0);
  return angle - turn * std::floor(angle / turn + 0.5);
}

template <class R>
PointDifference difference(const RawPoint<R>& a, const RawPoint<R>& b,
                           const std::array<bool, 2>& angle) {
  PointDifference d;
  d.t = std::abs(to_double(R(a.t - b.t)));
  for (std::size_t i = 0; i < 2; ++i) {
    d.size[i] = angle[i] ? 1 : a.size[i];
    const double terms = std::abs(to_double(a.at[i])) + a.size[i];
    d.rounding = std::max(d.rounding, terms / d.size[i]);
    if (a.by_section[i] > 0) d.by_section = std::max(d.by_section, a.by_section[i] / d.size[i]);
    const double apart = to_double(R(a.at[i] - b.at[i]));
    d.at[i] = std::abs(angle[i] ? modulo_turn(apart) : apart);
  }
  return d;
}

bool is_nearer(const PointDifference& a, const PointDifference& b) {
  return std::max(a.at[0], a.at[1]) < std::max(b.at[0], b.at[1]);
}

} // namespace

template <class R>
std::vector<PointDifference> compared(const std::vector<RawPoint<R>>& first,
                                      const std::vector<RawPoint<R>>& second,
                                      const std::array<bool, 2>& angle) {
  std::vector<PointDifference> all;
  std::ptrdiff_t shift = 0; // of the numbers of two crossings that belong together
  std::size_t near = 0;     // the nearest in time
  const auto distance = [&](std::size_t i, std::size_t j) {
    return std::abs(to_double(R(first[i].t - second[j].t)));
  };
  for (std::size_t i = 0; i < first.size(); ++i) {
    PointDifference best{INFINITY, {INFINITY, INFINITY}, first[i].size};
    while (near + 1 < second.size() && distance(i, near + 1) <= distance(i, near))
      ++near;
    const std::ptrdiff_t same = static_cast<std::ptrdiff_t>(i) + shift;
    if (same >= 0 && same < static_cast<std::ptrdiff_t>(second.size()))
      best = difference(first[i], second[static_cast<std::size_t>(same)], angle);
    if (near < second.size())
      if (const PointDifference other = difference(first[i], second[near], angle);
          is_nearer(other, best)) {
        best = other;
        shift = static_cast<std::ptrdiff_t>(near) - static_cast<std::ptrdiff_t>(i);
      }
    all.push_back(best);
  }
  return all;
}

std::vector<double> errors_of(const std::vector<PointDifference>& differences, double roundoff) {
  std::vector<double> one, all;
  bool lost = false;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const PointDifference& d = differences[i];
    double here = 0;
    for (std::size_t part = 0; part < 2; ++part)
      here = std::max(here, d.at[part] > 0 ? d.at[part] / d.size[part] : 0);
    one.push_back(here);
    const auto now = one.end();
    double e = std::min(
        1.0, 4 * roundoff * d.rounding + d.by_section +
                 safety * *std::max_element(now - 1 - static_cast<std::ptrdiff_t>(memory(i)), now));
    if (lost) e = std::max(e, error_lost);
    lost = lost || e >= error_lost;
    all.push_back(e);
  }
  return all;
}

template std::vector<PointDifference> compared(const std::vector<RawPoint<double>>&,
                                               const std::vector<RawPoint<double>>&,
                                               const std::array<bool, 2>&);
template std::vector<PointDifference> compared(const std::vector<RawPoint<long double>>&,
                                               const std::vector<RawPoint<long double>>&,
                                               const std::array<bool, 2>&);
template std::vector<PointDifference> compared(const std::vector<RawPoint<Twin1>>&,
                                               const std::vector<RawPoint<Twin1>>&,
                                               const std::array<bool, 2>&);
template std::vector<PointDifference> compared(const std::vector<RawPoint<BigReal>>&,
                                               const std::vector<RawPoint<BigReal>>&,
                                               const std::array<bool, 2>&);

} // namespace kov::flow
