#include "flow/chaos/periodic_orbit.hpp"

#include "exact/lists.hpp"
#include "flow/chaos/index_grid.hpp"
#include "flow/chaos/krawczyk.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

using Ball = Enclosure;
using State2 = std::vector<double>; // a point of phase space

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

} // namespace

std::string to_string(Stability s) {
  constexpr std::array all{"elliptic", "hyperbolic", "inverse hyperbolic"};
  return all.at(static_cast<std::size_t>(s));
}

std::array<double, 2> PeriodicOrbit::multiplier() const {
  const double half = trace / 2, q = half * half - determinant;
  return q >= 0 ? std::array{half + std::copysign(std::sqrt(q), trace), 0.0}
                : std::array{half, std::sqrt(-q)};
}

PeriodicOrbit prove_orbit(EnclosedMap& map, QuickMap& quick, const PeriodicOrbit& found) {
  PeriodicOrbit o = found;
  try {
    const EnclosedOrbit e =
        enclose_orbit(map, quick, mapped<State2>(found.points, &PeriodicPoint::x));
    const auto shown = [](const Ball& x, double& middle) {
      middle = static_cast<double>(x);
      return bound_of(x - Ball(middle));
    };
    for (std::size_t k = 0; k < o.points.size(); ++k) {
      const PhasePoint<Ball>& at = e.patches[k].at;
      const auto drawn = map.values(at).drawn;
      for (std::size_t j = 0; j < at.size(); ++j)
        o.error = std::max(o.error, shown(at[j].v, o.points[k].x[j]));
      for (std::size_t d = 0; d < 2; ++d)
        o.error = std::max(o.error, shown(drawn[d].v, o.points[k].drawn[d]));
    }
    o.time = static_cast<double>(e.time);
    o.trace_error = shown(e.trace, o.trace);
    o.determinant = static_cast<double>(e.determinant);
    o.stability = e.stability;
    o.proved = true;
  } catch (const NotProved& n) {
    o.stability.reset();
    o.why = n;
  }
  return o;
}

EnclosedOrbit enclose_orbit(EnclosedMap& map, QuickMap& quick,
                            const std::vector<std::vector<double>>& points) {
  return OrbitProof(map, quick, points).run();
}

namespace {

// With more and more bits, until the orbit is proved and its trace is known well.
PeriodicOrbit proved(const SectionSurface& surface, QuickMap& quick, const PeriodicOrbit& found,
                     const PeriodicOptions& o) {
  PeriodicOrbit best = found;
  for (long bits = o.bits; bits <= o.most_bits; bits += o.bits / 2) {
    const EnclosureScope scope(bits);
    EnclosedMap map(surface, o.stop);
    const PeriodicOrbit one = prove_orbit(map, quick, found);
    if (one.proved || !best.proved) best = one;
    if ((one.proved && one.trace_error <= 1e-9) || one.why == NotProved::multiplier_one ||
        (o.stop != nullptr && o.stop->load()))
      break;
  }
  return best;
}

} // namespace

PeriodicOrbits periodic_orbits(const SystemScene& scene, const PeriodicOptions& options) {
  const SectionSurface surface(scene);
  QuickMap quick(surface);
  PeriodicOrbits all = look_for_orbits(scene, quick, options);
  const auto in_units = [&](PeriodicOrbit& o) {
    if (scene.body) o.time = std::ldexp(o.time, static_cast<int>(scene.body->units.time));
  };
  std::ranges::for_each(all.orbits, in_units);
  for (std::size_t i = 0; options.prove && i < all.orbits.size(); ++i) {
    if (options.progress) options.progress(all, i);
    all.orbits[i] = proved(surface, quick, all.orbits[i], options);
    if (all.orbits[i].proved) in_units(all.orbits[i]);
  }
  all.stopped = all.stopped || (options.stop != nullptr && options.stop->load());
  return all;
}

} // namespace kov::flow
