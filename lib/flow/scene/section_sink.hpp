#pragma once
// The work of every run at a crossing: is it one, and what is drawn there.

#include "flow/scene/point_errors.hpp"
#include "flow/scene/resolution.hpp"
#include "flow/scene/section_stage.hpp"

namespace kov::flow {

template <class R> class SectionSink : public FieldSink<R> {
public:
  /// numbers: of the field, for each orbit, if they are not the same for all.
  SectionSink(const Stage& s, std::size_t orbits, const std::vector<R>* numbers = nullptr)
      : stage(s), numbers_(numbers), drawn_(s.field, s.scene.drawn()),
        where_(s.field,
               s.scene.where ? std::vector{s.scene.where->value} : std::vector<MFraction>{}),
        fraction_(s.field, parts_of(s)), before_(orbits), seen_(orbits), grown_(orbits, 0),
        unit_(orbits, 1) {
    for (const SceneFormula& f : s.scene.plot)
      sizes_.emplace_back(s.field, f.value);
  }

  void sizes_there(const R* of_variables) override { there_ = doubles(of_variables); }

  bool resolves(std::size_t orbit, const R* start, const R* x, const R* usual, bool deep) override {
    if (!resolution_) {
      resolution_.emplace(stage.field, stage.scene, stage.integrals);
      forget_numbers();
    }
    if (!deep && !resolution_->has_encounters()) return true;
    use_numbers_of(orbit);
    const std::vector<double> begun = doubles(start), now = doubles(x), sizes = doubles(usual);
    const double roundoff = to_double(unit_roundoff<R>());
    const bool no_low_parts = std::is_same_v<R, Twin1>; // their sums have errors of the last digit
    return (*resolution_)({begun.data(), now.data(), sizes.data(), grown_[orbit]}, roundoff,
                          no_low_parts ? 1 : roundoff);
  }

  R section_noise(std::size_t orbit, const R* of_variables, const R& step) override {
    if (!noise_) {
      noise_ = stage.section_noise;
      forget_numbers();
    }
    use_numbers_of(orbit);
    const std::vector<double> at = doubles(of_variables);
    return R((*noise_)(at.data(), to_double(step))) * (unit_roundoff<R>() * R(16));
  }

protected:
  /// From now on everything is asked with the field's numbers of this orbit.
  void use_numbers_of(std::size_t orbit) {
    const std::size_t each = stage.field.numbers().size();
    if (numbers_ == nullptr || each == 0 || orbit == numbers_of_) return;
    numbers_of_ = orbit;
    const R* numbers = numbers_->data() + orbit * each;
    std::vector<double> rounded;
    for (std::size_t i = 0; i < each; ++i)
      rounded.push_back(to_double(numbers[i]));
    where_.set(numbers);
    fraction_.set(numbers);
    if (noise_) noise_->set(rounded.data());
    if (resolution_) resolution_->set(rounded.data());
    numbers_changed(numbers, rounded.data());
  }
  virtual void numbers_changed(const R*, const double*) {}
  /// Is S = N/D zero there, not infinite, and `where` positive?
  [[nodiscard]] bool is_wanted(const R* x) {
    if (!is_constant(stage.scene.section.value.den()) && !crosses_a_zero(x)) return false;
    return !stage.scene.where || where_(x)[0] > R(0);
  }
  /// The point of a crossing that is wanted; none of those that are skipped, and of the first one of a return map.
  [[nodiscard]] std::optional<RawPoint<R>> point(std::size_t orbit, const R& t, const R* x) {
    if (++seen_[orbit] <= stage.scene.skip) return std::nullopt;
    const auto& at = drawn_(x);
    RawPoint<R> p{t, {at[0], at[1]}};
    if (stage.scene.sphere) p.at = on_sphere(at);
    if (!there_.empty()) {
      p.size = drawn_sizes(x, unit_[orbit]);
      p.by_section = rounding_of_section(x);
    }
    if (!stage.scene.return_map) return p;
    p.at[0] = std::exchange(before_[orbit], p.at[1]);
    if (seen_[orbit] == stage.scene.skip + 1) return std::nullopt;
    return p;
  }
  [[nodiscard]] std::vector<double> doubles(const R* x) const {
    std::vector<double> all;
    for (std::size_t i = 0; i < stage.field.variables().size(); ++i)
      all.push_back(to_double(x[i]));
    return all;
  }
  const Stage& stage;

private:
  // In radian, in [0, 2 pi); over the length.
  template <class S> static std::array<S, 2> longitude_and_height(const std::vector<S>& n) {
    using std::atan2;
    using std::sqrt;
    const S l = atan2(n[0], n[1]);
    return {l < S(0) ? S(l + S(2) * pi_of(S(0))) : l,
            S(n[2] / sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]))};
  }
  // A pair of doubles has no arctangent.
  static std::array<R, 2> on_sphere(const std::vector<R>& n) {
    if constexpr (!std::is_same_v<R, Twin1>) {
      return longitude_and_height(n);
    } else {
      const auto at = longitude_and_height<BigReal>({to_big(n[0]), to_big(n[1]), to_big(n[2])});
      return {to_twin(at[0]), to_twin(at[1])};
    }
  }
  void forget_numbers() { numbers_of_ = static_cast<std::size_t>(-1); }
  static std::vector<MFraction> parts_of(const Stage& s) {
    const MFraction& f = s.scene.section.value;
    return {MFraction(f.num()), MFraction(f.den())};
  }
  // For N/D at a zero of N D: is it N that is 0?
  [[nodiscard]] bool crosses_a_zero(const R* x) {
    const std::vector<R>& parts = fraction_(x);
    return std::abs(to_double(parts[0])) / stage.part_sizes[0] <
           std::abs(to_double(parts[1])) / stage.part_sizes[1];
  }

  // unit: how much smaller than the others the orbit is.
  [[nodiscard]] std::array<double, 2> drawn_sizes(const R* x, double unit) {
    const std::vector<double> at = doubles(x);
    std::array<double, 2> all{};
    for (std::size_t i = 0; i < 2; ++i)
      all[i] = std::max(unit * least_drawn_[i], sizes_[i](at.data(), there_.data()));
    return all;
  }

  // Half a unit roundoff of the terms of S is a time of that over |S'|, in which what is drawn moves on.
  [[nodiscard]] std::array<double, 2> rounding_of_section(const R* x) {
    if (!rates_) {
      const auto rate = [this](const MFraction& f) {
        return lie_derivative(stage.scene.system.field, f);
      };
      rates_.emplace(stage.field,
                     std::vector{rate(stage.scene.section.value), rate(stage.scene.plot[0].value),
                                 rate(stage.scene.plot[1].value)});
      terms_.emplace(stage.field, stage.scene.section.value);
    }
    const std::vector<R>& rates = (*rates_)(x);
    const double noise =
        to_double(unit_roundoff<R>()) / 2 * (*terms_)(doubles(x).data(), there_.data());
    std::array<double, 2> all{};
    for (std::size_t i = 0; i < 2; ++i)
      all[i] = noise * std::abs(to_double(rates[1 + i]) / to_double(rates[0]));
    return all;
  }

  const std::vector<R>* numbers_ = nullptr;
  std::size_t numbers_of_ = static_cast<std::size_t>(-1); ///< the orbit whose numbers are used
  std::vector<TermSize> sizes_;                           ///< of what is drawn
  std::vector<double> there_;                             ///< sizes of the variables in this step
  std::array<double, 2> least_drawn_ = stage.least_drawn();
  Evaluator<R> drawn_, where_, fraction_; ///< fraction: of the section
  std::optional<Evaluator<R>> rates_;     ///< along the orbit: of the section, of what is drawn
  std::optional<TermSize> terms_;         ///< of the section
  std::optional<SectionNoise> noise_;     ///< where it was needed
  std::optional<Resolution> resolution_;
  std::vector<R> before_;            ///< of each orbit: what was drawn last, for a return map
  std::vector<long> seen_;           ///< crossings of each orbit, with those that are skipped
  std::vector<std::uint64_t> grown_; ///< of each orbit, for resolution_

protected:
  std::vector<double> unit_; ///< how much smaller than the others each orbit is
};

/// Only the points, by orbit.
template <class R> class RawSink : public SectionSink<R> {
public:
  RawSink(const Stage& s, std::size_t orbits) : SectionSink<R>(s, orbits), points(orbits) {}
  bool crossing(std::size_t orbit, const R& t, const R* x, bool) override {
    if (!this->is_wanted(x)) return false;
    if (auto p = this->point(orbit, t, x)) points[orbit].push_back(std::move(*p));
    return true;
  }
  void look(std::size_t, const R*) override {}
  void finished(std::size_t, const FieldFinish<R>& f) override {
    stopped = stopped || f.ended == Ended::stopped;
  }
  std::vector<std::vector<RawPoint<R>>> points;
  bool stopped = false;
};

template <class R>
void integrate_any(const FieldTapes<R>& tapes, const FieldRun<R>& run, [[maybe_unused]] int lanes) {
  if constexpr (std::is_same_v<R, double>)
    integrate_field(tapes, run, lanes);
  else
    integrate_field(tapes, run);
}

/// The same orbits with other roundings (point_errors.hpp).
template <class R> class SecondRun {
public:
  explicit SecondRun(const Stage& s)
      : stage_(s), field_(s.field_alone(false)), tapes_(*field_, s.order, true),
        finer_(s.scene, *field_) {}

  /// The points of the orbits first ... ; `run` and `starts` are those of the first run.  Empty: stopped.
  [[nodiscard]] std::vector<std::vector<RawPoint<R>>>
  operator()(FieldRun<R> run, const std::vector<R>& starts, std::size_t first, int lanes) {
    const std::size_t n = field_->variables().size(), each = starts.size() / run.orbits;
    std::vector<R> begun;
    for (std::size_t i = 0; i < run.orbits; ++i) {
      const std::vector<R> x(starts.begin() + static_cast<long>(i * each),
                             starts.begin() + static_cast<long>(i * each + n));
      const std::vector<R> other = rounded_otherwise(x, stage_.starts[first + i]);
      begun.insert(begun.end(), other.begin(), other.end());
    }
    RawSink<R> sink(stage_, run.orbits);
    run.starts = begun.data();
    run.values = tapes_.values();
    run.sink = &sink;
    run.log2_shorter = -second_run_steps;
    run.t_end = run.t_end * R(1.01); // the last crossing may come a little later
    if (run.max_steps > 0) run.max_steps *= 2;
    integrate_any(tapes_.tapes(), run, lanes);
    if (sink.stopped) return {};
    return std::move(sink.points);
  }

private:
  using Finer = std::conditional_t<std::is_same_v<R, double>, long double, R>;

  // As far from x as the exact start is, but three times; one bit where no arithmetic is at hand that tells.
  std::vector<R> rounded_otherwise(std::vector<R> x, const FieldStart& start) {
    if constexpr (std::is_same_v<R, double>) {
      const std::vector<long double> exact = finer_(start);
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += static_cast<double>(3 * (exact[i] - static_cast<long double>(x[i])));
    } else {
      bool up = false;
      for (R& one : x) {
        const R bit = one * (unit_roundoff<R>() * R(2));
        one += up ? bit : R(R(0) - bit);
        up = !up;
      }
    }
    return x;
  }

  const Stage& stage_;
  std::unique_ptr<Field> field_;
  Tapes<R> tapes_;
  StartRefiner<Finer> finer_;
};

} // namespace kov::flow
