#include "flow/chaos/manifold_arcs.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

using Spot = std::array<double, 2>;
double apart(const Spot& a, const Spot& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

// Do the segments cross?  The parts of each before the crossing.
std::optional<Spot> crossing(const Spot& a, const Spot& b, const Spot& c, const Spot& d) {
  const double x = b[0] - a[0], y = b[1] - a[1], u = d[0] - c[0], v = d[1] - c[1];
  const double det = x * v - y * u;
  if (det == 0) return std::nullopt;
  const double s = ((c[0] - a[0]) * v - (c[1] - a[1]) * u) / det;
  const double t = ((c[0] - a[0]) * y - (c[1] - a[1]) * x) / det;
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return std::nullopt;
  return Spot{s, t};
}

} // namespace

// With derivatives by the chart's coordinates.
PhasePoint<double> ManifoldArcs::start_of(bool stable, double along) const {
  const std::size_t axis = stable ? 1 : 0;
  const auto x = map_.lifted(
      frame_.chart,
      {frame_.at[0] + frame_.axes[0][axis] * along, frame_.at[1] + frame_.axes[1][axis] * along},
      frame_.near);
  return x ? *x : PhasePoint<double>{};
}

std::optional<PhasePoint<double>> ManifoldArcs::image(bool stable, double along, int level) const {
  PhasePoint<double> x = start_of(stable, along);
  for (int k = 0; k < level && !x.empty(); ++k) {
    const auto next = map_(x, stable, frame_.turns);
    if (!next) return std::nullopt;
    x = next->at;
  }
  if (x.empty()) return std::nullopt;
  return x;
}

ManifoldArcs::Sample ManifoldArcs::sampled(bool stable, double along, int levels) {
  Sample s{along, {}, {}, false};
  PhasePoint<double> x = start_of(stable, along);
  for (int k = 0; !x.empty(); ++k) {
    const auto v = map_.code().at(x);
    s.at.push_back({v.drawn[0].v, v.drawn[1].v});
    s.end = doubles(x);
    if (k == levels) return s;
    left_ -= frame_.turns;
    const auto next = map_(x, stable, frame_.turns);
    if (!next) break;
    x = next->at;
  }
  s.lost = true;
  return s;
}

// One more image of the fundamental segment, with more samples where it is drawn out.
void ManifoldArcs::extend(Arc& arc, int level) {
  for (Sample& s : arc.samples) {
    if (s.lost || static_cast<int>(s.at.size()) > level) continue;
    PhasePoint<double> x(s.end.begin(), s.end.end());
    left_ -= frame_.turns;
    const auto next = map_(x, arc.stable, frame_.turns);
    if (!next) {
      s.lost = true;
      continue;
    }
    const auto v = map_.code().at(next->at);
    s.at.push_back({v.drawn[0].v, v.drawn[1].v});
    s.end = doubles(next->at);
  }
  for (int round = 0; round < 8; ++round) {
    std::vector<Sample> more;
    for (std::size_t i = 0; i + 1 < arc.samples.size(); ++i) {
      const Sample &a = arc.samples[i], &b = arc.samples[i + 1];
      if (a.lost || b.lost || !(apart(a.at.back(), b.at.back()) > size_ / 50)) continue;
      if (stopped()) break;
      const double middle = std::copysign(std::sqrt(a.start * b.start), a.start);
      more.push_back(sampled(arc.stable, middle, level));
    }
    if (more.empty()) return;
    arc.samples.insert(arc.samples.end(), more.begin(), more.end());
    std::ranges::sort(arc.samples, [](const auto& a, const auto& b) {
      return std::abs(a.start) < std::abs(b.start);
    });
  }
}

void ManifoldArcs::add_segments(const Arc& arc, std::size_t number, int level,
                                std::vector<Segment>& all) const {
  const auto k = static_cast<std::size_t>(level);
  for (std::size_t i = 0; i + 1 < arc.samples.size(); ++i) {
    const Sample &a = arc.samples[i], &b = arc.samples[i + 1];
    if (a.at.size() <= k || b.at.size() <= k || apart(a.at[k], b.at[k]) > size_ / 4) continue;
    all.push_back({number, i, level, a.at[k], b.at[k]});
  }
}

// Newton's method for "the image of xi is the image of eta".
std::optional<HomoclinicGuess> ManifoldArcs::refined(const Segment& u, const Segment& s) {
  const auto part = crossing(u.a, u.b, s.a, s.b);
  if (!part) return std::nullopt;
  const auto between = [&](const Segment& g, double t) {
    const double a = arcs_[g.arc].samples[g.sample].start,
                 b = arcs_[g.arc].samples[g.sample + 1].start;
    return a * std::pow(b / a, t);
  };
  double xi = between(u, (*part)[0]), eta = between(s, (*part)[1]);
  bool close = false;
  for (int i = 0; i < 12; ++i) {
    const auto x = image(false, xi, u.level), y = image(true, eta, s.level);
    if (!x || !y) return std::nullopt;
    const auto a = map_.code().at(*x).drawn, b = map_.code().at(*y).drawn;
    const auto along = [&](const Dual<double>& d, std::size_t axis) {
      return d.d[0] * frame_.axes[0][axis] + d.d[1] * frame_.axes[1][axis];
    };
    const auto step =
        solved<double>({{along(a[0], 0), -along(b[0], 1)}, {along(a[1], 0), -along(b[1], 1)}},
                       {a[0].v - b[0].v, a[1].v - b[1].v});
    if (!std::isfinite(step[0] + step[1])) return std::nullopt;
    if (std::abs(step[0]) > 0.2 * std::abs(xi) || std::abs(step[1]) > 0.2 * std::abs(eta))
      return std::nullopt;
    xi -= step[0];
    eta -= step[1];
    close = std::abs(step[0]) < 1e-9 * std::abs(xi) && std::abs(step[1]) < 1e-9 * std::abs(eta);
    if (close) break;
  }
  if (!close || std::abs(xi) > 0.99 * frame_.reach || std::abs(eta) > 0.99 * frame_.reach)
    return std::nullopt;
  HomoclinicGuess g{xi, eta, {}, static_cast<std::size_t>(u.level)};
  for (int k = 0; k < u.level; ++k)
    g.orbit.push_back(doubles(*image(false, xi, k)));
  for (int k = s.level; k >= 0; --k)
    g.orbit.push_back(doubles(*image(true, eta, k)));
  const std::vector<double> end = doubles(*image(false, xi, u.level));
  for (std::size_t j = 0; j < end.size(); ++j) // the same sheet
    if (!(std::abs(end[j] - g.orbit[g.middle][j]) < 1e-4 * size_)) return std::nullopt;
  return g;
}

std::vector<HomoclinicGuess> ManifoldArcs::guesses(std::size_t most) {
  for (const bool stable : {false, true})
    for (const double side : {1.0, -1.0}) {
      const double stretch = stable ? frame_.stretch_stable : frame_.stretch_unstable;
      Arc arc{stable, {}};
      constexpr int n = 16;
      for (int i = 0; i <= n; ++i)
        arc.samples.push_back(
            sampled(stable, side * 0.9 * frame_.reach * std::pow(stretch, double(i) / n - 1), 0));
      arcs_.push_back(std::move(arc));
    }
  size_ = 1e-300;
  for (const double c : frame_.near)
    size_ = std::max(size_, std::abs(c));
  std::vector<HomoclinicGuess> found;
  std::vector<Segment> all[2];
  for (int level = 1; level < 200 && found.empty() && !stopped(); ++level) {
    std::vector<Segment> fresh[2];
    bool lost = true;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      extend(arcs_[i], level);
      add_segments(arcs_[i], i, level, fresh[arcs_[i].stable ? 1 : 0]);
      for (const Sample& s : arcs_[i].samples)
        lost = lost && s.lost;
    }
    // new against old and new of the other kind
    const auto meet = [&](const std::vector<Segment>& us, const std::vector<Segment>& ss) {
      for (const Segment& u : us)
        for (const Segment& s : ss) {
          if (found.size() >= most) return;
          if (std::max(u.a[0], u.b[0]) < std::min(s.a[0], s.b[0]) ||
              std::min(u.a[0], u.b[0]) > std::max(s.a[0], s.b[0]) || !crossing(u.a, u.b, s.a, s.b))
            continue;
          const auto g = refined(u, s);
          const auto same = [&](const HomoclinicGuess& old) {
            return std::abs(old.xi - g->xi) < 1e-6 * std::abs(g->xi) &&
                   std::abs(old.eta - g->eta) < 1e-6 * std::abs(g->eta);
          };
          if (g && std::ranges::none_of(found, same)) found.push_back(*g);
        }
    };
    meet(fresh[0], all[1]);
    all[1].insert(all[1].end(), fresh[1].begin(), fresh[1].end());
    meet(all[0], fresh[1]);
    meet(fresh[0], fresh[1]);
    all[0].insert(all[0].end(), fresh[0].begin(), fresh[0].end());
    if (lost) break;
  }
  for (const Arc& arc : arcs_) { // for the picture
    std::size_t levels = 0;
    for (const Sample& s : arc.samples)
      levels = std::max(levels, s.at.size());
    for (std::size_t k = 0; k < levels; ++k) {
      Curve curve;
      for (const Sample& s : arc.samples)
        if (s.at.size() > k) curve.push_back(s.at[k]);
      curves_[arc.stable ? 1 : 0].push_back(curve);
    }
  }
  return found;
}

} // namespace kov::flow
