#include "exact/ball.hpp"

#include "exact/error.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

Ball around(const Rational& middle, const Rational& radius) {
  Ball x;
  arb_set_fmpq(x.raw(), middle.raw(), 100);
  Ball r;
  arb_set_fmpq(r.raw(), radius.raw(), 100);
  arb_add_error(x.raw(), r.raw());
  return x;
}

TEST(Ball, BoundsHoldAllItsPoints) {
  for (const Rational& middle :
       {Rational(0), Rational(1, 3), Rational(-22, 7), Rational(pow(Integer(10), 30)),
        Rational(Integer(1), pow(Integer(3), 50))})
    for (const Rational& radius : {Rational(0), Rational(1, 1000), Rational(5)}) {
      const Ball x = around(middle, radius);
      EXPECT_LE(lower_bound(x), middle - radius);
      EXPECT_GE(upper_bound(x), middle + radius);
      const Rational width = upper_bound(x) - lower_bound(x);
      EXPECT_LE(width, Rational(2) * radius * Rational(101, 100) +
                           abs(middle) * Rational(Integer(1), pow(Integer(2), 60)));
    }
}

TEST(Ball, ExactNumbersHaveExactBounds) {
  for (const long n : {0L, 1L, -5L, 1L << 40}) {
    const Ball x = around(Rational(n, 64), Rational(0));
    EXPECT_EQ(lower_bound(x), Rational(n, 64));
    EXPECT_EQ(upper_bound(x), Rational(n, 64));
  }
}

TEST(Ball, InfiniteBallsHaveNoBounds) {
  Ball x;
  arb_indeterminate(x.raw());
  EXPECT_THROW((void)upper_bound(x), DomainError);
  arb_pos_inf(x.raw());
  EXPECT_THROW((void)lower_bound(x), DomainError);
}

TEST(Ball, CopiesAreIndependent) {
  Ball x = around(Rational(1), Rational(0));
  Ball y = x;
  arb_add_ui(x.raw(), x.raw(), 1, 64);
  EXPECT_EQ(upper_bound(y), Rational(1));
  y = std::move(x);
  EXPECT_EQ(upper_bound(y), Rational(2));
  ComplexBall z;
  acb_onei(z.raw());
  ComplexBall w = z;
  acb_mul(z.raw(), z.raw(), w.raw(), 64); // i^2
  EXPECT_TRUE(acb_equal_si(z.raw(), -1));
  w = std::move(z);
  EXPECT_TRUE(acb_equal_si(w.raw(), -1));
}

} // namespace
} // namespace kov
