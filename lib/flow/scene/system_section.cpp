#include "flow/scene/system_section.hpp"

#include "exact/error.hpp"
#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <thread>

namespace kov::flow {
namespace {

// A time that no orbit reaches, whose products do not overflow.
constexpr double forever = 1e150;

std::vector<MFraction> values_of(const std::vector<SceneFormula>& formulas) {
  std::vector<MFraction> all;
  for (const SceneFormula& f : formulas)
    all.push_back(f.value);
  return all;
}

// All that a run asks of the variables.
std::vector<MFraction> needed_by(const SystemScene& s, const std::vector<SceneFormula>& integrals) {
  std::vector<MFraction> all = values_of(s.start);
  for (const SceneFormula& f : integrals)
    all.push_back(f.value);
  for (const auto& level : s.levels)
    all.push_back(level.function.value);
  for (const SceneFormula& f : s.plot)
    all.push_back(f.value);
  if (s.where) all.push_back(s.where->value);
  all.push_back(lie_derivative(s.system.field, s.section.value));
  return all;
}

// Changes its sign where the section N/D does: the factors of N and of D with odd exponents.  Its series passes the
// poles, which crosses_a_zero tells from zeros; where the section only touches 0 it has none.
MFraction sign_changes_of(const MFraction& section) {
  MFraction all(section.ring(), Rational(1));
  for (const MPoly& part : {section.num(), section.den()}) {
    const auto [content, factors] = factor(part);
    if (content < Integer(0)) all = -all;
    for (const MFactor& f : factors)
      if (f.exponent % 2 != 0) all = all * MFraction(f.base);
  }
  return all;
}

MFraction crossed_in(const SystemScene& s) {
  MFraction f = sign_changes_of(s.section.value);
  if (is_constant(f))
    throw InputError(s.file, 0, 0, 1,
                     "the section " + s.section.text +
                         " never changes its sign: it is not crossed");
  return f;
}

// What rounding may make of a section function: units of its terms, and of those of the rates of its variables.
class SectionNoise {
public:
  SectionNoise(const Field& f, const System& s, const MFraction& section) : size_(f, section) {
    for (std::size_t i = 0; i < f.variables().size(); ++i) {
      const std::size_t v = f.variables()[i];
      const MFraction slope = derivative(section, v);
      if (is_zero(slope)) continue;
      const MFraction rate = i < f.coordinates()
                                 ? s.field.components[i]
                                 : lie_derivative(s.field, MFraction::variable(s.ring(), v));
      by_rates_.push_back({TermSize(f, slope), TermSize(f, rate)});
    }
  }
  // In units of 16 unit roundoffs.
  double operator()(const double* sizes, double step) {
    double sum = size_(sizes);
    for (auto& [slope, rate] : by_rates_)
      if (const double one = slope(sizes) * rate(sizes) * step; std::isfinite(one)) sum += one;
    return sum;
  }

private:
  struct ByRate {
    TermSize slope, rate;
  };
  TermSize size_;
  std::vector<ByRate> by_rates_;
};

// What all orbits and all arithmetics share.
struct Stage {
  const SystemScene& scene;
  std::vector<SceneFormula> integrals;
  Field field;
  std::size_t skipped = 0;
  std::vector<FieldStart> starts;
  Scales scales;
  std::vector<double> per_scale;    ///< 1/scale of every variable: powers of 2
  std::vector<TermSize> term_sizes; ///< of the integrals, then of the section
  std::optional<SectionNoise> section_noise;
  double section_size = 1;            ///< the largest that was seen
  std::array<double, 2> part_sizes{}; ///< of the section's numerator and denominator
  int order = 20;

  Stage(const SystemScene& s, const std::atomic<bool>* stop)
      : scene(s), integrals(s.integrals()), field(s.system, crossed_in(s), needed_by(s, integrals),
                                                  s.values, s.indicator != Indicator::none),
        starts(starts_of(s, field, &skipped, stop)) {
    const std::size_t n = field.variables().size();
    std::vector<double> all;
    StartRefiner<double> refine(s, field);
    for (const FieldStart& start : starts) {
      if (stop != nullptr && stop->load() && !all.empty()) break;
      const auto x = refine(start);
      all.insert(all.end(), x.begin(), x.begin() + static_cast<long>(n));
    }
    scales = scales_of(field, all, s.time ? s.time->as<double>() : forever);
    scales.path.insert(scales.path.end(), all.begin(), all.end());
    measure();
    check_relations(all);
    order = flow::choose_order(field, scales, log2_tolerance());
    for (const double scale : scales.of)
      per_scale.push_back(1 / scale);
  }

  // How much smaller than the others the orbit from x is.
  [[nodiscard]] double own_unit(const double* x) const {
    return flow::own_unit(x, per_scale.data(), per_scale.size());
  }

  [[nodiscard]] double log2_tolerance() const {
    return log2_estimate(scene.tolerance.as<BigReal>()) - safety_bits;
  }

private:
  // The size of a function: that of its terms, at most, on what a few orbits have shown.
  void measure() {
    std::vector<MFraction> functions = values_of(integrals);
    functions.push_back(sign_changes_of(scene.section.value));
    for (const MFraction& f : functions)
      term_sizes.emplace_back(field, f);
    section_size = largest(term_sizes.back());
    section_noise.emplace(field, scene.system, functions.back());
    const MFraction& f = scene.section.value;
    for (std::size_t i = 0; i < 2; ++i) {
      TermSize part(field, MFraction(i == 0 ? f.num() : f.den()));
      part_sizes[i] = largest(part);
    }
  }

  double largest(TermSize& size) const {
    const std::size_t n = field.variables().size(), states = scales.path.size() / n;
    double most = 1e-300;
    for (std::size_t state = 0; state < states; state += states / most_states + 1)
      if (const double now = size(&scales.path[state * n]); std::isfinite(now))
        most = std::max(most, now);
    return most;
  }

  // A relation that does not hold at the start holds nowhere.
  void check_relations(const std::vector<double>& all) {
    const std::size_t n = field.variables().size();
    for (const MPoly& relation : scene.system.field.relations) {
      Evaluator<double> value(field, {MFraction(relation)});
      TermSize size(field, MFraction(relation));
      for (std::size_t i = 0; i < all.size() && i < most_states * n; i += n)
        if (std::abs(value(&all[i])[0]) > 1e-6 * size(&all[i]))
          throw InputError(scene.file, 0, 0, 1,
                           "the relation " + kov::to_string(relation) +
                               " = 0 does not hold at a start",
                           "a value in 'set' contradicts it, or what 'means' says of a function");
    }
  }

  static constexpr std::size_t most_states = 1000;
};

double turned(double angle) {
  return angle - 2 * pi_of(0.0) * std::floor(angle / (2 * pi_of(0.0)) + 0.5);
}
BigReal turned(BigReal angle) {
  const BigReal turn = BigReal(2) * pi_of(angle), turns = angle / turn + BigReal(0.5);
  BigReal whole;
  mpfr_floor(whole.raw(), turns.raw());
  return angle - turn * whole;
}

// How much the constants of one orbit have changed, in units of the size of their terms on this orbit.  Terms and
// changes are the largest up to now; nothing is told of the start alone, where terms may vanish that do not later.
class OrbitDrift {
public:
  void note(std::size_t i, double change, double size) {
    if (i >= change_.size()) {
      change_.resize(i + 1, 0);
      size_.resize(i + 1, 1e-300);
      looks_.resize(i + 1, 0);
    }
    if (std::isfinite(size)) size_[i] = std::max(size_[i], size);
    change_[i] = std::max(change_[i], change);
    ++looks_[i];
  }
  [[nodiscard]] double of(std::size_t i) const { return looks_[i] > 1 ? change_[i] / size_[i] : 0; }

private:
  std::vector<double> change_, size_;
  std::vector<long> looks_;
};

// What a variable is at least in the size of a term, in units of its scale on this orbit: a variable that is only
// what rounding has left of 0 makes no size.
constexpr double least_of_scale = 0x1p-40;

template <class R> struct DrawnSink : FieldSink<R> {
  const Stage& stage;
  std::size_t first;
  Evaluator<R> drawn, where, integrals, fraction; ///< fraction: of the section
  std::vector<TermSize> sizes;
  std::optional<SectionNoise> noise; ///< where it was needed
  MeaningCheck meanings;
  std::vector<double> before;        ///< of each orbit: what was drawn last, for a return map
  std::vector<long> seen;            ///< crossings of each orbit, with those that are skipped
  std::vector<std::vector<R>> begun; ///< of each orbit: its integrals
  std::vector<std::vector<double>>
      least; ///< of each orbit: what its variables are at least in the size of a term
  std::vector<OrbitDrift> changes;
  std::vector<double> worst; ///< of each orbit: its drift
  std::vector<DrawnPoint> points;
  std::vector<std::pair<std::size_t, DrawnOrbit>> orbits;
  std::vector<double> drifts;

  DrawnSink(const Stage& s, std::size_t n, std::size_t count)
      : stage(s), first(n), drawn(s.field, {s.scene.plot[0].value, s.scene.plot[1].value}),
        where(s.field,
              s.scene.where ? std::vector{s.scene.where->value} : std::vector<MFraction>{}),
        integrals(s.field, values_of(s.integrals)), fraction(s.field, parts_of(s)),
        sizes(s.term_sizes), meanings(s.scene, s.field), before(count), seen(count), begun(count),
        least(count), changes(count), worst(count), drifts(s.integrals.size() + 1) {}

  bool crossing(std::size_t orbit, const R& t, const R* x, bool) override {
    if (!is_constant(stage.scene.section.value.den()) && !crosses_a_zero(x)) return false;
    if (stage.scene.where && !(where(x)[0] > R(0))) return false;
    if (++seen[orbit] <= stage.scene.skip) return true;
    const auto& at = drawn(x);
    DrawnPoint p{first + orbit, to_double(t), {to_double(at[0]), to_double(at[1])}, {}};
    for (std::size_t i = 0; i < 2; ++i)
      if (stage.scene.angle[i]) p.at[i] = turned(p.at[i]);
    if constexpr (!std::is_same_v<R, double>)
      if (!stage.scene.return_map) p.digits = all_digits(t, at);
    if (stage.scene.return_map) {
      const bool first_one = seen[orbit] == stage.scene.skip + 1;
      p.at[0] = std::exchange(before[orbit], p.at[1]);
      if (first_one) return true;
    }
    points.push_back(std::move(p));
    return true;
  }

  R section_noise(const R* of_variables, const R& step) override {
    if (!noise) noise = stage.section_noise;
    const std::vector<double> at = doubles(of_variables);
    return R((*noise)(at.data(), to_double(step))) * (unit_roundoff<R>() * R(16));
  }

  void look(std::size_t orbit, const R* x) override {
    const std::vector<R>& now = integrals(x);
    const std::vector<double> at = doubles(x);
    if (begun[orbit].empty()) {
      begun[orbit] = now;
      const double unit = stage.own_unit(at.data());
      for (const double scale : stage.scales.of)
        least[orbit].push_back(least_of_scale * unit * scale);
    }
    const double* smallest = least[orbit].data();
    for (std::size_t i = 0; i < now.size(); ++i)
      note(orbit, i, i, std::abs(to_double(R(now[i] - begun[orbit][i]))),
           sizes[i](at.data(), smallest));
    for (std::size_t i = 0; i < meanings.size(); ++i) {
      const std::size_t place = meanings.place(i);
      note(orbit, now.size() + i, now.size(), meanings.deviation(i, at.data()),
           std::max(std::abs(at[place]), smallest[place] / least_of_scale));
    }
  }

  void finished(std::size_t orbit, const FieldFinish<R>& f) override {
    DrawnOrbit o;
    o.crossings = f.crossings;
    o.steps = f.steps;
    o.tangencies = f.tangencies;
    o.time = to_double(f.t);
    o.drift = worst[orbit];
    o.indicators = f.indicators;
    o.ended = f.ended;
    o.rest_from = to_double(f.rest_from);
    o.inside_from = to_double(f.inside_from);
    orbits.emplace_back(first + orbit, o);
  }

private:
  // of: the function among all; shown: the drift that tells of it
  void note(std::size_t orbit, std::size_t of, std::size_t shown, double change, double size) {
    changes[orbit].note(of, change, size);
    const double drift = changes[orbit].of(of);
    worst[orbit] = std::max(worst[orbit], drift);
    drifts[shown] = std::max(drifts[shown], drift);
  }

  [[nodiscard]] std::vector<double> doubles(const R* x) const {
    std::vector<double> all;
    for (std::size_t i = 0; i < stage.field.variables().size(); ++i)
      all.push_back(to_double(x[i]));
    return all;
  }

  static std::vector<MFraction> parts_of(const Stage& s) {
    const MFraction& f = s.scene.section.value;
    return {MFraction(f.num()), MFraction(f.den())};
  }

  // Of N/D, at a zero of N D: is it N that is 0?
  [[nodiscard]] bool crosses_a_zero(const R* x) {
    const std::vector<R>& parts = fraction(x);
    return std::abs(to_double(parts[0])) / stage.part_sizes[0] <
           std::abs(to_double(parts[1])) / stage.part_sizes[1];
  }

  [[nodiscard]] std::string all_digits(const R& t, const std::vector<R>& at) const {
    const int n = digits_shown(stage.scene.tolerance, stage.scene.digits);
    std::string text = to_string(to_big(t), n);
    for (std::size_t i = 0; i < 2; ++i)
      text += " " + to_string(stage.scene.angle[i] ? turned(to_big(at[i])) : to_big(at[i]), n);
    return text;
  }
};

// The size of the section on an orbit that is smaller than the others by the factor `unit`.
class SectionSize {
public:
  explicit SectionSize(const Stage& s) : stage_(s), size_(s.term_sizes.back()) {}
  double operator()(double unit) {
    if (unit == 1) return stage_.section_size;
    std::vector<double> x;
    for (const double scale : stage_.scales.of)
      x.push_back(unit * scale);
    return std::max(1e-300, std::min(stage_.section_size, size_(x.data())));
  }

private:
  const Stage& stage_;
  TermSize size_;
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
      if constexpr (std::is_same_v<R, double>)
        integrate_field(tapes.tapes(), run, options.lanes);
      else
        integrate_field(tapes.tapes(), run);
      keep(sink);
    }
  }

  FieldRun<R> plan(const Tapes<R>& tapes) const {
    const SystemScene& s = stage.scene;
    FieldRun<R> run;
    run.log2_tolerance = stage.log2_tolerance();
    run.order = stage.order;
    run.t_end = s.time ? s.time->as<R>() : R(forever);
    run.max_crossings = s.crossings > 0 ? s.crossings + s.skip
                                        : most_points / static_cast<long>(stage.starts.size()) + 1;
    run.max_steps = s.time ? -1 : least_steps + steps_for_crossing * (s.crossings + s.skip);
    run.idle_ends = !s.time;
    run.falling = s.falling;
    run.rising = s.rising;
    run.values = tapes.values();
    run.stop = options.stop;
    return run;
  }

  void keep(const DrawnSink<R>& sink) {
    const std::lock_guard lock(mutex);
    out.points.insert(out.points.end(), sink.points.begin(), sink.points.end());
    for (const auto& [orbit, o] : sink.orbits) {
      const auto start = out.orbits[orbit].start;
      out.orbits[orbit] = o;
      out.orbits[orbit].start = start;
    }
    for (std::size_t i = 0; i < out.drifts.size(); ++i)
      out.drifts[i] = std::max(out.drifts[i], sink.drifts[i]);
    done += sink.orbits.size();
    if (options.progress) options.progress(done, stage.starts.size());
    if (options.finished_some) options.finished_some(out);
  }
};

template <class R>
void run_all(const Stage& stage, const SystemSectionOptions& o, SystemSection& out) {
  SectionWork<R> work{stage, o, out};
  std::vector<std::jthread> threads;
  for (int i = 1; i < o.threads; ++i)
    threads.emplace_back([&work] { work(); });
  work();
}

void run_in_arithmetic(const Stage& stage, const SystemSectionOptions& o, SystemSection& out) {
  const int digits = stage.scene.digits;
  if (digits == 0) {
    const int lanes = o.lanes == 0 ? best_lanes() : o.lanes;
    out.arithmetic = "double, " + to_string(best_isa()) + ", " + std::to_string(lanes) +
                     (lanes == 1 ? " lane" : " lanes");
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

Stage staged(const SystemScene& s, const std::atomic<bool>* stop) {
  try {
    return {s, stop};
  } catch (const InputError&) {
    throw;
  } catch (const OutOfBudget& e) {
    throw InputError(s.file, 0, 0, 1, e.what());
  } catch (const InvalidArgument& e) {
    throw InputError(s.file, 0, 0, 1, e.what());
  } catch (const DomainError& e) {
    throw InputError(s.file, 0, 0, 1, e.what());
  }
}

} // namespace

std::size_t SystemSection::count(Ended how) const {
  return static_cast<std::size_t>(std::count_if(
      orbits.begin(), orbits.end(), [&](const DrawnOrbit& o) { return o.ended == how; }));
}

std::size_t SystemSection::cut_short() const {
  return count(Ended::steps) + (has_time ? count(Ended::crossings) : 0);
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

} // namespace

SystemSection simulate(const SystemScene& scene, const SystemSectionOptions& options) {
  if (!scene.family.empty()) return simulate_family(scene, options);
  const Stage stage = staged(scene, options.stop);
  SystemSection out;
  check_points(scene, stage.starts.size());
  for (const FieldStart& start : stage.starts)
    out.orbits.emplace_back().start = start.drawn;
  for (const SceneFormula& f : stage.integrals)
    out.integrals.push_back(f.text);
  if (stage.field.variables().size() > stage.field.coordinates())
    out.integrals.emplace_back("functions");
  out.drifts.assign(stage.integrals.size() + 1, 0);
  out.skipped = stage.skipped;
  out.order = stage.order;
  out.products = stage.field.cost();
  out.has_time = scene.time && scene.crossings < 0;
  run_in_arithmetic(stage, options, out);
  std::stable_sort(out.points.begin(), out.points.end(), [](const auto& a, const auto& b) {
    return a.orbit != b.orbit ? a.orbit < b.orbit : a.t < b.t;
  });
  out.drift = *std::max_element(out.drifts.begin(), out.drifts.end());
  out.stopped = out.count(Ended::stopped) > 0;
  out.drifts.resize(out.integrals.size());
  return out;
}

} // namespace kov::flow
