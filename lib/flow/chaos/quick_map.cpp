#include "flow/chaos/return_map.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {

std::vector<double> doubles(const PhasePoint<double>& x) {
  std::vector<double> all;
  for (const auto& c : x)
    all.push_back(c.v);
  return all;
}

std::optional<PhasePoint<double>> QuickMap::lifted(const Chart& chart, std::array<double, 2> at,
                                                   const std::vector<double>& near) {
  PhasePoint<double> x(near.begin(), near.end());
  for (std::size_t d = 0; d < 2; ++d) {
    x[chart.free[d]] = Dual<double>(at[d]);
    x[chart.free[d]].d[d] = 1;
  }
  for (int i = 0; i < 12; ++i) {
    const auto v = code_.at(x);
    std::vector<std::vector<double>> a;
    std::vector<std::vector<double>> right(3);
    for (std::size_t e = 0; e < v.slope.size(); ++e) {
      a.emplace_back();
      for (const std::size_t j : chart.rest)
        a.back().push_back(v.slope[e][j].v);
      right[0].push_back(v.equations[e].v);
      for (std::size_t d = 0; d < 2; ++d)
        right[d + 1].push_back(-v.slope[e][chart.free[d]].v);
    }
    const auto step = solved(a, right[0]), by_u = solved(a, right[1]), by_v = solved(a, right[2]);
    double length = 0, size = 0;
    for (std::size_t k = 0; k < step.size(); ++k) {
      Dual<double>& c = x[chart.rest[k]];
      c = Dual<double>(c.v - step[k], by_u[k], by_v[k]);
      length = std::max(length, std::abs(step[k]));
      size = std::max(size, std::abs(c.v));
    }
    if (!std::isfinite(length) || length > 1e3 * (size + 1)) return std::nullopt;
    if (length < 1e-14 * (size + 1)) return x;
  }
  return std::nullopt;
}

std::optional<QuickMap::Image> QuickMap::operator()(const PhasePoint<double>& from, bool backward,
                                                    int turns) {
  Image all{from, 0};
  for (int i = 0; i < turns; ++i) {
    const auto one = returned(all.at, backward);
    if (!one) return std::nullopt;
    all = {one->at, all.time + one->time};
  }
  return all;
}

std::optional<QuickMap::Image> QuickMap::returned(const PhasePoint<double>& from, bool backward) {
  const double way = backward ? -1 : 1, sign = s_.rising() ? 1 : -1;
  PhasePoint<double> x = from;
  double time = 0, s0 = 0;
  for (int step = 0; step < 2000; ++step) {
    code_.expand(x, order);
    double h = 1e100;
    for (const int k : {order - 1, order}) {
      double size = 1e-300;
      for (std::size_t j = 0; j < x.size(); ++j)
        size = std::max(size, std::abs(code_.coefficient(j, k).v));
      h = std::min(h, std::pow(1e-17 / size, 1.0 / k));
    }
    if (!(h > 1e-9) || !std::isfinite(h)) return std::nullopt;
    PhasePoint<double> end = code_.polynomial(way * h, order);
    const double s1 = sign * way * code_.at(end).equations[0].v;
    if (step > 0 && s0 < 0 && s1 >= 0) {
      double low = 0, high = h, t = h * s0 / (s0 - s1);
      for (int i = 0; i < 40; ++i) {
        const auto v = code_.at(code_.polynomial(way * t, order));
        const double s = sign * way * v.equations[0].v;
        (s < 0 ? low : high) = t;
        double speed = 0;
        for (std::size_t j = 0; j < x.size(); ++j)
          speed += sign * v.slope[0][j].v * v.field[j].v;
        double next = t - s / speed;
        if (!(next > low && next < high)) next = (low + high) / 2;
        if (std::abs(next - t) < 1e-16 * h) break;
        t = next;
      }
      PhasePoint<double> y = code_.polynomial(way * t, order);
      const auto v = code_.at(y);
      if (v.side.v > 0) {
        double speed = 0, slope[2] = {0, 0};
        for (std::size_t j = 0; j < x.size(); ++j) {
          speed += v.slope[0][j].v * v.field[j].v;
          for (int d = 0; d < 2; ++d)
            slope[d] += v.slope[0][j].v * y[j].d[d];
        }
        for (std::size_t j = 0; j < x.size(); ++j)
          for (int d = 0; d < 2; ++d)
            y[j].d[d] -= v.field[j].v * slope[d] / speed;
        return Image{y, time + way * t};
      }
    }
    x = end;
    s0 = s1;
    time += way * h;
  }
  return std::nullopt;
}

} // namespace kov::flow
