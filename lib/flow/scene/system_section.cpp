#include "flow/scene/system_section.hpp"

#include "flow/scene/effects_needed.hpp"
#include "flow/scene/section_sink.hpp"
#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <mutex>

namespace kov::flow {
namespace {

double turned(double angle) {
  return angle - 2 * pi_of(0.0) * std::floor(angle / (2 * pi_of(0.0)) + 0.5);
}
BigReal turned(BigReal angle) {
  const BigReal turn = BigReal(2) * pi_of(angle), turns = angle / turn + BigReal(0.5);
  BigReal whole;
  mpfr_floor(whole.raw(), turns.raw());
  return angle - turn * whole;
}

// How much the constants of one orbit have changed, in units of the size of their terms there; of a constant that is 0,
// whose terms may vanish together, at least in a small unit of what they were up to then.
class OrbitDrift {
public:
  void note(std::size_t i, double change, double size, bool is_small) {
    if (i >= size_.size()) {
      size_.resize(i + 1, 0);
      drift_.resize(i + 1, 0);
      small_.resize(i + 1, is_small);
    }
    if (!std::isfinite(size)) return;
    size_[i] = std::max(size_[i], size);
    const double unit = std::max(size, small_[i] ? size_[i] * of_largest : 0);
    if (change > 0) drift_[i] = std::max(drift_[i], change / std::max(unit, 1e-300));
  }
  [[nodiscard]] double of(std::size_t i) const { return drift_[i]; }

private:
  static constexpr double of_largest = 0x1p-20;
  std::vector<double> size_, drift_;
  std::vector<bool> small_; ///< 0 at the start beside its terms
};

// The least size of a variable that counts in the size of a term, in units of its scale on this
// orbit: a variable that is only what rounding has left of 0 makes no size.
constexpr double least_of_scale = 0x1p-40;

template <class R> struct DrawnSink : SectionSink<R> {
  using SectionSink<R>::stage;
  std::size_t first;
  Evaluator<R> integrals;
  std::vector<TermSize> sizes;
  MeaningCheck<R> meanings;
  std::vector<std::vector<R>> begun; ///< of each orbit: its integrals
  std::vector<std::vector<double>>
      least; ///< of each orbit: what its variables are at least in the size of a term
  std::vector<OrbitDrift> changes;
  const double bound;                  ///< of the drift: what an orbit does beyond it is not drawn
  std::vector<double> worst;           ///< of each orbit: its drift
  std::vector<std::size_t> made, kept; ///< of each orbit: its points; those within the bound
  std::vector<DrawnPoint> points;
  std::vector<std::pair<std::size_t, DrawnOrbit>> orbits;
  std::vector<double> drifts, beyond; ///< within the bound; all
  int log2_time;                      ///< of the scene's unit

  std::vector<std::vector<RawPoint<R>>> raw;   ///< of each orbit, where errors are wanted
  std::vector<std::vector<std::size_t>> drawn; ///< and the places of its points

  DrawnSink(const Stage& s, std::size_t n, std::size_t count)
      : SectionSink<R>(s, count), first(n), integrals(s.field, values_of(s.integrals)),
        sizes(s.term_sizes), meanings(s.scene, s.field), begun(count), least(count), changes(count),
        bound(s.scene.drift.template as<double>()), worst(count), made(count), kept(count),
        drifts(s.integrals.size() + 1), beyond(drifts),
        log2_time(s.scene.body ? static_cast<int>(s.scene.body->units.time) : 0), raw(count),
        drawn(count) {
    if (s.scene.crossings > 0)
      points.reserve(
          std::min<std::size_t>(count * static_cast<std::size_t>(s.scene.crossings), 1 << 20));
  }

  bool crossing(std::size_t orbit, const R& t, const R* x, bool) override {
    if (!this->is_wanted(x)) return false;
    const auto at = this->point(orbit, t, x);
    if (!at) return true;
    DrawnPoint p{first + orbit, in_units(t), {to_double(at->at[0]), to_double(at->at[1])}, {}};
    for (std::size_t i = 0; i < 2; ++i)
      if (turns_back(i)) {
        const double angle = turned(p.at[i]);
        p.turns[i] = static_cast<float>(std::round((p.at[i] - angle) / (2 * pi_of(0.0))));
        p.at[i] = angle;
      }
    if constexpr (!std::is_same_v<R, double>)
      if (!stage.scene.return_map)
        p.digits = all_digits(*at, {digits_lost(p, 0), digits_lost(p, 1)});
    if (stage.scene.errors) {
      raw[orbit].push_back(*at);
      drawn[orbit].push_back(points.size());
    }
    points.push_back(std::move(p));
    ++made[orbit];
    return true;
  }

  /// Finds the errors from the points of a second run.
  void compare(const std::vector<std::vector<RawPoint<R>>>& second) {
    for (std::size_t orbit = 0; orbit < second.size(); ++orbit) {
      const auto errors = errors_of(compared(raw[orbit], second[orbit], stage.scene.angle),
                                    to_double(unit_roundoff<R>()));
      for (std::size_t i = 0; i < errors.size(); ++i) {
        DrawnPoint& p = points[drawn[orbit][i]];
        p.error = errors[i];
        for (std::size_t part = 0; part < 2; ++part)
          p.size[part] = static_cast<float>(stage.scene.angle[part] ? 1 : raw[orbit][i].size[part]);
      }
    }
  }

  void look(std::size_t orbit, const R* x) override {
    const std::vector<R>& now = integrals(x);
    const std::vector<double> at = this->doubles(x);
    if (begun[orbit].empty()) {
      begun[orbit] = now;
      const double unit = this->unit_[orbit] = stage.own_unit(at.data());
      for (const double scale : stage.scales.of)
        least[orbit].push_back(least_of_scale * unit * scale);
    }
    const double* smallest = least[orbit].data();
    for (std::size_t i = 0; i < now.size(); ++i)
      note(orbit, i, i, to_double(R(now[i] - begun[orbit][i])), sizes[i](at.data(), smallest),
           to_double(begun[orbit][i]));
    for (std::size_t i = 0; i < meanings.size(); ++i) {
      const std::size_t place = meanings.place(i);
      note(orbit, now.size() + i, now.size(), meanings.deviation(i, x),
           std::max(std::abs(at[place]), smallest[place] / least_of_scale), 0);
    }
    if (worst[orbit] <= bound) kept[orbit] = made[orbit];
  }

  void finished(std::size_t orbit, const FieldFinish<R>& f) override {
    DrawnOrbit o;
    o.crossings = f.crossings;
    o.steps = f.steps;
    o.tangencies = f.tangencies;
    o.hidden = f.hidden;
    o.time = in_units(f.t);
    o.drift = worst[orbit];
    o.indicators = f.indicators;
    o.ended = f.ended;
    if (o.drift > bound && f.ended != Ended::stopped) {
      o.ended = Ended::lost;
      o.indicators = {NAN, NAN, NAN, NAN};
    } else {
      kept[orbit] = made[orbit];
    }
    o.rest_from = in_units(f.rest_from);
    o.inside_from = in_units(f.inside_from);
    orbits.emplace_back(first + orbit, o);
  }

private:
  [[nodiscard]] double in_units(const R& t) const { return std::ldexp(to_double(t), log2_time); }
  // An angle that is drawn in [-pi, pi).
  [[nodiscard]] bool turns_back(std::size_t i) const {
    return stage.scene.angle[i] && !stage.scene.sphere;
  }
  // of: the function among all; shown: the drift that tells of it
  void note(std::size_t orbit, std::size_t of, std::size_t shown, double change, double size,
            double begun_with) {
    changes[orbit].note(of, std::abs(change), size, std::abs(begun_with) <= 0x1p-20 * size);
    const double drift = changes[orbit].of(of);
    worst[orbit] = std::max(worst[orbit], drift);
    beyond[shown] = std::max(beyond[shown], drift);
    if (worst[orbit] <= bound) drifts[shown] = std::max(drifts[shown], drift);
  }

  [[nodiscard]] std::string all_digits(const RawPoint<R>& p, const std::array<int, 2>& lost) const {
    const int n = digits_shown(stage.scene.tolerance, stage.scene.digits);
    BigReal t = to_big(p.t);
    mpfr_mul_2si(t.raw(), t.raw(), log2_time, MPFR_RNDN);
    std::string text = to_string(t, n);
    for (std::size_t i = 0; i < 2; ++i)
      text += " " + (turns_back(i) ? to_string(turned(to_big(p.at[i])), std::max(1, n - lost[i]))
                                   : to_string(to_big(p.at[i]), n));
    return text;
  }
};

// One worker: takes the next few orbits until none are left.
template <class R> struct SectionWork {
  const Stage& stage;
  const SystemSectionOptions& options;
  SystemSection& out;
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::mutex mutex{};

  void operator()() {
    const SystemScene& s = stage.scene;
    const PrecisionScope scope(bits_of(std::max(s.digits, 34)));
    const Tapes<R> tapes(stage.field, stage.order);
    StartRefiner<R> refine(s, stage.field);
    FieldRun<R> run = plan(tapes);
    std::vector<R> per_scale;
    for (const double x : stage.per_scale)
      per_scale.emplace_back(x);
    SectionSize section_size(stage);
    const std::array<R, 3> turn = turn_in_parts<R>();
    run.turn = turn.data();
    std::optional<SecondRun<R>> again;
    if (s.errors) again.emplace(stage);
    run.per_scale = per_scale.data();
    const std::size_t chunk = std::is_same_v<R, double> ? 64 : std::is_same_v<R, Twin1> ? 8 : 1;
    for (std::size_t first = next.fetch_add(chunk); first < stage.starts.size();
         first = next.fetch_add(chunk)) {
      if (options.stop != nullptr && options.stop->load()) return;
      const std::size_t last = std::min(stage.starts.size(), first + chunk);
      DrawnSink<R> sink(stage, first, last - first);
      std::vector<R> numbers, section_sizes;
      for (std::size_t i = first; i < last; ++i) {
        const std::vector<R> x = refine(stage.starts[i]);
        numbers.insert(numbers.end(), x.begin(), x.end());
        section_sizes.emplace_back(
            section_size(own_unit(x.data(), per_scale.data(), per_scale.size())));
      }
      run.starts = numbers.data();
      run.section_sizes = section_sizes.data();
      run.orbits = last - first;
      run.sink = &sink;
      integrate_any(tapes.tapes(), run, options.lanes);
      if (again) sink.compare((*again)(run, numbers, first, options.lanes));
      keep(sink);
    }
  }

  FieldRun<R> plan(const Tapes<R>& tapes) const {
    const SystemScene& s = stage.scene;
    FieldRun<R> run = stage.run(tapes);
    if (s.crossings <= 0)
      run.max_crossings = most_points / static_cast<long>(stage.starts.size()) + 1;
    // the more integrals, the fewer looks: to watch them costs no more than to watch one
    run.check_every = 16 * static_cast<int>(std::max<std::size_t>(1, stage.integrals.size()));
    run.sizes_at_crossings = s.errors;
    run.turning = stage.turning.data();
    run.turning_count = stage.turning.size();
    run.stop = options.stop;
    run.native = options.native;
    return run;
  }

  void keep(DrawnSink<R>& sink) {
    const std::lock_guard lock(mutex);
    for (DrawnPoint& p : sink.points) { // an orbit ends where its drift leaves the bound
      std::size_t& left = sink.kept[p.orbit - sink.first];
      if (left == 0) continue;
      --left;
      out.points.push_back(std::move(p));
    }
    for (const auto& [orbit, o] : sink.orbits) {
      const DrawnOrbit begun = std::exchange(out.orbits[orbit], o);
      out.orbits[orbit].start = begun.start;
      out.orbits[orbit].sign = begun.sign;
    }
    for (std::size_t i = 0; i < out.drifts.size(); ++i) {
      out.drifts[i] = std::max(out.drifts[i], sink.drifts[i]);
      out.beyond[i] = std::max(out.beyond[i], sink.beyond[i]);
    }
    done += sink.orbits.size();
    if (options.progress) options.progress(done, stage.starts.size());
    if (options.finished_some) options.finished_some(out);
  }
};

template <class R>
void run_all(const Stage& stage, const SystemSectionOptions& o, SystemSection& out) {
  SectionWork<R> work{stage, o, out};
  in_threads(o.threads, work);
}

void run_in_arithmetic(const Stage& stage, const SystemSectionOptions& o, SystemSection& out) {
  const int digits = stage.scene.digits;
  if (digits == 0) {
    out.arithmetic = "double";
    run_all<double>(stage, o, out);
  } else if (digits <= 19) {
    out.arithmetic = "long double";
    run_all<long double>(stage, o, out);
  } else if (digits <= 31) {
    out.arithmetic = "pairs of doubles";
    run_all<Twin1>(stage, o, out);
  } else {
    out.arithmetic = "MPFR, " + std::to_string(bits_of(digits)) + " bits";
    run_all<BigReal>(stage, o, out);
  }
}

// Refuses what would not fit into the memory.
void check_points(const SystemScene& s, std::size_t orbits) {
  if (s.crossings > 0 && s.crossings > most_points / static_cast<long>(orbits))
    throw InputError(s.file, 0, 0, 1,
                     std::to_string(orbits) + " orbits with " + std::to_string(s.crossings) +
                         " crossings each are more than " + std::to_string(most_points) + " points",
                     "fewer orbits, or fewer crossings");
}

} // namespace

int digits_shown(const Quantity& tolerance, int digits) {
  const double n = -log2_estimate(tolerance.as<BigReal>()) * std::log10(2.0);
  return std::clamp(static_cast<int>(n + 1.5), 6, digits > 0 ? digits : 17);
}

int digits_lost(const DrawnPoint& p, std::size_t part) {
  const double turns = std::abs(p.turns[part]);
  return turns > 0 && std::isfinite(turns) ? static_cast<int>(std::ceil(std::log10(2 * turns))) : 0;
}

std::size_t SystemSection::count(Ended how) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(orbits, [&](const DrawnOrbit& o) { return o.ended == how; }));
}

std::size_t SystemSection::cut_short() const {
  return count(Ended::steps) + (has_time ? count(Ended::crossings) : 0);
}

PointAccuracy accuracy_of(const SystemSection& s) {
  PointAccuracy a;
  double worst = 0;
  for (const DrawnPoint& p : s.points) {
    if (p.error < 0) return {};
    a.known = true;
    worst = std::max(worst, p.error);
    a.doubtful += p.error > visible_error ? 1 : 0;
  }
  if (worst <= a.bound) a.bound = worst;
  const auto count = [&] {
    std::vector<std::size_t> right(s.orbits.size(), 0), all(s.orbits.size(), 0);
    for (const DrawnPoint& p : s.points) {
      right[p.orbit] += right[p.orbit] == all[p.orbit] && p.error <= a.bound ? 1 : 0;
      ++all[p.orbit];
    }
    a.whole = 0;
    a.returns = s.points.size();
    for (std::size_t i = 0; i < all.size(); ++i)
      if (right[i] == all[i])
        ++a.whole;
      else
        a.returns = std::min(a.returns, right[i]);
  };
  count();
  if (a.returns == 0 && a.whole < s.orbits.size()) {
    a.bound = visible_error;
    count();
  }
  return a;
}

namespace {

// The section at one value of the parameter joins those at the values before.
void join(SystemSection& all, SystemSection&& one, double value) {
  for (DrawnPoint& p : one.points) {
    p.orbit += all.orbits.size();
    p.at = {value, p.at[0]};
    p.digits.clear();
    all.points.push_back(std::move(p));
  }
  for (DrawnOrbit& o : one.orbits) {
    o.start[0] = value;
    all.orbits.push_back(o);
  }
  if (all.integrals.empty()) all.integrals = one.integrals;
  all.drifts.resize(all.integrals.size());
  for (std::size_t i = 0; i < std::min(all.drifts.size(), one.drifts.size()); ++i)
    all.drifts[i] = std::max(all.drifts[i], one.drifts[i]);
  all.drift = std::max(all.drift, one.drift);
  all.order = std::max(all.order, one.order);
  all.products = one.products;
  all.arithmetic = one.arithmetic;
  all.stopped = all.stopped || one.stopped;
  all.has_time = one.has_time;
}

SystemSection simulate_family(const SystemScene& scene, const SystemSectionOptions& options) {
  const std::size_t values = scene.family.size();
  check_points(scene, scene.states.size() * values);
  SystemSectionOptions each = options;
  each.progress = {};
  each.finished_some = {};
  SystemSection all;
  for (std::size_t i = 0; i < values && !all.stopped; ++i) {
    const SystemScene& one = scene.family[i];
    join(all, simulate(one, each), one.value.as<double>());
    if (options.progress) options.progress(i + 1, values);
  }
  return all;
}

// The orbits whose section was lost in rounding (the terms of a polynomial may be far larger than
// its values).
std::vector<std::size_t> hiding(const SystemSection& s, double most_steps) {
  std::vector<std::size_t> which;
  double steps = 0;
  for (std::size_t i = 0; i < s.orbits.size(); ++i) {
    const DrawnOrbit& o = s.orbits[i];
    if (o.hidden == 0 || o.ended == Ended::stopped) continue;
    which.push_back(i);
    steps += static_cast<double>(o.steps);
  }
  if (steps > most_steps) which.clear();
  return which;
}

void replace(SystemSection& out, SystemSection& fine, const std::vector<std::size_t>& which) {
  std::vector<bool> replaced(out.orbits.size());
  for (std::size_t i = 0; i < which.size(); ++i) {
    replaced[which[i]] = true;
    fine.orbits[i].start = out.orbits[which[i]].start;
    fine.orbits[i].sign = out.orbits[which[i]].sign;
    out.orbits[which[i]] = fine.orbits[i];
  }
  std::erase_if(out.points, [&](const DrawnPoint& p) { return replaced[p.orbit]; });
  for (DrawnPoint& p : fine.points) {
    p.orbit = which[p.orbit];
    p.digits.clear();
    out.points.push_back(std::move(p));
  }
}

// Once more, with more digits.
void look_again(const SystemScene& scene, const Stage& stage, const SystemSectionOptions& options,
                SystemSection& out) {
  if (scene.digits > 0) return;
  struct Again {
    int digits;
    const char* tolerance;
    double most_steps;
  };
  for (const auto& [digits, tolerance, most_steps] :
       {Again{31, "10^-28", 3e6}, Again{60, "10^-56", 3e4}}) {
    const std::vector<std::size_t> which = hiding(out, most_steps);
    if (which.empty()) return;
    SystemScene finer = scene;
    finer.digits = digits;
    finer.tolerance = tolerance; // of the largest terms of the section, too
    const std::unique_ptr<Stage> again = staged(finer, options.stop, [&](const Field&) {
      std::vector<FieldStart> starts;
      for (const std::size_t i : which)
        starts.push_back(stage.starts[i]);
      return starts;
    });
    SystemSection fine;
    fine.orbits.resize(which.size());
    fine.drifts = fine.beyond = std::vector<double>(out.drifts.size(), 0);
    SystemSectionOptions quiet = options;
    quiet.progress = {};
    quiet.finished_some = {};
    run_in_arithmetic(*again, quiet, fine);
    if (options.stop != nullptr && options.stop->load()) return;
    replace(out, fine, which);
    out.again = std::max(out.again, which.size());
    out.digits_again = digits;
  }
}

bool ends_early(const DrawnOrbit& o) {
  return o.ended == Ended::singular || o.ended == Ended::broken || o.ended == Ended::escaped ||
         o.ended == Ended::lost || o.ended == Ended::stopped;
}

void add_spectra(const Stage& stage, const SystemSectionOptions& options, SystemSection& out) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    SpectrumRun run(stage, static_cast<std::size_t>(stage.scene.exponents));
    for (std::size_t i = next.fetch_add(1); i < out.orbits.size(); i = next.fetch_add(1))
      if (DrawnOrbit& o = out.orbits[i]; !ends_early(o))
        o.spectrum = run(i, o.time, o.steps, options.stop);
  };
  in_threads(options.threads, work);
}

// The points of an orbit are in the order of time.
void sort_by_orbit(std::vector<DrawnPoint>& points, std::size_t orbits) {
  std::vector<std::size_t> place(orbits + 1, 0);
  for (const DrawnPoint& p : points)
    ++place[p.orbit + 1];
  for (std::size_t i = 0; i < orbits; ++i)
    place[i + 1] += place[i];
  std::vector<DrawnPoint> sorted(points.size());
  for (DrawnPoint& p : points)
    sorted[place[p.orbit]++] = std::move(p);
  points = std::move(sorted);
}

void add_signs(const Stage& stage, SystemSection& out) {
  Evaluator<double> form(stage.field, {*stage.scene.sign_of});
  StartRefiner<double> refine(stage.scene, stage.field);
  for (std::size_t i = 0; i < out.orbits.size(); ++i)
    out.orbits[i].sign = form(refine(stage.starts[i]).data())[0] > 0 ? 1 : -1;
}

void add_winding(const SystemScene& scene, SystemSection& out) {
  std::vector<std::array<double, 2>> one;
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    const DrawnPoint& p = out.points[i];
    one.push_back(p.at);
    for (std::size_t part = 0; part < 2; ++part)
      one.back()[part] += 2 * pi_of(0.0) * static_cast<double>(p.turns[part]);
    if (i + 1 < out.points.size() && out.points[i + 1].orbit == p.orbit) continue;
    out.orbits[p.orbit].winding = winding_of(one, scene.angle);
    one.clear();
  }
}

} // namespace

SystemSection simulate(const SystemScene& scene, const SystemSectionOptions& options) {
  if (!scene.family.empty()) return simulate_family(scene, options);
  const SystemScene needed = without_idle_coordinates(scene);
  const std::unique_ptr<Stage> made = staged(needed, options.stop);
  const Stage& stage = *made;
  SystemSection out;
  check_points(scene, stage.starts.size());
  for (const FieldStart& start : stage.starts)
    out.orbits.emplace_back().start = start.drawn;
  if (needed.sign_of) add_signs(stage, out);
  for (const SceneFormula& f : stage.integrals)
    out.integrals.push_back(f.text);
  if (stage.field.variables().size() > stage.field.coordinates())
    out.integrals.emplace_back("functions");
  out.drifts = out.beyond = std::vector<double>(stage.integrals.size() + 1, 0);
  out.skipped = stage.skipped;
  out.order = stage.order;
  out.products = stage.field.cost();
  out.has_time = scene.time && scene.crossings < 0;
  if (scene.crossings > 0)
    out.points.reserve(stage.starts.size() * static_cast<std::size_t>(scene.crossings));
  const std::clock_t begun = std::clock();
  run_in_arithmetic(stage, options, out);
  out.seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  look_again(needed, stage, options, out);
  sort_by_orbit(out.points, out.orbits.size());
  if (scene.exponents > 0) add_spectra(stage, options, out);
  if (scene.winding && !scene.return_map) add_winding(scene, out);
  if (out.count(Ended::lost) == out.orbits.size()) out.drifts = out.beyond; // nothing is right
  out.drift = *std::ranges::max_element(out.drifts);
  out.stopped = out.count(Ended::stopped) > 0;
  out.drifts.resize(out.integrals.size());
  return out;
}

} // namespace kov::flow
