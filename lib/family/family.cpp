#include "family/family.hpp"

#include "family/algebraic_constants.hpp"
#include "family/assumptions.hpp"
#include "family/parameter_scope.hpp"
#include "system/linear_formula.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov {

Family read_family(const EquationText& text) {
  const auto constants = AlgebraicConstants::in(text);
  if (!constants) throw FreeParameters(text.parameters);
  check_assumptions(text);
  Family f;
  const EquationNames given = equation_names(text);
  f.variable = given.variable;
  std::set<std::string> fixed;
  for (const auto& [name, value] : text.set)
    fixed.insert(name);
  std::vector<std::string> names = constants->names();
  for (const auto& p : text.parameters)
    if (!fixed.contains(p) && p != f.variable &&
        std::find(names.begin(), names.end(), p) == names.end())
      names.push_back(p);
  names.push_back(f.variable);
  const Ring ring = make_ring(names);
  std::map<std::string, MFraction> values;
  for (const auto& [name, value] : text.set)
    values[name] = evaluate(value, ParameterScope(ring, values));
  const ParameterScope scope(ring, values, constants->functions(ring));
  strata::Question& q = f.question;
  q.z = ring->index(f.variable);
  const auto reduced = [&](const MFraction& p, const MFraction& q0) { // y'' + p y' + q0 y = 0
    return Rational(1, 4) * (p * p) + Rational(1, 2) * derivative(p, q.z) - q0;
  };
  if (text.r) {
    q.r = evaluate(*text.r, scope);
  } else if (text.ode) {
    const auto form = parametric_second_order(*text.ode, given.unknown, q.z, scope);
    if (!form)
      throw text.ode->error("this is not a homogeneous linear equation of the second order",
                            "only a2*" + given.unknown + "'' + a1*" + given.unknown + "' + a0*" +
                                given.unknown + " = 0 can be solved");
    q.r = reduced(form->p, form->q);
  } else {
    q.r = reduced(evaluate(*text.p, scope), evaluate(*text.q, scope));
  }
  q.r = q.r.ring() ? constants->reduced(q.r, scope) : MFraction(ring);
  q.assumptions = read_assumptions(text, scope);
  constants->assume(q.assumptions, scope);
  return f;
}

} // namespace kov
