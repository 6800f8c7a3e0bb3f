#include "flow/scene/resolution.hpp"

#include "flow/number/rounded.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace kov::flow {
namespace {

constexpr double resolved = 0x1p-10;
constexpr long factored_terms = 400; // longer denominators are not factored

bool has_period_of_a_turn(const std::string& name) {
  static const std::set<std::string> all{"sin", "cos", "tan", "cot", "sec", "csc"};
  return all.contains(name);
}

// Does f change by whole multiples of the coordinate's period only?
bool is_whole_multiple(const MFraction& f, std::size_t variable) {
  if (!uses(f, variable)) return true;
  const MFraction slope = derivative(f, variable);
  return is_constant(slope) && to_rational(slope).den() == Integer(1);
}

bool is_angle_only(const SystemScene& s, const std::vector<SceneFormula>& watched,
                   std::size_t variable) {
  const auto in = [variable](const MFraction& f) { return uses(f, variable); };
  const VectorField& v = s.system.field;
  if (std::ranges::any_of(v.components, in) || in(s.section.value) ||
      (s.where && in(s.where->value)) ||
      std::ranges::any_of(watched, [&](const auto& f) { return in(f.value); }))
    return false;
  for (std::size_t i = 0; i < 2; ++i)
    if (in(s.plot[i].value) &&
        !(s.angle[i] && s.plot[i].value == MFraction::variable(s.system.ring(), variable)))
      return false;
  for (const FunctionSymbol& f : v.functions)
    if (std::ranges::any_of(f.gradient, in)) return false;
  return std::ranges::all_of(s.meanings, [&](const FunctionMeaning& m) {
    return !in(m.argument) ||
           (has_period_of_a_turn(m.name) && is_whole_multiple(m.argument, variable));
  });
}

} // namespace

std::vector<std::uint32_t> turning_angles(const SystemScene& s,
                                          const std::vector<SceneFormula>& watched) {
  std::vector<std::uint32_t> all;
  if (s.winding) return all; // counts them
  const auto& coordinates = s.system.field.coordinates;
  for (std::uint32_t i = 0; i < coordinates.size(); ++i)
    if (std::ranges::any_of(s.meanings,
                            [&](const auto& m) { return uses(m.argument, coordinates[i]); }) &&
        is_angle_only(s, watched, coordinates[i]))
      all.push_back(i);
  return all;
}

template <class R> std::array<R, 3> turn_in_parts() {
  const PrecisionScope scope(std::max<long>(2 * BigReal::bits(), 256));
  const BigReal turn = BigReal(2) * pi_of(BigReal());
  const BigReal first(6.28125);
  const BigReal second(static_cast<double>(static_cast<float>(static_cast<double>(turn - first))));
  const BigReal rest = turn - first - second;
  return {rounded<R>(first), rounded<R>(second), rounded<R>(rest)};
}
template std::array<double, 3> turn_in_parts();
template std::array<long double, 3> turn_in_parts();
template std::array<Twin1, 3> turn_in_parts();
template std::array<BigReal, 3> turn_in_parts();

PolynomialNoise::PolynomialNoise(const Field& f, const VectorField& v, const MPoly& p) {
  std::set<std::size_t> fixed(v.parameters.begin(), v.parameters.end());
  fixed.insert(v.constants.begin(), v.constants.end());
  if (const auto squares = squares_of(p, fixed))
    for (const Square& s : *squares)
      squares_.push_back({TermSize(f, s.number), Evaluator<double>(f, {MFraction(s.form)}),
                          TermSize(f, MFraction(s.form)), s.is_difference});
  else
    whole_.emplace_back(f, MFraction(p));
}

double PolynomialNoise::operator()(const double* x, double low) {
  if (!whole_.empty()) return whole_.front()(x);
  double all = 0;
  for (Part& part : squares_) {
    const double size = part.form_size(x);
    const double form =
        std::abs(part.form(x)[0]) + (part.is_difference && low < 1 ? low * size : 0);
    all += part.number(x) * (form * form + 2 * form * (part.is_difference ? low : 1) * size);
  }
  return all;
}

void PolynomialNoise::set(const double* numbers) {
  for (TermSize& one : whole_)
    one.set(numbers);
  for (Part& part : squares_) {
    part.number.set(numbers);
    part.form.set(numbers);
    part.form_size.set(numbers);
  }
}

Resolution::Resolution(const Field& f, const SystemScene& s,
                       const std::vector<SceneFormula>& integrals)
    : coordinates_(f.coordinates()) {
  const VectorField& v = s.system.field;
  const auto part_of = [&](const MPoly& p, std::optional<std::size_t> root) {
    return Part{Evaluator<double>(f, {MFraction(p)}), PolynomialNoise(f, v, p), root};
  };
  const auto add = [&](const MPoly& p, std::optional<std::size_t> root = {}) {
    if (!is_constant(p)) parts_.push_back(part_of(p, root));
  };
  std::vector<std::size_t> roots;
  std::vector<MPoly> arguments;
  for (const FunctionMeaning& m : s.meanings) {
    const auto found = std::ranges::find(f.variables(), m.variable);
    const bool ends = m.name == "sqrt" || m.name == "log" || m.name.starts_with("root");
    if (!ends || found == f.variables().end()) continue; // the others have a value at 0
    if (is_constant(m.argument.num())) continue;
    const bool is_root = m.name == "sqrt" && is_constant(m.argument.den());
    if (is_root) {
      roots_.push_back(parts_.size());
      roots.push_back(m.variable);
      arguments.push_back(m.argument.num());
      add(m.argument.num(), static_cast<std::size_t>(found - f.variables().begin()));
    } else {
      add(m.argument.num());
    }
  }
  // The factors of a denominator, but for roots and what stands below them.
  const auto factors_of = [&](const MPoly& p) {
    std::vector<MPoly> all;
    if (p.length() > factored_terms) return std::vector{p};
    for (const MFactor& x : factor(p).second) {
      const bool below_root = std::ranges::any_of(arguments, [&](const MPoly& argument) {
        const auto rest = divides(x.base, argument);
        return rest && is_constant(*rest);
      });
      if (x.base.length() > 1 && !below_root) all.push_back(x.base);
    }
    return all;
  };
  for (const MFraction& component : v.components)
    for (const MPoly& x : factors_of(component.den()))
      add(x);
  for (const SceneFormula& one : integrals) {
    std::vector<MFraction> slopes;
    for (const std::size_t root : roots)
      slopes.push_back(derivative(one.value, root));
    integrals_.push_back({TermSize(f, one.value), Evaluator<double>(f, slopes), {}});
    for (const MPoly& x : factors_of(one.value.den()))
      integrals_.back().denominator.push_back(part_of(x, {}));
    has_energy_ = has_energy_ || (v.hamiltonian && one.value == *v.hamiltonian);
  }
}

void Resolution::set(const double* numbers) {
  const auto set_part = [&](Part& part) {
    part.value.set(numbers);
    part.noise.set(numbers);
  };
  std::ranges::for_each(parts_, set_part);
  for (Integral& one : integrals_) {
    one.size.set(numbers);
    one.slopes.set(numbers);
    std::ranges::for_each(one.denominator, set_part);
  }
}

// The relative noise by rounding, in units of a unit roundoff.  A root has digits of its own, and
// is a better value.
double Resolution::relative(Part& part, const double* x, double low) {
  const double noise = part.noise(x, low);
  const double value = part.root ? x[*part.root] * x[*part.root] : std::abs(part.value(x)[0]);
  return noise / value;
}

// How many times as fast as usual the motion is.
double Resolution::faster(const State& s) const {
  double now = 0, usual = 0;
  for (std::size_t i = 0; i < coordinates_; ++i) {
    if (std::abs(s.x[i]) > 64 * s.usual[i]) s.grown |= std::uint64_t{1} << i;
    if ((s.grown >> i & 1) == 0) continue;
    now = std::max(now, std::abs(s.x[i]));
    usual = std::max(usual, s.usual[i]);
  }
  return usual > 0 ? now / usual : 1;
}

bool Resolution::operator()(const State& s, double roundoff, double low) {
  std::vector<double> of_parts;
  double worst = 1;
  for (Part& part : parts_) {
    of_parts.push_back(relative(part, s.x, low));
    if (!(roundoff * of_parts.back() <= resolved)) return false;
    worst = std::max(worst, of_parts.back());
  }
  for (Integral& one : integrals_) {
    const double begun = one.size(s.start);
    if (!(begun > 0)) continue;
    double noise = one.size(s.x);
    for (Part& part : one.denominator)
      noise *= 1 + relative(part, s.x, low);
    const std::vector<double>& slopes = one.slopes(s.x);
    for (std::size_t i = 0; i < roots_.size();
         ++i) // r changes by half of the relative change of r^2
      noise += std::abs(slopes[i] * s.x[*parts_[roots_[i]].root]) * of_parts[roots_[i]] / 2;
    if (!(roundoff * noise <= resolved * begun)) return false;
  }
  if (has_energy_ || parts_.empty()) return true;
  const double v = faster(s);
  return roundoff * worst * v * v <= resolved;
}

} // namespace kov::flow
