#include "equation/parametric_equation.hpp"

#include "equation/algebraic_constants.hpp"
#include "equation/assumptions.hpp"
#include "equation/linear_form.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "parameters/parametrised_set.hpp"
#include "symbol/rational_form.hpp"
#include "symbol/suggest.hpp"
#include "system/linear_formula.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov {
namespace {

// Assumes that not all coefficients of f in z vanish: where they do, f is 0.
void assume_somewhere_nonzero(strata::Question& q, const MPoly& f,
                              strata::Genericity::Else otherwise, std::string of = {}) {
  std::vector<MPoly> all = coefficients(f, q.z);
  std::erase_if(all, [](const MPoly& c) { return is_zero(c); });
  if (std::ranges::any_of(all, [](const MPoly& c) { return is_constant(c); })) return;
  q.generic.push_back({std::move(all), otherwise, std::move(of)});
}

void assume_defined(strata::Question& q, const MFraction& f) {
  if (!is_zero(f)) assume_somewhere_nonzero(q, f.den(), strata::Genericity::Else::no_value);
}

// Assumes that divisors are not 0 that are not seen in r any more: a in a*z/a.
template <class Value>
void assume_divisors(strata::Question& q, const EquationText& text, const std::string& unknown,
                     const Value& value) {
  using Else = strata::Genericity::Else;
  std::vector<Divisor> all = text.divisors;
  for (const auto* e : {&text.r, &text.p, &text.q, &text.ode})
    if (*e)
      for (const Expression& d : divisors_in(**e))
        all.push_back({d});
  for (const Divisor& d : all) {
    std::optional<MFraction> f;
    try {
      f = value(d.formula);
    } catch (const InputError&) { // the unknown function stands in it
      continue;
    }
    if (is_zero(*f)) throw NoValue(d.formula.error("division by zero: this is 0"));
    const auto otherwise = d.by == Divisor::By::order       ? Else::no_order
                           : d.by == Divisor::By::reduction ? Else::division
                                                            : Else::no_value;
    const std::string of = d.by == Divisor::By::order       ? unknown
                           : d.by == Divisor::By::reduction ? to_string(*f)
                                                            : std::string();
    for (const MPoly& factor : irreducible_parts(f->num()))
      if (!divides(factor, q.r.den())) assume_somewhere_nonzero(q, factor, otherwise, of);
    assume_defined(q, *f);
  }
}

// The constants are variables of the ring, so that sqrt(2)^2 - 2 is 0 by their equations only.
class NoZeroDivisors {
public:
  NoZeroDivisors(const AlgebraicConstants& constants, const Scope& scope)
      : constants_(constants), scope_(scope) {}

  void operator()(const Expression& e) const {
    for (const Expression& x : e.operands())
      (*this)(x);
    if (e.kind() == Expression::Kind::quotient) refuse_zero(e.operand(1));
    if (e.kind() == Expression::Kind::power && is_negative(e.operand(1))) refuse_zero(e.operand(0));
  }

private:
  // Nothing where it has no value, e.g. with the unknown function in it.
  [[nodiscard]] std::optional<MFraction> value_of(const Expression& e) const {
    return tried<InputError>([&] { return std::optional(evaluate(e, scope_)); });
  }
  [[nodiscard]] bool is_negative(const Expression& exponent) const {
    const auto k = value_of(exponent);
    return k && is_constant(*k) && sign(to_rational(*k)) < 0;
  }
  void refuse_zero(const Expression& e) const {
    const auto below = value_of(e);
    if (below && is_zero(constants_.reduced(*below, scope_)))
      throw NoValue(e.error("division by zero: this is 0"));
  }

  const AlgebraicConstants& constants_;
  const Scope& scope_;
};

// Forgotten parameters, told as the reader without parameters tells them.
void refuse_unknown_names(const EquationText& text, const EquationNames& given,
                          const Scope& scope) {
  std::set<std::string> unknown;
  const Expression* first = nullptr;
  for (const auto* formula : {&text.r, &text.p, &text.q, &text.ode}) {
    if (!*formula) continue;
    for (const std::string& name : names_in(**formula)) {
      if (scope.value(name) || (text.ode && name == given.unknown)) continue;
      if (unknown.empty()) first = find_name(**formula, name);
      unknown.insert(name);
    }
  }
  if (unknown.empty()) return;
  if (unknown.size() == 1) throw unknown_name(*first, text.parameters, given.variable);
  throw unknown_names(*first, {unknown.begin(), unknown.end()}, given.variable);
}

} // namespace

ParametricEquation read_parametric_equation(const EquationText& text) {
  const auto constants = AlgebraicConstants::in(text);
  if (!constants)
    throw FreeParameters(text.parameters,
                         "beside them the constants can be I, square roots of integers, or one "
                         "--minpoly, and this equation has others: give the parameters values with "
                         "--set NAME=VALUE, or the other constants a name");
  check_assumptions(text);
  ParametricEquation f;
  const EquationNames given = equation_names(text);
  f.variable = given.variable;
  std::set<std::string> fixed;
  for (const auto& [name, value] : text.set)
    fixed.insert(name);
  std::vector<std::string> names = constants->names();
  for (const auto& p : text.parameters)
    if (!fixed.contains(p) && p != f.variable && !is_among(p, names)) names.push_back(p);
  names.push_back(f.variable);
  const Ring ring = make_ring(names);
  std::map<std::string, MFraction> values;
  for (const auto& [name, value] : text.set)
    values[name] = evaluate(value, ParameterScope(ring, values));
  const ParameterScope scope(ring, values, constants->functions(ring));
  refuse_unknown_names(text, given, scope);
  const NoZeroDivisors refuse_zero_divisors(*constants, scope);
  for (const auto& [name, value] : text.set)
    refuse_zero_divisors(value);
  for (const auto* e : {&text.r, &text.p, &text.q, &text.ode})
    if (*e) refuse_zero_divisors(**e);
  strata::Question& q = f.question;
  f.p = MFraction(ring);
  q.z = ring->index(f.variable);
  const auto reduced = [&](const MFraction& p, const MFraction& q0) { // y'' + p y' + q0 y = 0
    return Rational(1, 4) * (p * p) + Rational(1, 2) * derivative(p, q.z) - q0;
  };
  if (text.r) {
    q.r = evaluate(*text.r, scope);
    f.q = -q.r;
  } else if (text.ode) {
    const auto form = parametric_second_order(*text.ode, given.unknown, q.z, scope);
    for (const MFraction& c : {form.c0, form.c1, form.c2})
      assume_defined(q, c);
    if (is_zero(constants->reduced(form.c2, scope)))
      throw NoValue(text.ode->error("the coefficient of " + given.unknown + "'' is 0"));
    assume_somewhere_nonzero(q, form.c2.num(), strata::Genericity::Else::no_order, given.unknown);
    f.p = form.c1 / form.c2, f.q = form.c0 / form.c2;
    q.r = reduced(f.p, f.q);
  } else {
    f.p = evaluate(*text.p, scope), f.q = evaluate(*text.q, scope);
    for (const MFraction& c : {f.p, f.q})
      assume_defined(q, c);
    q.r = reduced(f.p, f.q);
  }
  q.r = q.r.ring() ? constants->reduced(q.r, scope) : MFraction(ring);
  f.form = text.r     ? GivenEquation::Form::r
           : text.ode ? GivenEquation::Form::ode
                      : GivenEquation::Form::pq;
  f.gauge = Rational(-1, 2) * f.p;
  const auto value = [&](const Expression& e) {
    return constants->reduced(evaluate(e, scope), scope);
  };
  assume_divisors(q, text, text.change ? text.change->unknown : given.unknown, value);
  if (text.change && text.change->nonzero)
    if (const MFraction there = value(*text.change->nonzero); !is_zero(there))
      f.nonzero = irreducible_parts(there.num());
  constants->assume(q.assumptions, scope);
  q.assumptions = read_assumptions(text, scope, std::move(q.assumptions));
  constants->assume_signs(q.assumptions, scope);
  f.assumed = q.assumptions;
  for (const Expression& e : text.zero)
    q.assumptions.require(value(e), Sign::zero);
  for (const Expression& e : text.nonzero)
    q.assumptions.require(value(e), Sign::nonzero);
  return f;
}

std::vector<EquationPart> read_parts(const EquationText& text) {
  EquationPart first{{}, read_parametric_equation(text)};
  if (!text.change || !text.change->nonzero) return {first};
  const ParametrisedSet assumed(first.equation->question.r.ring(), first.equation->assumed);
  std::vector<EquationPart> parts;
  EquationText there = text;
  there.p = there.q = std::nullopt;
  there.ode = text.change->elsewhere;
  there.variable = text.change->variable;
  there.divisors = text.change->divisors;
  there.change.reset();
  Assumptions& here = first.equation->question.assumptions;
  for (const MPoly& f : first.equation->nonzero) {
    if (assumed.provably_nonzero(f)) continue;
    const Expression e = parse_expression(to_string(f), "condition");
    there.zero = {e};
    const std::string zero = to_string(Condition{f, Sign::zero}),
                      nonzero = to_string(Condition{f, Sign::nonzero});
    EquationPart part{first.where, {}};
    part.where.emplace_back(zero, nonzero);
    try {
      part.equation = read_parametric_equation(there);
    } catch (const NoValue& error) {
      part.none = error.message();
    } catch (const InputError& error) { // a constant that nothing decides with
      part.open = error.message();
    } catch (const FreeParameters& why) {
      part.open = why.what();
    }
    parts.push_back(std::move(part));
    first.where.emplace_back(nonzero, zero);
    here.require(MFraction(f), Sign::nonzero);
    there.nonzero.push_back(e);
  }
  parts.insert(parts.begin(), std::move(first));
  return parts;
}

namespace {

// The obvious one; the energy where it is the only usual letter, which is refused then; z where there is no other name.
std::string variable_among(const EquationText& text, const std::vector<std::string>& names,
                           const std::string& unknown, const std::string& energy) {
  std::vector<std::string> others = names;
  std::erase(others, energy);
  const auto variable = obvious_variable(others, unknown);
  if (variable && is_among(*variable, others)) return *variable;
  if (is_usual_variable(energy, unknown)) return energy;
  if (others.empty()) return "z";
  const Expression& at = text.r ? *text.r : text.ode ? *text.ode : *text.p;
  throw at.error("which of " + enumerate(names) + " is the variable?", "name it with --variable");
}

} // namespace

void take_all_parameters(EquationText& text, const std::string& energy) {
  const auto has_value = [&](const std::string& name) {
    return std::ranges::any_of(text.set, [&](const auto& value) { return value.first == name; });
  };
  refuse_words(text);
  auto names = settable_names(text);
  std::erase_if(names, has_value);
  std::string unknown;
  if (text.ode) {
    const OdeNames given = ode_names(*text.ode, text.unknown);
    unknown = given.unknown;
    std::erase(names, unknown);
    if (text.variable.empty()) text.variable = given.variable;
  }
  if (text.variable.empty()) text.variable = variable_among(text, names, unknown, energy);
  for (const std::string& name : names)
    if (name != text.variable && !is_among(name, text.parameters)) text.parameters.push_back(name);
}

std::size_t energy_of(const ParametricEquation& equation, const std::string& name) {
  const auto found = equation.question.r.ring()->find(name);
  if (!found || *found == equation.question.z)
    throw InvalidArgument("the equation has no parameter '" + name +
                          "'; name the one whose values are asked for");
  return *found;
}

} // namespace kov
