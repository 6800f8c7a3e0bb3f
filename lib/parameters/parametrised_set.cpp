#include "parameters/parametrised_set.hpp"

#include "exact/error.hpp"
#include "exact/ideal.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "parameters/integers.hpp"
#include "parameters/reals.hpp"
#include "parameters/signs.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr long z3_terms = 40; // larger polynomials are beyond its limit anyway
constexpr long z3_degree = 12;

constexpr std::size_t most_saturated = 6; // polynomials that an ideal is saturated by
constexpr double groebner_work = 1e5;     // the same on every machine

bool is_small(const MPoly& p, long times = 1) {
  if (p.length() > times * z3_terms) return false;
  for (long i = 0; i < p.length(); ++i) {
    long total = 0;
    for (const unsigned long e : p.exponents(i))
      total += static_cast<long>(e);
    if (total > times * z3_degree) return false;
  }
  return true;
}

} // namespace

ParametrisedSet::ParametrisedSet(Ring ring, Assumptions assumptions)
    : ring_(std::move(ring)), assumptions_(std::move(assumptions)) {
  for (const auto& c : assumptions_.conditions)
    if (c.sign == Sign::nonzero && !is_zero(c.p))
      for (auto& f : irreducible_parts(c.p))
        if (!is_among(f, nonzero_)) nonzero_.push_back(std::move(f));
  assumed_nonzero_ = nonzero_;
}

bool ParametrisedSet::is_real(std::size_t variable) const {
  return is_among(variable, assumptions_.real);
}

bool ParametrisedSet::is_rational(std::size_t variable) const {
  return is_among(variable, assumptions_.rational);
}

bool ParametrisedSet::has_no_admissible_root(const MPoly& p) const {
  const auto used = used_variables(p);
  if (used.size() != 1) return false;
  if (degree(p, used[0]) > 1) return is_rational(used[0]);
  const auto line = coefficients(p, used[0]);
  const Substitution root{{used[0], -(MFraction(line[0]) / MFraction(line[1]))}};
  return std::ranges::any_of(assumptions_.memberships, [&](const Membership& m) {
    const auto in = used_variables(m.value);
    return in.size() == 1 && in[0] == used[0] && is_constant(m.value.den()) &&
           violated(m, substitute(m.value, root));
  });
}

bool ParametrisedSet::is_real(const MPoly& p) const {
  const auto used = used_variables(p);
  return std::ranges::all_of(used, [&](std::size_t i) { return is_real(i); });
}

MFraction ParametrisedSet::restrict(const MFraction& f) const {
  return solved_.empty() ? f : substitute(f, solved_);
}

int ParametrisedSet::sign_of_irreducible(const MPoly& p) const {
  for (const auto& [known, s] : signs_)
    if (known == p) return s;
  int s = SignProver(ring_, assumptions_.conditions, nonzero_, assumptions_.real).sign_of(p);
  const auto conditions = real_conditions();
  const bool ordered = std::ranges::any_of(conditions, certify::is_ordered, &Condition::sign);
  if (s == 0 && is_real(p) && ordered) {
    for (const int candidate : {1, -1}) {
      if (!refutes({{candidate > 0 ? -p : p, Sign::nonnegative}})) continue;
      s = candidate;
      break;
    }
  }
  signs_.emplace_back(p, s);
  return s;
}

int ParametrisedSet::sign_of(const MPoly& p) const {
  if (is_zero(p)) return 0;
  const auto [content, factors] = factor(p);
  int s = sign(content);
  for (const auto& f : factors) {
    if (f.exponent % 2 == 0 && is_real(f.base) && provably_nonzero(f.base)) continue;
    const int one = sign_of_irreducible(f.base);
    if (one == 0) return 0;
    if (f.exponent % 2 != 0) s *= one;
  }
  return s;
}

int ParametrisedSet::exact_sign_of(const MPoly& p) const {
  if (is_zero(p)) return 0;
  const SignProver prover(ring_, assumptions_.conditions, nonzero_, assumptions_.real);
  if (const int whole = prover.sign_of(p)) return whole;
  const auto [content, factors] = factor(p);
  int s = sign(content);
  for (const auto& f : factors) {
    if (f.exponent % 2 == 0 && is_real(f.base) && is_among(f.base, nonzero_)) continue;
    const int one = prover.sign_of(f.base);
    if (one == 0) return 0;
    if (f.exponent % 2 != 0) s *= one;
  }
  return s;
}

bool ParametrisedSet::provably_nonzero(const MPoly& p) const {
  return !is_zero(p) && !doubtful_factor(p);
}

std::optional<MPoly> ParametrisedSet::doubtful_factor(const MPoly& p) const {
  return doubtful_factor(p, relations_);
}

std::optional<MPoly> ParametrisedSet::doubtful_factor(const MPoly& p,
                                                      const std::vector<Relation>& unused) const {
  if (is_constant(p)) return std::nullopt;
  for (const auto& f : irreducible_parts(p))
    if (!is_among(f, nonzero_) && !differs_from_relations(f, unused) &&
        !has_no_admissible_root(f) && sign_of_irreducible(f) == 0)
      return f;
  return std::nullopt;
}

// A common zero of f and p is one of their resultant, as the leading coefficient of p has none.
// Each relation is used once: two of them in each other's variables would go round for ever.
bool ParametrisedSet::differs_from_relations(const MPoly& f,
                                             const std::vector<Relation>& unused) const {
  for (std::size_t i = 0; i < unused.size(); ++i) {
    const Relation& r = unused[i];
    if (!uses(f, r.variable) || !is_small(f)) continue;
    const MPoly left = resultant(f, r.p, r.variable);
    if (is_zero(left)) continue;
    std::vector<Relation> others(unused);
    others.erase(others.begin() + static_cast<long>(i));
    if (!doubtful_factor(left, others)) return true;
  }
  return false;
}

ParametrisedSet ParametrisedSet::with_relation(const MPoly& p, std::size_t variable,
                                               bool implied) const {
  ParametrisedSet r(*this);
  if (!implied) r.path_.push_back({p, Sign::zero});
  r.relations_.push_back({p, variable});
  r.signs_.clear();
  std::erase_if(r.assumptions_.conditions, [&](const Condition& c) {
    return c.sign == Sign::zero && !is_zero(c.p) && divides(p, c.p);
  });
  return r;
}

Truth ParametrisedSet::is_integral(const MFraction& v) const {
  return kov::is_integral(assumptions_.memberships, v);
}

std::vector<Condition> ParametrisedSet::real_conditions() const {
  std::vector<Condition> all; // without those that would keep it busy: it refutes less
  constexpr long times = 5;
  for (const auto& c : assumptions_.conditions)
    if (c.sign != Sign::nonzero && is_real(c.p) && is_small(c.p, times)) all.push_back(c);
  for (const auto& p : nonzero_)
    if (is_real(p) && is_small(p, times)) all.push_back({p, Sign::nonzero});
  return all;
}

bool ParametrisedSet::refutes(const std::vector<Condition>& more) const {
  auto all = real_conditions();
  if (!std::ranges::all_of(more, [](const Condition& c) { return is_small(c.p); })) return false;
  all.insert(all.end(), more.begin(), more.end());
  if (has_real_point(all, Budget{}) != Truth::no) return false;
  const std::string claim = joined(more, [](const Condition& c) { return to_string(c); });
  const std::string where = path_.empty() ? "" : " where " + to_string(path_);
  trusted_.push_back(
      {Trusted::Step::refuted_by_z3, (claim.empty() ? "" : " and " + claim) + where});
  return true;
}

bool ParametrisedSet::implies_nonzero(const MPoly& p) const {
  try {
    const MFraction f = restrict(MFraction(p));
    const auto parts = is_zero(f) ? std::vector<MPoly>{p} : irreducible_parts(f.num());
    const SignProver prover(ring_, assumptions_.conditions, assumed_nonzero_, assumptions_.real);
    return std::ranges::all_of(parts, [&](const MPoly& q) {
      return prover.sign_of(q) != 0 || is_among(q, assumed_nonzero_) || has_no_admissible_root(q);
    });
  } catch (const DomainError&) {
    return false;
  }
}

std::optional<std::size_t> ParametrisedSet::made_real_by(const MFraction& f) const {
  if (!f.ring()) return std::nullopt;
  auto open = used_variables(f);
  std::erase_if(open, [&](std::size_t i) { return is_real(i); });
  if (open.size() != 1) return std::nullopt;
  const MPoly num = f.num(), den = f.den();
  if (degree(num, open[0]) > 1 || degree(den, open[0]) > 1) return std::nullopt;
  const auto at = [&](const MPoly& p, std::size_t k) {
    const auto all = coefficients(p, open[0]);
    return k < all.size() ? all[k] : MPoly(ring_);
  };
  const MPoly determinant = at(num, 1) * at(den, 0) - at(num, 0) * at(den, 1);
  if (is_zero(determinant)) return std::nullopt;
  const auto is_a_factor = [&](const MPoly& q) { // of something positive
    return std::ranges::any_of(assumptions_.conditions, [&](const Condition& c) {
      return c.sign == Sign::positive && divides(q, c.p);
    });
  };
  for (const MPoly& q : irreducible_parts(determinant))
    if (!implies_nonzero(q) && !is_a_factor(q)) return std::nullopt;
  return open[0];
}

bool ParametrisedSet::has_no_real_root(const MPoly& p) const {
  return is_real(p) && refutes({{p, Sign::zero}});
}

ParametrisedSet ParametrisedSet::where_nonzero(const MPoly& p) const {
  ParametrisedSet r(*this);
  std::erase_if(r.signs_, [](const auto& known) { return known.second == 0; });
  r.nonzero_.push_back(p);
  r.path_.push_back({p, Sign::nonzero});
  return r;
}

std::variant<ParametrisedSet, ParametrisedSet::Empty, ParametrisedSet::Split,
             ParametrisedSet::Stuck>
ParametrisedSet::where_zero(const MPoly& p) const {
  KOV_ENSURE(!is_zero(p));
  if (is_constant(p)) return Empty{{}};
  const auto used = used_variables(p);
  std::optional<MPoly> obstacle;
  for (const bool constant_first : {true, false})
    for (auto x = used.rbegin(); x != used.rend(); ++x) {
      if (degree(p, *x) != 1) continue;
      const MPoly slope = coefficients(p, *x)[1];
      if (is_constant(slope) != constant_first) continue;
      if (const auto doubt = doubtful_factor(slope)) {
        if (!obstacle) obstacle = doubt;
        continue;
      }
      const auto solution = solve(p, *x);
      if (const auto* region = std::get_if<ParametrisedSet>(&solution)) return *region;
      return std::get<Empty>(solution);
    }
  if (obstacle) return Split{*obstacle};
  return Stuck{};
}

std::variant<ParametrisedSet, ParametrisedSet::Empty> ParametrisedSet::solve(const MPoly& p,
                                                                             std::size_t x) const {
  const auto line = coefficients(p, x);
  const Substitution step{{x, -(MFraction(line[0]) / MFraction(line[1]))}};
  ParametrisedSet r(ring_, {});
  r.path_ = path_;
  r.path_.push_back({p, Sign::zero});
  for (const auto& [i, value] : solved_)
    r.solved_[i] = substitute(value, step);
  r.solved_[x] = step.at(x);
  const auto keep_nonzero = [&](const MPoly& q) {
    for (auto& f : irreducible_parts(q))
      if (!is_among(f, r.nonzero_)) r.nonzero_.push_back(std::move(f));
  };
  keep_nonzero(line[1]);
  for (const auto& q : nonzero_) {
    const MFraction there = substitute(q, step);
    if (is_zero(there)) return Empty{{}};
    keep_nonzero(there.num());
  }
  for (const auto& q : assumed_nonzero_)
    for (auto& f : irreducible_parts(substitute(q, step).num()))
      r.assumed_nonzero_.push_back(std::move(f));
  for (const auto& c : assumptions_.conditions) {
    if (c.sign == Sign::nonzero) continue; // in nonzero_
    const MFraction there = substitute(c.p, step);
    if (is_zero(there)) {
      if (c.sign == Sign::positive) return Empty{{}};
      continue;
    }
    const bool ordered = certify::is_ordered(c.sign);
    if (ordered && !is_real(there.den())) { // num/den > 0 says nothing about the sign of num * den
      if (c.sign == Sign::positive) keep_nonzero(there.num());
      continue;
    }
    r.assumptions_.conditions.push_back(
        {ordered && !is_constant(there.den()) ? there.num() * there.den() : there.num(), c.sign});
  }
  for (const auto& m : assumptions_.memberships)
    r.assumptions_.memberships.push_back({substitute(m.value, step), m.in_integers});
  r.assumptions_.real = assumptions_.real;
  r.assumptions_.rational = assumptions_.rational;
  // x is a Moebius function over Q of one other parameter: real or rational together
  if (const auto used = used_variables(step.at(x)); used.size() == 1 && degree(p, used[0]) == 1) {
    if (is_real(x) && !is_real(used[0])) r.assumptions_.real.push_back(used[0]);
    if (is_rational(x) && !is_rational(used[0])) r.assumptions_.rational.push_back(used[0]);
  }
  for (const auto& relation : relations_) {
    if (!uses(relation.p, x)) {
      r.relations_.push_back(relation);
      continue;
    }
    // a^3 - b^2 at a = 0 is -b^2, no longer irreducible: an equation that is looked at anew
    const MFraction there = substitute(relation.p, step);
    if (is_zero(there)) continue;
    if (is_constant(there)) return Empty{{}};
    r.assumptions_.conditions.push_back({there.num(), Sign::zero});
  }
  if (r.is_empty()) return Empty{r.trusted_};
  return r;
}

std::optional<MPoly> ParametrisedSet::pending() const {
  for (const auto& c : assumptions_.conditions)
    if (c.sign == Sign::zero && !is_zero(c.p)) return c.p;
  return std::nullopt;
}

// 1 is in the ideal of the equations that are not solved, saturated by what does not vanish.
bool ParametrisedSet::equations_contradict() const {
  auto equations = mapped<MPoly>(relations_, [&](const auto& relation) { return relation.p; });
  for (const auto& c : assumptions_.conditions)
    if (c.sign == Sign::zero && !is_zero(c.p)) equations.push_back(c.p);
  if (equations.empty()) return false;
  if (equations.size() == 1) { // by the Nullstellensatz
    const auto parts = irreducible_parts(equations[0]);
    return std::ranges::all_of(parts, [&](const MPoly& p) { return is_among(p, nonzero_); });
  }
  const std::vector<std::size_t> variables = used_by_any(equations);
  std::vector<MPoly> nonzero;
  for (const auto& p : nonzero_) {
    if (uses_only(p, variables) && nonzero.size() < most_saturated && is_small(p))
      nonzero.push_back(p);
  }
  try {
    Budget little;
    little.max_work = groebner_work;
    return Ideal(ring_, variables, equations, nonzero, little).is_unit();
  } catch (const OutOfBudget&) {
    return false; // counts as not empty
  }
}

bool ParametrisedSet::is_empty_exactly() const {
  if (equations_contradict()) return true;
  const SignProver prover(ring_, assumptions_.conditions, nonzero_, assumptions_.real);
  for (const auto& c : assumptions_.conditions) {
    if (c.sign == Sign::nonzero && is_zero(c.p)) return true;
    if (c.sign == Sign::zero && !is_zero(c.p) && is_constant(c.p)) return true;
    if (c.sign == Sign::positive && is_zero(c.p)) return true;
    if (!certify::is_ordered(c.sign)) continue;
    if (is_constant(c.p) && !is_zero(c.p) && sign(c.p.coefficient(0)) < 0) return true;
  }
  for (std::size_t i = 0; i < assumptions_.conditions.size(); ++i) {
    const Condition& c = assumptions_.conditions[i];
    if (!certify::is_ordered(c.sign)) continue;
    auto others = assumptions_.conditions;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (SignProver(ring_, others, nonzero_, assumptions_.real).sign_of(c.p) < 0) return true;
  }
  return contradict(assumptions_.memberships);
}

bool ParametrisedSet::is_empty() const {
  if (is_empty_exactly()) return true;
  const auto conditions = real_conditions();
  const bool ordered = std::ranges::any_of(conditions, certify::is_ordered, &Condition::sign);
  return ordered && refutes({});
}

} // namespace kov
