#include "flow/scene/effort.hpp"

#include "flow/number/rounded.hpp"
#include "flow/scene/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace kov::flow {
namespace {

constexpr std::size_t kept_points = 10;

// Counts, and keeps the first points as they come.
template <class R> struct Counter : Sink<R> {
  std::vector<long> crossings;
  std::vector<std::vector<Crossing<R>>> points;
  std::vector<Finish<R>> ends;
  explicit Counter(std::size_t n) : crossings(n), points(n), ends(n) {}
  void crossing(const Crossing<R>& c) override {
    ++crossings[c.orbit];
    if (points[c.orbit].size() < kept_points) points[c.orbit].push_back(c);
  }
  void finished(std::size_t orbit, const Finish<R>& f) override { ends[orbit] = f; }
};

// The starts on the level, to the digits of R.
template <class R> std::vector<R> start_numbers(const Scene& s, std::size_t orbits) {
  const Body<BigReal> body = s.body<BigReal>();
  const Levels<BigReal> levels = s.levels<BigReal>();
  std::vector<R> numbers;
  for (const Start& start : starts_of(s)) {
    if (numbers.size() == 6 * orbits) break;
    const State<BigReal> x =
        refine_point(body, levels, s.section, BigReal(start.l), BigReal(start.y), start.g_size);
    for (const Vec<BigReal>& v : {x.omega, x.gamma})
      for (const BigReal& c : v)
        numbers.push_back(rounded<R>(c));
  }
  return numbers;
}

template <class R> struct Trial {
  Body<R> body;
  Effects effects;
  Model<R> model;
  Run<R> run;
  std::vector<R> numbers;
  int lanes = 0;

  Trial(const Scene& s, double log2_tolerance, std::size_t orbits)
      : body(s.body<R>()), effects(s.effects()), model(model_of(body, effects)),
        numbers(start_numbers<R>(s, orbits)) {
    run.section = s.section;
    run.t_end = s.time->as<R>();
    run.log2_tolerance = log2_tolerance - safety_bits;
    run.starts = numbers.data();
    run.orbits = numbers.size() / 6;
    const Body<double> plain = s.body<double>();
    const std::vector<double> rounded = start_numbers<double>(s, orbits);
    run.order = choose_order(effects, model_of(plain, effects), rounded.data(), run.orbits,
                             run.log2_tolerance);
  }
  Counter<R> operator()() {
    Counter<R> counter(run.orbits);
    run.sink = &counter;
    if constexpr (std::is_same_v<R, double> || std::is_same_v<R, Twin1>)
      integrate(effects, model, body.sliding, run, lanes);
    else
      integrate(effects, model, body.sliding, run);
    return counter;
  }
};

// (l, L/G) of the points that a run kept.
template <class R>
std::vector<std::array<BigReal, 2>> charted(const Scene& s,
                                            const std::vector<Crossing<R>>& points) {
  const Body<BigReal> body = s.body<BigReal>();
  std::vector<std::array<BigReal, 2>> out;
  for (const Crossing<R>& c : points) {
    State<BigReal> x;
    for (std::size_t i = 0; i < 3; ++i) {
      x.omega[i] = to_big(c.x[i]);
      x.gamma[i] = to_big(c.x[3 + i]);
    }
    const Andoyer<BigReal> a = andoyer_of(body, x, s.section.axis);
    out.push_back({a.l, a.y});
  }
  return out;
}

double distance(const std::array<BigReal, 2>& a, const std::array<BigReal, 2>& b) {
  const auto size = [](const BigReal& x) { return std::abs(static_cast<double>(x)); };
  const BigReal turn = BigReal(2) * pi_of(BigReal());
  const BigReal l = a[0] - b[0];
  return std::max(std::min({size(l), size(l - turn), size(l + turn)}), size(a[1] - b[1]));
}

template <class R>
void compare(Effort& e, const Scene& s, const Counter<R>& run, const Reference& reference) {
  const Levels<double> sizes = sizes_on_level(s.body<double>(), s.levels<double>());
  const double scale[] = {sizes.energy, sizes.length, sizes.casimir};
  for (std::size_t i = 0; i < run.ends.size(); ++i) {
    e.crossings += run.crossings[i];
    e.wrong += run.crossings[i] != reference.crossings.at(i) ? 1 : 0;
    for (int k = 0; k < 3; ++k)
      e.drift = std::max(e.drift, static_cast<double>(run.ends[i].drift[k]) / scale[k]);
    const auto points = charted(s, run.points[i]);
    const auto& wanted = reference.points.at(i);
    for (std::size_t n = 0; n < std::min(points.size(), wanted.size()); ++n)
      e.error = std::max(e.error, distance(points[n], wanted[n]));
  }
}

template <class R>
Effort measured(const Scene& s, int digits, std::size_t orbits, int lanes,
                const Reference& reference) {
  Effort e;
  e.tolerance = std::pow(10.0, -digits);
  e.seconds = INFINITY;
  Trial<R> trial(s, -digits * std::log2(10.0), orbits);
  trial.lanes = lanes;
  e.order = trial.run.order;
  for (int turn = 0; turn < 3 && (turn == 0 || e.seconds < 1); ++turn) {
    const std::clock_t begun = std::clock();
    const Counter<R> run = trial();
    e.seconds = std::min(e.seconds, static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
    if (turn == 0) compare(e, s, run, reference);
  }
  return e;
}

} // namespace

std::string to_string(Arithmetic a) {
  switch (a) {
  case Arithmetic::packs:
    return "double-" + std::to_string(best_lanes()) + "-lanes";
  case Arithmetic::one_lane:
    return "double-1-lane";
  case Arithmetic::extended:
    return "long-double";
  case Arithmetic::pairs:
    return "pairs-of-doubles";
  default:
    return "mpfr";
  }
}

Reference reference_of(const Scene& scene, int digits) {
  const PrecisionScope scope(bits_of(digits + 2));
  Reference out;
  const std::size_t all = starts_of(scene).size();
  Trial<Twin1> counting(scene, -28 * std::log2(10.0), all);
  out.crossings = counting().crossings;
  Trial<BigReal> precise(scene, -(digits - 3) * std::log2(10.0), all);
  precise.run.max_crossings = kept_points;
  for (const auto& points : precise().points)
    out.points.push_back(charted(scene, points));
  return out;
}

Effort measure(const Scene& scene, Arithmetic arithmetic, int digits, std::size_t orbits,
               const Reference& reference) {
  const PrecisionScope scope(bits_of(std::max(digits + 6, 42)));
  switch (arithmetic) {
  case Arithmetic::packs:
    return measured<double>(scene, digits, orbits, best_lanes(), reference);
  case Arithmetic::one_lane:
    return measured<double>(scene, digits, orbits, 1, reference);
  case Arithmetic::extended:
    return measured<long double>(scene, digits, orbits, 1, reference);
  case Arithmetic::pairs:
    return measured<Twin1>(scene, digits, orbits, 0, reference);
  default:
    return measured<BigReal>(scene, digits, orbits, 1, reference);
  }
}

} // namespace kov::flow
