#include "integrability/parameters.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "parameters/refutation.hpp"
#include "system/relations.hpp"

#include <algorithm>

namespace kov {
namespace {

void add_assumption(Assumptions& all, const Assumption& a, const Ring& ring) {
  const MFraction value = transfer(a.value, ring);
  if (const auto* sign = std::get_if<Sign>(&a.says)) {
    if (!is_constant(value) || !a.holds_at(to_rational(value))) all.require(value, *sign);
    return;
  }
  if (a.is(Sort::integer)) all.require_integral(value, true);
  a.is(Sort::real) ? all.declare_real(value) : all.declare_rational(value);
}

// One of several variables in it is not known to be real.
bool is_open(const Assumption& a, const System& s, const Ring& ring, const Assumptions& known) {
  const auto used = used_variables(a.value);
  return used.size() > 1 && std::ranges::count_if(used, [&](std::size_t i) {
                              return !is_among(*ring->find(s.ring()->name(i)), known.real);
                            }) == 1;
}

bool is_about(const MFraction& f, const Ring& its, const Ring& ring) {
  const auto used = used_variables(f);
  return std::ranges::all_of(used,
                             [&](std::size_t i) { return ring->find(its->name(i)).has_value(); });
}

std::vector<Assumption> about(const System& s, const Ring& ring) {
  std::vector<Assumption> all;
  std::ranges::copy_if(s.assumptions, std::back_inserter(all),
                       [&](const Assumption& a) { return is_about(a.value, s.ring(), ring); });
  return all;
}

// At special values there may be several systems, and the curve lies in one of them.
void add_special_relations(const System& s, const Ring& ring, strata::Question& q) {
  std::vector<MPoly> special;
  for (const MPoly& g : where_relations_fall_apart(s.field))
    special.push_back(transfer(MFraction(g), ring).num());
  if (special.empty()) return;
  q.generic.emplace_back();
  q.generic.back() = {std::move(special), strata::Genericity::Else::relations, {}};
}

} // namespace

Assumptions assumptions_on(const System& s, const Ring& ring) {
  const std::vector<Assumption> given = about(s, ring);
  std::vector<std::size_t> real;
  for (const std::string& name : s.real)
    if (const auto i = ring->find(name)) real.push_back(*i);
  for (;;) { // with more that is real more can be said, and more must be real
    Assumptions all;
    all.real = real;
    for (const Assumption& a : given)
      add_assumption(all, a, ring);
    for (const MPoly& p : s.domain.nonzero())
      if (is_about(MFraction(p), s.ring(), ring))
        all.require(transfer(MFraction(p), ring), Sign::nonzero);
    real = all.real;
    for (const Assumption& a : given)
      if (!a.is(Sign::zero) && !a.is(Sign::nonzero) && is_open(a, s, ring, all)) // it is real
        if (const auto i = ParametrisedSet(ring, all).made_real_by(transfer(a.value, ring)))
          add_once(real, *i);
    if (real.size() == all.real.size()) return all;
  }
}

namespace {

// The algebraic constants on which the question depends, with those to which relations tie them.
std::vector<std::size_t> constants_in(const System& s, const AlgebraicOde& ode) {
  std::vector<MFraction> all(ode.generic.begin(), ode.generic.end());
  all.push_back(ode.r);
  for (const Assumption& a : s.assumptions)
    all.push_back(a.value);
  for (const auto& domain : {s.domain.nonzero(), where_relations_fall_apart(s.field)})
    all.insert(all.end(), domain.begin(), domain.end());
  std::vector<std::size_t> needed;
  for (std::size_t before = 1; needed.size() != std::exchange(before, needed.size());) {
    needed.clear();
    for (const std::size_t i : s.field.constants)
      if (any_uses(all, i)) needed.push_back(i);
    for (const MPoly& relation : s.field.relations)
      if (std::ranges::any_of(needed, [&](std::size_t i) { return uses(relation, i); }))
        all.emplace_back(relation);
  }
  return needed;
}

} // namespace

strata::Question strata_question(const System& s, const AlgebraicOde& ode) {
  std::vector<std::string> names;
  const auto constants = constants_in(s, ode);
  for (const std::size_t i : constants)
    names.push_back(s.ring()->name(i));
  for (const std::size_t i : s.field.parameters)
    names.push_back(s.ring()->name(i));
  names.push_back(s.ring()->name(ode.z));
  const Ring ring = make_ring(names);
  const auto known = [&](const MFraction& f) {
    const auto used = used_variables(f);
    return std::ranges::all_of(
        used, [&](std::size_t i) { return ring->find(s.ring()->name(i)).has_value(); });
  };
  if (!known(ode.r))
    throw InvalidArgument("r depends on more than parameters and algebraic constants");
  strata::Question q;
  q.z = ring->index(s.ring()->name(ode.z));
  q.r = transfer(ode.r, ring);
  q.assumptions = assumptions_on(s, ring);
  for (const auto& relation : s.field.relations) { // among the algebraic constants
    const auto used = used_variables(relation);
    if (std::ranges::all_of(used, [&](std::size_t i) { return is_among(i, constants); }))
      q.assumptions.require(transfer(relation, ring), Sign::zero);
  }
  const auto levels = level_parameters(s);
  const auto chosen = [&](std::size_t i) {
    return i != ode.z && !uses(ode.r, i) && is_among(i, levels);
  };
  for (const auto& whole : ode.generic)
    for (const MPoly& g : irreducible_parts(whole)) {
      if (!known(MFraction(g))) continue;
      const auto used = used_variables(g);
      if (std::ranges::all_of(used, chosen)) // a level where it does not vanish
        q.assumptions.require(transfer(MFraction(g), ring), Sign::nonzero);
      else
        q.generic.push_back({coefficients(transfer(MFraction(g), ring).num(), q.z),
                             strata::Genericity::Else::division, brief(MFraction(g), 80)});
    }
  add_special_relations(s, ring, q);
  return q;
}

namespace {

bool occurs(const std::vector<Equation>& all, std::size_t i) {
  return std::ranges::any_of(all, [i](const Equation& e) { return uses(e.difference, i); });
}

// Only what the file assumes contains the parameter: it restricts the others, and is not a level.
bool is_auxiliary(const System& s, std::size_t i) {
  return std::ranges::any_of(s.assumptions,
                             [i](const Assumption& a) { return uses(a.value, i); }) &&
         s.reductions.empty() && std::ranges::none_of(s.manifolds, [i](const ManifoldSpec& m) {
           return occurs(m.equations, i) || occurs(m.levels, i);
         });
}

} // namespace

std::vector<std::size_t> level_parameters(const System& s) {
  // whatever the equations of motion rest on
  std::vector<MFraction> equations(s.field.components);
  for (const auto& f : s.field.functions)
    equations.insert(equations.end(), f.gradient.begin(), f.gradient.end());
  equations.insert(equations.end(), s.field.relations.begin(), s.field.relations.end());
  if (s.field.poisson)
    for (const auto& row : *s.field.poisson)
      equations.insert(equations.end(), row.begin(), row.end());
  std::vector<std::size_t> levels;
  for (const std::size_t i : s.field.parameters)
    if (!any_uses(equations, i) && !is_auxiliary(s, i)) levels.push_back(i);
  return levels;
}

namespace {

ParametrisedSet assumed_region(const System& s) { return {s.ring(), assumptions_on(s, s.ring())}; }

} // namespace

bool contradicts_itself(const System& s) {
  if (s.assumptions.empty() && s.domain.lists().empty()) return false;
  const ParametrisedSet all = assumed_region(s);
  return all.is_empty() || all.refutes({});
}

void require_consistent(const System& s) {
  if (contradicts_itself(s)) throw InvalidArgument("the assumptions contradict each other");
}

std::optional<std::vector<Trusted>>
refuted_over_the_reals(const System& s, const std::vector<Condition>& conditions) {
  const ParametrisedSet all = assumed_region(s);
  const auto is_real = [&](const Condition& c) { return all.is_real(c.p); };
  if (!std::ranges::all_of(conditions, is_real)) return std::nullopt;
  if (!all.refutes(conditions)) return std::nullopt; // most sets are not empty, and Z3 says so soon
  auto known = assumptions_on(s, s.ring()).conditions;
  std::erase_if(known, [&](const Condition& c) { return !is_real(c); });
  known.insert(known.end(), conditions.begin(), conditions.end());
  if (is_refuted_exactly(known)) return std::vector<Trusted>{};
  return std::vector{all.trusted().back()};
}

namespace {

// The conditions in real variables; some in several variables, from which signs of single ones may
// follow.
std::vector<Condition> real_conditions(const System& s) {
  const ParametrisedSet all = assumed_region(s);
  auto known = assumptions_on(s, s.ring()).conditions;
  std::erase_if(known, [&](const Condition& c) { return !all.is_real(c.p); });
  return known;
}

} // namespace

int sign_that_follows(const System& s, const MPoly& p) {
  const auto known = real_conditions(s);
  if (std::ranges::none_of(known, certify::is_ordered, &Condition::sign) ||
      !assumed_region(s).is_real(p))
    return 0;
  const auto found = sign_follows(known, p);
  return found ? found->sign : 0;
}

System with_signs_that_follow(System s) {
  auto known = real_conditions(s);
  const auto is_one_sign = [](const MPoly& p) {
    const auto used = used_variables(p);
    if (used.size() != 1) return false;
    const MPoly x = MPoly::variable(p.ring(), used.front());
    return p == x || p == -x;
  };
  const auto is_news = [&](const Condition& c) {
    return c.sign == Sign::nonnegative || (c.sign == Sign::positive && !is_one_sign(c.p));
  };
  if (std::ranges::none_of(known, is_news)) return s;
  const auto levels = level_parameters(s);
  const auto is_known = [&](const MPoly& x) {
    return std::ranges::any_of(known, [&](const Condition& c) {
      return c.sign == Sign::positive && (c.p == x || c.p == -x);
    });
  };
  const ParametrisedSet all = assumed_region(s);
  for (bool more = true; more;) { // with one sign another may follow
    more = false;
    for (const std::size_t i : s.field.parameters) {
      const MPoly x = MPoly::variable(s.ring(), i);
      if (!all.is_real(i) || is_known(x) || is_among(i, levels)) continue;
      const auto found = sign_follows(known, x);
      if (!found) continue;
      const MPoly positive = found->sign > 0 ? x : -x;
      known.push_back({positive, Sign::positive});
      s.assumptions.push_back({Sign::positive, MFraction(positive)});
      more = true;
    }
  }
  return s;
}

std::vector<MPoly> not_excluded(const System& s, const std::vector<MPoly>& generic) {
  const ParametrisedSet all = assumed_region(s);
  std::vector<MPoly> left;
  for (const MPoly& g : generic)
    if (!is_constant(g) && all.doubtful_factor(g)) left.push_back(g);
  return left;
}

bool may_vanish_identically(const System& s, const MPoly& d) {
  const std::vector<MPoly> parts = nonzero_coefficients(d, s.field.main_variables());
  return not_excluded(s, parts).size() == parts.size();
}

bool somewhere_not_abelian(const strata::StrataAnswer& answer) {
  const auto all = answer.told_apart();
  return std::ranges::any_of(all,
                             [](const strata::Stratum& x) { return x.leaf.abelian == Truth::no; });
}

strata::StrataLimits strata_limits(const System& s, const AlgebraicOde& ode,
                                   const CheckOptions& options) {
  strata::StrataLimits limits;
  limits.decide = options.decide;
  limits.decide.variable = s.ring()->name(ode.z);
  return limits;
}

} // namespace kov
