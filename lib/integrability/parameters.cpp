#include "integrability/parameters.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov {
namespace {

using Relation = Assumption::Relation;

void add_assumption(strata::Assumptions& all, const Assumption& a, const Ring& ring) {
  const MFraction value = transfer(a.value, ring);
  switch (a.relation) {
  case Relation::zero:
    return all.require(value, strata::Sign::zero);
  case Relation::nonzero:
    return all.require(value, strata::Sign::nonzero);
  case Relation::positive:
    return all.require(value, strata::Sign::positive);
  case Relation::nonnegative:
    return all.require(value, strata::Sign::nonnegative);
  case Relation::integer:
    all.memberships.push_back({value, true});
    [[fallthrough]];
  default: // real, rational: of a parameter
    if (const auto used = used_variables(value);
        used.size() == 1 && value == MFraction::variable(ring, used[0]))
      all.real.push_back(used[0]);
  }
}

} // namespace

strata::Question strata_question(const System& s, const AlgebraicOde& ode) {
  std::vector<std::string> names;
  for (const std::size_t i : s.field.parameters)
    names.push_back(s.ring()->name(i));
  names.push_back(s.ring()->name(ode.z));
  const Ring ring = make_ring(names);
  const auto known = [&](const MFraction& f) {
    const auto used = used_variables(f);
    return std::all_of(used.begin(), used.end(),
                       [&](std::size_t i) { return ring->find(s.ring()->name(i)).has_value(); });
  };
  if (!known(ode.r))
    throw InvalidArgument("r depends on algebraic constants and on parameters at the same time");
  strata::Question q;
  q.z = ring->index(s.ring()->name(ode.z));
  q.r = transfer(ode.r, ring);
  for (const auto& a : s.assumptions)
    if (known(a.value)) add_assumption(q.assumptions, a, ring);
  const auto levels = level_parameters(s);
  const auto chosen = [&](std::size_t i) {
    return i != ode.z && !uses(ode.r, i) &&
           std::find(levels.begin(), levels.end(), i) != levels.end();
  };
  for (const auto& whole : ode.generic)
    for (const MPoly& g : strata::irreducible_parts(whole)) {
      if (!known(MFraction(g))) continue;
      const auto used = used_variables(g);
      if (std::all_of(used.begin(), used.end(), chosen)) // a level where it does not vanish
        q.assumptions.require(transfer(MFraction(g), ring), strata::Sign::nonzero);
      else
        q.generic.push_back({coefficients(transfer(MFraction(g), ring).num(), q.z),
                             "the reduction divides by " + brief(MFraction(g), 80)});
    }
  return q;
}

std::vector<std::size_t> level_parameters(const System& s) {
  std::vector<std::size_t> levels;
  for (const std::size_t i : s.field.parameters)
    if (std::none_of(s.field.components.begin(), s.field.components.end(),
                     [&](const MFraction& x) { return uses(x, i); }))
      levels.push_back(i);
  return levels;
}

strata::StrataLimits strata_limits(const System& s, const AlgebraicOde& ode,
                                   const CheckOptions& options) {
  strata::StrataLimits limits;
  limits.decide = options.decide;
  limits.decide.variable = s.ring()->name(ode.z);
  return limits;
}

} // namespace kov
