#include "flow/scene/section_stage.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "flow/scene/effects_needed.hpp"
#include "flow/scene/resolution.hpp"
#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {

std::vector<MFraction> values_of(const std::vector<SceneFormula>& formulas) {
  return mapped<MFraction>(formulas, &SceneFormula::value);
}

namespace {

// All that a run asks of the variables.
std::vector<MFraction> needed_by(const SystemScene& s, const std::vector<SceneFormula>& integrals) {
  std::vector<MFraction> all = values_of(s.start);
  for (const SceneFormula& f : integrals)
    all.push_back(f.value);
  for (const auto& level : s.levels)
    all.push_back(level.function.value);
  for (const MFraction& f : s.drawn())
    all.push_back(f);
  if (s.sign_of) all.push_back(*s.sign_of);
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

constexpr std::size_t most_states = 1000;
constexpr double largest_angle = 4; // of one that is kept within a turn

} // namespace

SectionNoise::SectionNoise(const Field& f, const System& s, const MFraction& section)
    : size_(f, section) {
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

double SectionNoise::operator()(const double* sizes, double step) {
  double sum = size_(sizes);
  for (auto& [slope, rate] : by_rates_)
    if (const double one = slope(sizes) * rate(sizes) * step; std::isfinite(one)) sum += one;
  return sum;
}

void SectionNoise::set(const double* numbers) {
  size_.set(numbers);
  for (auto& [slope, rate] : by_rates_) {
    slope.set(numbers);
    rate.set(numbers);
  }
}

Stage::Stage(const SystemScene& s, const std::atomic<bool>* stop, const Starts& some)
    : scene(s), integrals(watched(s)), field(s.system, crossed_in(s), needed_by(s, integrals),
                                             s.values, s.has_tangent(), s.written.get()),
      starts(some ? some(field) : starts_of(s, field, &skipped, stop)) {
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
  turning = turning_angles(s, integrals);
  for (const std::uint32_t angle : turning)
    scales.of[angle] = std::min(scales.of[angle], largest_angle);
  order = flow::choose_order(field, scales, log2_tolerance());
  for (const double scale : scales.of)
    per_scale.push_back(1 / scale);
}

double Stage::log2_tolerance() const {
  return log2_estimate(scene.tolerance.as<BigReal>()) - safety_bits;
}

std::array<double, 2> Stage::least_drawn() const {
  std::array<double, 2> least{};
  for (std::size_t i = 0; i < 2; ++i)
    least[i] = 0x1p-44 * TermSize(field, scene.plot[i].value)(scales.of.data());
  return least;
}

std::unique_ptr<Field> Stage::field_alone(bool tangent) const {
  return std::make_unique<Field>(scene.system, crossed_in(scene), needed_by(scene, integrals),
                                 scene.values, tangent, scene.written.get());
}

// The size of a function: that of its terms, at most, on what a few orbits have shown.
void Stage::measure() {
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

double Stage::largest(TermSize& size) const {
  const std::size_t n = field.variables().size(), states = scales.path.size() / n;
  double most = 1e-300;
  for (std::size_t state = 0; state < states; state += states / most_states + 1)
    if (const double now = size(&scales.path[state * n]); std::isfinite(now))
      most = std::max(most, now);
  return most;
}

// A relation that does not hold at the start holds nowhere.
void Stage::check_relations(const std::vector<double>& all) {
  const std::size_t n = field.variables().size();
  for (const MPoly& relation : scene.system.field.relations) {
    const MFraction function(relation);
    const auto same = [&](const SceneFormula& f) { return f.value == function; };
    if (std::ranges::none_of(integrals, same)) continue;
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

std::unique_ptr<Stage> staged(const SystemScene& s, const std::atomic<bool>* stop,
                              const Stage::Starts& some) {
  try {
    return std::make_unique<Stage>(s, stop, some);
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

double SectionSize::operator()(double unit) {
  if (unit == 1) return stage_.section_size;
  auto x = mapped<double>(stage_.scales.of, [&](const double scale) { return unit * scale; });
  return std::max(1e-300, std::min(stage_.section_size, size_(x.data())));
}

} // namespace kov::flow
