// Sets without points, denominators that vanish, parameters that cancel, places that meet, limits.

#include "strata/at_point.hpp"
#include "strata/certificate.hpp"
#include "strata/domain.hpp"

#include <gmock/gmock.h>

#include <array>

namespace kov::strata::traps_test {
namespace {

using test::ExactPoint;
using test::Random;
using test::random_exact_point;
using testing::ElementsAre;
using testing::IsEmpty;

const Ring ring = make_ring({"a", "z", "b", "c"}); // z is not the first one
constexpr std::size_t Z = 1;
const MFraction z = MFraction::variable(ring, "z");
const MFraction a = MFraction::variable(ring, "a");
const MFraction b = MFraction::variable(ring, "b");
const MFraction c = MFraction::variable(ring, "c");
const MFraction one(ring, Rational(1));

MFraction number(long p, long q = 1) { return MFraction(ring, Rational(p, q)); }

Question asked(const MFraction& r) {
  Question q;
  q.r = r;
  q.z = Z;
  return q;
}

void expect_agreement(const Question& q, unsigned seed, int points = 12) {
  const auto strata = decide_strata(q).told_apart();
  Random random(seed);
  for (int k = 0; k < points; ++k) {
    const ExactPoint point = random_exact_point(q, random, k % 3 == 0);
    if (std::ranges::all_of(q.assumptions.conditions,
                            [&](const Condition& one) { return point.holds(one); }))
      agree_at(q, strata, point);
  }
}

ExactPoint at(long at_a, long at_b, long at_c) {
  return {Z, {{0, NfElem(at_a)}, {2, NfElem(at_b)}, {3, NfElem(at_c)}}};
}

TEST(Trap, WithoutParametersThereIsOneStratum) {
  for (const MFraction& r : {z, number(2) / (z * z), -one, z * z + number(3), MFraction(ring)}) {
    const StrataAnswer answer = decide_strata(asked(r));
    ASSERT_EQ(answer.strata.size(), 1U) << to_string(r);
    EXPECT_THAT(answer.strata[0].conditions, IsEmpty());
    NormalForm equation;
    if (!is_zero(r)) equation.r = to_rational_function(r, Z);
    EXPECT_EQ(answer.abelian(), decide(equation).abelian) << to_string(r);
  }
}

TEST(Trap, AParameterThatCancelsIsNoCondition) {
  const StrataAnswer answer = decide_strata(asked(c * (z * b + b) / (b * c)));
  ASSERT_EQ(answer.strata.size(), 1U);
  EXPECT_THAT(answer.strata[0].conditions, IsEmpty());
  EXPECT_EQ(answer.abelian(), Truth::no);
  EXPECT_THAT(in_words(domain(answer)), IsEmpty());
}

TEST(Trap, WhereADenominatorVanishesThereIsNoEquation) {
  const auto where = [](const MFraction& r) { return in_words(domain(decide_strata(asked(r)))); };
  EXPECT_THAT(where(z / a), ElementsAre("a != 0"));
  EXPECT_THAT(where(one / (a * z + b)), ElementsAre("a != 0 or b != 0"));
  EXPECT_THAT(where(one / (a * z * z + one)), IsEmpty());
  EXPECT_THAT(where(z / (a * b - one)), ElementsAre("a*b != 1"));
}

// The domain and the strata say it both, point by point.
TEST(Trap, TheDomainIsWhereTheEquationIs) {
  Random random(3);
  for (const MFraction& r : {z / (a - b), one / (a * z + b) + c, c / ((a * z + b) * (b * z + c)),
                             (a * z + b) / (a * b * z * z), z + c / (a * a - number(2) * b)}) {
    const Question q = asked(r);
    const StrataAnswer answer = decide_strata(q);
    const Domain there = domain(answer);
    const auto strata = answer.told_apart();
    for (int k = 0; k < 60; ++k) {
      const ExactPoint point = random_exact_point(q, random, k % 3 == 0);
      const auto nonzero = [&](const MPoly& f) { return point.holds({f, Sign::nonzero}); };
      const bool in_domain = std::ranges::all_of(there.nonzero, nonzero) &&
                             std::ranges::all_of(there.not_all_zero, [&](const auto& group) {
                               return std::ranges::any_of(group, nonzero);
                             });
      const auto s = the_stratum(strata, point);
      ASSERT_TRUE(s);
      EXPECT_EQ(in_domain, !s->leaf.no_equation()) << to_string(r) << " at " << point.text(ring);
    }
    for (const Stratum& s : on_domain(answer).strata)
      EXPECT_FALSE(s.leaf.no_equation());
  }
}

TEST(Trap, ASetWithoutPointsHasNoVerdict) {
  const auto empty = [](const std::vector<std::pair<MFraction, Sign>>& all,
                        const std::vector<MFraction>& real = {}) {
    Question q = asked(a * z + b);
    for (const MFraction& x : real)
      q.assumptions.declare_real(x);
    for (const auto& [f, sign] : all)
      q.assumptions.require(f, sign);
    const StrataAnswer answer = decide_strata(q);
    EXPECT_EQ(answer.contradictory, answer.strata.empty());
    if (answer.contradictory) {
      EXPECT_EQ(answer.abelian(), Truth::unknown);
    }
    return answer.contradictory;
  };
  using enum Sign;
  EXPECT_TRUE(empty({{a, zero}, {a, nonzero}}));
  EXPECT_TRUE(empty({{a, positive}, {-a, positive}}, {a}));
  EXPECT_TRUE(empty({{a * b, zero}, {a, nonzero}, {b, nonzero}}));
  EXPECT_TRUE(empty({{a * b - one, zero}, {a, zero}}));
  EXPECT_TRUE(empty({{a * a + one, zero}}, {a}));
  EXPECT_FALSE(empty({{a * a + one, zero}})); // a = i
  EXPECT_FALSE(empty({{a * b, zero}, {a, nonzero}}));
  EXPECT_FALSE(empty({{a, nonnegative}, {-a, nonnegative}}, {a})); // a = 0
}

TEST(Trap, ASetOfIntegersWithoutPoints) {
  for (const long twice : {1, 2}) {
    Question q = asked(z + a);
    q.assumptions.require_integral(a, true);
    q.assumptions.require(number(2) * a - number(twice), Sign::zero);
    EXPECT_EQ(decide_strata(q).contradictory, twice == 1);
  }
  Question root = asked(z + a);
  root.assumptions.declare_rational(a);
  root.assumptions.require(a * a - number(2), Sign::zero);
  EXPECT_TRUE(decide_strata(root).contradictory);
}

// a^3 = b^2 at a = 0 is b^2 = 0: no field.
TEST(Trap, ARelationMayLoseItsPrimality) {
  Question q = asked(a * z + b);
  q.assumptions.require(a * a * a - b * b, Sign::zero);
  const auto strata = decide_strata(q).told_apart();
  for (const auto& [at_a, at_b] : {std::pair(0L, 0L), std::pair(1L, 1L), std::pair(4L, -8L)})
    EXPECT_TRUE(agree_at(q, strata, at(at_a, at_b, 0))) << at_a;
}

// sqrt(2) and -sqrt(2), i and -i: what is decided holds for every choice of the root.
TEST(Trap, EveryRootIsMeant) {
  for (const long square : {2, -1, -3}) {
    Question q = asked(a * z * z + a * a);
    q.assumptions.require(a * a - number(square), Sign::zero);
    const auto strata = decide_strata(q).told_apart();
    const NfElem root = NfElem::generator(make_field({Integer(-square), 0, 1}, "w"));
    for (const NfElem& x : {root, -root})
      EXPECT_TRUE(agree_at(q, strata, ExactPoint(Z, {{0, x}, {2, NfElem(0)}, {3, NfElem(0)}})));
  }
}

// Two places, or three, become one; a pole and a zero meet; a pole moves to infinity.
TEST(Trap, PlacesMeet) {
  const MFraction x = z - a, y = z - b, w = z - c;
  const std::vector<MFraction> all{number(3, 4) / (x * x) + number(-3, 16) / (y * y),
                                   one / (x * y),
                                   number(-3, 16) * (one / (x * x) + one / (y * y)) + one / (x * y),
                                   w / (x * x * x),
                                   x * y * y,
                                   one / ((a * z + one) * (a * z + one)) + b,
                                   b / (x * x * w) + c};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Question q = asked(all[k]);
    SCOPED_TRACE(to_string(q.r));
    expect_agreement(q, static_cast<unsigned>(k));
    const auto strata = decide_strata(q).told_apart();
    for (const auto& [i, j, l] :
         {std::array{0L, 0L, 0L}, std::array{1L, 1L, 1L}, std::array{1L, 1L, 2L},
          std::array{2L, 1L, 2L}, std::array{2L, 1L, 1L}})
      agree_at(q, strata, at(i, j, l));
  }
}

TEST(Trap, WhatWasDividedByMayVanish) {
  Question q = asked(a * z + b);
  q.generic.push_back({{(a - c).num(), b.num()}, Genericity::Else::division, "x"});
  const auto strata = decide_strata(q).told_apart();
  const auto no_equation = [&](const ExactPoint& point) {
    const auto s = the_stratum(strata, point);
    return s && s->leaf.no_equation();
  };
  EXPECT_TRUE(no_equation(at(2, 0, 2)));
  EXPECT_TRUE(no_equation(at(0, 0, 0)));
  EXPECT_FALSE(no_equation(at(2, 1, 2)));
  EXPECT_FALSE(no_equation(at(2, 0, 1)));
  EXPECT_THAT(in_words(domain(decide_strata(q))), ElementsAre(testing::HasSubstr(" or ")));
}

// A limit leaves strata open, and claims nothing for all parameters.
TEST(Trap, ALimitIsNoVerdict) {
  const Question q = asked(a * z * z + b * z + c);
  StrataLimits limits;
  limits.max_strata = 1;
  const StrataAnswer few = decide_strata(q, limits);
  EXPECT_EQ(few.strata.size(), 1U);
  EXPECT_FALSE(few.unvisited.empty());
  EXPECT_FALSE(few.decided());
  EXPECT_EQ(few.abelian(), Truth::unknown);
  StrataLimits none;
  none.decide.budget = Budget::of_seconds(-1);
  const StrataAnswer nothing = decide_strata(q, none);
  EXPECT_TRUE(nothing.strata.empty());
  EXPECT_FALSE(nothing.unvisited.empty());
  EXPECT_FALSE(nothing.contradictory);
  EXPECT_EQ(nothing.abelian(), Truth::unknown);
}

// a and b exchanged, and z in another place of the ring: the same tree but for the names.
TEST(Trap, NamesAndTheirOrderDoNotMatter) {
  const auto exchanged = [](const MFraction& f) { return substitute(f, {{0, b}, {2, a}}); };
  Random random(11);
  for (const MFraction& r : {a * z + b * b, a / (z * z) + b, (a * a - number(1, 4)) / (z * z) - b,
                             a / z + b / (z * z * z), z * z + a * z + b}) {
    const Question q = asked(r), other = asked(exchanged(r));
    const auto here = decide_strata(q).told_apart(), there = decide_strata(other).told_apart();
    for (int k = 0; k < 30; ++k) {
      const long x = random.between(-2, 3), y = random.between(-2, 3);
      const auto s = the_stratum(here, at(x, y, 0)), t = the_stratum(there, at(y, x, 0));
      ASSERT_TRUE(s && t);
      EXPECT_EQ(s->leaf.abelian, t->leaf.abelian) << to_string(r) << ": " << x << ", " << y;
      EXPECT_EQ(s->leaf.group, t->leaf.group) << to_string(r) << ": " << x << ", " << y;
    }
  }
}

} // namespace
} // namespace kov::strata::traps_test
