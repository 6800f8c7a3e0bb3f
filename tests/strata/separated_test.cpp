// Three places, two differences that are not rational: the closed answer, at conjugate places too.
// docs/theory/kimura.md 6

#include "strata/at_point.hpp"
#include "strata/certificate.hpp"
#include "strata/separated.hpp"
#include "strata/specialisation.hpp"

#include <gtest/gtest.h>

namespace kov::strata::separated_test {
namespace {

const Ring ring = make_ring({"z", "a", "b"});
const MFraction z = MFraction::variable(ring, "z");
const MFraction a = MFraction::variable(ring, "a");
const MFraction b = MFraction::variable(ring, "b");
const MFraction one(ring, Rational(1));

MFraction number(long p, long q = 1) { return MFraction(ring, Rational(p, q)); }

// Delta^2 = u +- i v at +-i, D at 0, and infinity ordinary.
MFraction conjugate(const MFraction& u, const MFraction& v, const MFraction& D) {
  const MFraction w = z * z + one;
  const MFraction top = D - one + number(4) * v * z + (D + number(3) - number(4) * u) * z * z;
  return top / (number(4) * z * z * w * w);
}
// S at 0, T at 1, D at infinity.
MFraction riemann(const MFraction& S, const MFraction& T, const MFraction& D) {
  const MFraction w = z - one;
  return (S - one) / (number(4) * z * z) + (T - one) / (number(4) * w * w) +
         (one - S - T + D) / (number(4) * z * w);
}

Question question(const MFraction& r, const std::vector<MFraction>& real,
                  const std::vector<MFraction>& nonzero = {}) {
  Question q;
  q.r = r;
  for (const MFraction& x : real)
    q.assumptions.real.push_back(used_variables(x).front());
  for (const MFraction& x : nonzero)
    q.assumptions.require(x, Sign::nonzero);
  return q;
}

StrataAnswer answer(const Question& q) {
  StrataLimits limits;
  limits.decide.want_certificate = true;
  return decide_strata(q, limits);
}

// Proved, and the certificate is accepted without a trusted step.
void expect_never(const Question& q) {
  const StrataAnswer found = answer(q);
  EXPECT_EQ(found.abelian(), Truth::no);
  for (const Stratum& s : found.strata)
    EXPECT_FALSE(reason(s.leaf).empty()) << to_string(s.conditions);
  ASSERT_NE(found.certificate, nullptr);
  EXPECT_EQ(found.certificate->refusal, "");
  EXPECT_TRUE(found.certificate->trusted.empty());
  EXPECT_TRUE(found.certificate->left_out.empty());
  test::compare(q, found, 11);
}

// What is said at a point, where the parts are told apart.
Truth said(const StrataAnswer& found, const NfElem& at_a, const NfElem& at_b) {
  const auto s = test::the_stratum(found.told_apart(), test::ExactPoint(0, {{1, at_a}, {2, at_b}}));
  return s ? s->leaf.abelian : Truth::unknown;
}

TEST(Separated, SymmetricHeavyTopForAllMomentsAndAngles) {
  expect_never(question(conjugate(number(2) * a - number(7, 4), number(-4) * b, number(4) * a),
                        {a, b}, {b}));
}

// (n - 1)^2 > k^2 > 2 n^2 - s: nothing is left up to s = 7; for s = 8 it is n = 2, k = 1.
TEST(Separated, BorderlineOfTheGrowth) {
  const auto shifted = [](long s) {
    return conjugate(number(2) * a - number(s, 4), b, number(4) * a);
  };
  for (const long s : {-5, 0, 3, 7})
    expect_never(question(shifted(s), {a, b}, {b}));
  // a = 1 and b^2 = 1/4 is n = 2, k = 1
  const StrataAnswer eight = answer(question(shifted(8), {a, b}, {b}));
  EXPECT_EQ(eight.abelian(), Truth::unknown);
  EXPECT_TRUE(eight.decided());
  EXPECT_EQ(said(eight, NfElem(1), NfElem(Rational(1, 2))), Truth::yes);
  EXPECT_EQ(said(eight, NfElem(1), NfElem(1)), Truth::no);
  EXPECT_EQ(said(eight, NfElem(2), NfElem(Rational(1, 2))), Truth::no);
}

TEST(Separated, WithComplexParametersTheCriterionIsTold) {
  const MFraction r = conjugate(number(2) * a - number(7, 4), number(-4) * b, number(4) * a);
  const StrataAnswer found = answer(question(r, {}, {b}));
  // n = 3, k = 2: z^2 + 4 w z + 8 over 4 z^2 (z^2 + 1)^2, w^2 = -7
  const NfElem w = NfElem::generator(make_field({7, 0, 1}, "w"));
  const Truth there = said(found, NfElem(Rational(9, 4)), -w / NfElem(4));
  EXPECT_NE(there, Truth::no);
  EXPECT_NE(said(found, NfElem(2), w), Truth::yes);
}

TEST(Separated, OneThirdDifferenceFromOneToThree) {
  for (const long n : {1, 2, 3, 5}) {
    // d1, d2 = +-i a and +-i (a + 1): the sum is 0 nowhere
    const MFraction other = a + one;
    const Question q = question(riemann(-(a * a), -(other * other), number(n * n)), {a},
                                {a, other, number(2) * a + one});
    const StrataAnswer found = answer(q);
    EXPECT_EQ(found.abelian(), Truth::no) << n;
    test::compare(q, found, 11);
  }
}

TEST(Separated, BothImaginary) {
  Question q = question(riemann(-a, -b, z - z + number(4) * a * a + b), {a, b}, {a - b});
  q.assumptions.require(a, Sign::positive);
  q.assumptions.require(b, Sign::positive);
  expect_never(q);
}

TEST(Separated, ThePlacesThatItIsAbout) {
  const auto places = [](const MFraction& r, const std::vector<MFraction>& real,
                         const std::vector<MFraction>& nonzero) {
    const Question q = question(r, real, nonzero);
    ParametrisedSet region(ring, q.assumptions);
    for (const MFraction& f : nonzero)
      region = region.where_nonzero(f.num());
    const auto s = scheme(r, 0, region);
    const auto* found = std::get_if<Scheme>(&s);
    return found ? three_places(*found) : std::nullopt;
  };
  const auto pair = places(conjugate(a, b, a + one), {a, b}, {b, a, a + one});
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->pair.size(), 1U);
  EXPECT_EQ(pair->numbers.squares[0], a + one);
  EXPECT_EQ(pair->numbers.squares[1], number(2) * a);
  EXPECT_EQ(pair->numbers.squares[2], a * a + b * b);
  // rational differences, a fourth place, an irregular one
  EXPECT_FALSE(places(riemann(number(1, 4), number(1, 9), a), {a}, {a}));
  EXPECT_FALSE(places(conjugate(a, b, a + one) + one / (z * z), {a, b}, {b, a, a + one}));
  EXPECT_FALSE(places(conjugate(a, b, a + one) + one, {a, b}, {b, a, a + one}));
}

// Random squares u +- i v and D: the verdict at random points is that of the solver without parameters.
TEST(Separated, AsTheSolverWithoutParameters) {
  std::mt19937 random(20261126);
  const auto small = [&] { return std::uniform_int_distribution<long>(-3, 3)(random); };
  for (int k = 0; k < 12; ++k) {
    const MFraction u = number(small()) * a + number(small(), 2) + number(small()) * b;
    const MFraction v = b + number(small()) * a;
    const MFraction D = number(1 + std::abs(small())) * a + number(small());
    if (is_zero(v)) continue;
    const Question q = question(conjugate(u, v, D), {a, b}, {v});
    SCOPED_TRACE(to_string(q.r));
    test::compare(q, answer(q), static_cast<unsigned>(k));
  }
}

} // namespace
} // namespace kov::strata::separated_test
