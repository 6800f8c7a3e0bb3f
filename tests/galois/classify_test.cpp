// Groups of equations made to have them, their solutions put back, and what must not change them.

#include "galois/classify.hpp"

#include "galois/solutions.hpp"
#include "support/equations.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using testing::from_omega;
using testing::gauge;
using testing::pull_back;
using testing::riemann;

const Poly z = Poly::z();

RationalFunction by_differences(const Rational& a, const Rational& b, const Rational& c) {
  return riemann(NfElem(a * a), NfElem(b * b), NfElem(c * c));
}
RationalFunction over(long n, const Poly& d) { return {Poly(n), d}; }

struct Known {
  const char* name;
  RationalFunction r;
  GaloisGroup group;
};
void PrintTo(const Known& k, std::ostream* out) { *out << k.name; }

std::vector<Known> known() {
  const Rational half(1, 2), third(1, 3);
  return {
      {"Airy", RationalFunction(z), {GroupType::SL2, {}}},
      {"Weber", RationalFunction(z * z + Poly(2)), {GroupType::SL2, {}}},
      {"Gauss", by_differences(half, third, Rational(1, 7)), {GroupType::SL2, {}}},
      {"Legendre", by_differences(0, 0, Rational(1, 2)), {GroupType::SL2, {}}},
      {"Hermite", RationalFunction(z * z - Poly(3)), {GroupType::Borel, {}}},
      {"Exponentials", RationalFunction(1), {GroupType::Gm, {}}},
      {"BesselHalf", RationalFunction(-1) + over(2, z * z), {GroupType::Gm, {}}},
      {"IrrationalPower", over(1, z * z), {GroupType::Gm, {}}},
      {"Logarithm", RationalFunction(Poly(Rational(-1, 4)), z * z), {GroupType::T, Integer(2)}},
      {"Rational", over(2, z * z), {GroupType::cyclic, Integer(1)}}, // z^2 and 1/z
      {"Unipotent",
       from_omega(RationalFunction(Poly(-1), z) +
                  RationalFunction(Poly(1), z - Poly(1))), // (z - 1)/z
       {GroupType::T, Integer(1)}},
      {"Power", RationalFunction(Poly(Rational(-3, 16)), z * z), {GroupType::cyclic, Integer(4)}},
      {"PowerThird",
       RationalFunction(Poly(Rational(-2, 9)), z * z),
       {GroupType::cyclic, Integer(3)}},
      {"InfiniteDihedral",
       over(1, z) + RationalFunction(Poly(Rational(-3, 16)), z * z),
       {GroupType::Dinf, {}}},
      {"Quaternion", by_differences(half, half, half), {GroupType::D, Integer(2)}},
      {"Dihedral", by_differences(half, half, Rational(2, 5)), {GroupType::D, Integer(5)}},
      {"Tetrahedral", by_differences(half, third, third), {GroupType::A4, {}}},
      {"Octahedral", by_differences(half, third, Rational(1, 4)), {GroupType::S4, {}}},
      {"Icosahedral", by_differences(half, third, Rational(1, 5)), {GroupType::A5, {}}}};
}

class Groups : public ::testing::TestWithParam<Known> {};

// w' = r - w^2 carries the polynomial Q(w) to a multiple of itself: all its roots solve Riccati.
void expect_riccati(const std::vector<RationalFunction>& q, const RationalFunction& r) {
  const std::size_t n = q.size() - 1;
  std::vector<RationalFunction> d(n + 2);
  for (std::size_t i = 0; i <= n; ++i) {
    const RationalFunction factor(static_cast<long>(i));
    d[i] += derivative(q[i]);
    if (i > 0) d[i - 1] += factor * q[i] * r;
    d[i + 1] -= factor * q[i];
  }
  for (std::size_t i = n + 1; i >= n; --i) { // the remainder by Q
    const RationalFunction c = d[i] / q[n];
    for (std::size_t j = 0; j <= n; ++j)
      d[i - n + j] -= c * q[j];
  }
  for (const RationalFunction& c : d)
    EXPECT_TRUE(is_zero(c));
}

TEST_P(Groups, AreThoseThatWerePutIn) {
  const Classification c = classify(GetParam().r);
  ASSERT_TRUE(c.group) << reason(c);
  EXPECT_EQ(describe(*c.group), describe(GetParam().group));
  EXPECT_EQ(c.component, identity_component(GetParam().group));
  EXPECT_EQ(c.abelian, truth(is_abelian(*c.component)));
  EXPECT_FALSE(c.undecided);
  EXPECT_FALSE(reason(c).empty());
}

TEST_P(Groups, SolutionsPlugBack) {
  const RationalFunction& r = GetParam().r;
  const auto all = solutions(classify(r), r);
  EXPECT_EQ(all.empty(), GetParam().group.type == GroupType::SL2);
  for (const LiouvillianSolution& y : all) {
    if (y.exponential) {
      EXPECT_EQ(from_omega(y.exponential->omega()), r);
      EXPECT_FALSE(text(y).empty());
    } else if (!y.minimal_polynomial.empty()) {
      expect_riccati(y.minimal_polynomial, r);
      const std::size_t degree = y.minimal_polynomial.size() - 1;
      switch (GetParam().group.type) {
      case GroupType::A4:
      case GroupType::S4:
        EXPECT_TRUE(degree == 4 || degree == 6 || degree == 8) << degree;
        break;
      case GroupType::A5:
        EXPECT_EQ(degree, 12U);
        break;
      default:
        EXPECT_EQ(degree, 2U);
      }
    }
  }
}

TEST_P(Groups, MoebiusTransformationsAndGaugesKeepThem) {
  const RationalFunction& r = GetParam().r;
  const Classification before = classify(r);
  const RationalFunction f(z - Poly(7), Poly(3) * z + Poly(2));
  const Classification moved = classify(pull_back(r, f));
  ASSERT_TRUE(moved.component) << reason(moved);
  EXPECT_EQ(moved.component, before.component);
  const GroupType type =
      before.group->type; // square roots may come in where the group is reducible
  if (type != GroupType::cyclic && type != GroupType::T) {
    EXPECT_EQ(describe(*moved.group), describe(*before.group));
  }
  const RationalFunction a(Poly(1), z - Poly(5));
  if (is_zero(r + derivative(a) - a * a)) return;
  const Classification gauged = classify(gauge(r, a));
  ASSERT_TRUE(gauged.component) << reason(gauged);
  EXPECT_EQ(gauged.component, before.component);
}

INSTANTIATE_TEST_SUITE_P(All, Groups, ::testing::ValuesIn(known()),
                         [](const auto& test) { return test.param.name; });

// y = exp int omega for random omega: the group is reducible, and the solution found is verified.
TEST(Classify, PlantedExponentialsAreFound) {
  test::random_rounds(30, [](test::Random& random) {
    RationalFunction omega;
    for (long c = 0; c < 3; ++c)
      omega += RationalFunction(Poly(Rational(random.between(-5, 5), random.between(1, 4))),
                                z - Poly(c));
    if (random.once_in(2)) omega += RationalFunction(Poly(random.between(-2, 2)));
    const RationalFunction r = from_omega(omega);
    if (is_zero(r)) return;
    const Classification c = classify(r);
    ASSERT_TRUE(c.group) << to_string(r);
    EXPECT_EQ(kovacic_case(*c.group), 1) << to_string(r);
    for (const LiouvillianSolution& y : solutions(c, r))
      if (y.exponential) {
        EXPECT_EQ(from_omega(y.exponential->omega()), r);
      }
  });
}

TEST(Classify, WithoutTimeTheQuestionStaysOpen) {
  Budget late = Budget::of_seconds(0);
  late.deadline = *late.deadline - std::chrono::seconds(1);
  const Classification c =
      classify(by_differences(Rational(1, 2), Rational(1, 3), Rational(1, 5)), late);
  EXPECT_FALSE(c.group);
  EXPECT_EQ(c.abelian, Truth::unknown);
  ASSERT_TRUE(c.undecided);
  EXPECT_EQ(c.undecided->why, Unable::Why::budget);
}

TEST(Classify, FreeMotion) {
  const Classification c = classify(RationalFunction(0));
  EXPECT_EQ(*c.group, (GaloisGroup{GroupType::cyclic, Integer(1)}));
  EXPECT_FALSE(c.local);
}

// One line of degree 0, made from large exponents, and an invariant of degree 4 that would need an
// immense polynomial.  The group is that of the same shape with small exponents.
TEST(Classify, LargeExponentsDoNotHideASmallLine) {
  const auto pole = [](const Rational& a, long c) {
    return RationalFunction(Poly(a), z - Poly(c));
  };
  for (const long k : {1L, 1000L, 30000L, 1000000L, 1000000000000L}) {
    SCOPED_TRACE(k);
    const Rational a(3 * k + 1, 3);
    const Rational b(3 * k + 2, 3);
    const auto alone = classify(from_omega(pole(a, 0) + pole(b, 1) + pole(Rational(1, 5), 2)));
    ASSERT_TRUE(alone.group);
    EXPECT_EQ(*alone.group, (GaloisGroup{GroupType::T, Integer(15)}));
    const auto borel = classify(from_omega(pole(a, 0) + pole(b, 1) + RationalFunction(z)));
    ASSERT_TRUE(borel.group);
    EXPECT_EQ(borel.group->type, GroupType::Borel);
    // y1 y2 = v with opposite large exponents
    const RationalFunction v(z * (z - Poly(1)));
    const RationalFunction w(Poly(Rational(10 * k + 1, 5)));
    const auto two = classify(from_omega((derivative(v) + w) / (RationalFunction(2) * v)));
    ASSERT_TRUE(two.group);
    EXPECT_EQ(*two.group, (GaloisGroup{GroupType::cyclic, Integer(5)}));
  }
}

} // namespace
} // namespace kov
