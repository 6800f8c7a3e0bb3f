#include "parameters/signs.hpp"

#include "parameters/squares.hpp"

#include <algorithm>
#include <optional>

namespace kov {

std::optional<Rational> ratio(const MPoly& p, const MPoly& q) {
  if (is_zero(p) || is_zero(q)) return std::nullopt;
  const MFraction f(p, q);
  if (!is_constant(f)) return std::nullopt;
  return to_rational(f);
}

SignProver::SignProver(const Ring& ring, const std::vector<Condition>& conditions,
                       const std::vector<MPoly>& nonzero, const std::vector<std::size_t>& real)
    : conditions_(conditions), known_(ring->size()) {
  using As = Known::As;
  for (const std::size_t i : real)
    known_[i].as = As::real;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const Condition& c = conditions[i];
    const auto used = used_variables(c.p);
    if (!certify::is_ordered(c.sign) || used.size() != 1) continue;
    const auto k = ratio(c.p, MPoly::variable(ring, used[0]));
    Known& x = known_[used[0]];
    if (k && sign(*k) > 0 && (x.as < As::nonnegative || c.sign == Sign::positive))
      x = {c.sign == Sign::positive ? As::positive : As::nonnegative, i, *k};
  }
  for (const auto& p : nonzero) {
    const auto used = used_variables(p);
    if (p.length() != 1 || used.size() != 1) continue;
    Known::As& as = known_[used[0]].as;
    if (as == As::real) as = As::real_nonzero;
    if (as == As::nonnegative) as = As::positive;
  }
}

int SignProver::sign_of(const MPoly& p) const {
  if (is_zero(p)) return 0;
  if (is_constant(p)) return sign(p.coefficient(0));
  if (const int s = by_condition(p)) return s;
  if (const auto found = by_terms(p)) return found->sign;
  if (const auto found = by_shift(p)) return found->sign;
  for (const auto& c : conditions_) // a positive factor, which need not be irreducible
    if (c.sign == Sign::positive && !is_constant(c.p))
      if (const auto rest = divides(c.p, p)) return sign_of(*rest);
  return 0;
}

bool SignProver::is_never_zero(const MPoly& p) const {
  if (is_zero(p)) return false;
  const auto used = used_variables(p);
  return sign_of(p) != 0 ||
         (std::ranges::none_of(used,
                               [&](std::size_t i) { return known_[i].as == Known::As::nothing; }) &&
          no_real_zero(p).has_value());
}

// p is, up to a constant, one of the conditions; or the other factors of a condition have a sign.
int SignProver::by_condition(const MPoly& p) const {
  for (const auto& c : conditions_) {
    if (c.sign != Sign::positive) continue;
    if (const auto k = ratio(p, c.p)) return sign(*k);
    const auto rest = divides(p, c.p);
    if (!rest) continue;
    if (const auto found = by_terms(*rest)) return found->sign;
  }
  return 0;
}

// All terms have one sign, and one of them is not zero.
std::optional<SignedSum> SignProver::by_terms(const MPoly& p,
                                              const std::vector<Known>& known) const {
  using enum Known::As;
  SignedSum all{0, {}};
  bool strict = false;
  for (long i = 0; i < p.length(); ++i) {
    const Integer c = p.coefficient(i);
    if (all.sign != 0 && sign(c) != all.sign) return std::nullopt;
    all.sign = sign(c);
    certify::LemmaTerm t{abs(Rational(c))};
    bool nonzero = true;
    const auto e = p.exponents(i);
    for (std::size_t x = 0; x < e.size(); ++x) {
      if (e[x] == 0) continue;
      const Known& what = known[x];
      const bool has_sign = what.as == positive || what.as == nonnegative;
      if (what.as == nothing || (e[x] % 2 != 0 && !has_sign)) return std::nullopt;
      nonzero = nonzero && (what.as == positive || what.as == real_nonzero);
      if (has_sign) {
        t.c = t.c / Rational(pow(what.k.num(), e[x]), pow(what.k.den(), e[x]));
        t.powers.emplace_back(what.condition, e[x]);
      } else {
        t.squares.emplace_back(MPoly::variable(p.ring(), x), e[x] / 2);
      }
    }
    strict = strict || nonzero;
    all.terms.push_back(std::move(t));
  }
  return strict ? std::optional(std::move(all)) : std::nullopt;
}

// A condition s = alpha x + beta >= 0 turns p(x) into a polynomial in s, whose terms may show more.
std::optional<SignedSum> SignProver::by_shift(const MPoly& p) const {
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    const Condition& c = conditions_[i];
    if (!certify::is_ordered(c.sign)) continue;
    for (const std::size_t x : used_variables(c.p)) {
      if (degree(c.p, x) != 1 || !uses(p, x)) continue;
      const auto line = coefficients(c.p, x);
      if (!is_constant(line[1]) || is_zero(line[0])) continue;
      const MFraction shifted =
          (MFraction::variable(p.ring(), x) - MFraction(line[0])) / MFraction(line[1]);
      const MFraction q = substitute(p, {{x, shifted}});
      if (!is_constant(q.den())) continue;
      auto known = known_;
      known[x] = {c.sign == Sign::positive ? Known::As::positive : Known::As::nonnegative, i};
      auto found = by_terms(q.num(), known);
      if (!found) continue;
      const Integer over = q.den().coefficient(0);
      for (auto& t : found->terms)
        t.c = t.c / abs(Rational(over));
      found->sign *= sign(over);
      return found;
    }
  }
  return std::nullopt;
}

std::optional<SignedSum> SignProver::sum(const MPoly& p) const {
  if (auto found = by_terms(p)) return found;
  if (auto found = by_shift(p)) return found;
  for (std::size_t i = 0; i < conditions_.size(); ++i) { // a positive factor
    const Condition& c = conditions_[i];
    if (c.sign != Sign::positive || is_constant(c.p)) continue;
    const auto rest = divides(c.p, p);
    if (!rest) continue;
    auto found = sum(*rest);
    if (!found) continue;
    for (auto& t : found->terms)
      t.powers.emplace_back(i, 1);
    return found;
  }
  return std::nullopt;
}

} // namespace kov
