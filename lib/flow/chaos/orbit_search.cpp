// The search for periodic orbits, in double.

#include "exact/lists.hpp"
#include "flow/chaos/index_grid.hpp"
#include "flow/chaos/periodic_orbit.hpp"
#include "flow/scene/starts.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

using Point = std::vector<double>; // of phase space

double length_of(const Place& u) { return std::hypot(u[0], u[1]); }

/// P^N over the range of a scene.
class MapOverRange : public MapOverPicture {
public:
  MapOverRange(const SystemScene& s, QuickMap& map, const PeriodicOptions& o)
      : s_(s), map_(map), o_(o), field_(field_of_starts(s)), places_(s, field_) {
    for (std::size_t d = 0; d < 2; ++d)
      for (std::size_t end = 0; end < 2; ++end)
        range_[d][end] = (*s.range)[d][end].as<double>();
  }

  [[nodiscard]] std::vector<Displaced> over(const Place& u) override {
    std::vector<Displaced> all;
    if (stopped()) return all;
    Place drawn = u;
    for (std::size_t d = 0; d < 2; ++d)
      if (!s_.angle[d])
        drawn[d] = is_latitude(d)
                       ? std::sin(u[d])
                       : range_[d][0] + (u[d] / pi_ + 0.5) * (range_[d][1] - range_[d][0]);
    for (Point& x : places_.over(drawn))
      if (const auto there = follow({.at = u, .state = std::move(x)}, u)) all.push_back(*there);
    return all;
  }

  // Newton's method in a chart.
  [[nodiscard]] std::optional<Displaced> follow(const Displaced& from, const Place& to) override {
    Point near = from.state;
    const Chart chart = chart_at(map_.code(), near);
    for (int i = 0; i < 12; ++i) {
      const auto x = map_.lifted(chart, {near[chart.free[0]], near[chart.free[1]]}, near);
      if (!x) return std::nullopt;
      near = doubles(*x);
      const auto at = place_of(*x);
      const Place way = between({at[0].v, at[1].v}, to);
      if (length_of(way) < 1e-11) return Displaced{.at = to, .state = near};
      const auto step =
          solved<double>({{at[0].d[0], at[0].d[1]}, {at[1].d[0], at[1].d[1]}}, {way[0], way[1]});
      for (std::size_t d = 0; d < 2; ++d)
        near[chart.free[d]] += step[d];
    }
    return std::nullopt;
  }

  void displace(Displaced& x) override {
    if (stopped()) return;
    const auto from = lifted(x.state);
    const auto image = from ? map_(*from, false, o_.period) : std::nullopt;
    if (!image) return;
    const auto a = place_of(*from), b = place_of(image->at);
    const Place to{b[0].v, b[1].v}, by = between({a[0].v, a[1].v}, to);
    if (length_of(by) < 0.5) { // no displacement, if that of a point on another sheet
      const auto here = follow(x, to);
      if (here && distance(here->state, doubles(image->at)) > 1e-6 * size_of(x.state)) return;
    }
    const double det = a[0].d[0] * a[1].d[1] - a[0].d[1] * a[1].d[0];
    for (std::size_t i = 0; i < 2; ++i) {
      x.slopes[i] = {(b[i].d[0] * a[1].d[1] - b[i].d[1] * a[1].d[0]) / det,
                     (b[i].d[1] * a[0].d[0] - b[i].d[0] * a[0].d[1]) / det};
      x.slopes[i][i] -= 1;
    }
    x.by = by;
  }

  [[nodiscard]] Place place_of(const Point& x) {
    const auto at = place_of(PhasePoint<double>(x.begin(), x.end()));
    return {at[0].v, at[1].v};
  }
  [[nodiscard]] std::optional<PhasePoint<double>> lifted(const Point& x) {
    const Chart chart = chart_at(map_.code(), x);
    return map_.lifted(chart, {x[chart.free[0]], x[chart.free[1]]}, x);
  }
  [[nodiscard]] bool stopped() const { return o_.stop != nullptr && o_.stop->load(); }

private:
  static constexpr double pi_ = 3.14159265358979323846;
  const SystemScene& s_;
  QuickMap& map_;
  const PeriodicOptions& o_;
  const Field field_;
  Places places_;
  std::array<std::array<double, 2>, 2> range_{};

  [[nodiscard]] bool is_latitude(std::size_t d) const { return d == 1 && s_.sphere; }

  [[nodiscard]] std::array<Dual<double>, 2> place_of(const PhasePoint<double>& x) {
    auto at = map_.code().at(x).drawn;
    for (std::size_t d = 0; d < 2; ++d) {
      const double v = at[d].v, side = range_[d][1] - range_[d][0];
      if (is_latitude(d))
        at[d] = chain(std::asin(std::clamp(v, -1.0, 1.0)), 1 / std::sqrt(1 - v * v), at[d]);
      else if (!s_.angle[d])
        at[d] = chain(pi_ * ((v - range_[d][0]) / side - 0.5), pi_ / side, at[d]);
    }
    return at;
  }

  [[nodiscard]] Place between(const Place& a, const Place& b) const {
    Place d{b[0] - a[0], b[1] - a[1]};
    for (std::size_t i = 0; i < 2; ++i)
      if (s_.angle[i]) d[i] = std::remainder(d[i], 2 * pi_);
    return d;
  }
};

class OrbitSearch {
public:
  OrbitSearch(QuickMap& map, const PeriodicOptions& o) : map_(map), o_(o) {
    found.period = o.period;
  }

  void from(const Point& start) {
    if (o_.stop != nullptr && o_.stop->load()) return;
    const auto turn = newton(start);
    if (!turn) return;
    const Point first = doubles(turn->points.front());
    const bool known = std::ranges::any_of(zeros, [&](const Zero& z) {
      return distance(z.state, first) < 1e-6 * (size_of(z.state) + 1e-300);
    });
    if (!known) keep(*turn);
  }

  struct Zero {
    Point state;
    int index = 0; ///< 0: it may be anything
  };
  std::vector<Zero> zeros; ///< of P^N - 1
  PeriodicOrbits found;    ///< those of least period N
  bool curves = false;     ///< of zeros were met

private:
  QuickMap& map_;
  const PeriodicOptions& o_;

  /// The orbit of one turn; `u` and `v`: where it ends, in the chart of its first point.
  struct Turn {
    std::vector<PhasePoint<double>> points; ///< N + 1 of them
    double time = 0;
    Dual<double> u, v;
    [[nodiscard]] double trace() const { return u.d[0] + v.d[1]; }
    [[nodiscard]] double determinant() const { return u.d[0] * v.d[1] - u.d[1] * v.d[0]; }
    /// det(DP^N - 1)
    [[nodiscard]] double at_one() const { return 1 - trace() + determinant(); }
  };
  std::optional<Turn> turn(const PhasePoint<double>& x, const Chart& chart) {
    Turn t{{x}};
    for (int k = 0; k < o_.period; ++k) {
      const auto next = map_(t.points.back());
      if (!next) return std::nullopt;
      t.time += next->time;
      t.points.push_back(next->at);
    }
    t.u = t.points.back()[chart.free[0]];
    t.v = t.points.back()[chart.free[1]];
    return t;
  }

  // A singular DP^N - 1: the fixed points are not isolated (or a bifurcation is near).
  std::optional<Turn> newton(const Point& start) {
    const Chart chart = chart_at(map_.code(), start);
    const double scale = size_of(start);
    Point near = start;
    double least = INFINITY;
    for (int i = 0, in_vain = 0; i < 25 && in_vain < 3; ++i) {
      const auto x = map_.lifted(chart, {near[chart.free[0]], near[chart.free[1]]}, near);
      const auto t = x ? turn(*x, chart) : std::nullopt;
      if (!t) return std::nullopt;
      const double moved = distance(doubles(t->points.back()), doubles(*x)) / scale;
      in_vain = moved < least ? 0 : in_vain + 1;
      least = std::min(least, moved);
      if (moved < 1e-6 && std::abs(t->at_one()) < 1e-6) {
        curves = true;
        return std::nullopt;
      }
      const auto step =
          solved<double>({{t->u.d[0] - 1, t->u.d[1]}, {t->v.d[0], t->v.d[1] - 1}},
                         {t->u.v - (*x)[chart.free[0]].v, t->v.v - (*x)[chart.free[1]].v});
      const double length = std::hypot(step[0], step[1]);
      if (!std::isfinite(length)) return std::nullopt;
      if (length < 1e-11 * scale) return moved > 1e-7 ? std::nullopt : t;
      const double shorten = std::min(1.0, 0.1 * scale / length);
      near = doubles(*x);
      for (std::size_t d = 0; d < 2; ++d)
        near[chart.free[d]] -= shorten * step[d];
    }
    return std::nullopt;
  }

  // An orbit of a smaller period has zeros, too.
  void keep(const Turn& t) {
    PeriodicOrbit o;
    o.time = t.time;
    o.trace = t.trace();
    o.determinant = t.determinant();
    for (std::size_t k = 0; k + 1 < t.points.size(); ++k) {
      const auto drawn = map_.code().at(t.points[k]).drawn;
      o.points.push_back({doubles(t.points[k]), {drawn[0].v, drawn[1].v}});
      const Point& x = o.points[k].x;
      if (k > 0 && distance(x, o.points[0].x) < 1e-6 * size_of(x)) return;
      zeros.push_back({x, t.at_one() > 1e-6 ? 1 : t.at_one() < -1e-6 ? -1 : 0});
    }
    if (std::abs(std::abs(o.trace) - 2) > 1e-9)
      o.stability = o.trace > 2    ? Stability::hyperbolic
                    : o.trace < -2 ? Stability::inverse_hyperbolic
                                   : Stability::elliptic;
    found.orbits.push_back(std::move(o));
  }
};

/// The cells of a grid over the range.
class GridSearch {
public:
  GridSearch(const SystemScene& s, QuickMap& quick, const PeriodicOptions& o, OrbitSearch& search)
      : o_(o), search_(search), turns_(s.angle), map_(s, quick, o),
        grid_(s.angle, o.columns, o.rows, map_) {}

  CellCount run() {
    long points = 0, still = 0;
    for_nodes([&](const Displaced& x) {
      ++points;
      still += moves_by(x) < 1e-7 ? 1 : 0;
    });
    count_.identity = 2 * still > points;
    if (count_.identity) return count_;
    const std::vector<IndexGrid::Cell> cells = grid_.cells();
    for (const auto& c : cells)
      if (!c.index)
        from_places(c, 2);
      else if (*c.index != 0)
        start_at(c, 0.5, 0.5);
    for (int i = 0; i < o_.columns; ++i)
      for (int k = 0; k < o_.rows; ++k)
        for (const Displaced& x : grid_.node(i, k))
          if (moves_least(x, i, k)) search_.from(x.state);
    look_at_mirror_images();
    for (const auto& c : cells)
      if (!is_explained(c)) from_places(c, 5);
    for (const auto& c : cells) {
      ++(c.index ? count_.with_index : count_.without);
      count_.index_sum += c.index.value_or(0);
      count_.unexplained += is_explained(c) ? 0 : 1;
    }
    return count_;
  }

private:
  const PeriodicOptions& o_;
  OrbitSearch& search_;
  const std::array<bool, 2> turns_;
  MapOverRange map_;
  IndexGrid grid_; // samples the map when it is made: after what the map needs
  CellCount count_;

  static double moves_by(const Displaced& x) { return x.by ? length_of(*x.by) : INFINITY; }
  template <class F> void for_nodes(const F& f) const {
    for (int i = 0; i < o_.columns; ++i)
      for (int k = 0; k < o_.rows; ++k)
        for (const Displaced& x : grid_.node(i, k))
          f(x);
  }
  // Little, and less than all neighbours.
  [[nodiscard]] bool moves_least(const Displaced& x, int column, int row) const {
    bool least = moves_by(x) < 0.5;
    for (const int i : {column - 1, column, column + 1})
      for (const int k : {row - 1, row, row + 1})
        for (const Displaced& y : grid_.node(i, k))
          least = least && moves_by(x) <= moves_by(y);
    return least;
  }
  // Many systems have symmetries that turn or mirror the section: a good guess for the partners, no more.
  void look_at_mirror_images() {
    constexpr double pi = 3.14159265358979323846;
    const auto images = [&](const Place& u, std::size_t d) {
      std::vector<double> all{u[d], -u[d]};
      if (turns_[d]) all.insert(all.end(), {u[d] + pi, pi - u[d]});
      return all;
    };
    for (std::size_t i = 0; i < search_.zeros.size(); ++i) { // grows meanwhile
      const Place at = map_.place_of(search_.zeros[i].state);
      for (const double u : images(at, 0))
        for (const double v : images(at, 1))
          for (const Displaced& x : map_.over({u, v}))
            search_.from(x.state);
    }
  }
  void start_at(const IndexGrid::Cell& c, double column, double row) {
    const auto there = map_.follow(c.corner, grid_.place(c.column + column, c.row + row));
    search_.from(there ? there->state : c.corner.state);
  }
  // n times n places of the cell, until they are enough.
  void from_places(const IndexGrid::Cell& c, int n) {
    for (int i = 0; i < n * n && (!c.index || !is_explained(c)); ++i)
      start_at(c, (i % n + 0.5) / n, (i / n + 0.5) / n);
  }
  // The cell has no index, or the points found in it add up to it.
  [[nodiscard]] bool is_explained(const IndexGrid::Cell& c) {
    if (!c.index) return true;
    int sum = 0;
    for (const auto& z : search_.zeros) {
      if (!grid_.contains(c, {.at = map_.place_of(z.state), .state = z.state})) continue;
      if (z.index == 0) return true;
      sum += z.index;
    }
    return sum == *c.index;
  }
};

} // namespace

std::vector<std::vector<double>> starts_over(const SystemScene& scene,
                                             const std::array<Quantity, 2>& place,
                                             const std::atomic<bool>* stop) {
  SystemScene one = scene;
  one.columns = one.rows = 0;
  one.random = 0;
  one.states.clear();
  one.seeds = {place};
  return mapped<Point>(starts_of(one, field_of_starts(one), nullptr, stop), &FieldStart::x);
}

PeriodicOrbits look_for_orbits(const SystemScene& scene, QuickMap& map, const PeriodicOptions& o) {
  OrbitSearch search(map, o);
  SystemScene few = scene; // what the grid does not have
  few.columns = few.rows = 0;
  few.random = 0;
  if (!few.seeds.empty() || !few.states.empty())
    for (const FieldStart& start : starts_of(few, field_of_starts(few), nullptr, o.stop)) {
      PhasePoint<double> x(start.x.begin(), start.x.end());
      if (const auto crossing = start.state ? map(x) : std::nullopt) // anywhere: its first crossing
        x = crossing->at;
      search.from(doubles(x));
    }
  if (scene.range) {
    search.found.cells = GridSearch(scene, map, o, search).run();
    search.found.cells->curves = search.curves;
  }
  PeriodicOrbits& found = search.found;
  std::ranges::sort(found.orbits, {}, [](const PeriodicOrbit& p) { // rounding does not matter
    const auto& at = p.points[0].drawn;
    return std::pair(std::round(at[0] * 1e9), at[1]);
  });
  found.stopped = o.stop != nullptr && o.stop->load();
  return std::move(found);
}

} // namespace kov::flow
