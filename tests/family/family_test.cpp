// Equations with parameters as text, and what is decided for all of them at once.

#include "family/family.hpp"
#include "family/sentence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using ::testing::HasSubstr;

Family family(const std::string& r, const std::string& assume) {
  EquationText text;
  text.r = parse_expression(r, "r");
  text.variable = "z";
  text.assume.push_back(assume);
  for (const auto& name : names_in_assumption(assume))
    text.parameters.push_back(name);
  return read_family(text);
}

strata::StrataAnswer answer(const std::string& r, const std::string& assume) {
  return strata::decide_strata(family(r, assume).question);
}

TEST(Sentences, AreUnderstood) {
  EXPECT_EQ(sentences("A > 0, B >= C; n not an integer and nu not in 1/2+Z").size(), 4U);
  EXPECT_EQ(sentences("2*nu odd integer").at(0).modulus, Integer(2));
  EXPECT_FALSE(sentences("n is not an integer").at(0).holds);
  EXPECT_EQ(sentences("c arbitrary complex").at(0).kind, Sentence::Kind::declaration);
  EXPECT_THROW(sentences("c is blue"), InputError);
  EXPECT_THROW(sentences("A >"), InputError);
}

TEST(Families, AssumptionsAreAboutParameters) {
  EXPECT_THROW(static_cast<void>(family("a*z", "a = z")), InputError);
  EXPECT_THROW(static_cast<void>(family("a*z", "z > 0")), InputError);
}

TEST(Families, AiryIsNeverAbelian) {
  const auto a = answer("z + c", "c arbitrary complex");
  ASSERT_EQ(a.strata.size(), 1U);
  EXPECT_EQ(a.abelian(), Truth::no);
  EXPECT_EQ(a.strata[0].leaf.group->type, GroupType::SL2);
}

TEST(Families, BesselWithAndWithoutAHalfInteger) {
  const std::string r = "(4*nu^2-1)/(4*z^2)-1";
  const auto odd = answer(r, "2*nu odd integer");
  ASSERT_EQ(odd.strata.size(), 1U);
  EXPECT_EQ(odd.abelian(), Truth::yes);
  EXPECT_EQ(odd.strata[0].leaf.group->type, GroupType::Gm);
  const auto generic = answer(r, "nu not in 1/2+Z");
  ASSERT_EQ(generic.strata.size(), 1U);
  EXPECT_EQ(generic.abelian(), Truth::no);
  EXPECT_EQ(generic.strata[0].leaf.group->type, GroupType::SL2);
  const auto open = answer(r, "nu complex");
  EXPECT_FALSE(open.decided());
  EXPECT_THAT(open.strata[0].leaf.open_condition, HasSubstr("nu - 1/2 is an integer"));
}

TEST(Families, WeberIsNeverAbelian) {
  const std::string r = "z^2/4-1/2-n";
  EXPECT_EQ(answer(r, "n not an integer").strata[0].leaf.group->type, GroupType::SL2);
  EXPECT_EQ(answer(r, "n integer").strata[0].leaf.group->type, GroupType::Borel);
  const auto any = answer(r, "n complex");
  EXPECT_EQ(any.abelian(), Truth::no);
  EXPECT_FALSE(any.strata[0].leaf.group.has_value());
}

// Correction 13: generic irrationality says nothing about a reducible family.
TEST(Families, AReducibleFamilyIsNotCalledNonAbelian) {
  // omega' + omega^2 for omega = a/z + b/(z-1)
  const auto answered =
      answer("(a^2-a)/z^2 + (b^2-b)/(z-1)^2 + 2*a*b/(z*(z-1))", "a complex, b complex");
  for (const auto& s : answered.strata)
    EXPECT_NE(s.leaf.abelian, Truth::no) << strata::to_string(s.conditions) << s.leaf.reason;
}

TEST(Families, EulersEquationHasTwoExponentialSolutions) {
  EXPECT_EQ(answer("a/z^2", "a complex").abelian(), Truth::yes);
}

TEST(Families, ContradictionsAreTold) {
  EXPECT_TRUE(answer("a/z^2 + 1", "a > 1, a < 0").contradictory);
  EXPECT_TRUE(answer("a/z^2 + z", "a > 0, a^2 + a = 0").contradictory);
}

TEST(Families, EquationsAmongTheParametersAreSolved) {
  const auto a = answer("z + a + b", "a + b = 0");
  ASSERT_EQ(a.strata.size(), 1U);
  EXPECT_EQ(a.abelian(), Truth::no);
}

TEST(Families, WhereTheLeadingCoefficientVanishes) {
  const auto a = answer("a*z + b", "a complex, b complex");
  EXPECT_EQ(a.strata.size(), 3U); // Airy; r constant; r = 0
  EXPECT_TRUE(a.decided());
  EXPECT_EQ(a.abelian(), Truth::unknown);
}

} // namespace
} // namespace kov
