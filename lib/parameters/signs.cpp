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
    : conditions_(conditions), known_(ring->size(), Known::nothing) {
  const auto raise = [&](const MPoly& p, Known to) {
    const auto used = used_variables(p);
    if (used.size() != 1 || degree(p, used[0]) != 1) return;
    const auto c = coefficients(p, used[0]);
    if (!is_zero(c[0])) return; // not a multiple of the variable
    Known& k = known_.at(used[0]);
    if (sign(c[1].coefficient(0)) > 0) k = std::max(k, to);
  };
  for (const std::size_t i : real)
    known_[i] = Known::real;
  for (const auto& c : conditions) {
    if (c.sign == Sign::positive) raise(c.p, Known::positive);
    if (c.sign == Sign::nonnegative) raise(c.p, Known::nonnegative);
  }
  for (const auto& p : nonzero) {
    const auto used = used_variables(p);
    if (p.length() != 1 || used.size() != 1) continue;
    Known& k = known_[used[0]];
    if (k == Known::real) k = Known::real_nonzero;
    if (k == Known::nonnegative) k = Known::positive;
  }
}

int SignProver::sign_of(const MPoly& p) const {
  if (is_zero(p)) return 0;
  if (is_constant(p)) return sign(p.coefficient(0));
  if (const int s = by_condition(p)) return s;
  if (const int s = by_terms(p, known_)) return s;
  if (const int s = by_shift(p)) return s;
  for (const auto& c : conditions_) // a positive factor, which need not be irreducible
    if (c.sign == Sign::positive && !is_constant(c.p))
      if (const auto rest = divides(c.p, p)) return sign_of(*rest);
  return 0;
}

bool SignProver::is_never_zero(const MPoly& p) const {
  if (is_zero(p)) return false;
  const auto used = used_variables(p);
  return sign_of(p) != 0 ||
         (std::ranges::none_of(used, [&](std::size_t i) { return known_[i] == Known::nothing; }) &&
          no_real_zero(p).has_value());
}

// p is, up to a constant, one of the conditions; or the other factors of a condition have a sign.
int SignProver::by_condition(const MPoly& p) const {
  for (const auto& c : conditions_) {
    if (c.sign != Sign::positive) continue;
    if (const auto k = ratio(p, c.p)) return sign(*k);
    const auto rest = divides(p, c.p);
    if (!rest) continue;
    if (const int s = by_terms(*rest, known_)) return s;
  }
  return 0;
}

// All terms have one sign, and one of them is not zero.
int SignProver::by_terms(const MPoly& p, const std::vector<Known>& known) const {
  int common = 0;
  bool strict = false;
  for (long i = 0; i < p.length(); ++i) {
    const auto e = p.exponents(i);
    bool nonzero = true;
    for (std::size_t k = 0; k < e.size(); ++k) {
      if (e[k] == 0) continue;
      const Known what = known[k];
      if (what == Known::nothing) return 0;
      if (e[k] % 2 != 0 && what != Known::positive && what != Known::nonnegative) return 0;
      nonzero = nonzero && (what == Known::positive || what == Known::real_nonzero);
    }
    const int s = sign(p.coefficient(i));
    if (common != 0 && s != common) return 0;
    common = s;
    strict = strict || nonzero;
  }
  return strict ? common : 0;
}

// A condition s = alpha x + beta >= 0 turns p(x) into a polynomial in s, whose terms may show more.
int SignProver::by_shift(const MPoly& p) const {
  for (const auto& c : conditions_) {
    if (c.sign != Sign::positive && c.sign != Sign::nonnegative) continue;
    for (const std::size_t x : used_variables(c.p)) {
      if (degree(c.p, x) != 1 || !uses(p, x)) continue;
      const auto line = coefficients(c.p, x);
      if (!is_constant(line[1]) || is_zero(line[0])) continue;
      const MFraction shifted =
          (MFraction::variable(p.ring(), x) - MFraction(line[0])) / MFraction(line[1]);
      const MFraction q = substitute(p, {{x, shifted}});
      auto known = known_;
      known[x] = c.sign == Sign::positive ? Known::positive : Known::nonnegative;
      if (!is_constant(q.den())) continue;
      if (const int s = by_terms(q.num(), known)) return s * sign(q.den().coefficient(0));
    }
  }
  return 0;
}

} // namespace kov
