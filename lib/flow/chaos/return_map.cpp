#include "flow/chaos/return_map.hpp"

#include "exact/lists.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kov::flow {
namespace {

template <class R> using VectorOf = std::vector<R>;
template <class R> using MatrixOf = std::vector<std::vector<R>>;

template <class R> double magnitude(const PhasePoint<R>& x) {
  double most = 0;
  for (const Dual<R>& c : x)
    most = std::max({most, bound_of(c.v), bound_of(c.d[0]), bound_of(c.d[1])});
  return most;
}

// The intersection of two enclosures of one number.
template <class R> R common(const R& a, const R& b) {
  const auto both = intersection(a, b);
  if (!both) throw NotProved::enclosure_lost;
  return *both;
}

// The same set, or a larger one.
template <class To, class R> To ball(const R& x) {
  if constexpr (std::is_same_v<To, R>)
    return x;
  else if constexpr (std::is_same_v<To, DoubleBall>)
    return double_ball(x);
  else
    return around(x);
}
template <class To, class R> PhasePoint<To> each(const PhasePoint<R>& x) {
  PhasePoint<To> all;
  for (const Dual<R>& c : x)
    all.push_back({ball<To>(c.v), ball<To>(c.d[0]), ball<To>(c.d[1])});
  return all;
}

template <class R> std::vector<double> middles(const PhasePoint<R>& x) {
  return mapped<double>(x, [&](const auto& c) { return static_cast<double>(c.v); });
}

// ---- matrices ----

template <class R> MatrixOf<R> unit_matrix(std::size_t n) {
  MatrixOf<R> a(n, VectorOf<R>(n));
  for (std::size_t j = 0; j < n; ++j)
    a[j][j] = R(1);
  return a;
}

template <class R> MatrixOf<R> product(const MatrixOf<R>& a, const MatrixOf<R>& b) {
  MatrixOf<R> c(a.size(), VectorOf<R>(b[0].size()));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b[0].size(); ++j)
      for (std::size_t k = 0; k < b.size(); ++k)
        add_product(c[i][j], a[i][k], b[k][j]);
  return c;
}

template <class R> VectorOf<R> sum(VectorOf<R> a, const VectorOf<R>& b) {
  for (std::size_t j = 0; j < a.size(); ++j)
    a[j] += b[j];
  return a;
}

template <class R> MatrixOf<R> inverse(const MatrixOf<R>& a) {
  const std::size_t n = a.size();
  MatrixOf<R> b(n, VectorOf<R>(n));
  for (std::size_t k = 0; k < n; ++k) {
    VectorOf<R> e(n);
    e[k] = R(1);
    const VectorOf<R> column = solved(a, e);
    for (std::size_t j = 0; j < n; ++j)
      b[j][k] = column[j];
  }
  return b;
}

// Nearly orthonormal columns, exact, along the images of the axes, the largest uncertainty first: Gram and Schmidt in
// double.  Any regular matrix is correct.
template <class R> MatrixOf<R> axes_along(const MatrixOf<R>& moved, const VectorOf<R>& size) {
  const std::size_t n = size.size();
  std::vector<std::pair<double, std::vector<double>>> columns;
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> c(n);
    double length = 0;
    for (std::size_t j = 0; j < n; ++j)
      length = std::max(length, std::abs(c[j] = static_cast<double>(moved[j][k])));
    columns.emplace_back(length * bound_of(size[k]), c);
  }
  std::ranges::stable_sort(columns, [](const auto& a, const auto& b) { return a.first > b.first; });
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
  MatrixOf<R> axes(n, VectorOf<R>(n));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = 0; k < n; ++k)
      axes[j][k] = R(kept[k][j]);
  return axes;
}

} // namespace

std::vector<double> doubles(const PhasePoint<Enclosure>& x) { return middles(x); }
std::vector<double> doubles(const PhasePoint<DoubleBall>& x) { return middles(x); }

template <class R>
EnclosedMapOf<R>::EnclosedMapOf(const SectionSurface& s, const std::atomic<bool>* stop)
    : s_(s), stop_(stop), bits_(R::bits()), order_(static_cast<int>(R::bits()) / 5 + 4),
      over_box_(s, order_ + 1), point_(s, 0) {
  for (std::size_t j = 0; j < s.dimension(); j += 2)
    wide_.code.emplace_back(s, order_);
  thin_.code.emplace_back(s, order_);
}

// ---- charts ----

namespace {

// The equations and their derivatives by chart.rest at x.
template <class R> struct Local {
  std::vector<R> value;
  std::vector<std::vector<R>> by_rest, by_free;
};
template <class R>
Local<R> local(SurfaceCode<R>& code, const Chart& chart, const PhasePoint<R>& x) {
  const SurfaceValues<R> v = code.at(x);
  Local<R> l;
  for (std::size_t i = 0; i < v.equations.size(); ++i) {
    l.value.push_back(v.equations[i].v);
    l.by_rest.emplace_back();
    for (const std::size_t j : chart.rest)
      l.by_rest.back().push_back(v.slope[i][j].v);
    l.by_free.push_back({v.slope[i][chart.free[0]].v, v.slope[i][chart.free[1]].v});
  }
  return l;
}

template <class R>
PhasePoint<R> joined(const Chart& chart, const std::array<R, 2>& free, const std::vector<R>& rest) {
  PhasePoint<R> x(rest.size() + 2);
  for (std::size_t k = 0; k < 2; ++k)
    x[chart.free[k]] = Dual<R>(free[k]);
  for (std::size_t k = 0; k < rest.size(); ++k)
    x[chart.rest[k]] = Dual<R>(rest[k]);
  return x;
}

} // namespace

// Interval Newton for the rest: N = y - G_y(box, Y)^-1 G(box, y) inside Y proves that each point of the box has
// exactly one solution in Y, and that it lies in N.
template <class R>
PatchOf<R> EnclosedMapOf<R>::patch(const Chart& chart, const std::array<R, 2>& box,
                                   const std::vector<double>& near) {
  const std::array<R, 2> middle{box[0].middle(), box[1].middle()};
  std::vector<R> y;
  double scale = 0;
  for (const double c : near)
    scale = std::max(scale, std::abs(c));
  for (const std::size_t j : chart.rest)
    y.emplace_back(near[j]);
  for (int i = 0; i < 10; ++i) { // to full precision, in the middle
    const Local<R> l = local(point_, chart, joined(chart, middle, y));
    const std::vector<R> step = solved(l.by_rest, l.value);
    bool there = true;
    for (std::size_t k = 0; k < y.size(); ++k) {
      y[k] = (y[k] - step[k]).middle();
      there = there && step[k].contains_zero();
    }
    if (there) break;
  }
  const Local<R> here = local(point_, chart, joined(chart, box, y));
  for (double room = 1; room > 1e-20; room /= room > 0.1 ? 2 : 16) {
    Patch p{chart, box, {}, {}};
    for (const R& c : y)
      p.sheet.push_back(c.widened(R(room * scale)));
    const Local<R> over = local(point_, chart, joined(chart, box, p.sheet));
    const std::vector<R> step = solved(over.by_rest, here.value);
    std::vector<R> rest;
    bool inside = true;
    for (std::size_t k = 0; k < y.size(); ++k) {
      rest.push_back(y[k] - step[k]);
      inside = inside && rest.back().inside(p.sheet[k]);
    }
    if (!inside) continue;
    p.at = joined(chart, box, rest);
    const Local<R> tight = local(point_, chart, p.at);
    for (std::size_t d = 0; d < 2; ++d) { // implicit differentiation
      auto right = mapped<R>(tight.by_free, [&](const auto& row) { return -row[d]; });
      const std::vector<R> slope = solved(tight.by_rest, right);
      for (std::size_t k = 0; k < y.size(); ++k)
        p.at[chart.rest[k]].d[d] = slope[k];
      p.at[chart.free[d]].d[d] = R(1);
    }
    return p;
  }
  throw NotProved::section_piece;
}

template <class R> bool EnclosedMapOf<R>::same_sheet(const PhasePoint<R>& x, const Patch& to) {
  for (std::size_t k = 0; k < to.sheet.size(); ++k)
    if (!x[to.chart.rest[k]].v.inside(to.sheet[k])) return false;
  return true;
}

template <class R> bool EnclosedMapOf<R>::same_sheet(const Landing& l, const Patch& to) {
  return same_sheet(l.at, to);
}

// ---- integration ----

template <class R> R EnclosedMapOf<R>::rate(const SurfaceValues<R>& v) const {
  R sum(0);
  for (std::size_t j = 0; j < v.field.size(); ++j)
    add_product(sum, v.slope[0][j].v, v.field[j].v);
  return s_.rising() ? sum : -sum;
}

// (a - middle of the box) goes to the derivatives that the chart gives; the axes are those of phase space.
template <class R> typename EnclosedMapOf<R>::Front EnclosedMapOf<R>::start(const Patch& from) {
  std::array<R, 2> middle;
  tolerance_ = tolerance();
  for (std::size_t d = 0; d < 2; ++d) {
    middle[d] = from.box[d].middle();
    off_[d] = from.box[d] - middle[d];
    tolerance_ = std::fmax(tolerance_, std::ldexp(from.box[d].radius(), -20));
  }
  const Patch thin = patch(from.chart, middle, doubles(from.at));
  if (!same_sheet(thin.at, from)) throw NotProved::section_piece;
  const std::size_t n = from.at.size();
  Front f{{}, {}, unit_matrix<R>(n), {}, from.at};
  for (std::size_t j = 0; j < n; ++j) {
    f.middle.push_back(thin.at[j].v.middle());
    f.hull[j].v = R::hull(f.hull[j].v, f.middle[j]);
    f.error.push_back(thin.at[j].v - f.middle[j]);
    f.slope.push_back({from.at[j].d[0], from.at[j].d[1]});
  }
  return f;
}

// (chaos.md 1.3)
template <class R> void EnclosedMapOf<R>::transport(Front& f, const Move& m) const {
  const std::size_t n = f.middle.size();
  const MatrixOf<R> moved = product(m.slope, f.axes);
  VectorOf<R> size(n), rest(n);
  for (std::size_t j = 0; j < n; ++j)
    size[j] = f.error[j] + f.slope[j][0] * off_[0] + f.slope[j][1] * off_[1];
  f.axes = axes_along(moved, size);
  const MatrixOf<R> back = inverse(f.axes), turned = product(back, moved);
  for (std::size_t j = 0; j < n; ++j) {
    f.middle[j] = m.middle[j].middle();
    rest[j] = m.middle[j] - f.middle[j];
  }
  f.error = sum(applied(back, rest), applied(turned, f.error));
  f.slope = product(turned, f.slope);
  f.hull = m.hull;
  for (std::size_t j = 0; j < n; ++j)
    size[j] = f.error[j] + f.slope[j][0] * off_[0] + f.slope[j][1] * off_[1];
  const VectorOf<R> away = applied(f.axes, size);
  for (std::size_t j = 0; j < n; ++j)
    f.hull[j] = // with the middle, for the mean value theorem
        Dual<R>(R::hull(common(f.middle[j] + away[j], m.hull[j].v), f.middle[j]));
}

template <class R>
LandingOf<R> EnclosedMapOf<R>::operator()(const Patch& from, bool backward, int turns) {
  way_ = backward ? -1 : 1;
  closed_in_.clear();
  Front front = start(from);
  Landing all{{}, R(0)};
  for (int i = 0; i < turns; ++i) {
    Landing one = returned(front);
    all = {std::move(one.at), all.time + one.time, std::move(one.middle)};
  }
  return all;
}

template <class R>
LandingOf<R> EnclosedMapOf<R>::landing_from(const std::vector<R>& box, int turns) {
  way_ = 1;
  closed_in_ = turns == 1 ? box : std::vector<R>{};
  tolerance_ = tolerance();
  off_ = {};
  const std::size_t n = box.size();
  Front f{{}, {}, unit_matrix<R>(n), {}, PhasePoint<R>(box.begin(), box.end())};
  for (const R& x : box) {
    tolerance_ = std::fmax(tolerance_, std::ldexp(x.radius(), -20));
    f.middle.push_back(x.middle());
    f.error.push_back(x - f.middle.back());
    f.slope.emplace_back(2);
  }
  Landing all{{}, R(0)};
  for (int i = 0; i < turns; ++i) {
    Landing one = returned(f);
    all = {std::move(one.at), all.time + one.time};
  }
  return all;
}

// Leaves the front on the section.
template <class R> LandingOf<R> EnclosedMapOf<R>::returned(Front& f) {
  room_ = 1;
  R time(0);
  Crossing c;
  double h = 0.1, longest = 0;
  for (int step = 0; step < max_steps_of_a_return; ++step) {
    if (stop_ != nullptr && stop_->load()) throw NotProved::no_time;
    expand(f);
    Front next;
    Verdict v = Verdict::retry;
    for (;; h *= 0.61803) {
      advance(h);
      next = f;
      transport(next, moved(R(way_ * h)));
      v = look(f.hull, next, c);
      if (v != Verdict::retry) break;
      if (h < 1e-6) throw NotProved::end_of_step;
    }
    longest = std::fmax(longest, h);
    if (tolerance_ > tolerance() && h < longest / 32)
      throw NotProved::no_box; // two halves do better
    c.since = c.begun || v == Verdict::lands ? c.since + h : 0;
    if (v == Verdict::lands) {
      const double whole = h;
      h = middle_crosses(h);
      next = f;
      transport(next, moved(R(way_ * h)));
      f = std::move(next);
      return landing(f, time + R(way_ * h), c.since * (1 + 1e-12) - (whole - h) * (1 - 1e-12));
    }
    f = std::move(next);
    time += R(way_ * h);
    h *= room_;
  }
  throw NotProved::no_return;
}

// When, within the step; approximately.
template <class R> double EnclosedMapOf<R>::middle_crosses(double h) {
  const auto at = [&](double t) { return reached(thin_, 0, R(way_ * t)); };
  const auto middle_height = [&](double t) { return static_cast<double>(height(at(t))); };
  const double from = middle_height(0), to = middle_height(h);
  double low = 0, high = h, t = from < 0 && to > 0 ? h * from / (from - to) : h;
  for (int i = 0; i < 3 && t < h; ++i) {
    const double s = middle_height(t);
    (s < 0 ? low : high) = t;
    const double next = t - s / static_cast<double>(rate(point_.at(at(t))));
    t = next > low && next < high ? next : (low + high) / 2;
  }
  return t;
}

// All of the front crosses while the section's function grows, and none had crossed `since` before now, a bound
// from above (chaos.md 1.2).
template <class R> LandingOf<R> EnclosedMapOf<R>::landing(Front& f, const R& now, double since) {
  expand(f);
  const R at = height(f.hull);
  R speed = rate(point_.at(f.hull)).middle();
  double before = 0, after = 0;
  for (int attempt = 0;; ++attempt) {
    if (!speed.is_positive() || attempt > 6) throw NotProved::end_of_step;
    const double needed = 1.01 * bound_of(at / speed) + 1e-300;
    before = std::fmax(before, std::fmin(needed, since));
    after = std::fmax(after, needed);
    during_ = way_ > 0 ? R::between(-before, after) : R::between(-after, before);
    if (!contained(wide_, std::fmax(before, after))) throw NotProved::end_of_step;
    const SurfaceValues<R> over = point_.at(wide_.box[0]);
    speed = rate(over);
    if (speed.is_positive() && over.side.v.is_positive() &&
        (before >= since || (at - R(before) * speed).is_negative()) &&
        (at + R(after) * speed).is_positive())
      break;
  }
  of_middle_too();
  const R t = crossing_time(wide_);
  transport(f, landed(t, crossing_time(thin_)));
  Landing l{f.hull, now + t, sum(f.middle, applied(f.axes, f.error))};
  const MatrixOf<R> slope = product(f.axes, f.slope);
  for (std::size_t j = 0; j < slope.size(); ++j)
    for (std::size_t d = 0; d < 2; ++d)
      l.at[j].d[d] = slope[j][d];
  return l;
}

// The orbits of the hull with their derivatives by all coordinates, and that of the middle.
template <class R> void EnclosedMapOf<R>::expand(const Front& f) {
  PhasePoint<R> x = f.hull;
  for (std::size_t part = 0; part < wide_.code.size(); ++part) {
    for (std::size_t j = 0; j < x.size(); ++j)
      for (std::size_t d = 0; d < 2; ++d)
        x[j].d[d] = R(j == 2 * part + d ? 1 : 0);
    wide_.code[part].expand(x, order_);
  }
  thin_.code[0].expand(PhasePoint<R>(f.middle.begin(), f.middle.end()), order_);
}

// One step; may shorten h.
template <class R> void EnclosedMapOf<R>::advance(double& h) {
  for (int attempt = 0; attempt < 60; ++attempt) {
    during_ = way_ > 0 ? R::between(0, h) : R::between(-h, 0);
    if (contained(wide_, h)) return of_middle_too();
    h *= std::clamp(0.9 * scale_, 0.3, 0.9);
  }
  throw NotProved::no_box;
}

// The orbit of the middle is one of those of the hull: what is shown of them, holds of it.
template <class R> void EnclosedMapOf<R>::of_middle_too() {
  thin_.box.assign(1, wide_.box[0]);
  thin_.last.assign(1, wide_.last[0]);
}

// Let B be the Taylor polynomial over the times `during_`, widened by epsilon, and R an enclosure of the coefficient order + 1 over
// B.  If h^(order + 1) |R| < epsilon then the orbit stays in B during the step: as long as it does, it differs from the
// polynomial by at most h^(order + 1) |R|, so that it cannot reach the border of B [CorlissRihm1996].  The same for its
// derivatives, which solve an equation too; and backward in time, for the times of a landing.
template <class R> bool EnclosedMapOf<R>::contained(Step& s, double h) {
  const R epsilon(tolerance_);
  const double reach = bound_of(power(R(h), order_ + 1)) * (1 + 1e-15);
  double rest = 0;
  s.box.clear();
  s.last.clear();
  for (const auto& code : s.code) {
    if (!(rest < tolerance_)) break;
    s.box.push_back(code.polynomial(during_, order_));
    for (Dual<R>& c : s.box.back())
      c = Dual<R>(c.v.widened(epsilon), c.d[0].widened(epsilon), c.d[1].widened(epsilon));
    over_box_.expand(each<DoubleBall>(s.box.back()), order_ + 1);
    PhasePoint<DoubleBall> last;
    for (std::size_t j = 0; j < s.box.back().size(); ++j)
      last.push_back(over_box_.coefficient(j, order_ + 1));
    s.last.push_back(each<R>(last));
    rest = std::max(rest, magnitude(s.last.back()) * reach);
  }
  scale_ = std::isfinite(rest) ? std::pow(tolerance_ / (rest + 1e-290), 1.0 / (order_ + 1)) : 0.5;
  room_ = std::clamp(0.88 * scale_, 0.5, 1.2);
  return rest < tolerance_;
}

// The orbits at t within the current step.
template <class R>
PhasePoint<R> EnclosedMapOf<R>::reached(const Step& s, std::size_t part, const R& t) const {
  PhasePoint<R> x = s.code[part].polynomial(t, order_);
  const R reach = power(t, order_ + 1);
  for (std::size_t j = 0; j < x.size(); ++j) {
    x[j].v += reach * s.last[part][j].v;
    for (std::size_t d = 0; d < 2; ++d)
      x[j].d[d] += reach * s.last[part][j].d[d];
  }
  return x;
}

template <class R> typename EnclosedMapOf<R>::Move EnclosedMapOf<R>::moved(const R& t) const {
  const std::size_t n = s_.dimension();
  Move m{{}, MatrixOf<R>(n, VectorOf<R>(n)), {}};
  for (const Dual<R>& c : reached(thin_, 0, t))
    m.middle.push_back(c.v);
  for (std::size_t part = 0; part < wide_.code.size(); ++part) {
    const PhasePoint<R> x = reached(wide_, part, t);
    if (part == 0) m.hull = x;
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t d = 0; d < 2 && 2 * part + d < n; ++d)
        m.slope[j][2 * part + d] = x[j].d[d];
  }
  return m;
}

// The section's function, with the sign with which it grows where it is crossed as wanted, while time runs.
template <class R> R EnclosedMapOf<R>::height(const PhasePoint<R>& x) {
  const R s = point_.at(x).equations[0].v;
  return s_.rising() == (way_ > 0) ? s : -s;
}

// No wanted crossing in this step; or it begins, or goes on, and the middle has crossed in the end; or not decided.
template <class R>
typename EnclosedMapOf<R>::Verdict EnclosedMapOf<R>::look(const PhasePoint<R>& from,
                                                          const Front& to, Crossing& c) {
  const SurfaceValues<R> over = point_.at(wide_.box[0]);
  const R speed = rate(over);
  const bool no_crossing =
      !over.equations[0].v.contains_zero() || over.side.v.is_negative() || speed.is_negative();
  if (no_crossing && !c.begun) {
    c.leaving = false;
    return Verdict::goes_on;
  }
  if (c.leaving && over.bend && still_leaving(over, speed, c)) return Verdict::goes_on;
  const R s0 = height(from), s1 = height(to.hull);
  const bool known = speed.is_positive() &&
                     (c.begun || (c.leaving && !c.loose) || s0.is_positive() || s0.is_negative());
  const bool apart = (!c.begun || c.apart) && apart_from_start();
  if (!known && apart) { // who crosses here is not closed
    c = Crossing{false};
    return Verdict::goes_on;
  }
  if (!speed.is_positive()) return Verdict::retry;
  if (c.leaving && !c.loose) return Verdict::goes_on; // 0 at the start and monotone since
  if (!c.begun && s0.is_positive()) {
    c.leaving = false;
    return Verdict::goes_on;
  }
  if (!c.begun && !s0.is_negative()) throw NotProved::end_of_step;
  c.leaving = false; // all are before the section
  if (s1.is_negative()) return Verdict::goes_on;
  c.begun = true;
  c.apart = apart;
  return static_cast<double>(s1) < 0 ? Verdict::goes_on : Verdict::lands;
}

template <class R> bool EnclosedMapOf<R>::apart_from_start() const {
  for (std::size_t j = 0; j < closed_in_.size(); ++j)
    if (!(wide_.box[0][j].v - closed_in_[j]).contains_zero()) return true;
  return false;
}

// No wanted crossing in this step after a start that may be tangent, or only of orbits that are not closed (chaos.md 2.2).
template <class R>
bool EnclosedMapOf<R>::still_leaving(const SurfaceValues<R>& over, const R& speed,
                                     Crossing& c) const {
  const R bend = s_.rising() ? over.bend->v : -over.bend->v;
  std::vector<int> moving;
  for (const Dual<R>& x : over.field)
    moving.push_back(x.v.is_positive() ? 1 : x.v.is_negative() ? -1 : 0);
  for (std::size_t j = 0; j < c.moving.size(); ++j)
    if (moving[j] != c.moving[j]) moving[j] = 0;
  const bool one_way =
      !closed_in_.empty() && std::ranges::any_of(moving, [](int sign) { return sign != 0; });
  const bool none =
      !c.loose && (speed.is_positive() || bend.is_negative() || (bend.is_positive() && !c.bent));
  if (!none && !one_way) return false;
  c.bent = c.bent || (!speed.is_positive() && bend.is_negative());
  c.loose = c.loose || !none;
  c.moving = std::move(moving);
  return true;
}

// The only zero of the section's function in the step, by interval Newton on the time.
template <class R> R EnclosedMapOf<R>::crossing_time(const Step& s) {
  R t = during_;
  PhasePoint<R> x = s.box[0];
  for (int i = 0; i < 60; ++i) {
    const SurfaceValues<R> v = point_.at(x);
    const R m = t.middle(), speed = rate(v), height = point_.at(reached(s, 0, m)).equations[0].v;
    const double old = t.radius();
    t = common(m - (s_.rising() ? height : -height) / speed, t);
    x = reached(s, 0, t);
    if (t.radius() > 0.7 * old && i > 4) break;
  }
  return t;
}

// At the crossing: the derivatives are projected along the field into the section.
template <class R>
typename EnclosedMapOf<R>::Move EnclosedMapOf<R>::landed(const R& t, const R& of_middle) {
  Move m = moved(t);
  const PhasePoint<R> middle = reached(thin_, 0, of_middle);
  const SurfaceValues<R> v = point_.at(m.hull);
  const R speed = s_.rising() ? rate(v) : -rate(v);
  const std::size_t n = middle.size();
  for (std::size_t k = 0; k < n; ++k) {
    R later(0);
    for (std::size_t j = 0; j < n; ++j)
      add_product(later, v.slope[0][j].v, m.slope[j][k]);
    later /= speed;
    for (std::size_t j = 0; j < n; ++j)
      sub_product(m.slope[j][k], v.field[j].v, later);
    m.middle[k] = middle[k].v;
  }
  return m;
}

template class EnclosedMapOf<Enclosure>;
template class EnclosedMapOf<DoubleBall>;

} // namespace kov::flow
