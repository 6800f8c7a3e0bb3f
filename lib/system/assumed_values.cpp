#include "system/assumed_values.hpp"

#include "exact/error.hpp"

#include <algorithm>
#include <optional>

namespace kov {
namespace {

using Value = std::pair<std::string, std::string>;

// The value that an equation gives to a parameter: to the last one that will do.
std::optional<Value> value_by(const System& s, const Assumption& a) {
  if (!a.is(Sign::zero) || is_zero(a.value)) return std::nullopt;
  const MPoly equation = a.value.num();
  const auto& parameters = s.field.parameters;
  for (auto i = parameters.rbegin(); i != parameters.rend(); ++i) {
    if (degree(equation, *i) != 1) continue;
    const auto c = coefficients(equation, *i);
    if (is_constant(c[1]))
      return Value{s.ring()->name(*i), to_string(-(MFraction(c[0]) / MFraction(c[1])))};
  }
  return std::nullopt;
}

} // namespace

System read_system_as_assumed(const Entry& document, ParameterValues values) {
  System s = read_system(document, values);
  for (;;) {
    std::optional<Value> next;
    for (const Assumption& a : s.assumptions)
      if (!next) next = value_by(s, a);
    std::erase_if(s.assumptions,
                  [](const Assumption& a) { return a.is(Sign::zero) && is_zero(a.value); });
    if (!next) return s;
    values.push_back(*std::move(next)); // one parameter less
    try {
      s = read_system(document, values);
    } catch (const Error&) { // no value that can be given: the equation stays an assumption
      return s;
    }
  }
}

} // namespace kov
