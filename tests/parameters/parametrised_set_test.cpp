// Strata: sign proofs, equations solved, contradictions.

#include "parameters/parametrised_set.hpp"

#include <gtest/gtest.h>

namespace kov::parametrised_set_test {
namespace {

const Ring ring = make_ring({"A", "C", "h", "z"});
MFraction x(const char* name) { return MFraction::variable(ring, name); }
MFraction number(long n) { return {ring, Rational(n)}; }

ParametrisedSet positive_bodies() {
  Assumptions a;
  a.require(x("A"), Sign::positive);
  a.require(x("C"), Sign::positive);
  return {ring, a};
}

TEST(ParametrisedSet, SumsOfPositiveTermsAreNotZero) {
  const ParametrisedSet r = positive_bodies();
  EXPECT_TRUE(r.provably_nonzero((x("A") + number(1)).num()));
  EXPECT_TRUE(r.provably_nonzero((x("A") * x("C") + x("A") * x("A")).num()));
  EXPECT_EQ(r.sign_of((-x("A") - x("C") * x("C")).num()), -1);
  EXPECT_FALSE(r.provably_nonzero((x("A") - x("C")).num()));
  EXPECT_FALSE(r.provably_nonzero((x("h") * x("h") + number(1)).num())); // h is complex
  EXPECT_TRUE(r.trusted().empty());
}

// What is positive is real; what it is made of need not be.
TEST(ParametrisedSet, AnInequalityMakesItsValueReal) {
  Assumptions a;
  a.require(x("A") * x("C"), Sign::positive);
  a.require(Rational(2) * x("h") - number(1), Sign::nonnegative);
  const ParametrisedSet r(ring, a);
  EXPECT_FALSE(r.is_real((x("A")).num()) || r.is_real(x("C").num()));
  EXPECT_TRUE(r.is_real(x("h").num()));
  EXPECT_EQ(r.exact_sign_of((x("A") * x("C")).num()), 1);
  EXPECT_EQ(r.sign_of((x("A") * x("A") + number(1)).num()), 0);
  EXPECT_FALSE(r.made_real_by(x("A") * x("C")));
  Assumptions b;
  b.require(-x("C") * x("C"), Sign::positive); // C = i
  EXPECT_FALSE(ParametrisedSet(ring, b).is_empty());
  b.declare_real(x("C"));
  EXPECT_TRUE(ParametrisedSet(ring, b).is_empty());
  Assumptions c; // A/C > 0 holds at A = C = i
  c.require(x("A") / x("C"), Sign::positive);
  EXPECT_EQ(ParametrisedSet(ring, c).sign_of((x("A") * x("C")).num()), 0);
  EXPECT_TRUE(ParametrisedSet(ring, c).provably_nonzero((x("A") * x("C")).num()));
  Assumptions d;
  d.declare_real(x("C"));
  d.require(x("A") / x("C"), Sign::positive);
  EXPECT_EQ(ParametrisedSet(ring, d).made_real_by(x("A") / x("C")), ring->index("A"));
  EXPECT_EQ(ParametrisedSet(ring, d).made_real_by(x("A") * x("C") - number(1)), ring->index("A"));
  EXPECT_FALSE(ParametrisedSet(ring, d).made_real_by(x("A") * (x("C") - number(1)))); // at C = 1
}

// A^2 = 2 and A^2 = C^2 + 3, C^2 = 1: no parameter is linear in any of them.
TEST(ParametrisedSet, EquationsThatContradictEachOtherLeaveNothing) {
  Assumptions a;
  a.require(x("A") * x("A") - number(2), Sign::zero);
  a.require(x("A") * x("A") - x("C") * x("C") - number(3), Sign::zero);
  EXPECT_FALSE(ParametrisedSet(ring, a).is_empty());
  a.require(x("C") * x("C") - number(1), Sign::zero);
  EXPECT_TRUE(ParametrisedSet(ring, a).is_empty());
}

// x = d^2/c > 0 with complex c, d says nothing about the sign of c d^2.
TEST(ParametrisedSet, AnInequalityIsCarriedOverARealDenominatorOnly) {
  const Ring complex = make_ring({"c", "d", "x", "z"});
  const auto v = [&](const char* name) { return MFraction::variable(complex, name); };
  Assumptions a;
  a.require(v("x"), Sign::positive);
  a.require(v("c"), Sign::nonzero);
  const auto there =
      ParametrisedSet(complex, a).where_zero((v("c") * v("x") - v("d") * v("d")).num());
  ASSERT_TRUE(std::holds_alternative<ParametrisedSet>(there));
  const ParametrisedSet& s = std::get<ParametrisedSet>(there);
  EXPECT_EQ(s.sign_of((v("c") * v("d") * v("d")).num()), 0);
  EXPECT_TRUE(s.provably_nonzero(v("d").num()));
}

// A^3 = C^2 at A = 0 is C^2 = 0: no relation that C is a root of, but the equation C = 0.
TEST(ParametrisedSet, ARelationStaysIrreducible) {
  const ParametrisedSet r = ParametrisedSet(ring, {}).with_relation(
      (x("A") * x("A") * x("A") - x("C") * x("C")).num(), ring->index("A"), true);
  const auto there = r.where_zero(x("A").num());
  ASSERT_TRUE(std::holds_alternative<ParametrisedSet>(there));
  const ParametrisedSet& cusp = std::get<ParametrisedSet>(there);
  EXPECT_TRUE(cusp.relations().empty());
  ASSERT_TRUE(cusp.pending());
  EXPECT_TRUE(cusp.doubtful_factor(*cusp.pending()) == x("C").num());
}

// Resultants with two relations, each in the variable of the other one, must not go round for ever.
TEST(ParametrisedSet, RelationsInEachOthersVariablesEnd) {
  const auto cube = [](const MFraction& t) { return t * t * t; };
  const ParametrisedSet r =
      ParametrisedSet(ring, {})
          .with_relation((x("A") * x("A") - cube(x("C")) - number(1)).num(), ring->index("A"), true)
          .with_relation((x("C") * x("C") - cube(x("A")) - number(2)).num(), ring->index("C"),
                         true);
  (void)r.doubtful_factor((x("A") + x("C") + number(7)).num());
  EXPECT_EQ(r.relations().size(), 2U);
}

TEST(ParametrisedSet, EquationsAreSolvedAndCarriedIntoTheAssumptions) {
  const ParametrisedSet r = positive_bodies();
  const auto there = r.where_zero((x("C") - x("A") + number(1)).num());
  ASSERT_TRUE(std::holds_alternative<ParametrisedSet>(there));
  const ParametrisedSet& line = std::get<ParametrisedSet>(there);
  EXPECT_TRUE(line.restrict(x("C")) == x("A") - number(1));
  EXPECT_EQ(line.exact_sign_of((x("A") - number(1)).num()), 1); // C > 0
  EXPECT_EQ(line.exact_sign_of((x("A") * x("A") + x("A") - number(2)).num()), 1);
  EXPECT_FALSE(line.provably_nonzero((x("A") - number(2)).num()));
}

TEST(ParametrisedSet, ContradictionsAreSeen) {
  Assumptions a;
  a.require(x("A"), Sign::positive);
  a.require(-x("A") - number(1), Sign::nonnegative);
  EXPECT_TRUE(ParametrisedSet(ring, a).is_empty());
  const auto there = positive_bodies().where_zero((x("A") + x("C")).num());
  EXPECT_TRUE(std::holds_alternative<ParametrisedSet::Empty>(there));
}

TEST(ParametrisedSet, InequalitiesThatNeedTheOracleAreCounted) {
  Assumptions a;
  a.declare_real(x("A"));
  a.declare_real(x("C"));
  a.require(x("A") * x("A") + x("C") * x("C") - x("A") * x("C") - number(1), Sign::nonnegative);
  const ParametrisedSet r(ring, a);
  EXPECT_EQ(r.sign_of((x("A") * x("A") + x("C") * x("C") - x("A") * x("C")).num()), 1);
  EXPECT_EQ(r.trusted().size(), 1U);
}

TEST(ParametrisedSet, Memberships) {
  Assumptions a;
  a.memberships.push_back({x("h"), true});
  a.memberships.push_back({x("A") - MFraction(ring, Rational(1, 2)), false});
  const ParametrisedSet r(ring, a);
  EXPECT_EQ(r.is_integral(Rational(2) * x("h") + number(3)), Truth::yes);
  EXPECT_EQ(r.is_integral(x("h") + MFraction(ring, Rational(1, 3))), Truth::no);
  EXPECT_EQ(r.is_integral(x("A") + MFraction(ring, Rational(1, 2))), Truth::no);
  EXPECT_EQ(r.is_integral(x("A")), Truth::unknown);
}

} // namespace
} // namespace kov::parametrised_set_test
