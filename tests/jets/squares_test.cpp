#include "jets/squares.hpp"

#include <gtest/gtest.h>

namespace kov::jets {
namespace {

// Is n d^2 a sum of squares of integers for some d <= 12?
bool found(long n, int count) {
  const auto of_two = [](long m) {
    for (long a = 0; a * a <= m; ++a)
      for (long b = a; a * a + b * b <= m; ++b)
        if (a * a + b * b == m) return true;
    return false;
  };
  for (long d = 1; d <= 12; ++d)
    for (long c = 0; c * c <= n * d * d; ++c)
      if (of_two(n * d * d - c * c) && (count == 3 || c == 0)) return true;
  return false;
}

TEST(SumsOfSquares, AreThoseThatAreFound) {
  for (long n = 0; n < 200; ++n)
    for (const int count : {2, 3})
      EXPECT_EQ(may_be_sum_of_squares(n, count), found(n, count)) << n << " " << count;
}

TEST(SumsOfSquares, OfRationalNumbers) {
  EXPECT_FALSE(may_be_sum_of_squares(Rational(10, 3), 2));
  EXPECT_TRUE(may_be_sum_of_squares(Rational(10, 3), 3));
  EXPECT_TRUE(may_be_sum_of_squares(Rational(5, 49), 2));
  EXPECT_FALSE(may_be_sum_of_squares(Rational(-1, 4), 7));
  EXPECT_TRUE(may_be_sum_of_squares(Rational(7), 4));
  EXPECT_TRUE(may_be_sum_of_squares(Rational(3) * pow(Integer(10), 30), 2)); // not factored
}

} // namespace
} // namespace kov::jets
