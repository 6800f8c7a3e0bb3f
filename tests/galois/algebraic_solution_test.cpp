// The polynomial of y for A4, S4 and A5.

#include "galois/algebraic_solution.hpp"

#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

const Poly z = Poly::z();

NfElem square(long a, long b) { return NfElem(Rational(a * a, b * b)); }

struct Triple {
  const char* name;
  GroupType group;
  long a, b, c, d, e, f; ///< the exponent differences a/b, c/d, e/f at 0, 1, infinity
};

// The table of Schwarz, II to XV.
const Triple schwarz[] = {
    {"II", GroupType::A4, 1, 2, 1, 3, 1, 3},   {"III", GroupType::A4, 2, 3, 1, 3, 1, 3},
    {"IV", GroupType::S4, 1, 2, 1, 3, 1, 4},   {"V", GroupType::S4, 2, 3, 1, 4, 1, 4},
    {"VI", GroupType::A5, 1, 2, 1, 3, 1, 5},   {"VII", GroupType::A5, 2, 5, 1, 3, 1, 3},
    {"VIII", GroupType::A5, 2, 3, 1, 5, 1, 5}, {"IX", GroupType::A5, 1, 2, 2, 5, 1, 5},
    {"X", GroupType::A5, 3, 5, 1, 3, 1, 5},    {"XI", GroupType::A5, 2, 5, 2, 5, 2, 5},
    {"XII", GroupType::A5, 2, 3, 1, 3, 1, 5},  {"XIII", GroupType::A5, 4, 5, 1, 5, 1, 5},
    {"XIV", GroupType::A5, 1, 2, 2, 5, 1, 3},  {"XV", GroupType::A5, 3, 5, 2, 5, 1, 3}};

RationalFunction riemann(const Triple& t) {
  return testing::riemann(square(t.a, t.b), square(t.c, t.d), square(t.e, t.f));
}

void expect_polynomial(const RationalFunction& r, GroupType group, const std::string& name) {
  const Classification c = classify(r);
  ASSERT_TRUE(c.group) << name;
  ASSERT_EQ(c.group->type, group) << name;
  const auto y = algebraic_solution(c, r);
  ASSERT_TRUE(y) << name;
  EXPECT_EQ(y->power, group == GroupType::A4 ? 4 : group == GroupType::S4 ? 8 : 10) << name;
  EXPECT_EQ(y->polynomial.size(), group == GroupType::A5 ? 13U : 7U) << name;
}

TEST(AlgebraicSolution, TableOfSchwarz) {
  for (const Triple& t : schwarz)
    expect_polynomial(riemann(t), t.group, t.name);
}

TEST(AlgebraicSolution, AWrongOneIsRefused) {
  const RationalFunction r = riemann(schwarz[2]);
  const AlgebraicSolution y = *algebraic_solution(classify(r), r);
  EXPECT_TRUE(solves(y, r));
  EXPECT_FALSE(solves(y, riemann(schwarz[3])));
  for (std::size_t i = 0; i + 1 < y.polynomial.size(); ++i) {
    AlgebraicSolution wrong = y;
    wrong.polynomial[i] += Poly(1);
    EXPECT_FALSE(solves(wrong, r)) << i;
  }
  EXPECT_FALSE(solves({y.power / 2, y.factor, y.polynomial}, r));
  EXPECT_FALSE(solves({y.power, y.factor * RationalFunction(z), y.polynomial}, r));
}

TEST(AlgebraicSolution, PullBacksAndApparentSingularities) {
  const RationalFunction f(z * z - Poly(2) * z + Poly(5), z + Poly(1));
  for (const std::size_t i : {0U, 2U, 4U}) {
    const RationalFunction r = riemann(schwarz[i]);
    expect_polynomial(testing::pull_back(r, f), schwarz[i].group, schwarz[i].name);
    expect_polynomial(testing::gauge(r, RationalFunction(Poly(2), z + Poly(3))), schwarz[i].group,
                      schwarz[i].name);
  }
}

TEST(AlgebraicSolution, OverANumberField) {
  const Field k = make_field({-2, 0, 1}, "s");
  const RationalFunction f(scale(z * z, NfElem::generator(k)) + z, z - Poly(3));
  for (const std::size_t i : {0U, 2U, 4U})
    expect_polynomial(testing::pull_back(riemann(schwarz[i]), f), schwarz[i].group,
                      schwarz[i].name);
}

// y exp(int gauge): a rational power is a factor, and nothing else is.
TEST(AlgebraicSolution, WithAFactor) {
  const RationalFunction r = riemann(schwarz[0]), f(z, z - Poly(3));
  const AlgebraicSolution y = *algebraic_solution(classify(r), r);
  const auto by = [&](const RationalFunction& gauge) { return times_exponential(y, gauge); };
  const RationalFunction theta = derivative(f) / f;
  EXPECT_EQ(by(theta)->factor, y.factor * pow(f, 4));
  EXPECT_EQ(by(theta * RationalFunction(Rational(-3, 4)))->factor, y.factor * pow(f, -3));
  EXPECT_EQ(by(theta)->polynomial, y.polynomial);
  EXPECT_FALSE(by(theta * RationalFunction(Rational(1, 3))));
  EXPECT_FALSE(by(theta + RationalFunction(z)));
  EXPECT_FALSE(by(RationalFunction(z, z * z - Poly(2)) * RationalFunction(Rational(1, 3))));
  EXPECT_FALSE(by(RationalFunction(Poly(1), z * z - Poly(2))));
}

TEST(AlgebraicSolution, OnlyForPrimitiveFiniteGroups) {
  for (const RationalFunction& r :
       {RationalFunction(z), RationalFunction(0), RationalFunction(Rational(-3, 16)) / (z * z),
        RationalFunction(Poly(16) * z - Poly(3), Poly(16) * z * z)})
    EXPECT_FALSE(algebraic_solution(classify(r), r)) << to_string(r);
}

TEST(AlgebraicSolution, ADoubleRootIsNoSolution) {
  const RationalFunction r(Rational(-3, 16), z * z);
  EXPECT_TRUE(solves({4, RationalFunction(z), {Poly(-1), Poly(1)}}, r));
  EXPECT_FALSE(solves({4, RationalFunction(z), {Poly(1), Poly(-2), Poly(1)}}, r));
}

TEST(AlgebraicSolution, HasABudget) {
  const RationalFunction r =
      testing::pull_back(riemann(schwarz[4]), RationalFunction(pow(z, 5) + z, z - Poly(1)));
  const Classification c = classify(r);
  Budget over = Budget::of_seconds(0);
  EXPECT_THROW((void)algebraic_solution(c, r, over), OutOfBudget);
}

} // namespace
} // namespace kov
