#include "flow/chaos/homoclinic.hpp"

#include "exact/tried.hpp"
#include "flow/chaos/krawczyk.hpp"
#include "flow/chaos/manifold_arcs.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

using Ball = Enclosure;
using Matrix2 = std::array<std::array<Ball, 2>, 2>;

Ball around_zero(double radius) { return Ball(0).widened(Ball(radius)); }

Matrix2 product(const Matrix2& a, const Matrix2& b) {
  Matrix2 c;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j];
  return c;
}
Matrix2 inverse(const Matrix2& a) {
  const Ball det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
  return {{{a[1][1] / det, -a[0][1] / det}, {-a[1][0] / det, a[0][0] / det}}};
}
Matrix2 slope_in(const PhasePoint<Ball>& x, const Chart& c) {
  return {{{x[c.free[0]].d[0], x[c.free[0]].d[1]}, {x[c.free[1]].d[0], x[c.free[1]].d[1]}}};
}

// ---- the cones ----

struct KeptCone {
  double slope = 0, stretch = 0;
};

// The least 2^-k for which every matrix in m maps the cone |v1| <= slope |v0| into its interior and stretches |v0|.
// Which of the two components comes first says `first`.
std::optional<KeptCone> cone(const Matrix2& m, std::size_t first) {
  const std::size_t second = 1 - first;
  const Ball& a = m[first][first];
  const Ball along = a.is_positive() ? a : -a;
  const Ball b(bound_of(m[first][second])), c(bound_of(m[second][first])),
      d(bound_of(m[second][second]));
  if (!along.is_positive()) return std::nullopt;
  for (int k = 50; k >= 1; --k) {
    const Ball slope(std::ldexp(1.0, -k)), stretch = along - b * slope;
    if (!(c + d * slope < slope * stretch) || !(stretch > Ball(1))) continue;
    const double low =
        std::nextafter(static_cast<double>(stretch) - 2 * stretch.radius(), 0.0) * (1 - 1e-12);
    return KeptCone{std::ldexp(1.0, -k), low};
  }
  return std::nullopt;
}

// p with its parallelogram, and the slopes of the graphs that the manifolds are in it.
struct LocalManifolds {
  EnclosedOrbit orbit;
  Patch region; ///< a box around the parallelogram
  Matrix2 axes; ///< exact
  std::array<Ball, 2> p;
  LocalFrame frame; ///< for the search
  double reach = 0; ///< r
  KeptCone unstable, stable;
  std::array<double, 2> multipliers{}; ///< of Q, approximately
};

// Eigenvectors in double: the cones do not need them to be exact.
void set_axes(LocalManifolds& l) {
  Matrix2 d = l.orbit.slopes[0];
  for (std::size_t k = 1; k < l.orbit.slopes.size(); ++k)
    d = product(l.orbit.slopes[k], d);
  const auto at = [&](std::size_t i, std::size_t j) { return static_cast<double>(d[i][j]); };
  const double half = (at(0, 0) + at(1, 1)) / 2, det = at(0, 0) * at(1, 1) - at(0, 1) * at(1, 0);
  const double large = half + std::copysign(std::sqrt(std::max(half * half - det, 0.0)), half);
  const std::array<double, 2> multipliers{large, det / large};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double m = multipliers[axis];
    std::array<double, 2> v{at(0, 1), m - at(0, 0)}, w{m - at(1, 1), at(1, 0)};
    if (std::hypot(w[0], w[1]) > std::hypot(v[0], v[1])) v = w;
    const double length = std::max(std::abs(v[0]), std::abs(v[1]));
    for (std::size_t i = 0; i < 2; ++i) {
      l.frame.axes[i][axis] = v[i] / length;
      l.axes[i][axis] = Ball(l.frame.axes[i][axis]);
    }
  }
  l.frame.stretch_unstable = std::abs(multipliers[0]);
  l.frame.stretch_stable = 1 / std::abs(multipliers[1]);
  l.multipliers = multipliers;
}

bool find_cones(EnclosedMap& map, LocalManifolds& l, double reach) {
  std::array<Ball, 2> box;
  for (std::size_t i = 0; i < 2; ++i)
    box[i] = l.p[i] + l.axes[i][0] * around_zero(reach) + l.axes[i][1] * around_zero(reach);
  l.region = map.patch(l.frame.chart, box, l.frame.near);
  for (std::size_t i = 0; i < l.region.sheet.size(); ++i)
    if (!l.orbit.patches[0].at[l.region.chart.rest[i]].v.inside(l.region.sheet[i])) return false;
  const Matrix2 back = inverse(l.axes);
  for (const bool stable : {false, true}) {
    const Landing image = map(l.region, stable, l.frame.turns);
    if (!EnclosedMap::same_sheet(image, l.region)) return false;
    const auto found =
        cone(product(back, product(slope_in(image.at, l.frame.chart), l.axes)), stable ? 1 : 0);
    if (!found) return false;
    (stable ? l.stable : l.unstable) = *found;
  }
  l.reach = reach;
  return true;
}

LocalManifolds local_manifolds(EnclosedMap& map, QuickMap& quick,
                               const std::vector<std::vector<double>>& points, int smaller) {
  LocalManifolds l;
  l.orbit = enclose_orbit(map, quick, points);
  if (l.orbit.stability != Stability::hyperbolic &&
      l.orbit.stability != Stability::inverse_hyperbolic)
    throw NotProved::not_hyperbolic;
  const Patch& p = l.orbit.patches[0];
  l.p = p.box;
  l.frame.chart = p.chart;
  l.frame.near = doubles(p.at);
  l.frame.at = {static_cast<double>(p.box[0]), static_cast<double>(p.box[1])};
  l.frame.turns = static_cast<int>(points.size());
  set_axes(l);
  double size = 0;
  for (const double c : l.frame.near)
    size = std::max(size, std::abs(c));
  l.frame.reach = std::ldexp(size, -14);
  for (int k = 12; k <= 44; k += 4) // the largest that works, for the shortest orbits
    if (tried<NotProved>([&] {
          return find_cones(map, l, std::ldexp(size, -k)) &&
                 (smaller == 0 || find_cones(map, l, std::ldexp(size, -k - smaller)));
        }))
      return l;
  throw NotProved::no_cones;
}

// ---- directions ----

// (1, slope), or (slope, 1) where `first` is 1.
struct Direction {
  std::size_t first = 0;
  Ball slope;
};

std::array<Ball, 2> vector_of(const Direction& d) {
  std::array<Ball, 2> v{Ball(1), Ball(1)};
  v[1 - d.first] = d.slope;
  return v;
}

Direction direction_of(const std::array<Ball, 2>& v) {
  const std::size_t first =
      std::abs(static_cast<double>(v[0])) >= std::abs(static_cast<double>(v[1])) ? 0 : 1;
  return {first, v[1 - first] / v[first]};
}

// The image under every matrix in m.  By the mean value theorem, so that an attracted direction becomes sharper.
Direction carried(const Matrix2& m, const Direction& d) {
  const auto image = [&](const Ball& slope) {
    const auto v = vector_of({d.first, slope});
    return std::array<Ball, 2>{m[0][0] * v[0] + m[0][1] * v[1], m[1][0] * v[0] + m[1][1] * v[1]};
  };
  const Ball middle = d.slope.middle();
  const Direction to = direction_of(image(middle));
  const Ball det = m[0][0] * m[1][1] - m[0][1] * m[1][0], scale = image(d.slope)[to.first];
  const Ball rate = det / (scale * scale);
  return {to.first, to.slope + (to.first == d.first ? rate : -rate) * (d.slope - middle)};
}

// ---- the orbit from one graph to the other ----

struct ConnectionNode {
  Chart chart;
  std::array<Ball, 2> middle; ///< exact
  std::vector<double> near;
};

class HomoclinicConnection {
public:
  /// `rough`, or null: tried before `map`.
  HomoclinicConnection(EnclosedMap& map, EnclosedMapOf<DoubleBall>* rough, QuickMap& quick,
                       const LocalManifolds& l, const HomoclinicGuess& g)
      : map_(map), rough_(rough), quick_(quick), l_(l), xi_(g.xi), eta_(g.eta),
        nodes_(g.orbit.size() - 1) {
    for (std::size_t k = 1; k < nodes_.size(); ++k) {
      const std::vector<double>& x = g.orbit[k];
      const Chart chart = chart_at(quick.code(), x);
      nodes_[k] = {chart, {Ball(x[chart.free[0]]), Ball(x[chart.free[1]])}, x};
    }
    nodes_[0].chart = l.frame.chart;
    nodes_[0].near = g.orbit.front();
  }

  // Krawczyk's test; throws NotProved.  Then `links_` enclose the map near the proved orbit.
  void prove() {
    for (int i = 0; i < 6; ++i) { // Newton's method, in double
      links_ = approximately();
      const auto c = approximate_inverse(slopes());
      if (!c) throw NotProved::tangent;
      const BallVector step = applied(*c, value(links_));
      double left = 0;
      for (const Ball& b : step)
        left = std::max(left, std::abs(static_cast<double>(b)));
      if (!(left < 1e-2)) throw NotProved::left_by_newton;
      move(step);
      if (left < 1e-13) break;
    }
    if (rough_ != nullptr) try {
        return krawczyk();
      } catch (const NotProved&) {
        rough_ = nullptr;
      }
    krawczyk();
  }

  [[nodiscard]] const std::vector<double>& radius() const { return radius_; }
  [[nodiscard]] double xi() const { return static_cast<double>(xi_); }
  [[nodiscard]] double eta() const { return static_cast<double>(eta_); }

  [[nodiscard]] std::vector<std::vector<double>> orbit() const {
    std::vector<std::vector<double>> all;
    for (const Link& l : links_)
      all.push_back(doubles(l.patch.at));
    all.push_back(doubles(links_.back().landing.at));
    return all;
  }

  // A lower bound of |sin| of the angle between the manifolds at z_k, in its chart.
  [[nodiscard]] double sine(std::size_t k) const {
    Direction u = direction_of(along(0, l_.unstable.slope)),
              s = direction_of(along(1, l_.stable.slope));
    for (std::size_t i = 0; i < k; ++i)
      u = carried(links_[i].slope, u);
    for (std::size_t i = nodes_.size(); i-- > k;)
      s = carried(inverse(links_[i].slope), s);
    const auto a = vector_of(u), b = vector_of(s);
    const Ball sine = (a[0] * b[1] - a[1] * b[0]) /
                      sqrt((a[0] * a[0] + a[1] * a[1]) * (b[0] * b[0] + b[1] * b[1]));
    if (sine.contains_zero()) return 0;
    const double low = std::abs(static_cast<double>(sine)) - 2 * sine.radius();
    return low > 0 ? low * (1 - 1e-12) : 0;
  }

private:
  struct Link {
    Patch patch;               ///< around z_k
    Landing landing;           ///< of the patch
    Matrix2 slope;             ///< of Q over the patch
    std::array<Ball, 2> image; ///< of the middle
  };
  EnclosedMap& map_;
  EnclosedMapOf<DoubleBall>* rough_;
  QuickMap& quick_;
  const LocalManifolds& l_;
  Ball xi_, eta_;                     ///< exact
  std::vector<ConnectionNode> nodes_; ///< z_0 ... z_(n-1)
  std::vector<Link> links_;
  std::vector<double> radius_;

  // Unknowns: xi; z_1 ... z_(n-1); eta.
  [[nodiscard]] std::size_t unknowns() const { return 2 * nodes_.size(); }
  [[nodiscard]] const Chart& chart_of(std::size_t k) const {
    return k < nodes_.size() ? nodes_[k].chart : l_.frame.chart;
  }

  // To doubles, which both kinds of balls have as their middles.
  void move(const BallVector& step) {
    const auto moved = [](const Ball& x, const Ball& by) {
      return Ball(static_cast<double>(x - by));
    };
    xi_ = moved(xi_, step.front());
    eta_ = moved(eta_, step.back());
    for (std::size_t k = 1; k < nodes_.size(); ++k)
      for (std::size_t d = 0; d < 2; ++d)
        nodes_[k].middle[d] = moved(nodes_[k].middle[d], step[2 * k - 1 + d]);
  }

  // p + A (xi, w) for every w that the slope allows, |xi - middle| <= radius; or the same along the second axis.
  [[nodiscard]] std::array<Ball, 2> on_graph(std::size_t axis, const Ball& along, double slope,
                                             double radius) const {
    const Ball there = along.widened(Ball(radius));
    const Ball off = around_zero(slope) * there;
    std::array<Ball, 2> z;
    for (std::size_t i = 0; i < 2; ++i)
      z[i] = l_.p[i] + l_.axes[i][axis] * there + l_.axes[i][1 - axis] * off;
    return z;
  }
  // The tangents of all such graphs.
  [[nodiscard]] std::array<Ball, 2> along(std::size_t axis, double slope) const {
    std::array<Ball, 2> t;
    for (std::size_t i = 0; i < 2; ++i)
      t[i] = l_.axes[i][axis] + l_.axes[i][1 - axis] * around_zero(slope);
    return t;
  }

  // Around z_k, in its chart.
  [[nodiscard]] std::array<Ball, 2> box_of(std::size_t k, const std::vector<double>& radius) const {
    if (k == 0) return on_graph(0, xi_, l_.unstable.slope, radius[0]);
    std::array<Ball, 2> box = nodes_[k].middle;
    for (std::size_t d = 0; d < 2; ++d)
      box[d] = box[d].widened(Ball(radius[2 * k - 1 + d]));
    return box;
  }

  // The map over boxes, and at their middles.
  std::vector<Link> over(const std::vector<double>& radius) {
    std::vector<Link> all;
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      all.push_back(rough_ != nullptr ? over(*rough_, k, radius) : over(map_, k, radius));
    return all;
  }
  template <class R>
  Link over(EnclosedMapOf<R>& map, std::size_t k, const std::vector<double>& radius) {
    const std::array<Ball, 2> box = box_of(k, radius);
    Link link;
    const PatchOf<R> patch =
        map.patch(nodes_[k].chart, {as<R>(box[0]), as<R>(box[1])}, nodes_[k].near);
    const LandingOf<R> landing = map(patch, false, l_.frame.turns);
    link.patch = {patch.chart, {around(patch.box[0]), around(patch.box[1])}, around(patch.at), {}};
    for (const R& y : patch.sheet)
      link.patch.sheet.push_back(within(y));
    link.landing = {around(landing.at), around(landing.time)};
    link.slope = slope_in(link.landing.at, chart_of(k + 1));
    for (std::size_t d = 0; d < 2; ++d)
      link.image[d] = around(landing.middle[chart_of(k + 1).free[d]]);
    return link;
  }
  template <class R> static R as(const Ball& x) {
    if constexpr (std::is_same_v<R, DoubleBall>)
      return double_ball(x);
    else
      return x;
  }
  static const Ball& around(const Ball& x) { return x; }
  static Ball around(const DoubleBall& x) { return flow::around(x); }
  static const Ball& within(const Ball& x) { return x; }
  static Ball within(const DoubleBall& x) { return flow::within(x); }
  template <class R> static PhasePoint<Ball> around(const PhasePoint<R>& x) {
    PhasePoint<Ball> y;
    for (const Dual<R>& c : x)
      y.emplace_back(around(c.v), around(c.d[0]), around(c.d[1]));
    return y;
  }

  // The same in double, without proof.
  std::vector<Link> approximately() {
    std::vector<Link> all(nodes_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      Link& link = all[k];
      const std::vector<double> none(unknowns(), 0.0);
      link.patch.box = box_of(k, none);
      const auto& box = link.patch.box;
      const auto x =
          quick_.lifted(nodes_[k].chart, {static_cast<double>(box[0]), static_cast<double>(box[1])},
                        nodes_[k].near);
      const auto image = x ? quick_(*x, false, l_.frame.turns) : std::nullopt;
      if (!image) throw NotProved::left_by_newton;
      for (std::size_t i = 0; i < 2; ++i) {
        const auto& at = image->at[chart_of(k + 1).free[i]];
        link.image[i] = Ball(at.v);
        for (std::size_t d = 0; d < 2; ++d)
          link.slope[i][d] = Ball(at.d[d]);
      }
    }
    return all;
  }

  // F at the middles of the unknowns, for every pair of graphs.
  [[nodiscard]] BallVector value(const std::vector<Link>& links) const {
    BallVector f;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      std::array<Ball, 2> at = links[k].image;
      if (k == 0) { // by the mean value theorem from the middle
        const auto z = on_graph(0, xi_, l_.unstable.slope, 0);
        std::array<Ball, 2> off;
        for (std::size_t i = 0; i < 2; ++i)
          off[i] = z[i] - links[0].patch.box[i].middle();
        for (std::size_t i = 0; i < 2; ++i)
          at[i] += links[0].slope[i][0] * off[0] + links[0].slope[i][1] * off[1];
      }
      const std::array<Ball, 2> to =
          k + 1 < nodes_.size() ? nodes_[k + 1].middle : on_graph(1, eta_, l_.stable.slope, 0);
      for (std::size_t i = 0; i < 2; ++i)
        f.push_back(at[i] - to[i]);
    }
    return f;
  }

  [[nodiscard]] BallMatrix slopes() const {
    const std::size_t n = nodes_.size();
    BallMatrix a(unknowns(), BallVector(unknowns(), Ball(0)));
    const auto u = along(0, l_.unstable.slope), s = along(1, l_.stable.slope);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < 2; ++i) {
        BallVector& row = a[2 * k + i];
        const auto& d = links_[k].slope[i];
        if (k == 0) {
          row[0] = d[0] * u[0] + d[1] * u[1];
        } else {
          row[2 * k - 1] = d[0];
          row[2 * k] = d[1];
        }
        if (k + 1 < n)
          row[2 * k + 1 + i] = Ball(-1);
        else
          row[unknowns() - 1] = -s[i];
      }
    return a;
  }

  void krawczyk() {
    links_ = approximately();
    const double tolerance = rough_ != nullptr ? rough_->tolerance() : map_.tolerance();
    const Ball added(std::max(1e-15, 8 * tolerance)); // by the enclosure of a return
    for (Link& l : links_)
      for (Ball& x : l.image)
        x = x.widened(added);
    const auto c = approximate_inverse(slopes());
    if (!c) throw NotProved::tangent;
    radius_.clear();
    for (const Ball& b : applied(*c, value(links_)))
      radius_.push_back(2 * bound_of(b) + 1e-36);
    for (int attempt = 0; attempt < 6; ++attempt) {
      links_ = over(radius_);
      const BallVector shift = krawczyk_shift(*c, value(links_), slopes(), radius_);
      if (shift_inside(shift, radius_)) return look_at_ends();
      for (std::size_t i = 0; i < radius_.size(); ++i) {
        radius_[i] = 3 * std::max(radius_[i], bound_of(shift[i]));
        if (!(radius_[i] < 1e-3)) throw NotProved::krawczyk;
      }
    }
    throw NotProved::krawczyk;
  }

  // The zero is an orbit from one graph to the other: on its sheets, within the parallelogram, and not p.
  void look_at_ends() const {
    const Ball r(l_.reach), xi = xi_.widened(Ball(radius_.front())),
                            eta = eta_.widened(Ball(radius_.back()));
    for (const Ball& x : {xi, eta})
      if (x.contains_zero() || !(x < r) || !(-x < r)) throw NotProved::outside;
    for (std::size_t i = 0; i < l_.region.sheet.size(); ++i)
      if (!links_[0].patch.at[l_.region.chart.rest[i]].v.inside(l_.region.sheet[i]))
        throw NotProved::leaves_sheet;
    for (std::size_t k = 0; k < links_.size(); ++k)
      if (!EnclosedMap::same_sheet(links_[k].landing,
                                   k + 1 < links_.size() ? links_[k + 1].patch : l_.region))
        throw NotProved::another_sheet;
  }
};

} // namespace

namespace {

HomoclinicProof proof_of(const LocalManifolds& l, const PeriodicOrbit& fixed,
                         const HomoclinicConnection& c, const HomoclinicGuess& g, QuickMap& quick) {
  HomoclinicProof p;
  p.fixed = fixed;
  p.axes = l.frame.axes;
  p.chart = l.frame.chart;
  p.reach = l.reach;
  p.slope_unstable = l.unstable.slope;
  p.slope_stable = l.stable.slope;
  p.stretch_unstable = l.unstable.stretch;
  p.stretch_stable = l.stable.stretch;
  p.xi = c.xi();
  p.eta = c.eta();
  for (const auto& x : c.orbit()) {
    const auto v = quick.code().at(PhasePoint<double>(x.begin(), x.end()));
    p.orbit.push_back({x, {v.drawn[0].v, v.drawn[1].v}});
  }
  for (const double r : c.radius())
    p.error = std::max(p.error, r);
  p.middle = g.middle;
  p.sine = c.sine(g.middle);
  return p;
}

// With more of the orbit at both ends, until these lie in the parallelogram.  Near p the map is linear.
HomoclinicGuess drawn_out(HomoclinicGuess g, const LocalManifolds& l, QuickMap& quick) {
  const auto outside = [&](double x) { return std::abs(x) > 0.9 * l.reach; };
  const auto state = [&](std::size_t axis, double x) {
    const auto at = quick.lifted(
        l.frame.chart,
        {l.frame.at[0] + l.frame.axes[0][axis] * x, l.frame.at[1] + l.frame.axes[1][axis] * x},
        l.frame.near);
    if (!at) throw NotProved::section_piece;
    return doubles(*at);
  };
  for (; outside(g.xi); ++g.middle)
    g.orbit.insert(g.orbit.begin(), state(0, g.xi /= l.multipliers[0]));
  while (outside(g.eta))
    g.orbit.push_back(state(1, g.eta *= l.multipliers[1]));
  return g;
}

void try_orbit(EnclosedMap& map, EnclosedMapOf<DoubleBall>* rough, QuickMap& quick,
               const PeriodicOrbit& orbit, const HomoclinicOptions& o, Homoclinic& out) {
  std::vector<std::vector<double>> points;
  for (const PeriodicPoint& p : orbit.points)
    points.push_back(p.x);
  const LocalManifolds l = local_manifolds(map, quick, points, o.smaller);
  ManifoldArcs arcs(quick, l.frame, o.most_returns, o.stop);
  const auto guesses = arcs.guesses(static_cast<std::size_t>(o.most_candidates));
  out.unstable = arcs.curves(false);
  out.stable = arcs.curves(true);
  if (guesses.empty()) throw NotProved::no_crossing;
  std::optional<NotProved> why;
  for (const HomoclinicGuess& guess : guesses) {
    try {
      const HomoclinicGuess g = drawn_out(guess, l, quick);
      HomoclinicConnection c(map, rough, quick, l, g);
      c.prove();
      out.proof = proof_of(l, orbit, c, g, quick);
      return;
    } catch (const NotProved& n) {
      if (!why) why = n;
    }
  }
  throw *why;
}

// In double; those with the largest multipliers first, whose manifolds wind least.
std::vector<PeriodicOrbit> hyperbolic_orbits(const SystemScene& scene, QuickMap& quick,
                                             const HomoclinicOptions& o) {
  PeriodicOptions periodic;
  periodic.period = o.period;
  periodic.columns = 24;
  periodic.rows = 20;
  periodic.stop = o.stop;
  std::vector<PeriodicOrbit> all = look_for_orbits(scene, quick, periodic).orbits;
  std::erase_if(all, [](const PeriodicOrbit& p) { return std::abs(p.trace) <= 2; });
  std::ranges::stable_sort(all, [](const PeriodicOrbit& a, const PeriodicOrbit& b) {
    return std::abs(a.trace) > std::abs(b.trace) + 1e-6;
  });
  return all;
}

} // namespace

Homoclinic homoclinic(const SystemScene& scene, const HomoclinicOptions& options) {
  Homoclinic out;
  const SectionSurface surface(scene);
  QuickMap quick(surface);
  const EnclosureScope scope(options.bits);
  EnclosedMap map(surface, options.stop);
  std::optional<EnclosedMapOf<DoubleBall>> rough; // most digits of 64 bits are not needed
  if (options.bits <= 64) rough.emplace(surface, options.stop);
  for (const PeriodicOrbit& found : hyperbolic_orbits(scene, quick, options)) {
    if (out.proof || (options.stop != nullptr && options.stop->load())) break;
    const PeriodicOrbit orbit = prove_orbit(map, quick, found);
    if (!orbit.proved || (orbit.stability != Stability::hyperbolic &&
                          orbit.stability != Stability::inverse_hyperbolic))
      continue;
    out.hyperbolic.push_back(orbit);
    try {
      try_orbit(map, rough ? &*rough : nullptr, quick, orbit, options, out);
    } catch (const NotProved& n) {
      out.why = n;
    }
  }
  out.stopped = options.stop != nullptr && options.stop->load();
  return out;
}

} // namespace kov::flow
