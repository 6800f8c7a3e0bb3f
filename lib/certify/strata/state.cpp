#include "certify/strata/state.hpp"

#include "proof/text/refused.hpp"

#include <algorithm>

namespace kov::certify {

Stratum::Stratum(const StrataCertificate& c, Arithmetic& arithmetic)
    : ConditionSet(c.ring, arithmetic, std::vector<bool>(c.ring->size(), true), c.real, c.rational),
      r_(c.r) {
  hide(0);
  for (const Condition& f : c.assumptions) {
    need_parameters(f.p);
    assume(f);
  }
  for (const Membership& m : c.memberships) {
    need_parameters(m.value.num);
    need_parameters(m.value.den);
    assume(m);
  }
  for (const auto& g : c.generic) {
    for (const MPoly& f : g)
      need_parameters(f);
    assume_some(g);
  }
  need(!is_zero(r_->den), "den is 0");
}

const Fraction& Stratum::r() const {
  need(r_.has_value(), "den became 0 here");
  return *r_;
}

void Stratum::need_parameters(const MPoly& p) const {
  need(is_in(p, names()),
       "a polynomial in the parameters is expected, without those that are solved for");
}

void Stratum::need_variables(const MPoly& p) const {
  for (const std::size_t i : used_variables(p))
    need(i == 0 || names()[i], "a parameter occurs that was solved for");
}

bool Stratum::plainly_empty() const {
  return std::ranges::any_of(units(), [](const MPoly& f) { return is_zero(f); }) ||
         std::ranges::any_of(conditions(), [&](const Condition& c) {
           return c.sign == Sign::zero && is_unit(c.p);
         });
}

void Stratum::solve(const MPoly& p, const SolvedStratum& how) {
  replace_r(how.variable, ConditionSet::solve(p, how.variable), how.r);
}

// den' has to divide den*: where den' vanishes for all z, den* and so the den of the certificate
// does, and the point is not admitted.
void Stratum::replace_r(std::size_t x, const Root& root, const std::optional<Fraction>& given) {
  if (r_) {
    const long N = std::max(degree(r_->num, x), degree(r_->den, x));
    r_->num = root(r_->num, x, N);
    r_->den = root(r_->den, x, N);
    if (is_zero(r_->den)) r_.reset();
  }
  need(r_.has_value() == given.has_value(), r_ ? "r is missing" : "den became 0: no r is expected");
  if (!r_) return;
  Arithmetic& a = arithmetic();
  need_variables(given->num);
  need_variables(given->den);
  need(!uses(given->num, x) && !uses(given->den, x), "r has the parameter that is solved for");
  need(!is_zero(given->den), "den is 0");
  need(a.times(given->num, r_->den) == a.times(r_->num, given->den), "r is not the same function");
  need(vanishes(r_->den, &given->den, a), "den is not a divisor of the den before");
  r_ = *given;
}

double Stratum::size() const {
  double n = ConditionSet::size();
  if (r_) n += 8 + static_cast<double>(r_->num.length() + r_->den.length());
  return n;
}

} // namespace kov::certify
