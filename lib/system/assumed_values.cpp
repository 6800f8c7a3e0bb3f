#include "system/assumed_values.hpp"

#include "exact/error.hpp"

#include <algorithm>
#include <optional>

namespace kov {
namespace {

using Value = std::pair<std::string, std::string>;

// Of an equation; the last parameter that will do.
std::optional<Value> value_by(const System& s, const Assumption& a) {
  if (a.relation != Assumption::Relation::zero || is_zero(a.value)) return std::nullopt;
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

// What must not vanish for the file to say anything: factors in the parameters alone.
std::vector<MPoly> divisors(const System& s) {
  std::vector<MPoly> all = denominators(s.field);
  for (const Assumption& a : s.assumptions)
    if (a.relation == Assumption::Relation::nonzero) all.push_back(a.value.num());
  std::vector<MPoly> parts;
  const auto is_main = [main = s.field.main_variables()](std::size_t i) {
    return std::find(main.begin(), main.end(), i) != main.end();
  };
  for (const MPoly& p : all)
    for (const MFactor& f : factor(p).second)
      if (const auto used = used_variables(f.base); std::none_of(used.begin(), used.end(), is_main))
        parts.push_back(f.base);
  return parts;
}

// In a/b = 1 the value a of b cancels b, which is not 0 all the same.
void keep_nonzero(const std::vector<MPoly>& divisors, System& s) {
  Substitution values;
  for (const auto& [name, value] : s.values)
    values[s.ring()->index(name)] = value;
  for (const MPoly& p : divisors)
    assume_nonzero(substitute(transfer(MFraction(p), s.ring()), values).num(), 0, s);
}

} // namespace

System read_system_as_assumed(const Entry& document, ParameterValues values) {
  System s = read_system(document, values);
  const std::vector<MPoly> nonzero = divisors(s);
  for (;;) {
    std::optional<Value> next;
    for (const Assumption& a : s.assumptions)
      if (!next) next = value_by(s, a);
    std::erase_if(s.assumptions, [](const Assumption& a) {
      return a.relation == Assumption::Relation::zero && is_zero(a.value);
    });
    if (!next) return s;
    values.push_back(*std::move(next)); // one parameter less
    try {
      s = read_system(document, values);
      keep_nonzero(nonzero, s);
    } catch (const Error&) { // no value that can be given: the equation stays an assumption
      return s;
    }
  }
}

} // namespace kov
