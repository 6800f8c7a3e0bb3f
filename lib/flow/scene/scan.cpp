#include "flow/scene/scan.hpp"

#include "exact/joined.hpp"
#include "flow/scene/section_sink.hpp"
#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace kov::flow {

double scanned_value(const ScanAxis& axis, std::size_t i) {
  const double from = axis.from.as<double>(), to = axis.to.as<double>();
  return from + (to - from) * (static_cast<double>(i) + 0.5) / static_cast<double>(axis.count);
}

std::size_t cells_of(const Scan& scan) {
  std::size_t all = 1;
  for (const ScanAxis& axis : scan.axes)
    all *= axis.count;
  return all;
}

namespace {

constexpr std::size_t sample_side = 16; // starts of which the scales and the order are taken
constexpr int looks_every = 256;        // steps

// The numbers of one cell, by axis.
std::array<double, 2> place_of(const Scan& scan, std::size_t cell) {
  std::array<double, 2> at{};
  for (std::size_t i = 0; i < scan.axes.size(); ++i) {
    at[i] = scanned_value(scan.axes[i], cell % scan.axes[i].count);
    cell /= scan.axes[i].count;
  }
  return at;
}

bool is_over(const Scan& scan, ScanAxis::Kind kind) {
  return std::ranges::any_of(scan.axes, [&](const ScanAxis& a) { return a.kind == kind; });
}

// The orbits that start in a cell, and the numbers of the field there.
class CellStarts {
public:
  CellStarts(const SystemScene& s, const Field& f) : s_(s), f_(f) {
    for (const std::size_t variable : f.numbers())
      base_.push_back(s.values.at(variable).as<double>());
    numbers_ = base_;
    if (s.states.empty()) places_ = std::make_unique<Places>(s, f);
  }
  /// The numbers for the parameters.
  [[nodiscard]] const std::vector<double>& numbers() const { return numbers_; }

  std::vector<FieldStart> operator()(std::size_t cell) {
    const auto at = place_of(*s_.scan, cell);
    FieldStart start;
    start.given = places_ == nullptr;
    if (start.given)
      for (const Quantity& x : s_.states.front())
        start.x.push_back(x.as<double>());
    else if (!s_.seeds.empty())
      start.drawn = {s_.seeds.front()[0].as<double>(), s_.seeds.front()[1].as<double>()};
    numbers_ = base_;
    for (std::size_t i = 0; i < s_.scan->axes.size(); ++i)
      put(s_.scan->axes[i], at[i], start);
    if (start.given) return {start};
    places_->set(numbers_);
    std::vector<FieldStart> all;
    for (auto& x : places_->over(start.drawn)) {
      all.push_back(start);
      all.back().x = std::move(x);
    }
    return all;
  }

private:
  void put(const ScanAxis& axis, double value, FieldStart& start) {
    if (axis.kind == ScanAxis::Kind::drawn) start.drawn[axis.place] = value;
    if (axis.kind == ScanAxis::Kind::coordinate) start.x[axis.place] = value;
    if (axis.kind != ScanAxis::Kind::parameter) return;
    const auto& all = f_.numbers();
    numbers_[static_cast<std::size_t>(std::ranges::find(all, axis.place) - all.begin())] = value;
  }

  const SystemScene& s_;
  const Field& f_;
  std::vector<double> base_, numbers_;
  std::unique_ptr<Places> places_;
};

// A few of the starts, for what all orbits share.
std::vector<FieldStart> sample(const SystemScene& s, const Field& f) {
  CellStarts starts(s, f);
  std::vector<FieldStart> all;
  std::array<std::size_t, 2> counts{1, 1}, steps{1, 1};
  for (std::size_t i = 0; i < s.scan->axes.size(); ++i) {
    counts[i] = s.scan->axes[i].count;
    steps[i] = std::max<std::size_t>(1, counts[i] / sample_side);
  }
  for (std::size_t k = steps[1] / 2; k < counts[1]; k += steps[1])
    for (std::size_t i = steps[0] / 2; i < counts[0]; i += steps[0])
      for (FieldStart& one : starts(i + counts[0] * k))
        all.push_back(std::move(one));
  if (all.empty())
    throw InputError(s.file, 0, 0, 1,
                     "no orbit of the scan starts on the level with the wanted direction");
  return all;
}

double number_of(ScanValue of, const FieldFinish<double>& f) {
  const bool early =
      f.ended == Ended::singular || f.ended == Ended::broken || f.ended == Ended::escaped;
  if (of == ScanValue::crossings) return static_cast<double>(f.crossings);
  if (of == ScanValue::time) return f.t;
  if (early) return INFINITY;
  return of == ScanValue::megno      ? f.indicators.megno
         : of == ScanValue::lyapunov ? f.indicators.lyapunov
                                     : f.indicators.fli;
}

// Keeps one number of each orbit.
class ScanSink : public SectionSink<double> {
public:
  ScanSink(const Stage& s, std::size_t orbits, const std::vector<double>& numbers)
      : SectionSink<double>(s, orbits, numbers.empty() ? nullptr : &numbers),
        values(orbits, std::nan("")), integrals_(s.field, values_of(s.integrals)),
        sizes_(s.term_sizes), begun_(orbits), largest_(orbits) {}

  bool crossing(std::size_t orbit, const double&, const double* x, bool) override {
    use_numbers_of(orbit);
    if (!is_wanted(x)) return false;
    ++crossings;
    return true;
  }
  void look(std::size_t orbit, const double* x) override {
    use_numbers_of(orbit);
    const std::vector<double>& now = integrals_(x);
    if (begun_[orbit].empty()) {
      begun_[orbit] = now;
      largest_[orbit].assign(now.size(), 1e-300);
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (const double size = sizes_[i](x); std::isfinite(size))
        largest_[orbit][i] = std::max(largest_[orbit][i], size);
      drift = std::max(drift, std::abs(now[i] - begun_[orbit][i]) / largest_[orbit][i]);
    }
  }
  void finished(std::size_t orbit, const FieldFinish<double>& f) override {
    values[orbit] = number_of(stage.scene.scan->of, f);
    stopped = stopped || f.ended == Ended::stopped;
    begun_[orbit] = {};
    largest_[orbit] = {};
  }

  std::vector<double> values;
  double drift = 0, crossings = 0;
  bool stopped = false;

private:
  void numbers_changed(const double* numbers, const double*) override {
    integrals_.set(numbers);
    for (TermSize& size : sizes_)
      size.set(numbers);
  }
  Evaluator<double> integrals_;
  std::vector<TermSize> sizes_;
  std::vector<std::vector<double>> begun_, largest_; ///< of each orbit that runs
};

// One worker: takes the next block until none is left.
class ScanWork {
public:
  ScanWork(const Stage& stage, const ScanOptions& o, ScanResult& out)
      : stage_(stage), options_(o), out_(out), cells_(cells_of(*stage.scene.scan)),
        blocks_((cells_ + scan_block - 1) / scan_block) {
    for (std::size_t number = o.part; number < blocks_; number += o.parts)
      wanted_ += size_of(number);
    for (const auto& [number, block] : o.kept)
      keep(number, block);
  }

  void operator()() {
    const Tapes<double> tapes(stage_.field, stage_.order);
    StartRefiner<double> refine(stage_.scene, stage_.field);
    CellStarts starts(stage_.scene, stage_.field);
    SectionSize section_size(stage_);
    FieldRun<double> run = stage_.run(tapes);
    run.check_every = looks_every;
    run.per_scale = stage_.per_scale.data();
    run.stop = options_.stop;
    for (std::size_t number = next_.fetch_add(1); number < blocks_; number = next_.fetch_add(1)) {
      if (number % options_.parts != options_.part || options_.kept.contains(number)) continue;
      if (options_.stop != nullptr && options_.stop->load()) return;
      BlockOrbits orbits = begin(number, starts, refine, section_size);
      ScanSink sink(stage_, orbits.cell.size(), orbits.numbers);
      run.starts = orbits.x.data();
      run.orbits = orbits.cell.size();
      run.section_sizes = orbits.section_sizes.data();
      run.orbit_values = orbits.numbers.empty() ? nullptr : orbits.numbers.data();
      run.sink = &sink;
      integrate_field(tapes.tapes(), run, options_.lanes);
      if (sink.stopped) return;
      const std::lock_guard lock(mutex_);
      const ScanBlock block = block_of(number, orbits, sink);
      keep(number, block);
      if (options_.finished) options_.finished(number, block);
      if (options_.progress) options_.progress(done_, wanted_);
    }
  }

  [[nodiscard]] bool is_whole() const { return done_ == wanted_; }

private:
  struct BlockOrbits {
    std::vector<double> x, section_sizes, numbers;
    std::vector<std::size_t> cell; ///< of each, within the block
  };

  [[nodiscard]] std::size_t size_of(std::size_t number) const {
    return std::min(scan_block, cells_ - number * scan_block);
  }

  BlockOrbits begin(std::size_t number, CellStarts& starts, StartRefiner<double>& refine,
                    SectionSize& section_size) const {
    BlockOrbits all;
    const bool varied = is_over(*stage_.scene.scan, ScanAxis::Kind::parameter);
    for (std::size_t i = 0; i < size_of(number); ++i)
      for (const FieldStart& start : starts(number * scan_block + i)) {
        if (varied) {
          refine.set(starts.numbers());
          section_size.set(starts.numbers().data());
        }
        const std::vector<double> x = refine(start);
        all.x.insert(all.x.end(), x.begin(), x.end());
        all.section_sizes.push_back(section_size(stage_.own_unit(x.data())));
        if (varied)
          all.numbers.insert(all.numbers.end(), starts.numbers().begin(), starts.numbers().end());
        all.cell.push_back(i);
      }
    return all;
  }

  [[nodiscard]] ScanBlock block_of(std::size_t number, const BlockOrbits& orbits,
                                   const ScanSink& sink) const {
    ScanBlock block;
    block.values.assign(size_of(number), std::nan(""));
    block.drift = sink.drift;
    block.crossings = sink.crossings;
    for (std::size_t i = 0; i < orbits.cell.size(); ++i) {
      double& at = block.values[orbits.cell[i]];
      if (!(at >= sink.values[i])) at = sink.values[i];
    }
    return block;
  }

  void keep(std::size_t number, const ScanBlock& block) {
    std::ranges::copy(block.values,
                      out_.values.begin() + static_cast<std::ptrdiff_t>(number * scan_block));
    out_.drift = std::max(out_.drift, block.drift);
    out_.crossings += block.crossings;
    done_ += block.values.size();
  }

  const Stage& stage_;
  const ScanOptions& options_;
  ScanResult& out_;
  std::size_t cells_, blocks_;
  std::atomic<std::size_t> next_{0};
  std::size_t done_ = 0, wanted_ = 0; ///< cells
  std::mutex mutex_{};
};

} // namespace

ScanResult simulate_scan(const SystemScene& scene, const ScanOptions& options) {
  const std::unique_ptr<Stage> stage =
      staged(scene, options.stop, [&](const Field& f) { return sample(scene, f); });
  ScanResult out;
  out.values.assign(cells_of(*scene.scan), std::nan(""));
  out.integrals = joined(stage->integrals, &SceneFormula::text);
  out.order = stage->order;
  out.arithmetic = "double";
  ScanWork work(*stage, options, out);
  in_threads(options.threads, work);
  out.stopped = !work.is_whole();
  for (const double x : out.values) {
    out.empty += std::isnan(x) ? 1 : 0;
    out.early += std::isinf(x) ? 1 : 0;
  }
  out.orbits = out.values.size() - out.empty - out.early;
  return out;
}

} // namespace kov::flow
