#include "flow/scene/winding.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kov::flow {
namespace {

constexpr double turn = 6.283185307179586;
constexpr std::size_t least_points = 16;
constexpr double widest_gap = 0.36 * turn; // seen from the centre
constexpr double most_uneven =
    0.48; // of a turn: an advance that differs more from the mean is not told from less

double weighted_mean(const std::vector<double>& d, std::size_t first, std::size_t end) {
  double sum = 0, all = 0;
  const auto n = static_cast<double>(end - first + 1);
  for (std::size_t i = first; i < end; ++i) {
    const double s = static_cast<double>(i - first + 1) / n, w = std::exp(-1 / (s * (1 - s)));
    sum += w * d[i];
    all += w;
  }
  return sum / all;
}

// advances: in turns
Winding mean_of(const std::vector<double>& advances) {
  const std::size_t n = advances.size();
  Winding w;
  w.turns = weighted_mean(advances, 0, n);
  double apart = 0;
  for (const auto& [first, end] :
       {std::pair{std::size_t{0}, n / 2}, {n / 2, n}, {n / 4, n - n / 4}})
    apart = std::max(apart, std::abs(weighted_mean(advances, first, end) - w.turns));
  w.error = apart + 1e-15 * (1 + std::abs(w.turns));
  return w;
}

Winding of_angle(const std::vector<std::array<double, 2>>& points, std::size_t part) {
  std::vector<double> advances;
  for (std::size_t i = 1; i < points.size(); ++i)
    advances.push_back((points[i][part] - points[i - 1][part]) / turn);
  return mean_of(advances);
}

bool goes_round(const std::vector<std::array<double, 2>>& points, std::size_t part) {
  const auto [least, most] =
      std::minmax_element(points.begin(), points.end(),
                          [&](const auto& a, const auto& b) { return a[part] < b[part]; });
  return (*most)[part] - (*least)[part] >= turn;
}

// Directions of the points from their centre, where the covariance is 1.  Empty: they lie on a line.
std::vector<double> directions(const std::vector<std::array<double, 2>>& points) {
  const auto n = static_cast<double>(points.size());
  std::array<double, 2> centre{};
  for (const auto& p : points)
    for (std::size_t i = 0; i < 2; ++i)
      centre[i] += p[i] / n;
  double xx = 0, xy = 0, yy = 0;
  for (const auto& p : points) {
    const double x = p[0] - centre[0], y = p[1] - centre[1];
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const double rest = yy - xy * xy / xx; // of y, without its part along x
  if (!(xx > 0) || !(rest > 1e-20 * yy)) return {};
  std::vector<double> all;
  for (const auto& p : points) {
    const double x = p[0] - centre[0], y = p[1] - centre[1];
    all.push_back(std::atan2((y - x * xy / xx) / std::sqrt(rest), x / std::sqrt(xx)));
  }
  return all;
}

bool surrounds(std::vector<double> directions) {
  std::ranges::sort(directions);
  double gap = directions.front() + turn - directions.back();
  for (std::size_t i = 1; i < directions.size(); ++i)
    gap = std::max(gap, directions[i] - directions[i - 1]);
  return gap < widest_gap;
}

} // namespace

Winding winding_of(const std::vector<std::array<double, 2>>& points,
                   const std::array<bool, 2>& angle) {
  if (points.size() < least_points) return {};
  for (std::size_t part = 0; part < 2; ++part)
    if (angle[part] && goes_round(points, part)) return of_angle(points, part);
  const std::vector<double> seen = directions(points);
  if (seen.empty() || !surrounds(seen)) return {};
  std::vector<double> advances;
  double cosine = 0, sine = 0;
  for (std::size_t i = 1; i < seen.size(); ++i) {
    advances.push_back((seen[i] - seen[i - 1]) / turn);
    cosine += std::cos(turn * advances.back());
    sine += std::sin(turn * advances.back());
  }
  const double mean = std::atan2(sine, cosine) / turn;
  double uneven = 0;
  for (double& a : advances) {
    a = mean + std::remainder(a - mean, 1.0);
    uneven = std::max(uneven, std::abs(a - mean));
  }
  Winding w = mean_of(advances);
  if (uneven > most_uneven) w.error = std::max(w.error, 0.5);
  return w;
}

} // namespace kov::flow
