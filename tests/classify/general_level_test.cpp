#include "study/general_level.hpp"

#include <gtest/gtest.h>

namespace kov::general_level_test {
namespace {

const Ring ring = make_ring({"s", "h"});
const MFraction s = MFraction::variable(ring, "s"), h = MFraction::variable(ring, "h");
const MFraction one(ring, Rational(1));
const std::vector<Residues> integers{{Rational(0), Rational(1)}};

AtGeneralLevel at(const Assertion& statement) {
  return at_general_level({{{statement, true}}}, {1});
}
MFraction square(const MFraction& x) { return x * x; }

TEST(GeneralLevel, NumbersThatChangeAreNotRational) {
  EXPECT_TRUE(at(AllRational{{square(s), square(h)}}).parts.empty());
  EXPECT_EQ(at(AllRational{{square(s)}}).parts.size(), 1U);
  EXPECT_TRUE(at(AllRational{{square(s)}}).changing.empty());
  EXPECT_TRUE(at(InRow{{square(s), square(s), h}, GroupType::A5}).parts.empty());
  EXPECT_TRUE(at(Separated{{square(s), square(s + h)}}).parts.empty());
}

TEST(GeneralLevel, SumsThatDoNotChangeAreLeft) {
  const auto c = at(SumIn{{square(s + h), square(s - h)}, integers}); // 2s and 2h
  ASSERT_EQ(c.parts.size(), 1U);
  const auto* left = std::get_if<SumIn>(&c.parts[0][0].says);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->squares, Squares{square(Rational(2) * s)});
  EXPECT_TRUE(at(SumIn{{square(s), square(h)}, integers}).parts.empty());
  EXPECT_EQ(at(SumIn{{square(s), h}, integers}).parts.size(), 1U); // sqrt(h) is not a function
  EXPECT_TRUE(at(SumIn{{square(s), h}, integers}).changing.empty());
}

TEST(GeneralLevel, HalvesOfThoseThatStay) {
  EXPECT_TRUE(at(SomeIn{{square(s), square(h)}, Classes{half_integers}, false, 2}).parts.empty());
  const auto one_of_two = at(SomeIn{{square(s), square(h)}, Classes{half_integers}});
  ASSERT_EQ(one_of_two.parts.size(), 1U);
  EXPECT_EQ(std::get<SomeIn>(one_of_two.parts[0][0].says).squares, Squares{square(s)});
  EXPECT_EQ(one_of_two.changing, std::vector{square(h)}); // else it could be one of them
}

// Riemann's equation without a logarithm.
TEST(GeneralLevel, WithoutLogarithm) {
  const MFraction n = Rational(2) * s + one;
  const auto c = at(WithoutLogarithm{{square(s - h), square(n), square(s + h)}});
  ASSERT_EQ(c.parts.size(), 1U);
  const auto* left = std::get_if<Separated>(&c.parts[0][0].says);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->squares, (Squares{square(n), square(Rational(2) * s)}));
  EXPECT_EQ(c.changing.size(), 2U);
  EXPECT_TRUE(at(WithoutLogarithm{{square(s), square(h), square(Rational(2) * h)}}).parts.empty());
  EXPECT_TRUE(at(WithoutLogarithm{{square(s), square(n), square(h)}}).parts.empty());
  EXPECT_TRUE(at(WithoutLogarithm{{square(h), square(h), square(h)}}).parts.empty());
  EXPECT_EQ(at(WithoutLogarithm{{square(s), square(s), square(n)}}).parts.size(), 1U);
}

// What does not hold is not used: at special levels it may, and more parts are never wrong.
TEST(GeneralLevel, NegationsAreLeftOut) {
  const auto c = at_general_level({{{AllRational{{square(h)}}, false}}}, {1});
  ASSERT_EQ(c.parts.size(), 1U);
  EXPECT_TRUE(c.parts[0].empty());
  EXPECT_TRUE(c.changing.empty());
}

} // namespace
} // namespace kov::general_level_test
