// Statements at points of the parameters.

#include "closed/arithmetic.hpp"

#include <gtest/gtest.h>

namespace kov::arithmetic_test {
namespace {

const Ring ring = make_ring({"a", "b", "n"});
MFraction x(const char* name) { return MFraction::variable(ring, name); }
MFraction number(long p, long q = 1) { return {ring, Rational(p, q)}; }
MFraction squared(const MFraction& f) { return f * f; }

const Residues odd{Rational(1), Rational(2)};
const Residues halves{Rational(1, 2), Rational(1)};
const Residues integers{Rational(0), Rational(1)};

// Squares of both signs, rational and not.
NfElem at_two(const MFraction& f) {
  return NfElem(is_zero(f) ? Rational(0)
                           : to_rational(substitute(f, {{0, number(2)}, {1, number(1, 2)}})));
}

TEST(Statements, AtPoints) { // a = 2, b = 1/2
  const auto so = [](const Assertion& s) { return is_so({s, true}, at_two); };
  EXPECT_TRUE(so(SumIn{{squared(x("a"))}, {integers}}));
  EXPECT_FALSE(so(SumIn{{squared(x("a"))}, {odd}}));
  EXPECT_FALSE(so(SumIn{{x("a")}, {integers}})); // sqrt(2)
  EXPECT_TRUE(so(SumIn{{squared(x("a")), squared(x("b"))}, {halves}}));
  EXPECT_TRUE(so(SumIn{{x("a"), x("a")}, {integers}})); // sqrt(2) - sqrt(2)
  EXPECT_FALSE(so(SumIn{{x("a"), number(4) * x("a")}, {integers}}));
  EXPECT_TRUE(so(SumIn{{x("a"), x("a"), number(9)}, {odd}})); // sqrt(2) - sqrt(2) + 3
  EXPECT_FALSE(so(SumIn{{x("a"), x("a"), number(4)}, {odd}}));
  EXPECT_FALSE(so(AllRational{{x("a")}}));
  EXPECT_FALSE(so(AllRational{{-squared(x("a"))}}));
  EXPECT_TRUE(so(SomeIn{{squared(x("b")), x("a"), number(9, 4)}, Classes{halves}, false, 2}));
  // N = 2: +-1, no 0; N = 3: 0 and +-2
  EXPECT_TRUE(so(Separated{{number(4), number(1)}}));
  EXPECT_FALSE(so(Separated{{number(4), number(0)}}));
  EXPECT_TRUE(so(Separated{{number(9), number(0)}}));
  EXPECT_FALSE(so(Separated{{number(9), number(16)}}));
  // sqrt(2) + 1 - sqrt(2) = 1 is among N - 1, ... for N = 2
  EXPECT_FALSE(so(WithoutLogarithm{{number(0), number(0), number(1)}})); // Legendre, degree 0
  EXPECT_TRUE(so(WithoutLogarithm{{number(1), number(1, 9), number(1, 9)}}));
  EXPECT_FALSE(so(WithoutLogarithm{{number(1), number(1, 9), number(4, 9)}}));
  EXPECT_TRUE(so(InRow{{number(1, 4), number(1, 9), number(1, 25)}, GroupType::A5}));
  EXPECT_FALSE(so(InRow{{number(1, 4), number(1, 9), number(1, 25)}, GroupType::A4}));
}

} // namespace
} // namespace kov::arithmetic_test
