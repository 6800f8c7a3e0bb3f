#include "proof/condition/set.hpp"

#include "exact/to_poly.hpp"
#include "proof/text/limits.hpp"
#include "proof/text/refused.hpp"

#include <algorithm>
#include <utility>

namespace kov::certify {

namespace {

constexpr mp_limb_t max_number_bits = 33220; // 10000 digits
constexpr std::size_t max_with = 100;

void need_short(const Integer& n) {
  need_within(fmpz_bits(n.raw()) <= max_number_bits, "a limit: the length of a number");
}

} // namespace

MPoly Root::operator()(const MPoly& f, std::size_t x, long N) const {
  const long n = std::max(degree(f, x), 0L);
  if (is_zero(f) || (n == 0 && N <= 0)) return f;
  a_.charge(static_cast<double>(n));
  const MPoly sum = a_.homogeneous(coefficients(f, x), minus_m_, l_);
  return N > n ? a_.times(sum, a_.power(l_, static_cast<unsigned long>(N - n))) : sum;
}

bool vanishes(const MPoly& f, const MPoly* p, Arithmetic& a) {
  return is_zero(f) || (p && !is_zero(*p) && a.quotient(primitive(f), primitive(*p)));
}

ConditionSet::ConditionSet(Ring ring, Arithmetic& a, std::vector<bool> names,
                           std::vector<bool> real, std::vector<bool> rational)
    : ring_(std::move(ring)), arithmetic_(&a), names_(std::move(names)), real_(std::move(real)),
      rational_(std::move(rational)) {
  rational_.resize(ring_->size(), false);
}

const MPoly& ConditionSet::condition(std::size_t i, std::initializer_list<Sign> signs) const {
  need(i < conditions_.size(), "there is no such condition");
  need(std::ranges::find(signs, conditions_[i].sign) != signs.end(),
       signs.size() == 1 ? "the condition is not an equation" : "the condition has no sign");
  return conditions_[i].p;
}

const Membership& ConditionSet::membership(std::size_t i) const {
  need(i < memberships_.size(), "there is no such membership");
  return memberships_[i];
}

const std::vector<MPoly>& ConditionSet::group(std::size_t i) const {
  need(i < groups_.size(), "there is no such group");
  return groups_[i];
}

bool ConditionSet::is_rational(const MPoly& p) const { return is_in(p, rational_); }

void ConditionSet::assume(Condition c) {
  if (excludes_zero(c.sign)) added_.push_back(c.p);
  conditions_.push_back(std::move(c));
}

void ConditionSet::forget() {
  if (excludes_zero(conditions_.back().sign)) added_.pop_back();
  conditions_.pop_back();
  if (divided_ <= added_.size()) return;
  units_.clear();
  divided_ = 0;
}

void ConditionSet::assume(Membership m) {
  added_.push_back(m.value.den);
  memberships_.push_back(std::move(m));
}

bool ConditionSet::is_real(const MPoly& p) const {
  return is_in(p, real_) || std::ranges::any_of(conditions_, [&](const Condition& c) {
           if (!is_ordered(c.sign) || is_zero(c.p)) return false;
           arithmetic_->charge(1 + static_cast<double>(c.p.length()));
           return is_multiple(p, c.p);
         });
}

MPoly ConditionSet::rest(MPoly p) const {
  if (is_zero(p)) return p;
  p = primitive(p);
  for (const MPoly& g : units()) {
    if (is_constant(p)) break;
    if (is_zero(g)) continue;
    while (auto q = arithmetic_->quotient(p, g))
      p = *std::move(q);
  }
  return p;
}

bool ConditionSet::is_unit(const MPoly& p) const {
  if (is_zero(p) || is_constant(p)) return !is_zero(p);
  return is_constant(rest(p));
}

bool ConditionSet::is_positive(const MPoly& p) const {
  if (is_zero(p)) return false;
  if (is_constant(p)) return sign(p.coefficient(0)) > 0;
  const MPoly f = primitive(p);
  return std::ranges::any_of(conditions_, [&](const Condition& c) {
    if (c.sign != Sign::positive) return false;
    arithmetic_->charge(1 + static_cast<double>(c.p.length()));
    return primitive(c.p) == f;
  });
}

const std::vector<MPoly>& ConditionSet::units() const {
  while (divided_ < added_.size())
    divide(added_[divided_++]);
  return units_;
}

// The new one is divided by the old ones and these by it.
void ConditionSet::divide(const MPoly& unit) const {
  MPoly g = primitive(unit);
  const auto reduce = [&](MPoly& f, const MPoly& by) {
    while (!is_zero(f) && !is_zero(by) && !is_constant(f)) {
      auto q = arithmetic_->quotient(f, by);
      if (!q) break;
      f = *std::move(q);
    }
  };
  for (const MPoly& f : units_)
    reduce(g, f);
  if (!is_zero(g) && is_constant(g)) return;
  for (MPoly& f : units_)
    reduce(f, g);
  std::erase_if(units_, [](const MPoly& f) { return !is_zero(f) && is_constant(f); });
  units_.push_back(std::move(g));
}

bool ConditionSet::is_strict(const SignTerm& t) const {
  return is_unit(t.q) && std::ranges::all_of(t.powers, [&](const auto& x) {
           const Condition& c = conditions_[x.first];
           return c.sign != Sign::nonnegative || is_unit(c.p);
         });
}

bool ConditionSet::has_sign(const SignTerm& t) const {
  return is_real(t.q) && std::ranges::all_of(t.powers, [&](const auto& x) {
           const Condition& c = conditions_[x.first];
           return is_ordered(c.sign) || (x.second % 2 == 0 && is_real(c.p));
         });
}

std::pair<MPoly, Integer> ConditionSet::sum(const std::vector<SignTerm>& terms,
                                            bool positive) const {
  Arithmetic& a = *arithmetic_;
  Integer k(1);
  for (const SignTerm& t : terms) {
    need(t.c > Rational(0), "a factor is not positive");
    need_short(t.c.num());
    need_short(t.c.den());
    k = a.common_multiple(k, t.c.den());
    need_short(k);
  }
  MPoly total(ring_);
  for (const SignTerm& t : terms) {
    MPoly f = a.times(t.q, t.q);
    for (const auto& [i, e] : t.powers)
      f = a.times(f, a.power(condition(i, {Sign::positive, Sign::nonnegative, Sign::nonzero}), e));
    total = a.plus(total, a.scaled(f, t.c.num() * exact_div(k, t.c.den())));
  }
  const auto is_plain = [&](const SignTerm& t) { // needs no division to be strict
    return is_constant(t.q) && std::ranges::none_of(t.powers, [&](const auto& x) {
             return conditions_[x.first].sign == Sign::nonnegative;
           });
  };
  need(std::ranges::any_of(terms, [&](const SignTerm& t) { return is_plain(t) && is_strict(t); }) ||
           std::ranges::any_of(terms,
                               [&](const SignTerm& t) { return !is_plain(t) && is_strict(t); }),
       "no term is known to be positive");
  need((terms.size() == 1 && !positive) ||
           std::ranges::all_of(terms, [&](const SignTerm& t) { return has_sign(t); }),
       "a factor is not real");
  return {total, k};
}

void ConditionSet::need_violated(std::size_t i, const Rational& c, const MPoly* p) const {
  const auto& [value, integral] = membership(i);
  need(is_integer(c) != integral, "the membership allows this value");
  const MPoly f = arithmetic_->minus(scaled(value.num, c.den()), scaled(value.den, c.num()));
  need(vanishes(f, p, *arithmetic_), "the membership has another value there");
}

// v is an integer with w and those of the sum; or w would be one with v, or a constant that is none.
void ConditionSet::need_shown(const ShownMembership& x) const {
  const auto need_multiple = [](const Integer& times) {
    need_within(abs(Rational(times)) <= Rational(max_multiple), "a limit: times");
  };
  need(is_unit(x.value.den), "a denominator may vanish");
  need_within(x.with.size() <= max_with, "a limit: the number of memberships");
  need_multiple(x.times);
  const auto& [w, in] = membership(x.membership);
  need(in || !x.integral, "the membership says something else");
  const Fraction& left = x.integral ? w : x.value;
  Fraction sum{scaled(left.num, x.times), left.den};
  for (const MultipleOfMembership& m : x.with) {
    need_multiple(m.times);
    const auto& [f, integer] = membership(m.membership);
    need(integer, "a membership of the sum is none of integers");
    sum = combined(sum, Rational(m.times), f, *arithmetic_);
  }
  const auto c =
      constant_value(combined(sum, Rational(-1), x.integral ? x.value : w, *arithmetic_));
  need(c && is_integer(*c) == (x.integral || !in), "nothing follows from the memberships");
}

// The denominator of a rational root divides the leading coefficient: it has an image modulo q.
void ConditionSet::need_no_rational_root(const MPoly& p, mp_limb_t q) const {
  const auto used = used_variables(p);
  need(used.size() == 1 && is_rational(p), "p is not in one rational parameter");
  need(q < max_lemma_prime && n_is_prime(q) != 0, "the prime is none below 10000");
  arithmetic_->charge(static_cast<double>(q) * static_cast<double>(degree(p, used[0]) + 1));
  const NmodPoly f = to_poly(p, used[0], q);
  need(degree(f) == degree(p, used[0]), "the prime divides the leading coefficient");
  for (mp_limb_t x = 0; x < q; ++x)
    need(evaluate(f, x) != 0, "p has a root modulo the prime");
}

Root ConditionSet::solve(const MPoly& p, std::size_t x) {
  need(names_[x], "the parameter was solved for before");
  need(degree(p, x) == 1, "the polynomial is not linear in the parameter");
  const Coefficients c = coefficients(p, x);
  need(is_unit(c[1]), "the leading coefficient is not known to be nonzero");
  Root root(*arithmetic_, c[1], c[0]);
  added_ = units();
  for (MPoly& f : added_)
    f = root(f, x);
  added_.push_back(c[1]);
  replace(x, root, is_real(c[1]));
  units_.clear();
  divided_ = 0;
  learn_sorts(p, x);
  hide(x);
  return root;
}

void ConditionSet::replace(std::size_t x, const Root& root, bool real) {
  for (Condition& c : conditions_) {
    const long n = degree(c.p, x);
    if (n <= 0 || c.sign == Sign::dropped) continue;
    const bool ordered = is_ordered(c.sign);
    c.p = root(c.p, x, ordered && real ? n + n % 2 : n); // l^2 > 0
    if (ordered && !real) c.sign = Sign::dropped;        // what is positive is a unit
  }
  for (auto& [value, integral] : memberships_) {
    const long n = std::max(degree(value.num, x), degree(value.den, x));
    value = {root(value.num, x, n), root(value.den, x, n)};
  }
  for (auto& group : groups_)
    for (MPoly& f : group)
      f = root(f, x);
}

// (alpha x + beta) u + gamma x + delta = 0, of rank 2: u is real, or rational, if x is.
void ConditionSet::learn_sorts(const MPoly& p, std::size_t x) {
  const auto v = used_variables(p);
  if (v.size() != 2) return;
  const std::size_t u = v[0] == x ? v[1] : v[0];
  if (degree(p, u) != 1) return;
  const Coefficients in_u = coefficients(p, u);
  const auto at = [&](std::size_t i, std::size_t k) {
    const Coefficients c = coefficients(in_u[i], x);
    return k < c.size() && !is_zero(c[k]) ? c[k].coefficient(0) : Integer(0);
  };
  if (at(1, 1) * at(0, 0) == at(1, 0) * at(0, 1)) return;
  real_[u] = real_[u] || real_[x];
  rational_[u] = rational_[u] || rational_[x];
}

double ConditionSet::size() const {
  double n = 1;
  const auto add = [&](const MPoly& f) { n += 4 + static_cast<double>(f.length()); };
  for (const Condition& c : conditions_)
    add(c.p);
  std::ranges::for_each(added_, add);
  std::ranges::for_each(units_, add);
  for (const Membership& m : memberships_) {
    add(m.value.num);
    add(m.value.den);
  }
  for (const auto& g : groups_)
    std::ranges::for_each(g, add);
  return n;
}

} // namespace kov::certify
