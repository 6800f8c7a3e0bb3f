#include "flow/chaos/periodic_orbit.hpp"

#include "exact/lists.hpp"
#include "flow/chaos/krawczyk.hpp"
#include "flow/scene/starts.hpp"
#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

using Ball = Enclosure;
using State2 = std::vector<double>; // a point of phase space

double distance(const State2& a, const State2& b) {
  double most = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    most = std::max(most, std::abs(a[j] - b[j]));
  return most;
}
double size_of(const State2& a) { return distance(a, State2(a.size())); }

// ---- search ----

class OrbitSearch {
public:
  OrbitSearch(QuickMap& map, int period, const std::atomic<bool>* stop)
      : map_(map), period_(period), stop_(stop) {}

  void from(const State2& start) {
    if (stop_ != nullptr && stop_->load()) return;
    const auto orbit = newton(start);
    if (!orbit) return;
    for (const auto& known : found)
      for (const State2& x : known)
        if (distance(x, orbit->front()) < 1e-6 * (size_of(x) + 1e-300)) return;
    found.push_back(*orbit);
  }
  std::vector<std::vector<State2>> found;

private:
  QuickMap& map_;
  int period_;
  const std::atomic<bool>* stop_;

  // The orbit of one turn from x; its last point carries the derivatives by x's chart coordinates.
  std::optional<std::vector<PhasePoint<double>>> turn(const PhasePoint<double>& x) {
    std::vector<PhasePoint<double>> all{x};
    for (int k = 0; k < period_; ++k) {
      const auto next = map_(all.back());
      if (!next) return std::nullopt;
      all.push_back(next->at);
    }
    return all;
  }

  std::optional<std::vector<State2>> newton(const State2& start) {
    const Chart chart = chart_at(map_.code(), start);
    const double scale = size_of(start);
    State2 near = start;
    for (int i = 0; i < 25; ++i) {
      const auto x = map_.lifted(chart, {near[chart.free[0]], near[chart.free[1]]}, near);
      if (!x) return std::nullopt;
      const auto orbit = turn(*x);
      if (!orbit) return std::nullopt;
      const Dual<double>&u = orbit->back()[chart.free[0]], &v = orbit->back()[chart.free[1]];
      const auto step = solved<double>({{u.d[0] - 1, u.d[1]}, {v.d[0], v.d[1] - 1}},
                                       {u.v - (*x)[chart.free[0]].v, v.v - (*x)[chart.free[1]].v});
      const double length = std::hypot(step[0], step[1]);
      if (!std::isfinite(length)) return std::nullopt;
      if (length < 1e-11 * scale) return closed(*orbit, scale);
      const double shorten = std::min(1.0, 0.1 * scale / length);
      near = doubles(*x);
      for (std::size_t d = 0; d < 2; ++d)
        near[chart.free[d]] -= shorten * step[d];
    }
    return std::nullopt;
  }

  // It comes back to the same sheet, and not before N returns.
  [[nodiscard]] std::optional<std::vector<State2>>
  closed(const std::vector<PhasePoint<double>>& orbit, double scale) const {
    auto points = mapped<State2>(orbit, [&](const auto& x) { return doubles(x); });
    if (distance(points.back(), points.front()) > 1e-7 * scale) return std::nullopt;
    points.pop_back();
    for (std::size_t k = 1; k < points.size(); ++k)
      if (distance(points[k], points.front()) < 1e-6 * scale) return std::nullopt;
    return points;
  }
};

} // namespace

std::vector<State2> starts_over(const SystemScene& scene, const std::array<Quantity, 2>& place,
                                const std::atomic<bool>* stop) {
  SystemScene one = scene;
  one.columns = one.rows = 0;
  one.random = 0;
  one.states.clear();
  one.seeds = {place};
  return mapped<State2>(starts_of(one, field_of_starts(one), nullptr, stop), &FieldStart::x);
}

std::vector<std::vector<std::vector<double>>>
look_for_orbits(const SystemScene& scene, QuickMap& map, const PeriodicOptions& o) {
  SystemScene dense = scene;
  if (scene.range) {
    dense.columns = std::max(scene.columns, o.grid);
    dense.rows = std::max(scene.rows, o.grid);
  }
  const Field field = field_of_starts(dense);
  OrbitSearch search(map, o.period, o.stop);
  for (const FieldStart& start : starts_of(dense, field, nullptr, o.stop)) {
    State2 x = start.x;
    if (start.state) { // anywhere: its first crossing
      const auto crossing = map(PhasePoint<double>(x.begin(), x.end()));
      if (!crossing) continue;
      x = doubles(crossing->at);
    }
    search.from(x);
  }
  return search.found;
}

// ---- proof ----

namespace {

struct OrbitNode {
  Chart chart;
  std::array<Ball, 2> middle;
  std::vector<double> near;
};

using Slope = std::array<std::array<Ball, 2>, 2>;

// Landing and derivative in a chart's coordinates.
std::array<Ball, 2> in_chart(const PhasePoint<Ball>& x, const Chart& c) {
  return {x[c.free[0]].v, x[c.free[1]].v};
}
Slope slope_in(const PhasePoint<Ball>& x, const Chart& c) {
  return {{{x[c.free[0]].d[0], x[c.free[0]].d[1]}, {x[c.free[1]].d[0], x[c.free[1]].d[1]}}};
}

class OrbitProof {
public:
  OrbitProof(EnclosedMap& map, QuickMap& quick, const std::vector<State2>& points)
      : map_(map), fine_(map.surface()) {
    for (const State2& x : points) {
      const Chart chart = chart_at(quick.code(), x);
      nodes_.push_back({chart, {Ball(x[chart.free[0]]), Ball(x[chart.free[1]])}, x});
    }
  }

  EnclosedOrbit run() {
    for (int i = 0; i < 6; ++i) { // Newton's method, until a step more would not be seen
      at_middles();
      inverse_ = approximate_inverse(slopes(middle_slopes_));
      if (!inverse_) throw NotProved::multiplier_one;
      const BallVector step = applied(*inverse_, value_);
      double left = 0;
      for (const Ball& b : step)
        left = std::max(left, bound_of(b));
      const double size = size_of(nodes_[0].near);
      if (!(left < 1e-3 * size)) throw NotProved::left_by_newton;
      for (std::size_t k = 0; k < nodes_.size(); ++k)
        for (std::size_t d = 0; d < 2; ++d)
          nodes_[k].middle[d] = (nodes_[k].middle[d] - step[2 * k + d]).middle();
      if (left <= size * std::sqrt(map_.tolerance())) break;
    }
    return krawczyk();
  }

private:
  EnclosedMap& map_;
  QuickMapOf<Ball> fine_;
  std::vector<OrbitNode> nodes_;
  std::optional<BallMatrix> inverse_;
  BallVector value_; ///< P(z_k) - z_(k+1), in the middles
  std::vector<Slope> middle_slopes_;

  [[nodiscard]] std::size_t next(std::size_t k) const { return (k + 1) % nodes_.size(); }

  void at_middles() {
    value_.clear();
    middle_slopes_.clear();
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const OrbitNode& from = nodes_[k];
      const auto x = fine_.lifted(from.chart, from.middle, from.near);
      const auto image = x ? fine_(*x) : std::nullopt;
      if (!image) throw NotProved::no_return;
      add_value(in_chart(image->at, nodes_[next(k)].chart), next(k));
      middle_slopes_.push_back(slope_in(image->at, nodes_[next(k)].chart));
    }
  }

  void add_value(const std::array<Ball, 2>& at, std::size_t node) {
    for (std::size_t d = 0; d < 2; ++d)
      value_.push_back(at[d] - nodes_[node].middle[d]);
  }

  [[nodiscard]] BallMatrix slopes(const std::vector<Slope>& d) const {
    const std::size_t n = 2 * nodes_.size();
    BallMatrix a(n, BallVector(n, Ball(0)));
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j)
          a[2 * k + i][2 * k + j] += d[k][i][j];
        a[2 * k + i][2 * next(k) + i] -= Ball(1);
      }
    return a;
  }

  EnclosedOrbit krawczyk() {
    const double size = size_of(nodes_[0].near);
    std::vector<double> radius(2 * nodes_.size(), 16 * size * map_.tolerance());
    for (int attempt = 0; attempt < 8; ++attempt) {
      EnclosedOrbit orbit = over(radius);
      const BallVector shift = krawczyk_shift(*inverse_, value_, slopes(orbit.slopes), radius);
      if (shift_inside(shift, radius)) return finished(orbit);
      for (std::size_t i = 0; i < radius.size(); ++i) {
        radius[i] = 4 * std::max(radius[i], bound_of(shift[i]));
        if (!(radius[i] < 1e-3 * size)) throw NotProved::krawczyk;
      }
    }
    throw NotProved::krawczyk;
  }

  // The map over boxes around the middles, and where these land.
  EnclosedOrbit over(const std::vector<double>& radius) {
    EnclosedOrbit o;
    o.time = Ball(0);
    value_.clear();
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const OrbitNode& n = nodes_[k];
      o.patches.push_back(map_.patch(
          n.chart,
          {n.middle[0].widened(Ball(radius[2 * k])), n.middle[1].widened(Ball(radius[2 * k + 1]))},
          n.near));
    }
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const Landing l = map_(o.patches[k]);
      if (!EnclosedMap::same_sheet(l, o.patches[next(k)])) throw NotProved::another_sheet;
      const Chart& chart = nodes_[next(k)].chart;
      add_value({l.middle[chart.free[0]], l.middle[chart.free[1]]}, next(k));
      o.slopes.push_back(slope_in(l.at, chart));
      o.time += l.time;
    }
    return o;
  }

  EnclosedOrbit finished(EnclosedOrbit o) {
    Slope all = o.slopes[0];
    for (std::size_t k = 1; k < o.slopes.size(); ++k) {
      const Slope &a = o.slopes[k], b = all;
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
          all[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j];
    }
    o.trace = all[0][0] + all[1][1];
    o.determinant = all[0][0] * all[1][1] - all[0][1] * all[1][0];
    const bool area = keeps_area(o.patches[0]);
    if (area) o.determinant = Ball(1);
    o.stability = stability(o.trace, o.determinant, area);
    least_period(o);
    return o;
  }

  // Is the bracket of rank four there?  Then the leaf is symplectic of dimension four, and the map
  // keeps the area of the section.
  bool keeps_area(const Patch& p) {
    const std::size_t n = map_.surface().dimension();
    const auto j = map_.values(p.at).bracket;
    if (j.empty()) return false;
    const auto entry = [&](std::size_t a, std::size_t b) -> const Ball& {
      return j[a * n - a * (a + 1) / 2 + b - a - 1].v;
    };
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b)
        for (std::size_t c = b + 1; c < n; ++c)
          for (std::size_t d = c + 1; d < n; ++d) {
            const Ball pfaffian =
                entry(a, b) * entry(c, d) - entry(a, c) * entry(b, d) + entry(a, d) * entry(b, c);
            if (pfaffian.is_positive() || pfaffian.is_negative()) return true;
          }
    return false;
  }

  // From the signs of the characteristic polynomial at 1 and -1.
  static std::optional<Stability> stability(const Ball& trace, const Ball& det, bool area) {
    const Ball at_one = Ball(1) - trace + det, at_minus_one = Ball(1) + trace + det;
    if (at_one.is_negative() && at_minus_one.is_positive()) return Stability::hyperbolic;
    if (at_one.is_positive() && at_minus_one.is_negative()) return Stability::inverse_hyperbolic;
    if (area && at_one.is_positive() && at_minus_one.is_positive()) return Stability::elliptic;
    return std::nullopt;
  }

  static void least_period(const EnclosedOrbit& o) {
    for (std::size_t k = 1; k < o.patches.size(); ++k) {
      bool apart = false;
      for (std::size_t j = 0; j < o.patches[0].at.size(); ++j) {
        const Ball d = o.patches[k].at[j].v - o.patches[0].at[j].v;
        apart = apart || d.is_positive() || d.is_negative();
      }
      if (!apart) throw NotProved::smaller_period;
    }
  }
};

PeriodicPoint shown(QuickMap& quick, const State2& x) {
  const auto v = quick.code().at(PhasePoint<double>(x.begin(), x.end()));
  return {x, {v.drawn[0].v, v.drawn[1].v}};
}

void set_multiplier(PeriodicOrbit& o) {
  const double half = o.trace / 2, q = half * half - o.determinant;
  o.multiplier = q >= 0 ? std::array{half + std::copysign(std::sqrt(q), o.trace), 0.0}
                        : std::array{half, std::sqrt(-q)};
}

} // namespace

PeriodicOrbit prove_orbit(EnclosedMap& map, QuickMap& quick, const std::vector<State2>& points) {
  PeriodicOrbit o;
  for (const State2& x : points)
    o.points.push_back(shown(quick, x));
  try {
    const EnclosedOrbit e = enclose_orbit(map, quick, points);
    o.points.clear();
    for (const Patch& p : e.patches) {
      const State2 x = doubles(p.at);
      o.points.push_back(shown(quick, x));
      for (std::size_t j = 0; j < x.size(); ++j)
        o.error = std::max(o.error, bound_of(p.at[j].v - Ball(x[j])));
    }
    o.time = static_cast<double>(e.time);
    o.trace = static_cast<double>(e.trace);
    o.trace_error = bound_of(e.trace - Ball(o.trace));
    o.determinant = static_cast<double>(e.determinant);
    o.stability = e.stability;
    o.proved = true;
    set_multiplier(o);
  } catch (const NotProved& n) {
    o.why = n;
  }
  return o;
}

EnclosedOrbit enclose_orbit(EnclosedMap& map, QuickMap& quick,
                            const std::vector<std::vector<double>>& points) {
  return OrbitProof(map, quick, points).run();
}

PeriodicOrbits periodic_orbits(const SystemScene& scene, const PeriodicOptions& options) {
  const SectionSurface surface(scene);
  QuickMap quick(surface);
  PeriodicOrbits all;
  all.period = options.period;
  const auto found = look_for_orbits(scene, quick, options);
  const EnclosureScope scope(options.bits);
  EnclosedMap map(surface, options.stop);
  for (const auto& points : found)
    all.orbits.push_back(prove_orbit(map, quick, points));
  std::ranges::sort(all.orbits, [](const auto& a, const auto& b) {
    return a.points[0].drawn < b.points[0].drawn;
  });
  all.stopped = options.stop != nullptr && options.stop->load();
  return all;
}

} // namespace kov::flow
