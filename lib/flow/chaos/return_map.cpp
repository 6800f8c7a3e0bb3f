#include "flow/chaos/return_map.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kov::flow {
namespace {

using Ball = Enclosure;
using DualBall = Dual<Ball>;

// An upper bound of |x|, or infinity where there is none.
double magnitude(const Ball& x) {
  const double m = (std::abs(static_cast<double>(x)) + x.radius()) * (1 + 1e-15);
  return std::isfinite(m) ? m : INFINITY;
}

double magnitude(const PhasePoint<Ball>& x) {
  double most = 0;
  for (const DualBall& c : x)
    most = std::max({most, magnitude(c.v), magnitude(c.d[0]), magnitude(c.d[1])});
  return most;
}

// What two enclosures of one number have in common.
Ball common(const Ball& a, const Ball& b) {
  if (arb_is_finite(a.raw()) == 0 || arb_is_finite(b.raw()) == 0) throw NotProved::enclosure_lost;
  Ball both;
  if (arb_intersection(both.raw(), a.raw(), b.raw(), Ball::bits()) == 0)
    throw NotProved::enclosures_apart; // cannot be
  return both;
}

// ---- matrices ----

BallMatrix unit_matrix(std::size_t n) {
  BallMatrix a(n, BallVector(n));
  for (std::size_t j = 0; j < n; ++j)
    a[j][j] = Ball(1);
  return a;
}

BallMatrix product(const BallMatrix& a, const BallMatrix& b) {
  BallMatrix c(a.size(), BallVector(b[0].size()));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b[0].size(); ++j)
      for (std::size_t k = 0; k < b.size(); ++k)
        add_product(c[i][j], a[i][k], b[k][j]);
  return c;
}

BallVector sum(BallVector a, const BallVector& b) {
  for (std::size_t j = 0; j < a.size(); ++j)
    a[j] += b[j];
  return a;
}

BallMatrix inverse(const BallMatrix& a) {
  const std::size_t n = a.size();
  BallMatrix b(n, BallVector(n));
  for (std::size_t k = 0; k < n; ++k) {
    BallVector e(n);
    e[k] = Ball(1);
    const BallVector column = solved(a, e);
    for (std::size_t j = 0; j < n; ++j)
      b[j][k] = column[j];
  }
  return b;
}

// Nearly orthonormal columns, exact, along the images of the axes, the largest uncertainty first: Gram and Schmidt in
// double.  Any regular matrix is correct.
BallMatrix axes_along(const BallMatrix& moved, const BallVector& size) {
  const std::size_t n = size.size();
  std::vector<std::pair<double, std::vector<double>>> columns;
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> c(n);
    double length = 0;
    for (std::size_t j = 0; j < n; ++j)
      length = std::max(length, std::abs(c[j] = static_cast<double>(moved[j][k])));
    columns.emplace_back(length * bound_of(size[k]), c);
  }
  std::stable_sort(columns.begin(), columns.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t k = 0; k < n; ++k) { // where an axis is lost
    columns.emplace_back(0, std::vector<double>(n));
    columns.back().second[k] = 1;
  }
  std::vector<std::vector<double>> kept;
  for (auto& [weight, c] : columns) {
    double before = 0;
    for (const double x : c)
      before += x * x;
    for (int twice = 0; twice < 2; ++twice)
      for (const auto& q : kept) {
        const double along = std::inner_product(c.begin(), c.end(), q.begin(), 0.0);
        for (std::size_t j = 0; j < n; ++j)
          c[j] -= along * q[j];
      }
    const double after = std::inner_product(c.begin(), c.end(), c.begin(), 0.0);
    if (kept.size() == n || !(after > 1e-12 * before) || !std::isfinite(after)) continue;
    for (double& x : c)
      x /= std::sqrt(after);
    kept.push_back(c);
  }
  if (kept.size() < n) throw NotProved::enclosure_lost;
  BallMatrix axes(n, BallVector(n));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = 0; k < n; ++k)
      axes[j][k] = Ball(kept[k][j]);
  return axes;
}

Ball power(const Ball& x, int n) {
  Ball r;
  arb_pow_ui(r.raw(), x.raw(), static_cast<ulong>(n), Ball::bits());
  return r;
}

} // namespace

std::vector<double> doubles(const PhasePoint<double>& x) {
  std::vector<double> all;
  for (const auto& c : x)
    all.push_back(c.v);
  return all;
}
std::vector<double> doubles(const PhasePoint<Enclosure>& x) {
  std::vector<double> all;
  for (const auto& c : x)
    all.push_back(static_cast<double>(c.v));
  return all;
}

EnclosedMap::EnclosedMap(const SectionSurface& s, const std::atomic<bool>* stop)
    : s_(s), stop_(stop), tolerance_(std::exp2(-0.625 * static_cast<double>(Ball::bits()))),
      order_(static_cast<int>(Ball::bits()) / 5 + 4), over_box_(s, order_ + 1), point_(s, 0) {
  for (std::size_t j = 0; j < s.dimension(); j += 2)
    wide_.code.emplace_back(s, order_ + 1);
  thin_.code.emplace_back(s, order_ + 1);
}

// ---- charts ----

namespace {

// The equations and their derivatives by chart.rest at x.
struct Local {
  std::vector<Ball> value;
  std::vector<std::vector<Ball>> by_rest, by_free;
};
Local local(SurfaceCode<Ball>& code, const Chart& chart, const PhasePoint<Ball>& x) {
  const SurfaceValues<Ball> v = code.at(x);
  Local l;
  for (std::size_t i = 0; i < v.equations.size(); ++i) {
    l.value.push_back(v.equations[i].v);
    l.by_rest.emplace_back();
    for (const std::size_t j : chart.rest)
      l.by_rest.back().push_back(v.slope[i][j].v);
    l.by_free.push_back({v.slope[i][chart.free[0]].v, v.slope[i][chart.free[1]].v});
  }
  return l;
}

PhasePoint<Ball> joined(const Chart& chart, const std::array<Ball, 2>& free,
                        const std::vector<Ball>& rest) {
  PhasePoint<Ball> x(rest.size() + 2);
  for (std::size_t k = 0; k < 2; ++k)
    x[chart.free[k]] = DualBall(free[k]);
  for (std::size_t k = 0; k < rest.size(); ++k)
    x[chart.rest[k]] = DualBall(rest[k]);
  return x;
}

} // namespace

// Interval Newton for the rest: N = y - G_y(box, Y)^-1 G(box, y) inside Y proves that each point of the box has
// exactly one solution in Y, and that it lies in N.
Patch EnclosedMap::patch(const Chart& chart, const std::array<Ball, 2>& box,
                         const std::vector<double>& near) {
  const std::array<Ball, 2> middle{box[0].middle(), box[1].middle()};
  std::vector<Ball> y;
  double scale = 0;
  for (const double c : near)
    scale = std::max(scale, std::abs(c));
  for (const std::size_t j : chart.rest)
    y.emplace_back(near[j]);
  for (int i = 0; i < 10; ++i) { // to full precision, in the middle
    const Local l = local(point_, chart, joined(chart, middle, y));
    const std::vector<Ball> step = solved(l.by_rest, l.value);
    for (std::size_t k = 0; k < y.size(); ++k)
      y[k] = (y[k] - step[k]).middle();
  }
  const Local here = local(point_, chart, joined(chart, box, y));
  for (double room = 1.0 / 32; room > 1e-20; room /= 16) {
    Patch p{chart, box, {}, {}};
    for (const Ball& c : y)
      p.sheet.push_back(c.widened(Ball(room * scale)));
    const Local over = local(point_, chart, joined(chart, box, p.sheet));
    const std::vector<Ball> step = solved(over.by_rest, here.value);
    std::vector<Ball> rest;
    bool inside = true;
    for (std::size_t k = 0; k < y.size(); ++k) {
      rest.push_back(y[k] - step[k]);
      inside = inside && rest.back().inside(p.sheet[k]);
    }
    if (!inside) continue;
    p.at = joined(chart, box, rest);
    const Local tight = local(point_, chart, p.at);
    for (std::size_t d = 0; d < 2; ++d) { // implicit differentiation
      std::vector<Ball> right;
      for (const auto& row : tight.by_free)
        right.push_back(-row[d]);
      const std::vector<Ball> slope = solved(tight.by_rest, right);
      for (std::size_t k = 0; k < y.size(); ++k)
        p.at[chart.rest[k]].d[d] = slope[k];
      p.at[chart.free[d]].d[d] = Ball(1);
    }
    return p;
  }
  throw NotProved::section_piece;
}

bool EnclosedMap::same_sheet(const PhasePoint<Enclosure>& x, const Patch& to) {
  for (std::size_t k = 0; k < to.sheet.size(); ++k)
    if (!x[to.chart.rest[k]].v.inside(to.sheet[k])) return false;
  return true;
}

bool EnclosedMap::same_sheet(const Landing& l, const Patch& to) { return same_sheet(l.at, to); }

// ---- integration ----

Enclosure EnclosedMap::onward(double h) const {
  return way_ > 0 ? Ball::between(0, h) : Ball::between(-h, 0);
}

// Of the section's function along the orbits, forward in time, positive where it is crossed as wanted.
Enclosure EnclosedMap::rate(const SurfaceValues<Ball>& v) const {
  Ball sum(0);
  for (std::size_t j = 0; j < v.field.size(); ++j)
    add_product(sum, v.slope[0][j].v, v.field[j].v);
  return s_.rising() ? sum : -sum;
}

// (a - middle of the box) goes to the derivatives that the chart gives; the axes are those of phase space.
EnclosedMap::Front EnclosedMap::start(const Patch& from) {
  std::array<Ball, 2> middle;
  for (std::size_t d = 0; d < 2; ++d) {
    middle[d] = from.box[d].middle();
    off_[d] = from.box[d] - middle[d];
  }
  const Patch thin = patch(from.chart, middle, doubles(from.at));
  if (!same_sheet(thin.at, from)) throw NotProved::section_piece;
  const std::size_t n = from.at.size();
  Front f{{}, {}, unit_matrix(n), {}, from.at};
  for (std::size_t j = 0; j < n; ++j) {
    f.middle.push_back(thin.at[j].v.middle());
    f.hull[j].v = Ball::hull(f.hull[j].v, f.middle[j]);
    f.error.push_back(thin.at[j].v - f.middle[j]);
    f.slope.push_back({from.at[j].d[0], from.at[j].d[1]});
  }
  return f;
}

// (chaos.md 1.3)
void EnclosedMap::transport(Front& f, const Move& m) const {
  const std::size_t n = f.middle.size();
  const BallMatrix moved = product(m.slope, f.axes);
  BallVector size(n), rest(n);
  for (std::size_t j = 0; j < n; ++j)
    size[j] = f.error[j] + f.slope[j][0] * off_[0] + f.slope[j][1] * off_[1];
  f.axes = axes_along(moved, size);
  const BallMatrix back = inverse(f.axes), turned = product(back, moved);
  for (std::size_t j = 0; j < n; ++j) {
    f.middle[j] = m.middle[j].middle();
    rest[j] = m.middle[j] - f.middle[j];
  }
  f.error = sum(applied(back, rest), applied(turned, f.error));
  f.slope = product(turned, f.slope);
  f.hull = m.hull;
  for (std::size_t j = 0; j < n; ++j)
    size[j] = f.error[j] + f.slope[j][0] * off_[0] + f.slope[j][1] * off_[1];
  const BallVector away = applied(f.axes, size);
  for (std::size_t j = 0; j < n; ++j)
    f.hull[j] = // with the middle, for the mean value theorem
        DualBall(Ball::hull(common(f.middle[j] + away[j], m.hull[j].v), f.middle[j]));
}

Landing EnclosedMap::operator()(const Patch& from, bool backward, int turns) {
  way_ = backward ? -1 : 1;
  Front front = start(from);
  Landing all{{}, Ball(0)};
  for (int i = 0; i < turns; ++i) {
    Landing one = returned(front);
    all = {std::move(one.at), all.time + one.time, std::move(one.middle)};
  }
  return all;
}

// Leaves the front on the section.
Landing EnclosedMap::returned(Front& f) {
  room_ = 1;
  Ball time(0);
  bool leaving = true; // the section, on which the orbit starts
  double h = 0.1;
  for (int step = 0; step < max_steps_of_a_return; ++step) {
    if (stop_ != nullptr && stop_->load()) throw NotProved::no_time;
    expand(f);
    Front next;
    Verdict v = Verdict::retry;
    for (;; h *= 0.61803) {
      advance(h);
      next = f;
      transport(next, moved(Ball(way_ * h)));
      v = look(f.hull, next.hull, leaving);
      if (v != Verdict::retry) break;
      if (h < 1e-6) throw NotProved::end_of_step;
    }
    if (v == Verdict::lands) {
      const Ball t = crossing_time(wide_, h);
      transport(f, landed(t, crossing_time(thin_, h)));
      Landing landing{f.hull, time + t, sum(f.middle, applied(f.axes, f.error))};
      const BallMatrix slope = product(f.axes, f.slope);
      for (std::size_t j = 0; j < slope.size(); ++j)
        for (std::size_t d = 0; d < 2; ++d)
          landing.at[j].d[d] = slope[j][d];
      return landing;
    }
    f = std::move(next);
    time += Ball(way_ * h);
    h *= room_;
  }
  throw NotProved::no_return;
}

// The orbits of the hull with their derivatives by all coordinates, and that of the middle.
void EnclosedMap::expand(const Front& f) {
  PhasePoint<Ball> x = f.hull;
  for (std::size_t part = 0; part < wide_.code.size(); ++part) {
    for (std::size_t j = 0; j < x.size(); ++j)
      for (std::size_t d = 0; d < 2; ++d)
        x[j].d[d] = Ball(j == 2 * part + d ? 1 : 0);
    wide_.code[part].expand(x, order_ + 1);
  }
  thin_.code[0].expand(PhasePoint<Ball>(f.middle.begin(), f.middle.end()), order_ + 1);
}

// One step; may shorten h.  The orbit of the middle is one of those of the hull: what is shown of them, holds of it.
void EnclosedMap::advance(double& h) {
  for (int attempt = 0; attempt < 60; ++attempt)
    if (contained(wide_, h)) {
      thin_.box.assign(1, wide_.box[0]);
      thin_.last.assign(1, wide_.last[0]);
      return;
    }
  throw NotProved::no_box;
}

// Let B be the Taylor polynomial over [0, h], widened by epsilon, and R an enclosure of the coefficient order + 1 over
// B.  If h^(order + 1) |R| < epsilon then the orbit stays in B during the step: as long as it does, it differs from the
// polynomial by at most h^(order + 1) |R|, so that it cannot reach the border of B [CorlissRihm1996].  The same for its
// derivatives, which solve an equation too.  Otherwise h becomes shorter.
bool EnclosedMap::contained(Step& s, double& h) {
  const Ball epsilon(tolerance_);
  const double reach = magnitude(power(Ball(h), order_ + 1)) * (1 + 1e-15);
  double rest = 0;
  s.box.clear();
  s.last.clear();
  for (const auto& code : s.code) {
    if (!(rest < tolerance_)) break;
    s.box.push_back(code.polynomial(onward(h), order_));
    for (DualBall& c : s.box.back())
      c = DualBall(c.v.widened(epsilon), c.d[0].widened(epsilon), c.d[1].widened(epsilon));
    over_box_.expand(s.box.back(), order_ + 1);
    s.last.emplace_back();
    for (std::size_t j = 0; j < s.box.back().size(); ++j)
      s.last.back().push_back(over_box_.coefficient(j, order_ + 1));
    rest = std::max(rest, magnitude(s.last.back()) * reach);
  }
  const double scale =
      std::isfinite(rest) ? std::pow(tolerance_ / (rest + 1e-290), 1.0 / (order_ + 1)) : 0.5;
  room_ = std::clamp(0.88 * scale, 0.5, 1.2);
  if (rest < tolerance_) return true;
  h *= std::clamp(0.9 * scale, 0.3, 0.9);
  return false;
}

// The orbits at t within the current step.
PhasePoint<Ball> EnclosedMap::reached(const Step& s, std::size_t part, const Ball& t) const {
  PhasePoint<Ball> x = s.code[part].polynomial(t, order_);
  const Ball reach = power(t, order_ + 1);
  for (std::size_t j = 0; j < x.size(); ++j) {
    x[j].v += reach * s.last[part][j].v;
    for (std::size_t d = 0; d < 2; ++d)
      x[j].d[d] += reach * s.last[part][j].d[d];
  }
  return x;
}

EnclosedMap::Move EnclosedMap::moved(const Ball& t) const {
  const std::size_t n = s_.dimension();
  Move m{{}, BallMatrix(n, BallVector(n)), {}};
  for (const DualBall& c : reached(thin_, 0, t))
    m.middle.push_back(c.v);
  for (std::size_t part = 0; part < wide_.code.size(); ++part) {
    const PhasePoint<Ball> x = reached(wide_, part, t);
    if (part == 0) m.hull = x;
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t d = 0; d < 2 && 2 * part + d < n; ++d)
        m.slope[j][2 * part + d] = x[j].d[d];
  }
  return m;
}

// No wanted crossing in this step, or exactly one, or not decided.
EnclosedMap::Verdict EnclosedMap::look(const PhasePoint<Ball>& from, const PhasePoint<Ball>& to,
                                       bool& leaving) {
  const SurfaceValues<Ball> over = point_.at(wide_.box[0]);
  const Ball speed = rate(over);
  if (!over.equations[0].v.contains_zero() || over.side.v.is_negative() || speed.is_negative()) {
    leaving = false;
    return Verdict::goes_on;
  }
  if (!speed.is_positive()) return Verdict::retry;
  if (leaving) return Verdict::goes_on;                // 0 at the start and monotone since
  const auto height = [&](const PhasePoint<Ball>& x) { // grows while time runs
    const Ball s = point_.at(x).equations[0].v;
    return s_.rising() == (way_ > 0) ? s : -s;
  };
  const Ball s0 = height(from), s1 = height(to);
  if (s0.is_negative() && s1.is_positive())
    return over.side.v.is_positive() ? Verdict::lands : Verdict::retry;
  if ((s0.is_negative() && s1.is_negative()) || (s0.is_positive() && s1.is_positive()))
    return Verdict::goes_on;
  return Verdict::retry;
}

// The only zero of the section's function in the step, by interval Newton on the time.
Enclosure EnclosedMap::crossing_time(const Step& s, double h) {
  Ball t = onward(h);
  PhasePoint<Ball> x = s.box[0];
  for (int i = 0; i < 60; ++i) {
    const SurfaceValues<Ball> v = point_.at(x);
    const Ball m = t.middle(), speed = rate(v), height = point_.at(reached(s, 0, m)).equations[0].v;
    const double old = t.radius();
    t = common(m - (s_.rising() ? height : -height) / speed, t);
    x = reached(s, 0, t);
    if (t.radius() > 0.7 * old && i > 4) break;
  }
  return t;
}

// At the crossing: the derivatives are projected along the field into the section.
EnclosedMap::Move EnclosedMap::landed(const Ball& t, const Ball& of_middle) {
  Move m = moved(t);
  const PhasePoint<Ball> middle = reached(thin_, 0, of_middle);
  const SurfaceValues<Ball> v = point_.at(m.hull);
  const Ball speed = s_.rising() ? rate(v) : -rate(v);
  const std::size_t n = middle.size();
  for (std::size_t k = 0; k < n; ++k) {
    Ball later(0);
    for (std::size_t j = 0; j < n; ++j)
      add_product(later, v.slope[0][j].v, m.slope[j][k]);
    later /= speed;
    for (std::size_t j = 0; j < n; ++j)
      sub_product(m.slope[j][k], v.field[j].v, later);
    m.middle[k] = middle[k].v;
  }
  return m;
}

// ---- in double ----

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
