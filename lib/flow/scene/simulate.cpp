#include "flow/scene/simulate.hpp"

#include "flow/scene/own_units.hpp"
#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <thread>

namespace kov::flow {
namespace {

template <class R> State<double> rounded(const R (&x)[6]) {
  const auto d = [&](int i) { return static_cast<double>(x[i]); };
  return {{d(0), d(1), d(2)}, {d(3), d(4), d(5)}};
}

std::string decimal(BigReal x, long shift, int digits) {
  mpfr_mul_2si(x.raw(), x.raw(), shift, MPFR_RNDN);
  return to_string(x, digits);
}

// Turns crossings into section points as they come, from own units into those of the scene.
template <class R> struct Collector : Sink<R> {
  const Scene& scene; ///< in own units
  const OwnUnits& units;
  Body<double> body;
  Body<BigReal> precise;
  Levels<double> sizes;
  std::size_t first; ///< number of the run's first orbit in the scene
  std::vector<SectionPoint> points;
  std::vector<std::pair<std::size_t, OrbitReport>> orbits;

  Collector(const Scene& s, const OwnUnits& u, std::size_t n)
      : scene(s), units(u), body(s.body<double>()), precise(s.body<BigReal>()),
        sizes(sizes_on_level(body, s.levels<double>())), first(n) {}
  void crossing(const Crossing<R>& c) override {
    const Andoyer<double> a = andoyer_of(body, rounded(c.x), scene.section.axis);
    points.push_back({first + c.orbit, std::ldexp(static_cast<double>(c.t), int(units.time)), a.l,
                      a.y, std::ldexp(a.g_size, int(units.momentum())), all_digits(c)});
  }
  void finished(std::size_t orbit, const Finish<R>& f) override {
    OrbitReport r;
    r.crossings = f.crossings;
    r.steps = f.steps;
    r.tangencies = f.tangencies;
    r.time = std::ldexp(static_cast<double>(f.t), int(units.time));
    r.drift = {static_cast<double>(f.drift[0]) / sizes.energy,
               static_cast<double>(f.drift[1]) / sizes.length,
               static_cast<double>(f.drift[2]) / sizes.casimir};
    r.ended = f.ended;
    orbits.emplace_back(first + orbit, r);
  }

private:
  [[nodiscard]] std::string all_digits(const Crossing<R>& c) const {
    if constexpr (std::is_same_v<R, double>) {
      return {};
    } else {
      State<BigReal> x;
      for (std::size_t i = 0; i < 3; ++i) {
        x.omega[i] = to_big(c.x[i]);
        x.gamma[i] = to_big(c.x[3 + i]);
      }
      const Andoyer<BigReal> a = andoyer_of(precise, x, scene.section.axis);
      const int n = digits_shown(scene.tolerance, scene.digits);
      return decimal(to_big(c.t), units.time, n) + " " + decimal(a.l, 0, n) + " " +
             decimal(a.y, 0, n) + " " + decimal(a.g_size, units.momentum(), n);
    }
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

double log2_tolerance(const Scene& s) {
  return log2_estimate(s.tolerance.as<BigReal>()) - safety_bits;
}

// In own units: a time that no orbit reaches, whose products do not overflow.
constexpr double forever = 1e150;

template <class R> Plan<R> plan_of(const Scene& s, const SimulateOptions& o, std::size_t orbits) {
  Plan<R> p;
  p.body = s.body<R>();
  p.effects = s.effects();
  p.model = model_of(p.body, p.effects);
  p.run.section = s.section;
  p.run.stop = o.stop;
  p.run.max_crossings = s.crossings > 0 ? s.crossings : most_points / static_cast<long>(orbits) + 1;
  p.run.t_end = s.time ? s.time->as<R>() : R(forever);
  // Without a time an orbit that never comes back must end somewhere.
  p.run.max_steps = s.time ? -1 : least_steps + steps_for_crossing * s.crossings;
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
template <class R> struct SimulationWork {
  const Scene& scene; // in own units
  const OwnUnits& units;
  const SimulateOptions& options;
  const std::vector<Start>& starts;
  Section& out;
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::mutex mutex{};

  void operator()() {
    const PrecisionScope scope(bits_of(std::max(scene.digits, 34)));
    const Plan<R> plan = plan_of<R>(scene, options, starts.size());
    const std::size_t chunk = std::is_same_v<R, double> ? 32 : std::is_same_v<R, Twin1> ? 8 : 1;
    for (std::size_t first = next.fetch_add(chunk); first < starts.size();
         first = next.fetch_add(chunk)) {
      if (options.stop != nullptr && options.stop->load()) return;
      const std::size_t last = std::min(starts.size(), first + chunk);
      Collector<R> collector(scene, units, first);
      const std::vector<R> numbers = start_numbers(first, last);
      Run<R> run = plan.run;
      run.starts = numbers.data();
      run.orbits = last - first;
      run.sink = &collector;
      run.order = order_for(plan.effects, first, last);
      integrate_any(plan, run, options.lanes);
      keep(collector, run.order);
    }
  }

  // The best order for these orbits, whatever the others need.
  int order_for(const Effects& effects, std::size_t first, std::size_t last) const {
    std::vector<double> numbers;
    for (std::size_t i = first; i < last; ++i)
      for (const Vec<double>* v : {&starts[i].x.omega, &starts[i].x.gamma})
        numbers.insert(numbers.end(), v->begin(), v->end());
    return choose_order(effects, model_of(scene.body<double>(), effects), numbers.data(),
                        last - first, log2_tolerance(scene));
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
      const S l = s.seed ? scene.seeds[*s.seed].l.template as<S>() : S(s.l);
      const S y = s.seed ? scene.seeds[*s.seed].y.template as<S>() : S(s.y);
      const State<S> x = refine_point(body, levels, scene.section, l, y, s.g_size);
      for (const Vec<S>& v : {x.omega, x.gamma})
        for (const S& c : v)
          keep_number(c);
    }
    return numbers;
  }

  void keep(const Collector<R>& c, int order) {
    const std::lock_guard lock(mutex);
    out.least_order = out.least_order == 0 ? order : std::min(out.least_order, order);
    out.order = std::max(out.order, order);
    out.points.insert(out.points.end(), c.points.begin(), c.points.end());
    for (const auto& [orbit, r] : c.orbits) {
      OrbitReport full = r;
      full.l = out.orbits[orbit].l;
      full.y = out.orbits[orbit].y;
      full.g_size = out.orbits[orbit].g_size;
      full.sign = out.orbits[orbit].sign;
      out.orbits[orbit] = full;
    }
    done += c.orbits.size();
    if (options.progress) options.progress(done, starts.size());
    if (options.finished_some) options.finished_some(out);
  }
};

template <class R>
void run_all(const Scene& s, const OwnUnits& u, const SimulateOptions& o,
             const std::vector<Start>& starts, Section& out) {
  SimulationWork<R> work{s, u, o, starts, out};
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
  std::ranges::stable_sort(s.points, [](const auto& a, const auto& b) {
    return a.orbit != b.orbit ? a.orbit < b.orbit : a.t < b.t;
  });
}

// In own units.
std::vector<Start> own_starts(const Scene& s, std::size_t* skipped) {
  const Body<double> b = s.body<double>();
  const Levels<double> f = s.levels<double>();
  std::vector<Start> starts;
  std::size_t missing = 0;
  const auto try_point = [&](double l, double y, std::optional<std::size_t> seed) {
    const auto sizes = momentum_sizes(b, f, s.section, l, y);
    for (const double g : sizes)
      starts.push_back({l, y, g, section_point(b, f, s.section, l, y, g), seed});
    return !sizes.empty();
  };
  for (std::size_t i = 0; i < s.seeds.size(); ++i) {
    const Seed& seed = s.seeds[i];
    if (!try_point(seed.l.as<double>(), seed.y.as<double>(), i))
      throw InputError(
          s.file, 0, 0, 1,
          "the level H = " + s.energy.text() + ", F1 = " + s.length.text() +
              ", F2 = " + s.casimir.text() + " has no point over l = " + seed.l.text() +
              ", L/G = " + seed.y.text() + " with the wanted direction",
          "kovacic section with a grid instead of seeds shows where the level has points");
  }
  for (int i = 0; i < s.columns; ++i)
    for (int k = 0; k < s.rows; ++k) {
      // Off the lines of symmetry, so that mirror images are different orbits.
      const double l = 2 * pi_of(0.0) * (i + 0.3819660112501051) / s.columns;
      const double y = -1 + 2 * (k + 0.5) / s.rows;
      if (!try_point(l, y, std::nullopt)) ++missing;
    }
  if (starts.empty())
    throw InputError(s.file, 0, 0, 1,
                     "no point of the grid lies on the level H = " + s.energy.text() +
                         ", F1 = " + s.length.text() + ", F2 = " + s.casimir.text(),
                     "raise H, or lower |F2|");
  if (skipped != nullptr) *skipped = missing;
  return starts;
}

// Refuses what would not fit into the memory.
void check_points(const Scene& s, std::size_t orbits) {
  if (s.crossings > 0 && s.crossings > most_points / static_cast<long>(orbits))
    throw InputError(s.file, 0, 0, 1,
                     std::to_string(orbits) + " orbits with " + std::to_string(s.crossings) +
                         " crossings each are more than " + std::to_string(most_points) + " points",
                     "fewer orbits, or fewer crossings");
}

OrbitReport begun(const Scene& own, const OwnUnits& units, const Body<double>& body,
                  const Start& s) {
  OrbitReport r;
  r.ended = Ended::stopped;
  r.sign = sign_at(own, body, s.x);
  r.l = s.l;
  r.y = s.y;
  r.g_size = std::ldexp(s.g_size, static_cast<int>(units.momentum()));
  return r;
}

void run_in_arithmetic(const Scene& s, const OwnUnits& u, const SimulateOptions& o,
                       const std::vector<Start>& starts, Section& out) {
  if (s.digits == 0) {
    const int lanes = o.lanes == 0 ? best_lanes() : o.lanes;
    out.arithmetic = "double, " + to_string(best_isa()) + ", " + std::to_string(lanes) +
                     (lanes == 1 ? " lane" : " lanes");
    run_all<double>(s, u, o, starts, out);
  } else if (s.digits <= 19) {
    out.arithmetic = "long double";
    run_all<long double>(s, u, o, starts, out);
  } else if (s.digits <= 31) {
    out.arithmetic = "pairs of doubles";
    run_all<Twin1>(s, u, o, starts, out);
  } else {
    out.arithmetic = "MPFR, " + std::to_string(bits_of(s.digits)) + " bits";
    run_all<BigReal>(s, u, o, starts, out);
  }
}

} // namespace

int digits_shown(const Quantity& tolerance, int digits) {
  const double n = -log2_estimate(tolerance.as<BigReal>()) * std::log10(2.0);
  return std::clamp(static_cast<int>(n + 1.5), 6, digits > 0 ? digits : 17);
}

std::size_t Section::cut_short() const {
  return static_cast<std::size_t>(std::ranges::count_if(orbits, [&](const auto& o) {
    return o.ended == Ended::steps || (o.ended == Ended::crossings && has_time);
  }));
}

std::vector<Start> starts_of(const Scene& scene, std::size_t* skipped) {
  const OwnUnits units = own_units(scene);
  std::vector<Start> starts = own_starts(in_units(scene, units), skipped);
  for (Start& s : starts) {
    s.g_size = std::ldexp(s.g_size, static_cast<int>(units.momentum()));
    for (std::size_t i = 0; i < 3; ++i) {
      s.x.omega[i] = std::ldexp(s.x.omega[i], static_cast<int>(-units.time));
      s.x.gamma[i] = std::ldexp(s.x.gamma[i], static_cast<int>(units.vertical));
    }
  }
  return starts;
}

Section simulate(const Scene& scene, const SimulateOptions& options) {
  Section out;
  const OwnUnits units = own_units(scene);
  const Scene own = in_units(scene, units);
  const std::vector<Start> starts = own_starts(own, &out.skipped);
  check_points(scene, starts.size());
  const Body<double> body = own.body<double>();
  for (const Start& s : starts)
    out.orbits.push_back(begun(own, units, body, s));
  out.has_time = scene.time && scene.crossings < 0;
  run_in_arithmetic(own, units, options, starts, out);
  sort_points(out);
  for (const OrbitReport& r : out.orbits) {
    out.stopped = out.stopped || r.ended == Ended::stopped;
    out.drift = std::max({out.drift, r.drift[0], r.drift[1], r.drift[2]});
  }
  return out;
}

} // namespace kov::flow
