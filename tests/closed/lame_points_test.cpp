// Where the conditions for a finite group have common zeros, the engines find that group: B = 1,
// and g2, g3 in the number fields that the zeros generate.

#include "closed/lame.hpp"
#include "decide/decide.hpp"
#include "decide/words.hpp"

#include "exact/factor.hpp"

#include <gtest/gtest.h>

namespace kov::lame_points_test {
namespace {

Rational q(long n, long d = 1) { return {Integer(n), Integer(d)}; }

// A root of a primitive irreducible polynomial, as an element of the field that it generates.
NfElem root_of(const Poly& f) {
  const long k = degree(f);
  if (k == 1) return -f.coeff(0) / f.coeff(1);
  Integer lead(1);
  for (long i = 0; i <= k; ++i)
    lead = lcm(lead, to_rational(f.coeff(i) / f.coeff(k)).den());
  std::vector<Integer> monic; // lead * root is integral
  for (long i = 0; i <= k; ++i) {
    const Rational c = to_rational(f.coeff(i) / f.coeff(k)) *
                       Rational(pow(lead, static_cast<unsigned long>(k - i)));
    monic.push_back(c.num());
  }
  return NfElem::generator(make_field(monic, "t")) / NfElem(Rational(lead));
}

// f(g2, g3) at g3 = c, a polynomial in g2.
Poly at(const MPoly& f, const NfElem& c) {
  Poly sum(coerce(NfElem(0), c.field()));
  for (long i = 0; i < f.length(); ++i) {
    const auto e = f.exponents(i);
    sum +=
        Poly::monomial(NfElem(Rational(f.coefficient(i))) * pow(c, e[2]), static_cast<long>(e[1]));
  }
  return sum;
}

// The points of V(conditions) with B = 1 and g3 of degree <= 3.
std::vector<LameParameters<NfElem>> points(const Rational& n, long m) {
  const Ring ring = make_ring({"B", "g2", "g3"});
  const LameParameters<MFraction> p{MFraction(ring, Rational(1)), MFraction::variable(ring, 1),
                                    MFraction::variable(ring, 2)};
  std::vector<MPoly> conditions;
  for (const MFraction& c : invariant_conditions(n, m, p))
    conditions.push_back(c.num());
  MPoly eliminant(ring);
  for (std::size_t i = 1; i < conditions.size(); ++i)
    eliminant = gcd(eliminant, resultant(conditions[0], conditions[i], 1));
  std::vector<LameParameters<NfElem>> found;
  for (const MFactor& factor : factor(eliminant).second) {
    if (degree(factor.base, 2) > 3) continue;
    const NfElem g3 = root_of(to_rational_function(MFraction(factor.base), 2).num());
    Poly common(coerce(NfElem(0), g3.field()));
    for (const MPoly& c : conditions)
      common = gcd(common, at(c, g3));
    if (degree(common) != 1) continue;
    const LameParameters<NfElem> point{NfElem(1), -common.coeff(0), g3};
    if (!is_zero(point.g2 * point.g2 * point.g2 - NfElem(27) * g3 * g3)) found.push_back(point);
  }
  return found;
}

TEST(LamePoints, TheEnginesFindTheGroup) {
  int seen = 0;
  for (const auto& [n, m, group] :
       std::vector<std::tuple<Rational, long, GroupType>>{{q(3, 4), 8, GroupType::S4},
                                                          {q(5, 4), 8, GroupType::S4},
                                                          {q(7, 4), 8, GroupType::S4},
                                                          {q(5, 6), 8, GroupType::S4},
                                                          {q(7, 6), 8, GroupType::S4},
                                                          {q(1, 6), 12, GroupType::A5},
                                                          {q(3, 10), 12, GroupType::A5},
                                                          {q(7, 10), 12, GroupType::A5},
                                                          {q(9, 10), 12, GroupType::A5}})
    for (const auto& p : points(n, m)) {
      ++seen;
      const NfElem alpha(n * (n + q(1)));
      const ClosedAnswer answer = lame_answer(alpha, p);
      ASSERT_TRUE(answer.group);
      EXPECT_EQ(answer.group->type, group) << to_string(n) << ", g3 = " << to_string(p.g3);
      Options options;
      options.want_solutions = false;
      const Decision d = decide({.r = lame_equation(alpha, p), .p = RationalFunction()}, options);
      ASSERT_TRUE(d.group) << reason(d);
      EXPECT_EQ(d.group->type, group) << to_string(n) << ", g3 = " << to_string(p.g3);
    }
  EXPECT_GE(seen, 8);
}

} // namespace
} // namespace kov::lame_points_test
