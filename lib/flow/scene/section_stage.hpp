#pragma once
// Everything that all orbits of a scene and all arithmetics share: the field, the starts, the
// scales of the motion, the order.

#include "flow/field/field_kernels.hpp"
#include "flow/scene/starts.hpp"

#include <optional>
#include <thread>

namespace kov::flow {

/// A step's local error is kept below tolerance / 2^6: then the integrals drift by about the tolerance in a
/// thousand turns (measured in docs/accuracy.md), and the number of crossings is right from 10^-4 on.
inline constexpr int safety_bits = 6;
/// Scenes without a time: an orbit ends after `least_steps` + `steps_for_crossing` for each
/// crossing.
inline constexpr long least_steps = 20000, steps_for_crossing = 2000;
/// Scenes with a time: at most so many points, for the memory.
inline constexpr long most_points = 50'000'000;
/// A time that no orbit reaches, whose products do not overflow.
inline constexpr double forever = 1e150;

[[nodiscard]] std::vector<MFraction> values_of(const std::vector<SceneFormula>& formulas);

/// The size that rounding may give to a section function: units of its terms, and of those of the
/// rates of its variables.
class SectionNoise {
public:
  SectionNoise(const Field& f, const System& s, const MFraction& section);
  /// In units of 16 unit roundoffs.
  [[nodiscard]] double operator()(const double* sizes, double step);
  /// Other values of the field's numbers.
  void set(const double* numbers);

private:
  struct ByRate {
    TermSize slope, rate;
  };
  TermSize size_;
  std::vector<ByRate> by_rates_;
};

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
  std::vector<std::uint32_t> turning; ///< angles that are kept within a turn

  /// Errors  InputError: no start, a function without a value, too large a system
  using Starts = std::function<std::vector<FieldStart>(const Field&)>;
  /// some: of the starts are enough
  Stage(const SystemScene& s, const std::atomic<bool>* stop, const Starts& some = {});

  /// How much smaller than the others the orbit from x is.
  [[nodiscard]] double own_unit(const double* x) const {
    return flow::own_unit(x, per_scale.data(), per_scale.size());
  }
  [[nodiscard]] double log2_tolerance() const;
  /// Values of what is drawn below these are not told from 0.
  [[nodiscard]] std::array<double, 2> least_drawn() const;
  /// A run as the scene asks for it; starts, scales and sink are the caller's.
  template <class R> [[nodiscard]] FieldRun<R> run(const Tapes<R>& tapes) const {
    FieldRun<R> run;
    run.log2_tolerance = log2_tolerance();
    run.order = order;
    run.t_end = scene.time ? scene.time->as<R>() : R(forever);
    run.max_crossings = scene.crossings > 0 ? scene.crossings + scene.skip : -1;
    run.max_steps =
        scene.time ? -1 : least_steps + steps_for_crossing * (scene.crossings + scene.skip);
    run.idle_ends = !scene.time;
    run.falling = scene.falling;
    run.rising = scene.rising;
    run.values = tapes.values();
    return run;
  }
  /// The same motion, with a tangent vector or without.
  [[nodiscard]] std::unique_ptr<Field> field_alone(bool tangent) const;

private:
  void measure();
  double largest(TermSize& size) const;
  void check_relations(const std::vector<double>& all);
};

/// A Stage whose errors have the file.  Errors  InputError
[[nodiscard]] std::unique_ptr<Stage> staged(const SystemScene& s, const std::atomic<bool>* stop,
                                            const Stage::Starts& some = {});

/// So many workers; this thread is one of them.
template <class Work> void in_threads(int threads, Work& work) {
  std::vector<std::jthread> others;
  for (int i = 1; i < threads; ++i)
    others.emplace_back([&work] { work(); });
  work();
}

/// The size of the section on an orbit that is smaller than the others by the factor `unit`.
class SectionSize {
public:
  explicit SectionSize(const Stage& s) : stage_(s), size_(s.term_sizes.back()) {}
  [[nodiscard]] double operator()(double unit);
  /// Other values of the field's numbers.
  void set(const double* numbers) { size_.set(numbers); }

private:
  const Stage& stage_;
  TermSize size_;
};

} // namespace kov::flow
