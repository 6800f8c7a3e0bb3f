#include "flow/scene/resolution.hpp"

#include "flow/number/conversions.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace kov::flow {
namespace {

constexpr double resolved = 0x1p-10;

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
  if (std::any_of(v.components.begin(), v.components.end(), in) || in(s.section.value) ||
      (s.where && in(s.where->value)) ||
      std::any_of(watched.begin(), watched.end(), [&](const auto& f) { return in(f.value); }))
    return false;
  for (std::size_t i = 0; i < 2; ++i)
    if (in(s.plot[i].value) &&
        !(s.angle[i] && s.plot[i].value == MFraction::variable(s.system.ring(), variable)))
      return false;
  for (const FunctionSymbol& f : v.functions)
    if (std::any_of(f.gradient.begin(), f.gradient.end(), in)) return false;
  return std::all_of(s.meanings.begin(), s.meanings.end(), [&](const FunctionMeaning& m) {
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
    if (std::any_of(s.meanings.begin(), s.meanings.end(),
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
  const auto as = [](const BigReal& x) {
    if constexpr (std::is_same_v<R, BigReal>)
      return x;
    else if constexpr (std::is_same_v<R, Twin1>)
      return to_twin(x);
    else if constexpr (std::is_same_v<R, long double>)
      return mpfr_get_ld(x.raw(), MPFR_RNDN);
    else
      return static_cast<double>(x);
  };
  return {as(first), as(second), as(rest)};
}
template std::array<double, 3> turn_in_parts();
template std::array<long double, 3> turn_in_parts();
template std::array<Twin1, 3> turn_in_parts();
template std::array<BigReal, 3> turn_in_parts();

Resolution::Resolution(const Field& f, const SystemScene& s,
                       const std::vector<SceneFormula>& integrals) {
  const auto add = [&](const MPoly& p) {
    const MFraction value(p);
    if (!is_constant(value)) parts_.push_back({Evaluator<double>(f, {value}), TermSize(f, value)});
  };
  for (const MFraction& component : s.system.field.components)
    add(component.den());
  for (const FunctionMeaning& m : s.meanings)
    if ((m.name == "sqrt" || m.name == "log") &&
        std::find(f.variables().begin(), f.variables().end(), m.variable) != f.variables().end())
      add(m.argument.num());
  for (const SceneFormula& one : integrals)
    integrals_.emplace_back(f, one.value);
}

bool Resolution::operator()(const double* start, const double* x, double roundoff) {
  for (Part& part : parts_)
    if (!(roundoff * part.size(x) <= resolved * std::abs(part.value(x)[0]))) return false;
  return std::all_of(integrals_.begin(), integrals_.end(), [&](TermSize& size) {
    const double begun = size(start);
    return !(begun > 0) || roundoff * size(x) <= resolved * begun;
  });
}

} // namespace kov::flow
