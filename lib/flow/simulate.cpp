#include "flow/simulate.hpp"

#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <thread>

namespace kov::flow {
namespace {

// The three integrals' drifts, relative.
template <class R>
std::array<double, 3> relative(const Finish<R>& f, const Levels<double>& levels) {
  return {static_cast<double>(f.drift[0]) / std::max(1.0, std::abs(levels.energy)),
          static_cast<double>(f.drift[1]) / levels.length,
          static_cast<double>(f.drift[2]) / std::max(1.0, std::abs(levels.casimir))};
}

template <class R> State<double> rounded(const R (&x)[6]) {
  const auto d = [&](int i) { return static_cast<double>(x[i]); };
  return {{d(0), d(1), d(2)}, {d(3), d(4), d(5)}};
}

// Turns crossings into section points as they come.  The points are doubles whatever the orbit was.
template <class R> struct Collector : Sink<R> {
  Body<double> body;
  Levels<double> levels;
  int axis;
  std::size_t first; ///< number of the run's first orbit in the scene
  std::vector<SectionPoint> points;
  std::vector<std::pair<std::size_t, OrbitReport>> orbits;

  Collector(const Scene& s, std::size_t n)
      : body(s.body<double>()), levels(s.levels<double>()), axis(s.section.axis), first(n) {}
  void crossing(const Crossing<R>& c) override {
    const Andoyer<double> a = andoyer_of(body, rounded(c.x), axis);
    points.push_back({first + c.orbit, static_cast<double>(c.t), a.l, a.y, a.g_size});
  }
  void finished(std::size_t orbit, const Finish<R>& f) override {
    OrbitReport r;
    r.crossings = f.crossings;
    r.steps = f.steps;
    r.tangencies = f.tangencies;
    r.time = static_cast<double>(f.t);
    r.drift = relative(f, levels);
    r.ended = f.ended;
    orbits.emplace_back(first + orbit, r);
  }
};

// Everything that does not depend on the orbit.
template <class R> struct Plan {
  Body<R> body;
  Effects effects;
  Model<R> model;
  Run<R> run;
  long bits = 128; ///< of a BigReal
};

long bits_of(int digits) { return static_cast<long>(std::ceil(digits * 3.3219280948873623)) + 8; }

double log2_tolerance(const Scene& s) {
  return log2_estimate(s.tolerance.as<BigReal>()) - safety_bits;
}

template <class R> Plan<R> plan_of(const Scene& s, const SimulateOptions& o) {
  Plan<R> p;
  p.body = s.body<R>();
  p.effects = s.effects();
  p.model = model_of(p.body, p.effects);
  p.run.section = s.section;
  p.run.stop = o.stop;
  p.run.max_crossings = s.crossings;
  p.run.t_end = s.time ? s.time->as<R>() : R(1e12);
  // Without a time an orbit that never comes back must end somewhere.
  p.run.max_steps = s.time ? -1 : 20000 + 2000 * s.crossings;
  p.run.log2_tolerance = log2_tolerance(s);
  return p;
}

template <class R>
void integrate_any(const Plan<R>& p, const Run<R>& run, [[maybe_unused]] int lanes) {
  if constexpr (std::is_same_v<R, double> || std::is_same_v<R, Twin1>)
    integrate(p.effects, p.model, p.body.sliding, run, lanes);
  else
    integrate(p.effects, p.model, p.body.sliding, run);
}

// One worker: takes the next few orbits until none are left.
template <class R> struct Work {
  const Scene& scene;
  const SimulateOptions& options;
  const std::vector<Start>& starts;
  Section& out;
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::mutex mutex{};
  int order = 0;

  void operator()() {
    const PrecisionScope scope(bits_of(std::max(scene.digits, 34)));
    Plan<R> plan = plan_of<R>(scene, options);
    plan.run.order = order;
    const std::size_t chunk = std::is_same_v<R, double> ? 32 : std::is_same_v<R, Twin1> ? 8 : 1;
    for (std::size_t first = next.fetch_add(chunk); first < starts.size();
         first = next.fetch_add(chunk)) {
      if (options.stop != nullptr && options.stop->load()) return;
      const std::size_t last = std::min(starts.size(), first + chunk);
      Collector<R> collector(scene, first);
      const std::vector<R> numbers = start_numbers(first, last);
      Run<R> run = plan.run;
      run.starts = numbers.data();
      run.orbits = last - first;
      run.sink = &collector;
      integrate_any(plan, run, options.lanes);
      keep(collector);
    }
  }

  // On the level to the last digit of R.
  std::vector<R> start_numbers(std::size_t first, std::size_t last) const {
    using S = std::conditional_t<std::is_same_v<R, Twin1>, BigReal, R>;
    const Body<S> body = scene.body<S>();
    const Levels<S> levels = scene.levels<S>();
    std::vector<R> numbers;
    const auto keep_number = [&](const S& x) {
      if constexpr (std::is_same_v<R, Twin1>)
        numbers.push_back(to_twin(x));
      else
        numbers.push_back(x);
    };
    for (std::size_t i = first; i < last; ++i) {
      const Start& s = starts[i];
      const bool seed = i < scene.seeds.size();
      const S l = seed ? scene.seeds[i].l.template as<S>() : S(s.l);
      const S y = seed ? scene.seeds[i].y.template as<S>() : S(s.y);
      const State<S> x = refine_point(body, levels, scene.section, l, y, s.g_size);
      for (const Vec<S>& v : {x.omega, x.gamma})
        for (const S& c : v)
          keep_number(c);
    }
    return numbers;
  }

  void keep(const Collector<R>& c) {
    const std::lock_guard lock(mutex);
    out.points.insert(out.points.end(), c.points.begin(), c.points.end());
    for (const auto& [orbit, r] : c.orbits) {
      OrbitReport full = r;
      full.l = starts[orbit].l;
      full.y = starts[orbit].y;
      full.g_size = starts[orbit].g_size;
      full.sign = out.orbits[orbit].sign;
      out.orbits[orbit] = full;
    }
    done += c.orbits.size();
    if (options.progress) options.progress(done, starts.size());
  }
};

template <class R>
void run_all(const Scene& s, const SimulateOptions& o, const std::vector<Start>& starts,
             Section& out) {
  Work<R> work{s, o, starts, out};
  work.order = out.order;
  std::vector<std::jthread> threads;
  for (int i = 1; i < o.threads; ++i)
    threads.emplace_back([&work] { work(); });
  work();
}

int sign_at(const Scene& s, const Body<double>& b, const State<double>& x) {
  if (!s.sign_of) return 0;
  const Vec<double> m = momentum(b, x);
  double form = 0;
  for (std::size_t i = 0; i < 3; ++i)
    form += (*s.sign_of)[i].as<double>() * m[i];
  return form > 0 ? 1 : -1;
}

void sort_points(Section& s) {
  std::stable_sort(s.points.begin(), s.points.end(), [](const auto& a, const auto& b) {
    return a.orbit != b.orbit ? a.orbit < b.orbit : a.t < b.t;
  });
}

} // namespace

std::vector<Start> starts_of(const Scene& s, std::size_t* skipped) {
  const Body<double> b = s.body<double>();
  const Levels<double> f = s.levels<double>();
  std::vector<Start> starts;
  std::size_t missing = 0;
  const auto try_point = [&](double l, double y) {
    const auto sizes = momentum_sizes(b, f, s.section, l, y);
    if (sizes.empty()) return false;
    const double g = sizes.back();
    starts.push_back({l, y, g, section_point(b, f, s.section, l, y, g)});
    return true;
  };
  for (const Seed& seed : s.seeds)
    if (!try_point(seed.l.as<double>(), seed.y.as<double>()))
      throw InputError(
          s.file, 0, 0, 1,
          "the level H = " + s.energy.text() + ", F1 = " + s.length.text() +
              ", F2 = " + s.casimir.text() + " has no point over l = " + seed.l.text() +
              ", L/G = " + seed.y.text() + " with the wanted direction",
          "kovacic section with a grid instead of seeds shows where the level has points");
  for (int i = 0; i < s.columns; ++i)
    for (int k = 0; k < s.rows; ++k) {
      // Off the lines of symmetry, so that mirror images are different orbits.
      const double l = 2 * pi_of(0.0) * (i + 0.3819660112501051) / s.columns;
      const double y = -1 + 2 * (k + 0.5) / s.rows;
      if (!try_point(l, y)) ++missing;
    }
  if (starts.empty())
    throw InputError(s.file, 0, 0, 1,
                     "no point of the grid lies on the level H = " + s.energy.text() +
                         ", F1 = " + s.length.text() + ", F2 = " + s.casimir.text(),
                     "raise H, or lower |F2|");
  if (skipped != nullptr) *skipped = missing;
  return starts;
}

Section simulate(const Scene& scene, const SimulateOptions& options) {
  Section out;
  const std::vector<Start> starts = starts_of(scene, &out.skipped);
  const Body<double> body = scene.body<double>();
  const Effects effects = scene.effects();
  std::vector<double> numbers;
  for (const Start& s : starts) {
    numbers.insert(numbers.end(), s.x.omega.begin(), s.x.omega.end());
    numbers.insert(numbers.end(), s.x.gamma.begin(), s.x.gamma.end());
    OrbitReport r;
    r.ended = Ended::stopped;
    r.sign = sign_at(scene, body, s.x);
    r.l = s.l;
    r.y = s.y;
    r.g_size = s.g_size;
    out.orbits.push_back(r);
  }
  out.order = choose_order(effects, model_of(body, effects), numbers.data(), starts.size(),
                           log2_tolerance(scene));
  if (scene.digits == 0) {
    out.arithmetic = "double, " + to_string(best_isa()) + ", " + std::to_string(options.lanes) +
                     (options.lanes == 1 ? " lane" : " lanes");
    run_all<double>(scene, options, starts, out);
  } else if (scene.digits <= 19) {
    out.arithmetic = "long double";
    run_all<long double>(scene, options, starts, out);
  } else if (scene.digits <= 31) {
    out.arithmetic = "pairs of doubles";
    run_all<Twin1>(scene, options, starts, out);
  } else {
    out.arithmetic = "MPFR, " + std::to_string(bits_of(scene.digits)) + " bits";
    run_all<BigReal>(scene, options, starts, out);
  }
  sort_points(out);
  for (const OrbitReport& r : out.orbits) {
    out.stopped = out.stopped || r.ended == Ended::stopped;
    out.drift = std::max({out.drift, r.drift[0], r.drift[1], r.drift[2]});
  }
  return out;
}

} // namespace kov::flow
