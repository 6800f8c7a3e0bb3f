// kovacic-systems DIRECTORY [SECONDS]: what accuracy costs for six systems that are read from files (DIRECTORY/*.toml),
// with our integrator in every arithmetic and with those of Boost.odeint.
//
// Each gets the same starts, the same section and the same times.  Boost.odeint gets the right-hand side as a person
// would write it, compiled for this machine.  Output, by system:
//   # SYSTEM: how many orbits and returns
//   cost SYSTEM METHOD tolerance microseconds drift error wrong
//   ratio SYSTEM METHOD drift median least greatest turns
//   growth SYSTEM return orbits median worst drift
// cost: processor time of a return;  drift: of the energy, relative;  error: the median over the orbits of the largest error
// of the first `compared` points (of all coordinates, relative to their scales), against a run in pairs of doubles;
// wrong: orbits with another number of returns.  ratio: their time over ours with the same drift, by turns in one
// process (ours, theirs, ours).  growth: in double with the tolerance 1e-14, how wrong the points of all orbits are at a
// return, in runs that are four times as long, and the drift until then.

#define KOV_ISA systems
#include "systems.hpp"
#include "flow/scene/section_sink.hpp"
#include "symbol/document.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <optional>

namespace kov::bench {
namespace {

using namespace kov::flow;

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// ---- what a run leaves ----

struct Seen {
  double seconds = 0, drift = 0;
  std::vector<long> returns; ///< of each orbit
  std::vector<std::vector<std::vector<BigReal>>>
      points;                      ///< the first of each orbit: all coordinates
  std::vector<double> drift_until; ///< each return, over all orbits
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
  Keep(const Stage& s, std::size_t orbits, std::size_t points)
      : SectionSink<R>(s, orbits), seen(orbits), points_(points),
        integrals_(s.field, values_of(s.integrals)), begun_(orbits) {}
  bool crossing(std::size_t orbit, const R&, const R* at, bool) override {
    if (!this->is_wanted(at)) return false;
    ++seen.returns[orbit];
    look(orbit, at);
    if (seen.points[orbit].size() >= points_) return true;
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
    const auto k = static_cast<std::size_t>(seen.returns[orbit]);
    if (seen.drift_until.size() <= k) seen.drift_until.resize(k + 1);
    if (!(change <= seen.drift_until[k])) seen.drift_until[k] = change;
  }
  void finished(std::size_t, const FieldFinish<R>&) override {}
  Seen seen;

private:
  std::size_t points_; ///< of each orbit that are kept
  Evaluator<R> integrals_;
  std::vector<std::optional<R>> begun_;
};

struct Effort {
  double microseconds = 0, drift = 0, error = 0;
  long wrong = 0;
};

constexpr std::array<const char*, 3> their_methods{"rkf78", "dopri5", "bulirsch-stoer"};

// A system, its orbits, and what they must do.
class Bench {
public:
  Bench(const std::string& directory, std::string name)
      : name_(std::move(name)), theirs_{theirs_plain(name_), theirs_inlined(name_)} {
    scene_ = read_system_scenes(read_document(directory + "/" + name_ + ".toml")).front();
    const Stage stage(scene_, nullptr);
    starts_ = stage.starts;
    time_ = scene_.time->as<double>();
    StartRefiner<double> refine(scene_, stage.field);
    for (const FieldStart& s : starts_) {
      x_.push_back(refine(s));
      x_.back().resize(stage.field.coordinates());
    }
    for (std::size_t i = 0; i < stage.field.coordinates(); ++i)
      scales_.push_back(1 / stage.per_scale[i]);
    for (const char* method : their_methods)
      choose(method);
    const PrecisionScope scope(140);
    reference_ = ours<Twin1>(31, 28, all_points);
    std::printf("# %s: %zu orbits, %ld returns\n", name_.c_str(), x_.size(), reference_->all());
  }

  // The same for a longer time.
  Bench(const Bench& b, double times) : Bench(b) { time_ *= times; }

  // ---- tables ----

  void costs(double seconds) {
    const PrecisionScope scope(bits_of(60));
    table(
        "double", [&](double d) { return ours<double>(0, d); }, {4, 6, 8, 10, 12, 14, 16}, seconds);
    table(
        "long-double", [&](double d) { return ours<long double>(19, d); }, {8, 12, 16, 18},
        seconds);
    table(
        "pairs", [&](double d) { return ours<Twin1>(31, d); }, {8, 14, 20, 24}, seconds);
    table(
        "mpfr", [&](double d) { return ours<BigReal>(40, d); }, {10, 18, 26}, 8 * seconds);
    for (const char* method : their_methods)
      table(
          method, [&](double d) { return of_theirs(method, d); }, {4, 6, 8, 10, 12, 14}, seconds);
  }

  void ratios(double seconds) {
    const Method mine = [&](double d) { return ours<double>(0, d); };
    for (const double drift : {1e-6, 1e-9, 1e-12}) {
      const double own = loosest(mine, drift, seconds);
      if (!(own > 0)) continue;
      for (const char* name : their_methods) {
        const Method method = [&](double d) { return of_theirs(name, d); };
        const double their = loosest(method, drift, seconds);
        std::vector<double> all;
        const double begun = cpu_seconds();
        while (their > 0 && all.size() < 15 &&
               (all.size() < 3 || cpu_seconds() - begun < seconds)) {
          const double before = mine(own).seconds, between = method(their).seconds,
                       after = mine(own).seconds;
          all.push_back(2 * between / (before + after));
        }
        std::ranges::sort(all);
        if (all.empty())
          std::printf("ratio %s %s %.0e - - - 0\n", name_.c_str(), name, drift);
        else
          std::printf("ratio %s %s %.0e %.3g %.3g %.3g %zu\n", name_.c_str(), name, drift,
                      all[all.size() / 2], all.front(), all.back(), all.size());
        std::fflush(stdout);
      }
    }
  }

  void growth() const {
    const PrecisionScope scope(140);
    const Bench longer(*this, 4);
    const Seen s = longer.ours<double>(0, 14, all_points),
               right = longer.ours<Twin1>(31, 28, all_points);
    double drift = 0;
    for (std::size_t k = 0;; ++k) {
      std::vector<double> errors;
      for (std::size_t i = 0; i < x_.size(); ++i)
        if (k < s.points[i].size() && k < right.points[i].size())
          errors.push_back(distance(s.points[i][k], right.points[i][k]));
      if (errors.size() < x_.size() || k + 1 >= s.drift_until.size()) break;
      std::ranges::sort(errors);
      drift = std::max({drift, s.drift_until[k], s.drift_until[k + 1]});
      std::printf("growth %s %zu %zu %.2e %.2e %.2e\n", name_.c_str(), k + 1, errors.size(),
                  errors[errors.size() / 2], errors.back(), drift);
    }
  }

private:
  using Method = std::function<Seen(double digits)>;
  static constexpr std::size_t all_points = 10000;

  template <class R>
  Seen ours(int digits, double of_tolerance, std::size_t points = compared) const {
    SystemScene scene = scene_;
    scene.digits = digits;
    char text[64];
    std::snprintf(text, sizeof text, "10^-%ld/%ld", static_cast<long>(of_tolerance),
                  std::lround(std::pow(10, of_tolerance - std::floor(of_tolerance))));
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
    Keep<R> keep(stage, starts_.size(), points);
    run.sink = &keep;
    const double begun = cpu_seconds();
    integrate_any(tapes.tapes(), run, 0);
    keep.seen.seconds = cpu_seconds() - begun;
    return keep.seen;
  }

  // The way in which a method is faster.
  void choose(const std::string& method) {
    std::array<double, 2> best{INFINITY, INFINITY};
    for (int turn = 0; turn < 3; ++turn)
      for (std::size_t way = 0; way < 2; ++way) {
        way_[method] = way;
        best[way] = std::min(best[way], of_theirs(method, 8).seconds);
      }
    way_[method] = best[1] < best[0] ? 1 : 0;
  }

  [[nodiscard]] Seen of_theirs(const std::string& method, double digits) const {
    const double begun = cpu_seconds();
    const Ran ran = theirs_.at(way_.at(method)).run(method, std::pow(10.0, -digits), x_, time_);
    Seen seen(x_.size());
    seen.seconds = cpu_seconds() - begun;
    seen.drift = ran.drift;
    seen.returns = ran.returns;
    for (std::size_t i = 0; i < x_.size(); ++i)
      for (const std::vector<double>& point : ran.points[i])
        seen.points[i].emplace_back(point.begin(), point.end());
    return seen;
  }

  [[nodiscard]] double distance(const std::vector<BigReal>& a,
                                const std::vector<BigReal>& b) const {
    double most = 0;
    for (std::size_t c = 0; c < a.size(); ++c)
      most = std::max(most, std::abs(to_double(a[c] - b[c])) / scales_[c]);
    return most;
  }

  [[nodiscard]] Effort effort(const Seen& s) const {
    Effort e{1e6 * s.seconds / static_cast<double>(std::max(1L, s.all())), s.drift, 0, 0};
    std::vector<double> errors;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      e.wrong += s.returns[i] != reference_->returns[i] ? 1 : 0;
      const auto &mine = s.points[i], &wanted = reference_->points[i];
      double worst = 0;
      for (std::size_t k = 0; k < std::min({mine.size(), wanted.size(), compared}); ++k)
        worst = std::max(worst, distance(mine[k], wanted[k]));
      errors.push_back(worst);
    }
    std::ranges::sort(errors);
    e.error = errors[errors.size() / 2];
    return e;
  }

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

  std::string name_;
  std::array<Theirs, 2> theirs_;
  std::map<std::string, std::size_t> way_; ///< of a method, in theirs_
  SystemScene scene_;
  std::vector<FieldStart> starts_;
  std::vector<std::vector<double>> x_;
  double time_ = 0;
  std::vector<double> scales_;
  std::optional<Seen> reference_;
};

} // namespace
} // namespace kov::bench

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "kovacic-systems DIRECTORY [SECONDS]\n");
    return 2;
  }
  const double seconds = argc > 2 ? std::atof(argv[2]) : 2;
  for (const char* name : {"henon_heiles", "three_degrees", "swinging_atwood", "restricted",
                           "double_pendulum", "sliding_top"}) {
    kov::bench::Bench bench(argv[1], name);
    bench.costs(seconds);
    bench.ratios(seconds);
    bench.growth();
  }
}
