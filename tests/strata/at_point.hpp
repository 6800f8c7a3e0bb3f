#pragma once
// What a tree of strata says at one point whose coordinates lie in a number field, and what the solver
// without parameters says there.

#include "decide/decide.hpp"
#include "decide/words.hpp"
#include "exact/error.hpp"
#include "strata/decide_strata.hpp"
#include "strata/words.hpp"
#include "support/group_bound.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace kov::test {

/// Values of all variables but z, in one field.
class ExactPoint {
public:
  ExactPoint(std::size_t z, std::map<std::size_t, NfElem> values)
      : z_(z), values_(std::move(values)) {}

  /// f, free of z.  Throws DomainError where it has no value.
  [[nodiscard]] NfElem operator()(const MFraction& f) const {
    return is_zero(f) ? NfElem(0) : number(f.num()) / number(f.den());
  }
  /// Throws DomainError where the denominator vanishes for all z.
  [[nodiscard]] RationalFunction equation(const MFraction& r) const {
    if (is_zero(r)) return {};
    const Poly below = polynomial(r.den());
    if (is_zero(below)) throw DomainError("no equation");
    return RationalFunction(polynomial(r.num())) / RationalFunction(below);
  }
  [[nodiscard]] bool holds(const Condition& c) const {
    const NfElem v = (*this)(MFraction(c.p));
    if (c.sign == Sign::zero || c.sign == Sign::nonzero)
      return is_zero(v) == (c.sign == Sign::zero);
    const int s = is_rational(v) ? sign(to_rational(v)) : -1;
    return s > 0 || (s == 0 && c.sign == Sign::nonnegative);
  }
  [[nodiscard]] bool is_in(const strata::Stratum& s) const {
    return std::ranges::all_of(s.conditions, [&](const Condition& c) { return holds(c); }) &&
           std::ranges::all_of(s.arithmetic, [&](const Statement& c) { return is_so(c, *this); });
  }
  [[nodiscard]] std::string text(const Ring& ring) const {
    std::string all;
    for (const auto& [i, v] : values_)
      all += ring->name(i) + " = " + to_string(v) + "  ";
    return all;
  }

private:
  [[nodiscard]] NfElem number(const MPoly& p) const {
    NfElem sum(0);
    for (long i = 0; i < p.length(); ++i) {
      NfElem term{Rational(p.coefficient(i))};
      const auto e = p.exponents(i);
      for (const auto& [x, value] : values_)
        term *= pow(value, e[x]);
      sum += term;
    }
    return sum;
  }
  [[nodiscard]] Poly polynomial(const MPoly& p) const {
    Poly sum;
    long i = 0;
    for (const MPoly& c : coefficients(p, z_))
      sum = sum + Poly::monomial(is_zero(c) ? NfElem(0) : number(c), i++);
    return sum;
  }

  std::size_t z_;
  std::map<std::size_t, NfElem> values_;
};

/// Small numbers, often special ones; of Q(i) where `complex`.
inline ExactPoint random_exact_point(const strata::Question& q, Random& random, bool complex) {
  static const NfElem i = NfElem::generator(make_field({1, 0, 1}, "I"));
  const auto rational = [&] {
    return NfElem(random.once_in(3) ? Rational(random.between(-1, 2))
                                    : Rational(random.between(-7, 9), random.between(1, 4)));
  };
  std::map<std::size_t, NfElem> values;
  for (std::size_t x = 0; x < q.r.ring()->size(); ++x)
    if (x != q.z)
      values[x] = complex && random.once_in(2) ? rational() + NfElem(random.between(-2, 2)) * i
                                               : rational();
  return {q.z, std::move(values)};
}

/// The one stratum with the point; several, or none, are a failure.
inline std::optional<strata::Stratum> the_stratum(const std::vector<strata::Stratum>& told_apart,
                                                  const ExactPoint& point) {
  std::optional<strata::Stratum> found;
  for (const strata::Stratum& s : told_apart) {
    if (!point.is_in(s)) continue;
    EXPECT_FALSE(found) << "in two strata: " << to_string(s.conditions);
    found = s;
  }
  EXPECT_TRUE(found) << "in no stratum";
  return found;
}

/// The stratum says what the equation there says: the verdict, the group, and the bound of the group.
/// True: both know something.
inline bool agree_at(const strata::Question& q, const std::vector<strata::Stratum>& told_apart,
                     const ExactPoint& point) {
  SCOPED_TRACE(point.text(q.r.ring()));
  const auto s = the_stratum(told_apart, point);
  if (!s) return false;
  NormalForm equation;
  try {
    equation.r = point.equation(q.r);
  } catch (const DomainError&) {
    EXPECT_TRUE(s->leaf.no_equation()) << reason(s->leaf);
    return false;
  }
  EXPECT_FALSE(s->leaf.no_equation());
  Options options;
  options.want_solutions = false;
  const Decision d = decide(equation, options);
  if (s->leaf.abelian == Truth::unknown || d.abelian == Truth::unknown) return false;
  EXPECT_EQ(d.abelian, s->leaf.abelian) << reason(s->leaf) << "\nbut " << reason(d);
  if (d.group) {
    EXPECT_TRUE(allows(s->leaf.bound, *d.group)) << group_text(s->leaf) << describe(*d.group);
    if (s->leaf.group) {
      EXPECT_EQ(s->leaf.group->type, d.group->type) << reason(s->leaf);
      EXPECT_TRUE(!s->leaf.group->n || s->leaf.group->n == d.group->n) << describe(*d.group);
    }
  }
  return true;
}

} // namespace kov::test
