#include "flow/chaos/return_map.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

double middle(double x) { return x; }
Enclosure middle(const Enclosure& x) { return x.middle(); }
template <class R> PhasePoint<R> middles(PhasePoint<R> x) {
  for (Dual<R>& c : x)
    c = {middle(c.v), middle(c.d[0]), middle(c.d[1])};
  return x;
}

template <class R> double size_of(const R& x) { return std::abs(static_cast<double>(x)); }

template <class R> constexpr bool in_double = std::is_same_v<R, double>;

} // namespace

std::vector<double> doubles(const PhasePoint<double>& x) {
  std::vector<double> all;
  for (const auto& c : x)
    all.push_back(c.v);
  return all;
}

template <class R>
QuickMapOf<R>::QuickMapOf(const SectionSurface& s)
    : s_(s),
      tolerance_(in_double<R> ? 1e-16 : std::exp2(-0.625 * static_cast<double>(Enclosure::bits()))),
      order_(in_double<R> ? 18 : static_cast<int>(Enclosure::bits()) / 5 + 4), code_(s, order_) {}

template <class R>
std::optional<PhasePoint<R>> QuickMapOf<R>::lifted(const Chart& chart, std::array<R, 2> at,
                                                   const std::vector<double>& near) {
  PhasePoint<R> x(near.begin(), near.end());
  for (std::size_t d = 0; d < 2; ++d) {
    x[chart.free[d]] = Dual<R>(at[d]);
    x[chart.free[d]].d[d] = R(1);
  }
  for (int i = 0; i < 12; ++i) {
    const auto v = code_.at(x);
    std::vector<std::vector<R>> a;
    std::vector<std::vector<R>> right(3);
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
      Dual<R>& c = x[chart.rest[k]];
      c = {middle(R(c.v - step[k])), middle(by_u[k]), middle(by_v[k])};
      length = std::max(length, size_of(step[k]));
      size = std::max(size, size_of(c.v));
    }
    if (!std::isfinite(length) || length > 1e3 * (size + 1)) return std::nullopt;
    if (length < (in_double<R> ? 1e-14 : tolerance_) * (size + 1)) return x;
  }
  return std::nullopt;
}

template <class R>
std::optional<typename QuickMapOf<R>::Image> QuickMapOf<R>::operator()(const PhasePoint<R>& from,
                                                                       bool backward, int turns) {
  Image all{from, R(0)};
  for (int i = 0; i < turns; ++i) {
    const auto one = returned(all.at, backward);
    if (!one) return std::nullopt;
    all = {one->at, R(all.time + one->time)};
  }
  return all;
}

template <class R> double QuickMapOf<R>::step_size(std::size_t dimension) const {
  double h = 1e100;
  for (const int k : {order_ - 1, order_}) {
    double size = 1e-300;
    for (std::size_t j = 0; j < dimension;
         ++j) { // derivatives, too: values may vanish on a symmetry
      const Dual<R>& c = code_.coefficient(j, k);
      size = std::max({size, size_of(c.v), size_of(c.d[0]), size_of(c.d[1])});
    }
    h = std::min(h, std::pow(tolerance_ / size, 1.0 / k));
  }
  return h;
}

template <class R> R QuickMapOf<R>::rate(const SurfaceValues<R>& v) const {
  R speed(0);
  for (std::size_t j = 0; j < v.field.size(); ++j)
    speed += v.slope[0][j].v * v.field[j].v;
  return speed;
}

// The section's function has changed its sign from s0 to s1 in the step h.
template <class R> R QuickMapOf<R>::crossing_time(double h, double s0, double s1, double way) {
  const double sign = s_.rising() ? 1 : -1;
  double low = 0, high = h, t = h * s0 / (s0 - s1);
  const auto newton = [&](const R& at) {
    const auto v = code_.at(code_.polynomial(R(way) * at, order_));
    const R s = R(sign * way) * v.equations[0].v;
    (static_cast<double>(s) < 0 ? low : high) = static_cast<double>(at);
    return R(at - s / (R(sign) * rate(v)));
  };
  for (int i = 0; i < 40; ++i) {
    auto next = static_cast<double>(newton(R(t)));
    if (std::abs(next - t) < 1e-16 * h) break;
    if (!(next > low && next < high)) next = (low + high) / 2;
    t = next;
  }
  if constexpr (in_double<R>) return t;
  R exact(t);
  for (int i = 0; i < 3; ++i)
    exact = middle(newton(exact));
  return exact;
}

template <class R>
std::optional<typename QuickMapOf<R>::Image> QuickMapOf<R>::returned(const PhasePoint<R>& from,
                                                                     bool backward) {
  const double way = backward ? -1 : 1, sign = s_.rising() ? 1 : -1;
  PhasePoint<R> x = from;
  R time(0);
  double s0 = 0;
  for (int step = 0; step < 2000; ++step) {
    code_.expand(x, order_);
    const double h = step_size(x.size());
    if (!(h > 1e-9) || !std::isfinite(h)) return std::nullopt;
    const PhasePoint<R> end = middles(code_.polynomial(R(way * h), order_));
    const double s1 = sign * way * static_cast<double>(code_.at(end).equations[0].v);
    if (step > 0 && s0 < 0 && s1 >= 0) {
      const R t = crossing_time(h, s0, s1, way);
      PhasePoint<R> y = middles(code_.polynomial(R(way) * t, order_));
      const auto v = code_.at(y);
      if (static_cast<double>(v.side.v) > 0) {
        const R speed = rate(v);
        R slope[2] = {R(0), R(0)};
        for (std::size_t j = 0; j < x.size(); ++j)
          for (int d = 0; d < 2; ++d)
            slope[d] += v.slope[0][j].v * y[j].d[d];
        for (std::size_t j = 0; j < x.size(); ++j)
          for (int d = 0; d < 2; ++d)
            y[j].d[d] -= v.field[j].v * slope[d] / speed;
        return Image{middles(y), R(time + R(way) * t)};
      }
    }
    x = end;
    s0 = s1;
    time += R(way * h);
  }
  return std::nullopt;
}

template class QuickMapOf<double>;
template class QuickMapOf<Enclosure>;

} // namespace kov::flow
