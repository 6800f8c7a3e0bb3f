// Two differences that are special at finitely many values together.

#include "support/statements.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::common_values_test {
namespace {

using test::Kind;
using test::numbers;
using test::some;
using testing::ElementsAre;

const Ring ring = make_ring({"a", "b"});
const MFraction a = MFraction::variable(ring, "a"), b = MFraction::variable(ring, "b");
MFraction number(long n) { return {ring, Rational(n)}; }
Statement integer(const MFraction& x) { return some(Kind::integer, {x * x}); }

// Delta itself counts, not only its square: a and 3/(a + 5) are integers for a = -2, -4, -6, -8.
TEST(CommonValues, BothSignsOfADifference) {
  const auto common = common_values(integer(a), integer(number(3) / (a + number(5))));
  ASSERT_TRUE(common);
  EXPECT_EQ(common->square, a * a);
  EXPECT_THAT(common->values, ElementsAre(4, 16, 36, 64));
}

// The limit 1/2 of the second is not an integer, or is one of the halves and never reached.
TEST(CommonValues, NearTheLimit) {
  const MFraction f = a / (number(2) * a + number(1));
  const auto integers = common_values(integer(a), integer(f));
  ASSERT_TRUE(integers);
  EXPECT_THAT(integers->values, ElementsAre(0, 1)); // 0 and, for a = -1, 1
  Statement halves = integer(f);
  numbers(halves).classes = Kind::half_integer;
  const auto common = common_values(integer(a), halves);
  ASSERT_TRUE(common);
  EXPECT_THAT(common->values, ElementsAre(0, 1));
}

// Of a/b, by its square or cube: (s^2 - 1)(t^2 - 1) = 64 with s and t odd.
TEST(CommonValues, OfARatioOfTwoParameters) {
  for (const unsigned long k : {1UL, 2UL, 3UL}) {
    const MFraction ratio = pow(a / b, static_cast<long>(k)), one = number(1);
    const auto odd = [&](const MFraction& square) {
      return some(Classes{odd_integers}, {one + number(8) * square});
    };
    const auto common = common_values(odd(ratio), odd(one / ratio));
    ASSERT_TRUE(common) << k;
    EXPECT_THAT(common->values, ElementsAre(9)) << k;
  }
}

TEST(CommonValues, NothingIsSaidWithoutALimit) {
  EXPECT_FALSE(common_values(integer(a), integer(a * a)));
  EXPECT_FALSE(common_values(integer(a), integer(b)));
  EXPECT_FALSE(common_values(integer(a), integer(a + number(1))));
}

// The squares of numbers that are not functions of a: the limit 4 is as near to 1 as a = 25 needs.
TEST(CommonValues, TheSquareThatIsNearestToTheLimit) {
  const Statement root = some(Kind::integer, {a});
  const auto common = common_values(root, some(Kind::integer, {number(4) - number(75) / a}));
  ASSERT_TRUE(common);
  EXPECT_THAT(common->values, testing::Contains(Rational(25)));
}

// x^2 and 2 x^2 + 1 are squares for infinitely many x (Pell); -x^2 + 25 for finitely many.
TEST(CommonValues, SquaresThatGrow) {
  const Statement root = some(Kind::integer, {a});
  EXPECT_FALSE(common_values(root, some(Kind::integer, {number(2) * a + number(1)})));
  const auto common = common_values(root, some(Kind::integer, {number(25) - a}));
  ASSERT_TRUE(common);
  EXPECT_THAT(common->values, ElementsAre(0, 9, 16, 25));
}

} // namespace
} // namespace kov::common_values_test
