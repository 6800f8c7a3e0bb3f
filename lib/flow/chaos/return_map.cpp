#include "flow/chaos/return_map.hpp"

#include <algorithm>
#include <cmath>

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
      order_(static_cast<int>(Ball::bits()) / 5 + 4), wide_{{s, order_ + 1}}, thin_{{s,
                                                                                     order_ + 1}},
      over_box_(s, order_ + 1), point_(s, 0) {}

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
  throw NotProved{"a piece of the section surface could not be enclosed"};
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

// The box of the start with the derivatives that the chart gives, and its middle on the same sheet.
EnclosedMap::Front EnclosedMap::start(const Patch& from) {
  std::array<Ball, 2> middle;
  for (std::size_t d = 0; d < 2; ++d) {
    middle[d] = from.box[d].middle();
    off_[d] = from.box[d] - middle[d];
  }
  Front f{from.at, {}};
  const Patch thin = patch(from.chart, middle, doubles(from.at));
  for (std::size_t k = 0; k < from.sheet.size(); ++k)
    if (!thin.at[from.chart.rest[k]].v.inside(from.sheet[k]))
      throw NotProved{"a piece of the section surface could not be enclosed"};
  for (const DualBall& c : thin.at)
    f.thin.push_back(DualBall(c.v)); // its derivatives are not needed
  tighten(f.x, f.thin);
  return f;
}

void EnclosedMap::tighten(PhasePoint<Ball>& x, const PhasePoint<Ball>& thin) const {
  for (std::size_t j = 0; j < x.size(); ++j) {
    const Ball mean = thin[j].v + x[j].d[0] * off_[0] + x[j].d[1] * off_[1];
    if (!(mean.radius() < x[j].v.radius())) continue;
    Ball both;
    if (arb_intersection(both.raw(), mean.raw(), x[j].v.raw(), Ball::bits()) == 0)
      throw NotProved{"two enclosures of one orbit are apart"}; // cannot be
    x[j].v = both;
  }
}

Landing EnclosedMap::operator()(const Patch& from, bool backward, int turns) {
  way_ = backward ? -1 : 1;
  Front front = start(from);
  Landing all{{}, Ball(0)};
  for (int i = 0; i < turns; ++i) {
    Landing one = returned(front);
    all = {std::move(one.at), all.time + one.time};
  }
  return all;
}

// Leaves the front on the section.
Landing EnclosedMap::returned(Front& f) {
  constexpr int most_steps = 3000;
  room_ = 1;
  Ball time(0);
  bool leaving = true; // the section, on which the orbit starts
  double h = 0.1;
  for (int step = 0; step < most_steps; ++step) {
    if (stop_ != nullptr && stop_->load()) throw NotProved{"there was no time left"};
    wide_.code.expand(f.x, order_ + 1);
    Verdict v = Verdict::retry;
    PhasePoint<Ball> end;
    while (v == Verdict::retry) {
      end = advance(wide_, h);
      v = look(f.x, end, leaving);
      if (v != Verdict::retry) break;
      if (h < 1e-6) throw NotProved{"a crossing could not be separated from the end of a step"};
      h *= 0.61803;
    }
    thin_.code.expand(f.thin, order_ + 1);
    double same = h;
    PhasePoint<Ball> thin_end = advance(thin_, same);
    if (same != h) throw NotProved{"the orbit could not be contained in a box"};
    if (v == Verdict::lands) {
      Landing landing = land(wide_, h, time);
      f.thin = land(thin_, h, time).at;
      tighten(landing.at, f.thin);
      f.x = landing.at;
      return landing;
    }
    tighten(end, thin_end);
    f = {std::move(end), std::move(thin_end)};
    time += Ball(way_ * h);
    h *= room_;
  }
  throw NotProved{"the orbit did not return within " + std::to_string(most_steps) + " steps"};
}

// One step; may shorten h.  Let B be the Taylor polynomial over [0, h], widened by epsilon, and R an enclosure of the
// coefficient order + 1 over B.  If h^(order + 1) |R| < epsilon then the orbit stays in B during the step: as long as
// it does, it differs from the polynomial by at most h^(order + 1) |R|, so that it cannot reach the border of B
// [CorlissRihm1996].  The same for its derivatives, which solve an equation too.
PhasePoint<Ball> EnclosedMap::advance(Step& s, double& h) {
  const Ball epsilon(tolerance_);
  for (int attempt = 0; attempt < 60; ++attempt) {
    s.box = s.code.polynomial(onward(h), order_);
    for (DualBall& c : s.box)
      c = DualBall(c.v.widened(epsilon), c.d[0].widened(epsilon), c.d[1].widened(epsilon));
    over_box_.expand(s.box, order_ + 1);
    s.last.clear();
    for (std::size_t j = 0; j < s.box.size(); ++j)
      s.last.push_back(over_box_.coefficient(j, order_ + 1));
    const double rest = magnitude(s.last) * magnitude(power(Ball(h), order_ + 1)) * (1 + 1e-15);
    const double scale =
        std::isfinite(rest) ? std::pow(tolerance_ / (rest + 1e-290), 1.0 / (order_ + 1)) : 0.5;
    if (rest < tolerance_) {
      if (&s == &wide_) room_ = std::clamp(0.95 * scale, 0.5, 1.5);
      return reached(s, Ball(way_ * h));
    }
    h *= std::clamp(0.9 * scale, 0.3, 0.9);
  }
  throw NotProved{"the orbit could not be contained in a box"};
}

// The orbit at t within the current step.
PhasePoint<Ball> EnclosedMap::reached(const Step& s, const Ball& t) const {
  PhasePoint<Ball> x = s.code.polynomial(t, order_);
  const Ball reach = power(t, order_ + 1);
  for (std::size_t j = 0; j < x.size(); ++j) {
    x[j].v += reach * s.last[j].v;
    for (std::size_t d = 0; d < 2; ++d)
      x[j].d[d] += reach * s.last[j].d[d];
  }
  return x;
}

// No wanted crossing in this step, or exactly one, or not decided.
EnclosedMap::Verdict EnclosedMap::look(const PhasePoint<Ball>& from, const PhasePoint<Ball>& to,
                                       bool& leaving) {
  const SurfaceValues<Ball> over = point_.at(wide_.box);
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
Landing EnclosedMap::land(const Step& s, double h, const Ball& before) {
  Ball t = onward(h);
  PhasePoint<Ball> x = s.box;
  for (int i = 0; i < 60; ++i) {
    const SurfaceValues<Ball> v = point_.at(x);
    const Ball m = t.middle(), speed = rate(v), height = point_.at(reached(s, m)).equations[0].v;
    const Ball next = m - (s_.rising() ? height : -height) / speed;
    Ball both;
    if (arb_intersection(both.raw(), next.raw(), t.raw(), Ball::bits()) == 0)
      throw NotProved{"the crossing was lost"};
    const double old = t.radius();
    t = both;
    x = reached(s, t);
    if (t.radius() > 0.7 * old && i > 4) break;
  }
  const SurfaceValues<Ball> v = point_.at(x);
  const Ball speed = s_.rising() ? rate(v) : -rate(v);
  std::array<Ball, 2> slope{Ball(0),
                            Ball(0)}; // of the section's function, by the start's coordinates
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t j = 0; j < x.size(); ++j)
      add_product(slope[d], v.slope[0][j].v, x[j].d[d]);
  for (std::size_t j = 0; j < x.size(); ++j)
    for (std::size_t d = 0; d < 2; ++d)
      x[j].d[d] -= v.field[j].v * slope[d] / speed;
  return {x, before + t};
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
