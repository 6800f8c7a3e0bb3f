#include "strata/known_facts.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/to_poly.hpp"
#include "exact/variables.hpp"
#include "parameters/integers.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

Rational power(const Rational& k, long n) {
  return {pow(k.num(), static_cast<unsigned long>(n)), pow(k.den(), static_cast<unsigned long>(n))};
}

constexpr mp_limb_t most_lemma_prime = 1000; // the checkers take more

MPoly denominator(const MFraction& f) { return f.ring() ? f.den() : MPoly(); }

bool has_root(const NmodPoly& f) {
  for (mp_limb_t x = 0; x < f.modulus(); ++x)
    if (evaluate(f, x) == 0) return true;
  return false;
}

} // namespace

KnownFacts::KnownFacts(Ring ring, const Assumptions& assumptions,
                       std::vector<std::vector<MPoly>> generic)
    : ring_(std::move(ring)), memberships_(assumptions.memberships), real_(assumptions.real),
      rational_(assumptions.rational), generic_(std::move(generic)) {
  for (const auto& c : assumptions.conditions) {
    conditions_.push_back(c);
    if (certify::excludes_zero(c.sign)) nonzero_.push_back(c.p);
  }
  for (const auto& m : memberships_)
    nonzero_.push_back(denominator(m.value));
}

bool KnownFacts::is_real(const MPoly& p) const { return uses_only(p, real_); }

MPoly KnownFacts::without_known_factors(MPoly p) const {
  if (is_zero(p)) return p;
  for (const auto& q : nonzero_) {
    if (is_zero(q) || is_constant(q)) continue;
    while (auto rest = divides(q, p))
      p = *std::move(rest);
  }
  return p;
}

bool KnownFacts::contains_zero() const {
  return std::ranges::any_of(nonzero_, [](const MPoly& p) { return is_zero(p); });
}

void KnownFacts::add(const Lemma& lemma) {
  nonzero_.push_back(lemma.p);
  if (lemma.positive) conditions_.push_back({lemma.p, Sign::positive});
}

std::optional<std::pair<std::size_t, int>> KnownFacts::condition_with_sign(const MPoly& f) const {
  for (std::size_t i = 0; i < conditions_.size(); ++i)
    if (conditions_[i].sign == Sign::positive)
      if (const auto k = ratio(f, conditions_[i].p)) return std::pair(i, sign(*k));
  return std::nullopt;
}

// f or -f becomes a positive condition.
std::optional<std::pair<std::size_t, int>> KnownFacts::ensure_sign(const MPoly& f,
                                                                   std::vector<Lemma>& lemmas) {
  if (const auto known = condition_with_sign(f)) return known;
  const auto conclude = [&](Lemma lemma, int s) {
    lemma.positive = true;
    add(lemma);
    lemmas.push_back(std::move(lemma));
    return std::pair(conditions_.size() - 1, s);
  };
  if (auto sum = signs().sum(f))
    return conclude({.p = sum->sign > 0 ? f : -f, .terms = std::move(sum->terms)}, sum->sign);
  for (std::size_t i = 0; i < conditions_.size(); ++i) { // f rest = a positive condition
    const Condition& c = conditions_[i];
    if (c.sign != Sign::positive || is_zero(c.p)) continue;
    const auto rest = divides(f, c.p);
    if (!rest || is_constant(*rest)) continue;
    const auto other = signs().by_terms(*rest);
    if (!other) continue;
    const MPoly times = other->sign > 0 ? *rest : -*rest;
    const auto known = condition_with_sign(times);
    if (!known) (void)conclude({.p = times, .terms = other->terms}, 1);
    return conclude(
        {.p = other->sign > 0 ? f : -f, .times = times, .terms = Terms{{.powers = {{i, 1}}}}},
        other->sign);
  }
  return std::nullopt;
}

bool KnownFacts::ensure_nonzero(const MPoly& p, std::vector<Lemma>& lemmas) {
  if (is_zero(p)) return false;
  const MPoly rest = without_known_factors(p);
  if (is_constant(rest)) return true;
  const auto parts = irreducible_parts(rest);
  return std::ranges::all_of(parts, [&](const MPoly& f) {
    return divides_known(f, lemmas) || ensure_sign(f, lemmas).has_value() || violates(f, lemmas) ||
           has_no_rational_root(f, lemmas);
  });
}

// If the irreducible f were 0, a membership would have a value that it has not.
bool KnownFacts::violates(const MPoly& f, std::vector<Lemma>& lemmas) {
  for (const std::size_t x : used_variables(f)) {
    if (degree(f, x) != 1) continue;
    const auto line = coefficients(f, x);
    const Substitution root{{x, -(MFraction(line[0]) / MFraction(line[1]))}};
    for (std::size_t i = 0; i < memberships_.size(); ++i) {
      if (divides(f, denominator(memberships_[i].value))) continue;
      const auto c = violated(memberships_[i], substitute(memberships_[i].value, root));
      if (!c) continue;
      Lemma lemma{.p = f};
      lemma.violation = Violation{i, *c};
      add(lemma);
      lemmas.push_back(std::move(lemma));
      return true;
    }
  }
  return false;
}

// f is a polynomial in one rational parameter, without a root modulo some prime.
bool KnownFacts::has_no_rational_root(const MPoly& f, std::vector<Lemma>& lemmas) {
  const auto used = used_variables(f);
  if (used.size() != 1 || degree(f, used[0]) < 2 || !is_among(used[0], rational_)) return false;
  for (mp_limb_t q = 2; q < most_lemma_prime; q = n_nextprime(q, 1)) {
    const NmodPoly g = to_poly(f, used[0], q);
    if (kov::degree(g) != degree(f, used[0]) || has_root(g)) continue;
    Lemma lemma{.p = f};
    lemma.prime = q;
    add(lemma);
    lemmas.push_back(std::move(lemma));
    return true;
  }
  return false;
}

std::optional<Violation> KnownFacts::violation() const {
  for (std::size_t i = 0; i < memberships_.size(); ++i)
    if (const auto c = violated(memberships_[i], memberships_[i].value)) return Violation{i, *c};
  return std::nullopt;
}

// f is a factor of a polynomial that is known not to vanish.
bool KnownFacts::divides_known(const MPoly& f, std::vector<Lemma>& lemmas) {
  for (const auto& q : nonzero_) {
    if (is_zero(q)) continue;
    auto rest = divides(f, q);
    if (!rest) continue;
    Lemma lemma{.p = f, .times = std::move(rest)};
    add(lemma);
    lemmas.push_back(std::move(lemma));
    return true;
  }
  return false;
}

bool KnownFacts::ensure_positive(const MPoly& p, std::vector<Lemma>& lemmas) {
  if (is_zero(p)) return false;
  if (is_constant(p)) return sign(p.coefficient(0)) > 0;
  if (const auto known = condition_with_sign(p)) return known->second > 0;
  const auto conclude = [&](std::vector<LemmaTerm> terms) {
    Lemma lemma{.p = p, .positive = true, .terms = std::move(terms)};
    add(lemma);
    lemmas.push_back(std::move(lemma));
    return true;
  };
  if (auto sum = signs().sum(p)) return sum->sign > 0 && conclude(std::move(sum->terms));
  const auto [content, factors] = factor(p);
  LemmaTerm product;
  product.c = abs(Rational(content));
  int s = sign(content);
  for (const auto& f : factors) {
    if (f.exponent % 2 == 0 && is_real(f.base)) {
      if (!ensure_nonzero(f.base, lemmas)) return false;
      product.squares.emplace_back(f.base, f.exponent / 2);
      continue;
    }
    const auto one = ensure_sign(f.base, lemmas);
    if (!one) return false;
    const Rational k = *ratio(conditions_[one->first].p, f.base);
    product.c = product.c / abs(power(k, f.exponent));
    product.powers.emplace_back(one->first, f.exponent);
    if (f.exponent % 2 != 0) s *= one->second;
  }
  return s > 0 && conclude({product});
}

std::optional<std::vector<LemmaTerm>> KnownFacts::contradiction() const {
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    const Condition& c = conditions_[i];
    if (!certify::is_ordered(c.sign) || is_zero(c.p)) continue;
    KnownFacts others(*this); // without this condition
    others.conditions_[i].sign = Sign::dropped;
    std::erase(others.nonzero_, c.p);
    auto sum = others.signs().sum(c.p);
    if (!sum || sum->sign > 0) continue;
    sum->terms.push_back({.powers = {{i, 1}}});
    return std::move(sum->terms);
  }
  return std::nullopt;
}

MPoly on_line(const MPoly& p, std::size_t x, const MPoly& l, const MPoly& m, long n) {
  if (is_zero(p)) return p;
  const auto c = coefficients(p, x);
  MPoly sum(p.ring());
  MPoly power(p.ring(), Integer(1)); // (-m)^k
  for (std::size_t k = 0; k < c.size(); ++k) {
    sum += c[k] * power * pow(l, static_cast<unsigned long>(n - static_cast<long>(k)));
    power *= -m;
  }
  return sum;
}

void KnownFacts::solve(const MPoly& p, std::size_t x) {
  const auto line = coefficients(p, x);
  const MPoly& l = line[1];
  const MPoly& m = line[0];
  const auto there = [&](const MPoly& f, long n) { return on_line(f, x, l, m, n); };
  const bool real = is_real(l);
  for (auto& f : nonzero_)
    f = there(f, std::max(0L, degree(f, x)));
  for (auto& c : conditions_) {
    const long n = std::max(0L, degree(c.p, x));
    const bool even = certify::is_ordered(c.sign);
    if (even && n > 0 && !real) {
      if (c.sign == Sign::positive) nonzero_.push_back(there(c.p, n));
      c.sign = Sign::dropped;
    }
    c.p = there(c.p, even ? n + n % 2 : n);
  }
  for (auto& member : memberships_) {
    const MPoly den = denominator(member.value);
    if (is_zero(there(den, std::max(0L, degree(den, x))))) continue; // no points
    member.value = substitute(member.value, {{x, -(MFraction(m) / MFraction(l))}});
  }
  for (auto& group : generic_)
    for (auto& f : group)
      f = there(f, std::max(0L, degree(f, x)));
  nonzero_.push_back(l);
  const auto used = used_variables(p);
  const bool rational = is_among(x, rational_);
  if (used.size() == 2 && is_real(MPoly::variable(ring_, x))) {
    const std::size_t u = used[0] == x ? used[1] : used[0];
    if ((rational || !is_real(MPoly::variable(ring_, u))) && degree(p, u) == 1) {
      const auto a = [&](const MPoly& f, std::size_t k) { // coefficient of u^k in f
        const auto c = coefficients(f, u);
        return k < c.size() ? c[k] : MPoly(ring_);
      };
      if (!is_zero(a(l, 1) * a(m, 0) - a(l, 0) * a(m, 1))) {
        real_.push_back(u);
        if (rational) rational_.push_back(u);
      }
    }
  }
  std::erase(real_, x);
  std::erase(rational_, x);
}

} // namespace kov::strata
