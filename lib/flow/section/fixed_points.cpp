#include "flow/section/fixed_points.hpp"

#include "flow/chaos/krawczyk.hpp"
#include "flow/chaos/periodic_orbit.hpp"
#include "flow/scene/body_system.hpp"
#include "flow/section/index_grid.hpp"
#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace kov::flow {
namespace {

double wrapped(double angle) { return std::remainder(angle, 2 * pi_of(0.0)); }

// The section map's coordinates and their derivatives.
template <class R> struct Angles { Dual<R> l, y; };
struct SectionImage : Angles<double> { ///< with derivatives with respect to the start's (l, L/G)
  double time = 0;
  double g_size = 0; ///< G on arrival
};

// (l, L/G) of a state (N, Gamma); l is the value in (about - pi, about + pi], so that no cut is near `about`.
template <class R> Angles<R> angles_of(const PhasePoint<R>& x, const R& about) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Dual<R> c(R(cos(about))), s(R(sin(about)));
  return {Dual<R>(about) + atan2(x[0] * c - x[1] * s, x[1] * c + x[0] * s),
          x[2] / sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])};
}

// A scene in own units, as the search and the proofs know it.
class BodySection {
public:
  explicit BodySection(const SystemScene& s)
      : own_(s.body->own), body_(own_.body<double>()), levels_(own_.levels<double>()), surface_(s),
        quick_(surface_) {}

  /// Every G over (l, L/G) with the wanted direction, ascending.
  [[nodiscard]] std::vector<double> sizes(double l, double y) {
    std::vector<double> all = momentum_sizes(body_, levels_, own_.section, l, y);
    std::erase_if(all, [&](double size) {
      const std::vector<double> x = state(l, y, size);
      return (quick_.rate({x.begin(), x.end()}) > 0) != surface_.rising();
    });
    return all;
  }

  /// (N, Gamma) over (l, L/G), along the axes of system_of.
  [[nodiscard]] std::vector<double> state(double l, double y, double size) const {
    return coordinates_of(body_, section_point(body_, levels_, own_.section, l, y, size),
                          own_.section);
  }

  /// Nothing if the orbit does not come back.
  [[nodiscard]] std::optional<SectionImage> image(double l, double y, double size) {
    const std::vector<double> near = state(l, y, size);
    const Chart chart = chart_at(quick_.code(), near);
    const auto x = quick_.lifted(chart, {near[chart.free[0]], near[chart.free[1]]}, near);
    const auto there = x ? quick_(*x) : std::nullopt;
    if (!there) return std::nullopt;
    const Angles<double> from = angles_of(*x, l);
    SectionImage to{angles_of(there->at, l), there->time, 0};
    const double det = from.l.d[0] * from.y.d[1] - from.l.d[1] * from.y.d[0];
    for (Dual<double>* d : {&to.l, &to.y}) {
      const double u = d->d[0], v = d->d[1];
      d->d[0] = (u * from.y.d[1] - v * from.y.d[0]) / det;
      d->d[1] = (v * from.l.d[0] - u * from.l.d[1]) / det;
    }
    for (int i = 0; i < 3; ++i)
      to.g_size = std::hypot(to.g_size, there->at[static_cast<std::size_t>(i)].v);
    return to;
  }

  /// The point near f with its bounds; f with `why` where it is not proved.
  [[nodiscard]] FixedPoint proved(const FixedPoint& f, long bits, const std::atomic<bool>* stop) {
    FixedPoint p = f;
    const EnclosureScope scope(bits);
    try {
      EnclosedMap map(surface_, stop);
      const EnclosedOrbit orbit = enclose_orbit(map, quick_, {state(f.l, f.y, f.g_size)});
      const Angles<Enclosure> at = angles_of(orbit.patches[0].at, Enclosure(f.l));
      const auto shown = [](const Enclosure& x, double& middle) {
        middle = static_cast<double>(x);
        return bound_of(x - Enclosure(middle));
      };
      p.error = std::max(shown(at.l.v, p.l), shown(at.y.v, p.y));
      p.trace_error = shown(orbit.trace, p.trace);
      p.determinant = static_cast<double>(orbit.determinant);
      p.period = static_cast<double>(orbit.time);
      p.proved = true;
    } catch (const NotProved& why) {
      p.why = why;
    }
    return p;
  }

private:
  Scene own_;
  Body<double> body_;
  Levels<double> levels_;
  SectionSurface surface_;
  QuickMap quick_;
};

// The section map in double on one sheet of the level: the place in the order of the values of G over (l, L/G), from
// the largest.
class SectionMap {
public:
  SectionMap(BodySection& section, std::size_t sheet) : section_(section), sheet_(sheet) {}

  [[nodiscard]] std::optional<double> size_at(double l, double y) const {
    if (std::abs(y) >= 1) return std::nullopt;
    const auto sizes = section_.sizes(l, y);
    if (sizes.size() <= sheet_) return std::nullopt;
    return sizes[sizes.size() - 1 - sheet_];
  }

  /// The image lies on this sheet, too.
  [[nodiscard]] bool returns(const SectionImage& image) const {
    const auto size = size_at(image.l.v, image.y.v);
    return size && std::abs(image.g_size - *size) < 1e-6 * *size;
  }

  [[nodiscard]] std::optional<SectionImage> operator()(double l, double y) const {
    const auto size = size_at(l, y);
    return size ? section_.image(l, y, *size) : std::nullopt;
  }

private:
  BodySection& section_;
  std::size_t sheet_;
};

struct Place {
  double l = 0, y = 0;
};

// Newton's method for P(u) = u, with steps of at most 0.2.
// If DP - 1 is singular, the fixed points are not isolated (or a bifurcation is near):
// `along_a_curve`.
std::optional<FixedPoint> newton(const SectionMap& map, Place u, bool& along_a_curve) {
  along_a_curve = false;
  for (int i = 0; i < 30; ++i) {
    const auto p = map(u.l, u.y);
    if (!p) return std::nullopt;
    const double fl = wrapped(p->l.v - u.l), fy = p->y.v - u.y;
    const double a = p->l.d[0] - 1, b = p->l.d[1], c = p->y.d[0], d = p->y.d[1] - 1;
    const double det = a * d - b * c;
    double dl = -(d * fl - b * fy) / det, dy = -(a * fy - c * fl) / det;
    const double length = std::hypot(dl, dy);
    if (!std::isfinite(length)) return std::nullopt;
    if (std::hypot(fl, fy) < 1e-6 && std::abs(det) < 1e-4) {
      along_a_curve = true;
      return std::nullopt;
    }
    if (length < 1e-12 || (length < 1e-10 && i > 12)) {
      FixedPoint f;
      f.g_size = map.size_at(u.l, u.y).value_or(0);
      if (!(std::abs(p->g_size - f.g_size) < 1e-6 * f.g_size)) return std::nullopt; // another sheet
      f.l = std::remainder(u.l, 2 * pi_of(0.0));
      if (f.l < -1e-9) f.l += 2 * pi_of(0.0);
      f.l = std::abs(f.l) < 1e-13 ? 0 : f.l;
      f.y = std::abs(u.y) < 1e-13 ? 0 : u.y;
      f.period = p->time;
      f.trace = p->l.d[0] + p->y.d[1];
      f.determinant = p->l.d[0] * p->y.d[1] - b * c;
      return f;
    }
    const double shorten = std::min(1.0, 0.2 / length);
    u = {u.l + shorten * dl, u.y + shorten * dy};
  }
  return std::nullopt;
}

void classify(FixedPoint& f) {
  const double slack = std::max(f.trace_error, 1e-9);
  f.stability = std::abs(std::abs(f.trace) - 2) <= slack ? Stability::parabolic
                : f.trace > 2                            ? Stability::hyperbolic
                : f.trace < -2                           ? Stability::inverse_hyperbolic
                                                         : Stability::elliptic;
  const double q = f.trace * f.trace / 4 - 1;
  if (q >= 0)
    f.multiplier = {f.trace / 2 + std::copysign(std::sqrt(q), f.trace), 0};
  else
    f.multiplier = {f.trace / 2, std::sqrt(-q)};
}

int index_of(const FixedPoint& f) { return f.stability == Stability::hyperbolic ? -1 : 1; }

// The search on one sheet of the level.
class Search {
public:
  Search(BodySection& s, const FixedPointOptions& o, std::size_t sheet)
      : map_(s, sheet), o_(o),
        grid_(o.columns, o.rows, [this](const Latitude& u) { return displaced(u); }) {}

  FixedPoints run() {
    std::size_t still = 0;
    for_cells([&](int i, int k) { still += size_at(grid_.node(i, k)) < 1e-7 ? 1 : 0; });
    found_.degenerate = 2 * still > static_cast<std::size_t>(o_.columns * (o_.rows - 1));
    if (found_.degenerate) return found_;
    grid_.count();
    for_cells([&](int i, int k) { look(i, k); });
    look_at_mirror_images(0);
    for_cells([&](int i, int k) {
      if (!is_explained(i, k)) look_closer(i, k);
    });
    for_cells([&](int i, int k) { tally(i, k); });
    found_.at_poles = int(pole_[0]) + int(pole_[1]);
    return found_;
  }

  /// The level has no such sheet.
  [[nodiscard]] bool is_empty() const {
    bool empty = true;
    for_cells([&](int i, int k) {
      const Latitude u = grid_.place(i, k);
      empty = empty && !map_.size_at(u.l, std::sin(u.y));
    });
    return empty;
  }

private:
  SectionMap map_;
  FixedPointOptions o_;
  FixedPoints found_;
  IndexGrid grid_; // samples the map when it is made: after what the map needs
  bool pole_[2] = {false, false};

  template <class F> void for_cells(const F& f) const {
    for (int i = 0; i < o_.columns; ++i)
      for (int k = 0; k + 1 < o_.rows; ++k)
        f(i, k);
  }
  bool stopped() {
    if (o_.stop != nullptr && o_.stop->load()) found_.stopped = true;
    return found_.stopped;
  }
  static double size_at(const std::optional<Displaced>& d) {
    return d ? std::hypot(d->by.l, d->by.y) : INFINITY;
  }
  // Nothing where the orbit comes back to another sheet: this sheet has no map there.
  std::optional<Displaced> displaced(const Latitude& u) {
    if (stopped()) return std::nullopt;
    const double y = std::sin(u.y);
    const auto p = map_(u.l, y);
    if (!p || !map_.returns(*p)) return std::nullopt;
    const double from = std::cos(u.y), to = std::sqrt(1 - p->y.v * p->y.v);
    return Displaced{u,
                     {wrapped(p->l.v - u.l), std::asin(p->y.v) - u.y},
                     {p->l.d[0] - 1, p->l.d[1] * from, p->y.d[0] / to, p->y.d[1] * from / to - 1}};
  }
  bool keep(const std::optional<FixedPoint>& f) {
    if (!f) return false;
    if (1 - std::abs(f->y) < 1e-9) return pole_[f->y > 0 ? 1 : 0] = true; // no angle l there
    for (const FixedPoint& old : found_.points)
      if (std::abs(wrapped(old.l - f->l)) < 1e-7 && std::abs(old.y - f->y) < 1e-7) return true;
    FixedPoint full = *f;
    classify(full);
    found_.points.push_back(full);
    return true;
  }
  void start_at(const Latitude& u, bool& curve) {
    if (!stopped()) keep(newton(map_, {u.l, std::sin(u.y)}, curve));
  }
  // Many bodies have symmetries that turn or mirror the section: a good guess for the partners, no
  // more.
  void look_at_mirror_images(std::size_t first) {
    const double pi = pi_of(0.0);
    bool curve = false;
    for (std::size_t i = first; i < found_.points.size() && !stopped(); ++i) { // grows meanwhile
      const FixedPoint f = found_.points[i];
      for (const double l : {f.l, -f.l, f.l + pi, pi - f.l})
        for (const double y : {f.y, -f.y})
          keep(newton(map_, {l, y}, curve));
    }
  }
  void look(int i, int k) {
    bool curve = false;
    if (grid_.on_level(i, k) && grid_.index(i, k).value_or(1) != 0)
      start_at(grid_.place(i + 0.5, k + 0.5), curve);
    if (size_at(grid_.node(i, k)) < 0.5) start_at(grid_.place(i, k), curve);
    found_.curve_cells += curve ? 1 : 0;
  }
  // The cell has no index, or the points found in it add up to it.
  [[nodiscard]] bool is_explained(int i, int k) const {
    const auto index = grid_.index(i, k);
    if (!index) return true;
    int sum = 0;
    for (const FixedPoint& f : found_.points) {
      if (grid_.cell_of({f.l, std::asin(f.y)}) != std::array{i, k}) continue;
      if (f.stability == Stability::parabolic) return true; // its index may be anything
      sum += index_of(f);
    }
    return sum == *index;
  }
  // From many places of the cell.
  void look_closer(int i, int k) {
    constexpr int n = 5;
    bool curve = false;
    const std::size_t before = found_.points.size();
    for (int place = 0; place < n * n && !is_explained(i, k); ++place)
      start_at(grid_.place(i + (place % n + 0.5) / n, k + (place / n + 0.5) / n), curve);
    look_at_mirror_images(before);
  }
  void tally(int i, int k) {
    if (!grid_.on_level(i, k)) return;
    const auto index = grid_.index(i, k);
    ++(index ? found_.cells : found_.cells_without_index);
    found_.index_sum += index.value_or(0);
    found_.unexplained_cells += is_explained(i, k) ? 0 : 1;
  }
};

} // namespace

std::string to_string(Stability s) {
  constexpr std::array all{"elliptic", "hyperbolic", "inverse hyperbolic", "parabolic"};
  return all.at(static_cast<std::size_t>(s));
}

namespace {

// All sheets of the level together.
FixedPoints search(BodySection& section, const FixedPointOptions& options) {
  FixedPoints all;
  for (std::size_t sheet = 0; !all.stopped; ++sheet) {
    Search search(section, options, sheet);
    if (sheet > 0 && search.is_empty()) break;
    const FixedPoints one = search.run();
    all.points.insert(all.points.end(), one.points.begin(), one.points.end());
    all.index_sum += one.index_sum;
    all.cells += one.cells;
    all.cells_without_index += one.cells_without_index;
    all.at_poles += one.at_poles;
    all.unexplained_cells += one.unexplained_cells;
    all.curve_cells += one.curve_cells;
    all.stopped = one.stopped;
    all.degenerate = all.degenerate || one.degenerate;
  }
  std::ranges::sort(all.points, [](const auto& a, const auto& b) {
    return std::abs(a.l - b.l) > 1e-9 ? a.l < b.l : a.y < b.y;
  });
  return all;
}

FixedPoint in_units_of_scene(FixedPoint f, const OwnUnits& units) {
  f.g_size = std::ldexp(f.g_size, static_cast<int>(units.momentum()));
  f.period = std::ldexp(f.period, static_cast<int>(units.time));
  return f;
}

// With more and more bits, until the point is proved and its trace is known well.
FixedPoint proved(BodySection& section, const FixedPoint& guess, const FixedPointOptions& o) {
  FixedPoint best = guess;
  for (long bits = o.bits; bits <= o.most_bits; bits += o.bits / 2) {
    const FixedPoint f = section.proved(guess, bits, o.stop);
    if (f.proved || !best.proved) best = f;
    if ((f.proved && f.trace_error <= 1e-9) || (o.stop != nullptr && o.stop->load())) break;
  }
  classify(best);
  return best;
}

} // namespace

FixedPoints fixed_points(const SystemScene& scene, const FixedPointOptions& options) {
  if (scene.falling && scene.rising)
    throw InputError(scene.file, 0, 0, 1, "fixed points need one direction of crossing, not both",
                     "direction = \"upward\" or \"downward\"");
  const OwnUnits& units = scene.body->units;
  BodySection section(scene);
  FixedPoints found = search(section, options);
  const std::vector<FixedPoint> guesses = found.points;
  for (FixedPoint& f : found.points)
    f = in_units_of_scene(f, units);
  for (std::size_t i = 0; options.prove && i < guesses.size(); ++i) {
    if (options.progress) options.progress(found, i);
    found.points[i] = in_units_of_scene(proved(section, guesses[i], options), units);
  }
  found.stopped = found.stopped || (options.stop != nullptr && options.stop->load());
  return found;
}

FixedPoint prove_fixed_point(const SystemScene& scene, const FixedPoint& guess, long bits,
                             const std::atomic<bool>* stop) {
  const OwnUnits& units = scene.body->units;
  FixedPoint f = guess;
  f.g_size = std::ldexp(f.g_size, static_cast<int>(-units.momentum()));
  f.period = std::ldexp(f.period, static_cast<int>(-units.time));
  return in_units_of_scene(BodySection(scene).proved(f, bits, stop), units);
}

} // namespace kov::flow
