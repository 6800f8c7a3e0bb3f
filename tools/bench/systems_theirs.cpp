// The six systems of kovacic-systems with Boost.odeint: dopri5 and Bulirsch-Stoer with dense output, rkf78 controlled.

#include "systems.hpp"

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace kov::bench {
namespace {

namespace ode = boost::numeric::odeint;

// ---- the systems, as a person writes them ----

template <int n> using A = std::array<double, n>;

struct HenonHeiles {
  static constexpr int n = 4, direction = 1;
  static void rate(const A<n>& s, A<n>& d, double) {
    const auto& [x, y, u, v] = s;
    d = {u, v, -x - 2 * x * y, -y - x * x + y * y};
  }
  static double section(const A<n>& s) { return s[0]; }
  static double side(const A<n>&) { return 1; }
  static double energy(const A<n>& s) {
    const auto& [x, y, u, v] = s;
    return (u * u + v * v + x * x + y * y) / 2 + x * x * y - y * y * y / 3;
  }
};

struct ThreeDegrees {
  static constexpr int n = 6, direction = 1;
  static void rate(const A<n>& s, A<n>& d, double) {
    const auto& [x, y, z, u, v, w] = s;
    d = {u,
         v,
         w,
         -x - 2 * x * (y + z) - x * y * y,
         -2 * y - x * x + y * y - y * (x * x + z * z),
         -3 * z - x * x - y * y * z};
  }
  static double section(const A<n>& s) { return s[2]; }
  static double side(const A<n>&) { return 1; }
  static double energy(const A<n>& s) {
    const auto& [x, y, z, u, v, w] = s;
    return (u * u + v * v + w * w + x * x + 2 * y * y + 3 * z * z) / 2 + x * x * (y + z) -
           y * y * y / 3 + y * y * (x * x + z * z) / 2;
  }
};

struct Atwood {
  static constexpr int n = 4, direction = 1;
  static void rate(const A<n>& s, A<n>& d, double) {
    const auto& [r, a, p, l] = s;
    const double w = l / (r * r);
    d = {p / 2.5, w, w * l / r - 1.5 + std::cos(a), -r * std::sin(a)};
  }
  static double section(const A<n>& s) { return std::sin(s[1]); }
  static double side(const A<n>& s) { return std::cos(s[1]); }
  static double energy(const A<n>& s) {
    const auto& [r, a, p, l] = s;
    return p * p / 5 + l * l / (2 * r * r) + r * (1.5 - std::cos(a));
  }
};

struct Restricted {
  static constexpr int n = 4, direction = 1;
  static void rate(const A<n>& s, A<n>& d, double) {
    const auto& [x, y, u, v] = s;
    const double a = x + 0.1, b = x - 0.9, r = a * a + y * y, q = b * b + y * y;
    const double f = 0.9 / (r * std::sqrt(r)), g = 0.1 / (q * std::sqrt(q));
    d = {u + y, v - x, v - f * a - g * b, -u - (f + g) * y};
  }
  static double section(const A<n>& s) { return s[1]; }
  static double side(const A<n>&) { return 1; }
  static double energy(const A<n>& s) {
    const auto& [x, y, u, v] = s;
    return (u * u + v * v) / 2 + y * u - x * v - 0.9 / std::hypot(x + 0.1, y) -
           0.1 / std::hypot(x - 0.9, y);
  }
};

struct DoublePendulum {
  static constexpr int n = 4, direction = 1;
  static void rate(const A<n>& s, A<n>& d, double) {
    const auto& [a, b, p, q] = s;
    const double c = std::cos(a - b), e = std::sin(a - b), below = 1 + e * e;
    const double kinetic = (p * p + 2 * q * q - 2 * p * q * c) / (2 * below);
    const double turn = (p * q * e - 2 * kinetic * e * c) / below;
    d = {(p - q * c) / below, (2 * q - p * c) / below, -turn - 2 * std::sin(a), turn - std::sin(b)};
  }
  static double section(const A<n>& s) { return std::sin(s[0]); }
  static double side(const A<n>& s) { return std::cos(s[0]); }
  static double energy(const A<n>& s) {
    const auto& [a, b, p, q] = s;
    const double e = std::sin(a - b);
    return (p * p + 2 * q * q - 2 * p * q * std::cos(a - b)) / (2 + 2 * e * e) + 3 -
           2 * std::cos(a) - std::cos(b);
  }
};

struct SlidingTop {
  static constexpr int n = 6, direction = -1;
  static constexpr double lever = 8.0 / 9;
  static void rate(const A<n>& s, A<n>& d, double) {
    const auto& [w1, w2, w3, g1, g2, g3] = s;
    const double d1 = g2 * w3 - g3 * w2, d2 = g3 * w1 - g1 * w3, d3 = g1 * w2 - g2 * w1;
    const double v2 = -lever * g3, v3 = lever * g2, y2 = -0.75 * w3 * w1, y3 = 2.0 / 3 * w1 * w2;
    const double push =
        (lever * (d2 * w3 - d3 * w2) + v2 * y2 + v3 * y3) / (1 + 1.5 * v2 * v2 + 2 * v3 * v3);
    d = {w2 * w3 / 6, y2 - 1.5 * push * v2, y3 - 2 * push * v3, d1, d2, d3};
  }
  static std::array<double, 3> momentum(const A<n>& s) {
    const double v2 = -lever * s[5], v3 = lever * s[4], z = v2 * s[1] + v3 * s[2];
    return {s[0], s[1] * 2 / 3 + z * v2, s[2] / 2 + z * v3};
  }
  static double section(const A<n>& s) {
    const auto m = momentum(s);
    return (m[0] * s[3] + m[1] * s[4] + m[2] * s[5]) * m[2] -
           (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]) * s[5];
  }
  static double side(const A<n>& s) {
    const auto m = momentum(s);
    return m[1] * s[3] - m[0] * s[4];
  }
  static double energy(const A<n>& s) {
    const double z = lever * (s[4] * s[2] - s[5] * s[1]);
    return (s[0] * s[0] + s[1] * s[1] * 2 / 3 + s[2] * s[2] / 2 + z * z) / 2;
  }
};

// ---- with their integrators ----

template <class P> class Orbits {
public:
  using State = A<P::n>;
  // A type of its own, so that it is inlined.
  struct Rate {
    void operator()(const State& x, State& d, double t) const { P::rate(x, d, t); }
  };
  Orbits(const std::vector<std::vector<double>>& starts, double time) : time_(time) {
    for (const std::vector<double>& x : starts)
      std::copy_n(x.begin(), P::n, x_.emplace_back().begin());
  }

  Ran run(const std::string& method, double e) const {
    if (method == "rkf78") return controlled(e);
    if (method == "dopri5")
      return dense(ode::make_dense_output(e, e, ode::runge_kutta_dopri5<State>()));
    return dense(ode::bulirsch_stoer_dense_out<State>(e, e));
  }

private:
  Ran empty() const {
    Ran seen;
    seen.returns.resize(x_.size());
    seen.points.resize(x_.size());
    return seen;
  }
  static bool goes(double before, double now) {
    return P::direction > 0 ? before < 0 && now >= 0 : before > 0 && now <= 0;
  }
  static void note(Ran& seen, double begun, const State& x) {
    const double change = std::abs(P::energy(x) / begun - 1);
    if (!(change <= seen.drift)) seen.drift = std::isnan(change) ? INFINITY : change;
  }
  // Between two states with different signs of the section: the Illinois variant of the secant.
  template <class At>
  void locate(Ran& seen, std::size_t orbit, double begun, double a, double b, double sa, double sb,
              const At& at) const {
    State x{};
    for (int i = 0; i < 60 && std::abs(b - a) > 1e-15 * (1 + std::abs(b)); ++i) {
      const double c = b - sb * (b - a) / (sb - sa);
      at(c, x);
      const double sc = P::section(x);
      if (std::abs(sc) < 1e-15) break;
      if ((sc > 0) != (sb > 0)) {
        a = b;
        sa = sb;
      } else {
        sa /= 2;
      }
      b = c;
      sb = sc;
    }
    if (!(P::side(x) > 0)) return;
    ++seen.returns[orbit];
    note(seen, begun, x);
    if (seen.points[orbit].size() >= compared) return;
    seen.points[orbit].emplace_back(x.begin(), x.end());
  }

  template <class S> Ran dense(S stepper) const {
    Ran seen = empty();
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double begun = P::energy(x_[i]);
      stepper.initialize(x_[i], 0.0, 0.01);
      double before = P::direction, last = 0;
      for (long step = 1; last < time_; ++step) {
        const auto span = stepper.do_step(Rate());
        double end = span.second;
        State x = stepper.current_state();
        if (end > time_) stepper.calc_state(end = time_, x);
        const double now = P::section(x);
        if (goes(before, now))
          locate(seen, i, begun, span.first, end, before, now,
                 [&](double c, State& out) { stepper.calc_state(c, out); });
        before = now;
        last = end;
        if (step % 16 == 0 || !(end < time_)) note(seen, begun, x);
      }
    }
    return seen;
  }

  Ran controlled(double e) const {
    using Error = ode::runge_kutta_fehlberg78<State>;
    auto stepper = ode::make_controlled<Error>(e, e);
    Error plain;
    Ran seen = empty();
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double begun = P::energy(x_[i]);
      State x = x_[i];
      double t = 0, dt = 0.01, before = P::direction;
      for (long step = 1; t < time_; ++step) {
        dt = std::min(dt, time_ - t);
        const State old = x;
        const double from = t;
        while (stepper.try_step(Rate(), x, t, dt) == ode::fail) {
        }
        const double now = P::section(x);
        if (goes(before, now))
          locate(seen, i, begun, from, t, before, now, [&](double c, State& out) {
            out = old;
            plain.do_step(Rate(), out, from, c - from);
          });
        before = now;
        if (step % 16 == 0 || !(t < time_)) note(seen, begun, x);
      }
    }
    return seen;
  }

  double time_;
  std::vector<State> x_;
};

template <class P> Theirs of() {
  return {[](const std::string& method, double tolerance,
             const std::vector<std::vector<double>>& starts,
             double time) { return Orbits<P>(starts, time).run(method, tolerance); }};
}

} // namespace

Theirs KOV_THEIRS(const std::string& system) {
  return std::map<std::string, Theirs>{
      {"henon_heiles", of<HenonHeiles>()},       {"three_degrees", of<ThreeDegrees>()},
      {"swinging_atwood", of<Atwood>()},         {"restricted", of<Restricted>()},
      {"double_pendulum", of<DoublePendulum>()}, {"sliding_top", of<SlidingTop>()}}
      .at(system);
}

} // namespace kov::bench
