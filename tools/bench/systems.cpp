// kovacic-systems DIRECTORY [SECONDS]: what accuracy costs for six systems that are read from files (DIRECTORY/*.toml),
// with our integrator in every arithmetic and with those of Boost.odeint.
//
// Each gets the same starts, the same section and the same times.  Boost.odeint gets the right-hand side as a person
// would write it, compiled for this machine.  Output, by system:
//   # SYSTEM: how many orbits and returns
//   cost SYSTEM METHOD tolerance microseconds drift error wrong
//   ratio SYSTEM METHOD drift median least greatest turns
// cost: processor time of a return;  drift: of the energy, relative;  error: the median over the orbits of the largest error
// of the first `compared` points (of all coordinates, relative to their scales), against a run in pairs of doubles;
// wrong: orbits with another number of returns.  ratio: their time over ours with the same drift, by turns in one
// process (ours, theirs, ours).

#define KOV_ISA systems
#include "flow/scene/section_sink.hpp"
#include "symbol/document.hpp"

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>

namespace kov::bench {
namespace {

using namespace kov::flow;
namespace ode = boost::numeric::odeint;

constexpr std::size_t compared = 10;

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

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

// ---- what a run leaves ----

struct Seen {
  double seconds = 0, drift = 0;
  std::vector<long> returns; ///< of each orbit
  std::vector<std::vector<std::vector<BigReal>>>
      points; ///< the first of each orbit, all coordinates
  explicit Seen(std::size_t orbits) : returns(orbits), points(orbits) {}
  [[nodiscard]] long all() const {
    long sum = 0;
    for (const long n : returns)
      sum += n;
    return sum;
  }
};

template <class R> class Keep : public SectionSink<R> {
public:
  Keep(const Stage& s, std::size_t orbits)
      : SectionSink<R>(s, orbits), seen(orbits), integrals_(s.field, values_of(s.integrals)),
        begun_(orbits) {}
  bool crossing(std::size_t orbit, const R&, const R* at, bool) override {
    if (!this->is_wanted(at)) return false;
    ++seen.returns[orbit];
    look(orbit, at);
    if (seen.points[orbit].size() >= compared) return true;
    auto& one = seen.points[orbit].emplace_back();
    for (std::size_t i = 0; i < this->stage.field.coordinates(); ++i)
      one.push_back(to_big(at[i]));
    return true;
  }
  void look(std::size_t orbit, const R* at) override {
    const R now = integrals_(at)[0];
    if (!begun_[orbit]) begun_[orbit] = now;
    const double change = std::abs(to_double(R(now - *begun_[orbit])) / to_double(*begun_[orbit]));
    if (!(change <= seen.drift)) seen.drift = change;
  }
  void finished(std::size_t, const FieldFinish<R>&) override {}
  Seen seen;

private:
  Evaluator<R> integrals_;
  std::vector<std::optional<R>> begun_;
};

struct Effort {
  double microseconds = 0, drift = 0, error = 0;
  long wrong = 0;
};

// A system, its orbits, and what they must do.
template <class P> class Bench {
public:
  using State = A<P::n>;

  Bench(const std::string& directory, std::string name) : name_(std::move(name)) {
    scene_ = read_system_scenes(read_document(directory + "/" + name_ + ".toml")).front();
    const Stage stage(scene_, nullptr);
    starts_ = stage.starts;
    time_ = scene_.time->template as<double>();
    StartRefiner<double> refine(scene_, stage.field);
    for (const FieldStart& s : starts_) {
      const std::vector<double> x = refine(s);
      std::copy_n(x.begin(), P::n, x_.emplace_back().begin());
    }
    for (std::size_t i = 0; i < P::n; ++i)
      scales_.push_back(1 / stage.per_scale[i]);
  }

  void prepare() {
    const PrecisionScope scope(140);
    reference_ = ours<Twin1>(31, 28, 0);
    std::printf("# %s: %zu orbits, %ld returns\n", name_.c_str(), x_.size(), reference_->all());
  }

  template <class R> Seen ours(int digits, double tolerance_digits, int lanes) const {
    SystemScene scene = scene_;
    scene.digits = digits;
    char text[64];
    std::snprintf(text, sizeof text, "10^-%ld/%ld", static_cast<long>(tolerance_digits),
                  std::lround(std::pow(10, tolerance_digits - std::floor(tolerance_digits))));
    scene.tolerance = Quantity(text);
    const Stage stage(scene, nullptr, [&](const flow::Field&) { return starts_; });
    const Tapes<R> tapes(stage.field, stage.order);
    StartRefiner<R> refine(scene, stage.field);
    SectionSize section_size(stage);
    std::vector<R> per_scale, numbers, sizes;
    for (const double x : stage.per_scale)
      per_scale.emplace_back(x);
    for (const FieldStart& start : starts_) {
      const std::vector<R> x = refine(start);
      numbers.insert(numbers.end(), x.begin(), x.end());
      sizes.emplace_back(section_size(1));
    }
    FieldRun<R> run;
    run.log2_tolerance = stage.log2_tolerance();
    run.order = stage.order;
    run.t_end = R(time_);
    run.falling = scene.falling;
    run.rising = scene.rising;
    run.values = tapes.values();
    run.per_scale = per_scale.data();
    run.starts = numbers.data();
    run.section_sizes = sizes.data();
    run.orbits = starts_.size();
    Keep<R> keep(stage, starts_.size());
    run.sink = &keep;
    const double begun = cpu_seconds();
    integrate_any(tapes.tapes(), run, lanes);
    keep.seen.seconds = cpu_seconds() - begun;
    return keep.seen;
  }

  // ---- theirs ----

  Seen theirs(const std::string& method, double digits) const {
    const double e = std::pow(10.0, -digits);
    const double begun = cpu_seconds();
    Seen seen = method == "rkf78" ? controlled(e)
                : method == "dopri5"
                    ? dense(ode::make_dense_output(e, e, ode::runge_kutta_dopri5<State>()))
                    : dense(ode::bulirsch_stoer_dense_out<State>(e, e));
    seen.seconds = cpu_seconds() - begun;
    return seen;
  }

  [[nodiscard]] Effort effort(const Seen& s) const {
    Effort e{1e6 * s.seconds / static_cast<double>(std::max(1L, s.all())), s.drift, 0, 0};
    std::vector<double> errors;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      e.wrong += s.returns[i] != reference_->returns[i] ? 1 : 0;
      double worst = 0;
      const auto &mine = s.points[i], &wanted = reference_->points[i];
      for (std::size_t k = 0; k < std::min(mine.size(), wanted.size()); ++k)
        for (std::size_t c = 0; c < P::n; ++c)
          worst = std::max(worst, std::abs(to_double(mine[k][c] - wanted[k][c])) / scales_[c]);
      errors.push_back(worst);
    }
    std::nth_element(errors.begin(),
                     errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
    e.error = errors[errors.size() / 2];
    return e;
  }

  // ---- tables ----

  using Method = std::function<Seen(double digits)>;

  void costs(double seconds) {
    const PrecisionScope scope(bits_of(60));
    table(
        "double", [&](double d) { return ours<double>(0, d, 0); }, {4, 6, 8, 10, 12, 14, 16},
        seconds);
    table(
        "long-double", [&](double d) { return ours<long double>(19, d, 0); }, {8, 12, 16, 18},
        seconds);
    table(
        "pairs", [&](double d) { return ours<Twin1>(31, d, 0); }, {8, 14, 20, 24}, seconds);
    table(
        "mpfr", [&](double d) { return ours<BigReal>(40, d, 0); }, {10, 24}, seconds);
    for (const char* method : {"rkf78", "dopri5", "bulirsch-stoer"})
      table(
          method, [&](double d) { return theirs(method, d); }, {4, 6, 8, 10, 12, 14}, seconds);
  }

  void ratios(double seconds) {
    const Method mine = [&](double d) { return ours<double>(0, d, 0); };
    for (const double drift : {1e-6, 1e-9, 1e-12}) {
      const double own = loosest(mine, drift, seconds);
      if (!(own > 0)) continue;
      for (const char* name : {"rkf78", "dopri5", "bulirsch-stoer"}) {
        const Method method = [&](double d) { return theirs(name, d); };
        const double their = loosest(method, drift, seconds);
        std::vector<double> all;
        const double begun = cpu_seconds();
        while (their > 0 && all.size() < 15 &&
               (all.size() < 3 || cpu_seconds() - begun < seconds)) {
          const double before = mine(own).seconds, between = method(their).seconds,
                       after = mine(own).seconds;
          all.push_back(2 * between / (before + after));
        }
        std::sort(all.begin(), all.end());
        if (all.empty())
          std::printf("ratio %s %s %.0e - - - 0\n", name_.c_str(), name, drift);
        else
          std::printf("ratio %s %s %.0e %.3g %.3g %.3g %zu\n", name_.c_str(), name, drift,
                      all[all.size() / 2], all.front(), all.back(), all.size());
        std::fflush(stdout);
      }
    }
  }

private:
  void table(const char* method, const Method& run, const std::vector<double>& digits,
             double seconds) const {
    for (const double d : digits) {
      Seen s = run(d);
      for (int again = 0; again < 2 && s.seconds < seconds / 20; ++again)
        s.seconds = std::min(s.seconds, run(d).seconds);
      const Effort e = effort(s);
      std::printf("cost %s %s %g %.4g %.2e %.2e %ld\n", name_.c_str(), method, std::pow(10.0, -d),
                  e.microseconds, e.drift, e.error, e.wrong);
      std::fflush(stdout);
      if (s.seconds > seconds) break;
    }
  }

  // The fewest digits, to a quarter, that keep the drift; 0: none do.
  static double loosest(const Method& run, double drift, double seconds) {
    for (double d = 3; d <= 16; d += 1) {
      const Seen s = run(d);
      if (s.drift <= drift) {
        for (const double less : {0.75, 0.5, 0.25})
          if (d - less >= 3 && run(d - less).drift <= drift) return d - less;
        return d;
      }
      if (s.seconds > seconds) return 0;
    }
    return 0;
  }

  static bool goes(double before, double now) {
    return P::direction > 0 ? before < 0 && now >= 0 : before > 0 && now <= 0;
  }
  static void note(Seen& seen, std::size_t orbit, double begun, const State& x) {
    const double change = std::abs(P::energy(x) / begun - 1);
    if (!(change <= seen.drift)) seen.drift = change;
    if (std::isnan(change)) seen.drift = INFINITY;
    static_cast<void>(orbit);
  }
  // Between two states with different signs of the section: the Illinois variant of the secant.
  template <class At>
  void locate(Seen& seen, std::size_t orbit, double begun, double a, double b, double sa, double sb,
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
    note(seen, orbit, begun, x);
    if (seen.points[orbit].size() >= compared) return;
    auto& one = seen.points[orbit].emplace_back();
    for (const double c : x)
      one.emplace_back(c);
  }

  template <class S> Seen dense(S stepper) const {
    Seen seen(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double begun = P::energy(x_[i]);
      stepper.initialize(x_[i], 0.0, 0.01);
      double before = P::direction, last = 0;
      for (long step = 1; last < time_; ++step) {
        const auto span = stepper.do_step(P::rate);
        double end = span.second;
        State x = stepper.current_state();
        if (end > time_) stepper.calc_state(end = time_, x);
        const double now = P::section(x);
        if (goes(before, now))
          locate(seen, i, begun, span.first, end, before, now,
                 [&](double c, State& out) { stepper.calc_state(c, out); });
        before = now;
        last = end;
        if (step % 16 == 0 || !(end < time_)) note(seen, i, begun, x);
      }
    }
    return seen;
  }

  Seen controlled(double e) const {
    using Error = ode::runge_kutta_fehlberg78<State>;
    auto stepper = ode::make_controlled<Error>(e, e);
    Error plain;
    Seen seen(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double begun = P::energy(x_[i]);
      State x = x_[i];
      double t = 0, dt = 0.01, before = P::direction;
      for (long step = 1; t < time_; ++step) {
        dt = std::min(dt, time_ - t);
        const State old = x;
        const double from = t;
        while (stepper.try_step(P::rate, x, t, dt) == ode::fail) {
        }
        const double now = P::section(x);
        if (goes(before, now))
          locate(seen, i, begun, from, t, before, now, [&](double c, State& out) {
            out = old;
            plain.do_step(P::rate, out, from, c - from);
          });
        before = now;
        if (step % 16 == 0 || !(t < time_)) note(seen, i, begun, x);
      }
    }
    return seen;
  }

  std::string name_;
  SystemScene scene_;
  std::vector<FieldStart> starts_;
  std::vector<State> x_;
  double time_ = 0;
  std::vector<double> scales_;
  std::optional<Seen> reference_;
};

template <class P> void measure(const std::string& directory, const char* name, double seconds) {
  Bench<P> bench(directory, name);
  bench.prepare();
  bench.costs(seconds);
  bench.ratios(seconds);
}

} // namespace
} // namespace kov::bench

int main(int argc, char** argv) {
  using namespace kov::bench;
  if (argc < 2) {
    std::fprintf(stderr, "kovacic-systems DIRECTORY [SECONDS]\n");
    return 2;
  }
  const std::string directory = argv[1];
  const double seconds = argc > 2 ? std::atof(argv[2]) : 2;
  measure<HenonHeiles>(directory, "henon_heiles", seconds);
  measure<ThreeDegrees>(directory, "three_degrees", seconds);
  measure<Atwood>(directory, "swinging_atwood", seconds);
  measure<Restricted>(directory, "restricted", seconds);
  measure<DoublePendulum>(directory, "double_pendulum", seconds);
  measure<SlidingTop>(directory, "sliding_top", seconds);
}
