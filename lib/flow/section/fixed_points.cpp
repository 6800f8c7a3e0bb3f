#include "flow/section/fixed_points.hpp"

#include "flow/scene/own_units.hpp"
#include "flow/section/index_grid.hpp"
#include "flow/section/section_map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace kov::flow {
namespace {

double wrapped(double angle) { return std::remainder(angle, 2 * pi_of(0.0)); }

// The section map in double, with its derivative, on one sheet of the level: the place in the order
// of the values of G over (l, L/G), from the largest.
class SectionMap {
public:
  SectionMap(const Scene& s, std::size_t sheet)
      : sheet_(sheet), plain_(s.body<double>()), plain_levels_(s.levels<double>()),
        body_(dual_body(plain_)), levels_{Dual<double>(plain_levels_.energy),
                                          Dual<double>(plain_levels_.length),
                                          Dual<double>(plain_levels_.casimir)},
        rule_(s.section), effects_(s.effects()) {}

  [[nodiscard]] std::optional<double> size_at(double l, double y) const {
    if (std::abs(y) >= 1) return std::nullopt;
    const auto sizes = momentum_sizes(plain_, plain_levels_, rule_, l, y);
    if (sizes.size() <= sheet_) return std::nullopt;
    return sizes[sizes.size() - 1 - sheet_];
  }

  /// The image lies on this sheet, too.
  [[nodiscard]] bool returns(const SectionImage<double>& image) const {
    const auto size = size_at(image.l.v, image.y.v);
    return size && std::abs(image.g_size - *size) < 1e-6 * *size;
  }

  [[nodiscard]] std::optional<SectionImage<double>> operator()(double l, double y) const {
    const auto size = size_at(l, y);
    if (!size) return std::nullopt;
    VariationalJet<double> jet(body_, effects_, order);
    State<Dual<double>> x = lifted(body_, levels_, rule_, l, y, *size);
    double time = 0;
    bool above = rule_.rising; // it has just crossed
    for (int step = 0; step < 4000; ++step) {
      jet.expand(x, order);
      const double h = step_size(jet);
      const Dual<double>* s = jet.section(rule_.axis, order);
      double b[order + 1], power = 1;
      for (int k = 0; k <= order; ++k, power *= h)
        b[k] = s[k].v * power;
      Root<double> roots[order];
      int tangencies = 0;
      const int n = sign_changes(b, order, 1e-15, above, rule_.falling, rule_.rising, roots, order,
                                 tangencies);
      for (int i = 0; i < n; ++i) {
        const auto image = land(jet, s, roots[i].x * h, l);
        if (image)
          return SectionImage<double>{image->l, image->y, time + roots[i].x * h, image->g_size};
      }
      x = jet.at(Dual<double>(h), order);
      time += h;
    }
    return std::nullopt;
  }

private:
  static constexpr int order = 18;
  std::size_t sheet_;
  Body<double> plain_;
  Levels<double> plain_levels_;
  Body<Dual<double>> body_;
  Levels<Dual<double>> levels_;
  SectionRule rule_;
  Effects effects_;

  static double step_size(const VariationalJet<double>& jet) {
    double h = 1e100;
    for (const int k : {order - 1, order}) {
      const State<Dual<double>> c = jet.coefficient(k);
      double size = 1e-300;
      for (int i = 0; i < 3; ++i)
        for (const Dual<double>* d : {&c.omega[i], &c.gamma[i]})
          size = std::max({size, std::abs(d->v), std::abs(d->d[0]), std::abs(d->d[1])});
      h = std::min(h, std::pow(1e-16 / size, 1.0 / k));
    }
    return h;
  }

  static State<double> values(const State<Dual<double>>& x) {
    State<double> v;
    for (std::size_t i = 0; i < 3; ++i) {
      v.omega[i] = x.omega[i].v;
      v.gamma[i] = x.gamma[i].v;
    }
    return v;
  }

  // On the section with the wanted side; the time of arrival depends on the start too.
  [[nodiscard]] std::optional<SectionImage<double>>
  land(const VariationalJet<double>& jet, const Dual<double>* s, double t, double about) const {
    double rate = 0, power = 1;
    Dual<double> value;
    for (int k = 0; k <= order; ++k) {
      value = value + Dual<double>(power) * s[k];
      if (k < order) rate += (k + 1) * s[k + 1].v * power;
      power *= t;
    }
    const Dual<double> arrival(t, -value.d[0] / rate, -value.d[1] / rate);
    const State<Dual<double>> x = jet.at(arrival, order);
    if ((section_functions(body_, x, rule_.axis).c.v > 0) != (rule_.side > 0)) return std::nullopt;
    SectionImage<double> out;
    chart(body_, x, rule_.axis, Dual<double>(about), out.l, out.y);
    const Vec<double> n = minus(momentum(plain_, values(x)), plain_.gyrostat);
    out.g_size = std::sqrt(dot(n, n));
    return out;
  }
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
  Search(const Scene& s, const FixedPointOptions& o, std::size_t sheet)
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
  switch (s) {
  case Stability::elliptic:
    return "elliptic";
  case Stability::hyperbolic:
    return "hyperbolic";
  case Stability::inverse_hyperbolic:
    return "inverse hyperbolic";
  default:
    return "parabolic";
  }
}

namespace {

// All sheets of the level together.
FixedPoints search(const Scene& own, const FixedPointOptions& options) {
  FixedPoints all;
  for (std::size_t sheet = 0; !all.stopped; ++sheet) {
    Search search(own, options, sheet);
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

// With more and more bits, until the point is proved and its trace is known well.
FixedPoint proved(const Scene& scene, const FixedPoint& guess, const FixedPointOptions& o) {
  FixedPoint best = guess;
  for (long bits = o.bits; bits <= o.most_bits; bits += o.bits / 2) {
    const FixedPoint f = prove_fixed_point(scene, guess, bits, o.stop);
    if (f.proved || !best.proved) best = f;
    if ((f.proved && f.trace_error <= 1e-9) || (o.stop != nullptr && o.stop->load())) break;
  }
  classify(best);
  return best;
}

} // namespace

FixedPoints fixed_points(const Scene& scene, const FixedPointOptions& options) {
  if (scene.section.falling && scene.section.rising)
    throw InputError(scene.file, 0, 0, 1, "fixed points need one direction of crossing, not both",
                     "direction = \"upward\" or \"downward\"");
  const OwnUnits units = own_units(scene);
  FixedPoints found = search(in_units(scene, units), options);
  for (FixedPoint& f : found.points) {
    f.g_size = std::ldexp(f.g_size, static_cast<int>(units.momentum()));
    f.period = std::ldexp(f.period, static_cast<int>(units.time));
  }
  for (std::size_t i = 0; options.prove && i < found.points.size(); ++i) {
    if (options.progress) options.progress(found, i);
    found.points[i] = proved(scene, found.points[i], options);
  }
  found.stopped = found.stopped || (options.stop != nullptr && options.stop->load());
  return found;
}

} // namespace kov::flow
