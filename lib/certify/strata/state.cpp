#include "certify/strata/state.hpp"

#include "certify/equation/facts.hpp"
#include "certify/text/limits.hpp"

#include <algorithm>
#include <utility>

namespace kov::certify {

// x = -m/l: f becomes f* = sum f_k (-m)^k l^(N-k).
class Root {
public:
  Root(Arithmetic& a, MPoly slope, const MPoly& m) : a_(a), l_(std::move(slope)), minus_m_(-m) {}

  [[nodiscard]] const MPoly& slope() const { return l_; }

  [[nodiscard]] MPoly operator()(const MPoly& f, std::size_t x, long N) const {
    const long n = std::max(degree(f, x), 0L);
    if (is_zero(f) || (n == 0 && N <= 0)) return f;
    a_.charge(static_cast<double>(n));
    const Coefficients c = coefficients(f, x);
    MPoly sum(f.ring());
    MPoly power(f.ring(), Integer(1)); // of l
    for (long k = n; k >= 0; --k) {
      sum = a_.times(sum, minus_m_);
      const MPoly& coefficient = c[static_cast<std::size_t>(k)];
      if (!is_zero(coefficient)) sum = a_.plus(sum, a_.times(coefficient, power));
      if (k > 0) power = a_.times(power, l_);
    }
    return N > n ? a_.times(sum, a_.power(l_, static_cast<unsigned long>(N - n))) : sum;
  }

private:
  Arithmetic& a_;
  MPoly l_, minus_m_;
};

Stratum::Stratum(const StrataCertificate& c, Arithmetic& arithmetic)
    : arithmetic_(&arithmetic), left_(c.ring->size(), true), real_(c.real), rational_(c.rational),
      conditions_(c.assumptions), memberships_(c.memberships), generic_(c.generic), r_(c.r) {
  left_[0] = false;
  for (const Condition& f : conditions_) {
    need_parameters(f.p);
    if (f.sign == Sign::positive || f.sign == Sign::nonzero) add_nonzero(f.p);
  }
  for (const Membership& m : memberships_) {
    need_parameters(m.value.num);
    need_parameters(m.value.den);
    add_nonzero(m.value.den);
  }
  for (const auto& g : generic_)
    for (const MPoly& f : g)
      need_parameters(f);
  need(!is_zero(r_->den), "den is 0");
}

const Condition& Stratum::condition(std::size_t i) const {
  need(i < conditions_.size(), "there is no such condition");
  return conditions_[i];
}

const Membership& Stratum::membership(std::size_t i) const {
  need(i < memberships_.size(), "there is no such membership");
  return memberships_[i];
}

const std::vector<MPoly>& Stratum::group(std::size_t i) const {
  need(i < generic_.size(), "there is no such group of generic");
  return generic_[i];
}

const Fraction& Stratum::r() const {
  need(r_.has_value(), "den became 0 here");
  return *r_;
}

void Stratum::need_parameters(const MPoly& p) const {
  need(!uses(p, 0), "a polynomial in the parameters is expected");
  need_variables(p);
}

void Stratum::need_variables(const MPoly& p) const {
  for (const std::size_t i : used_variables(p))
    need(i == 0 || left_[i], "a parameter occurs that was solved for");
}

bool Stratum::all_real(const MPoly& p) const {
  const auto v = used_variables(p);
  return std::ranges::all_of(v, [&](std::size_t i) { return real_[i]; });
}

void Stratum::need_violated(const Violation& v, const MPoly* p) const {
  const auto& [value, integral] = membership(v.membership);
  need(is_integer(v.value) != integral, "the membership allows this value");
  const MPoly f =
      arithmetic_->minus(scaled(value.num, v.value.den()), scaled(value.den, v.value.num()));
  need(is_zero(f) || (p && arithmetic_->quotient(primitive(f), primitive(*p))),
       "the membership has another value there");
}

MPoly Stratum::stripped(MPoly p) const {
  if (is_zero(p)) return p;
  p = primitive(p);
  for (const MPoly& g : nonzero_) {
    if (is_constant(p)) break;
    if (is_zero(g)) continue;
    while (auto q = arithmetic_->quotient(p, g))
      p = *std::move(q);
  }
  return p;
}

bool Stratum::known_nonzero(const MPoly& p) const {
  if (is_zero(p) || is_constant(p)) return !is_zero(p);
  return is_constant(stripped(p));
}

bool Stratum::known_positive(const MPoly& p) const {
  if (is_zero(p)) return false;
  if (is_constant(p)) return sign(p.coefficient(0)) > 0;
  const MPoly f = primitive(p);
  return std::ranges::any_of(conditions_, [&](const Condition& c) {
    if (c.sign != Sign::positive) return false;
    arithmetic_->charge(1 + static_cast<double>(c.p.length()));
    return primitive(c.p) == f;
  });
}

void Stratum::add_nonzero(const MPoly& p) {
  MPoly g = stripped(p);
  if (!is_zero(g) && is_constant(g)) return;
  for (MPoly& f : nonzero_)
    while (!is_zero(g) && !is_zero(f)) {
      auto q = arithmetic_->quotient(f, g);
      if (!q) break;
      f = *std::move(q);
    }
  std::erase_if(nonzero_, [](const MPoly& f) { return !is_zero(f) && is_constant(f); });
  nonzero_.push_back(std::move(g));
}

bool Stratum::plainly_empty() const {
  return std::ranges::any_of(nonzero_, [](const MPoly& f) { return is_zero(f); }) ||
         std::ranges::any_of(conditions_, [&](const Condition& c) {
           return (c.sign == Sign::positive && is_zero(c.p)) ||
                  (c.sign == Sign::zero && known_nonzero(c.p));
         });
}

void Stratum::add_positive(const MPoly& p) {
  conditions_.push_back({p, Sign::positive});
  add_nonzero(p);
}

void Stratum::solve(const MPoly& p, const SolvedStratum& how) {
  const std::size_t x = how.variable;
  need(left_[x], "the parameter was solved for before");
  need(degree(p, x) == 1, "the polynomial is not linear in the parameter");
  const Coefficients c = coefficients(p, x);
  need(known_nonzero(c[1]), "the leading coefficient is not known to be nonzero");
  const Root root(*arithmetic_, c[1], c[0]);
  for (const MPoly& f : std::exchange(nonzero_, {}))
    add_nonzero(root(f, x, degree(f, x)));
  for (auto& group : generic_)
    for (MPoly& f : group)
      f = root(f, x, degree(f, x));
  replace_conditions(x, root);
  for (auto& [value, integral] : memberships_) {
    const long n = std::max(degree(value.num, x), degree(value.den, x));
    value = {root(value.num, x, n), root(value.den, x, n)};
  }
  replace_r(x, root, how.r);
  add_nonzero(root.slope());
  learn_field(p, x);
  left_[x] = false;
}

void Stratum::replace_conditions(std::size_t x, const Root& root) {
  const bool real = all_real(root.slope());
  for (Condition& c : conditions_) {
    const long n = degree(c.p, x);
    if (n <= 0 || c.sign == Sign::dropped) continue;
    const bool ordered = c.sign == Sign::positive || c.sign == Sign::nonnegative;
    c.p = root(c.p, x, ordered && real ? n + n % 2 : n);
    if (!ordered || real) continue;
    if (c.sign == Sign::positive) add_nonzero(c.p);
    c.sign = Sign::dropped;
  }
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
  Arithmetic& a = *arithmetic_;
  need_variables(given->num);
  need_variables(given->den);
  need(!uses(given->num, x) && !uses(given->den, x), "r has the parameter that is solved for");
  need(!is_zero(given->den), "den is 0");
  need(a.times(given->num, r_->den) == a.times(r_->num, given->den), "r is not the same function");
  need(a.quotient(primitive(r_->den), primitive(given->den)).has_value(),
       "den is not a divisor of the den before");
  r_ = *given;
}

// (alpha x + beta) u + gamma x + delta = 0, of rank 2: u is real, or rational, if x is.
void Stratum::learn_field(const MPoly& p, std::size_t x) {
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

double Stratum::size() const {
  double n = 1;
  const auto add = [&](const MPoly& f) { n += 4 + static_cast<double>(f.length()); };
  for (const Condition& c : conditions_)
    add(c.p);
  for (const MPoly& f : nonzero_)
    add(f);
  for (const Membership& m : memberships_) {
    add(m.value.num);
    add(m.value.den);
  }
  for (const auto& g : generic_)
    for (const MPoly& f : g)
      add(f);
  if (r_) {
    add(r_->num);
    add(r_->den);
  }
  return n;
}

} // namespace kov::certify
