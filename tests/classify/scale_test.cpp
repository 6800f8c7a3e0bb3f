#include "moves/scale.hpp"

#include "classify/classify.hpp"
#include "exact/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::scale_test {
namespace {

System planar(const std::string& parameters, const std::string& hamiltonian,
              const std::string& more = "") {
  return read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "parameters = [" +
          parameters + "]\nhamiltonian = '" + hamiltonian + "'\n" + more,
      "test.toml"));
}
std::vector<std::string> ones(const System& s) {
  std::vector<std::string> all;
  if (const auto x = scaled(s))
    for (const std::size_t i : x->ones)
      all.push_back(s.ring()->name(i));
  return all;
}

TEST(Scale, LengthTimeAndEnergy) {
  EXPECT_EQ(ones(planar("'A', 'B', 'a', 'b', 'c'", "(u^2 + v^2)/2 + A*x^2 + B*y^2 + a*x^4 + "
                                                   "b*x^2*y^2 + c*y^4"))
                .size(),
            2U);
  EXPECT_EQ(ones(planar("'a'", "(u^2 + v^2)/2 + a*x^2 + x^3 + x*y^2")).size(), 1U);
  EXPECT_THAT(ones(planar("'a'", "(u^2 + v^2)/2 + x^3 + a*x*y^2")), testing::IsEmpty());
  EXPECT_THAT(ones(planar("'a'", "(u^2 + v^2)/2 + x^2 + x^3 + a*x*y^2")), testing::IsEmpty());
  EXPECT_THAT(ones(planar("", "(u^2 + v^2)/2 + x^3")), testing::IsEmpty());
}

// An angle has no scale, and of a bracket that is no longer canonical up to a factor there is none.
TEST(Scale, WhatHasNoScale) {
  EXPECT_THAT(ones(planar("'a'", "(u^2 + v^2)/2 + a*cos(x) + a*cos(y)")).size(), 1U); // the time
  EXPECT_THAT(ones(planar("'a'", "(u^2 + v^2)/2 + cos(x) + cos(a*y)")), testing::IsEmpty());
  EXPECT_THAT(ones(planar("'a'", "u^2/2 + v^2/2 + x^2*y^2 + x*y + a*x*y^2")), testing::IsEmpty());
}

// c = p a^-1 stands for p: what is excluded for c = 3 is so for p = 3 a.
TEST(Scale, ConditionsAreThoseOfTheParametersBefore) {
  const System s = planar("'a', 'p'", "(u^2 + v^2)/2 + a*x^4 + p*x^2*y^2 + a*y^4");
  const auto x = scaled(s);
  ASSERT_TRUE(x);
  ASSERT_EQ(x->ones.size(), 1U);
  const bool a_is_one = s.ring()->name(x->ones[0]) == "a";
  const MPoly a = MPoly::variable(s.ring(), "a"), p = MPoly::variable(s.ring(), "p");
  Exclusion e;
  e.zero = {a_is_one ? p - MPoly(s.ring(), Integer(3))
                     : MPoly(s.ring(), Integer(3)) * a - MPoly(s.ring(), Integer(1))};
  const Exclusion before = x->before(e);
  EXPECT_TRUE(before.zero[0] == p - MPoly(s.ring(), Integer(3)) * a ||
              before.zero[0] == MPoly(s.ring(), Integer(3)) * a - p);
  ASSERT_FALSE(before.not_all_zero.empty());
  EXPECT_EQ(before.not_all_zero.back(), std::vector{a_is_one ? a : p});
}

// A set at the scale a = 1 lies on a level of H there; what it excludes is said of the set on a level of H itself.
TEST(Scale, ASetIsOnALevelOfTheIntegralBefore) {
  const System s = planar("'a', 'b'", "(u^2 + v^2)/2 + a*x^2*y + b*y^3/3");
  ClassifyOptions options;
  options.check.decide.budget.give(2e9);
  std::size_t levels = 0;
  for (const ClassifiedStratum& x : classify_system(s, options).strata) {
    if (!x.along) continue;
    for (const Equation& e : x.along->levels) {
      const Ring& ring = e.difference.ring();
      const MFraction value = transfer(*s.field.hamiltonian, ring) - e.difference;
      ++levels;
      for (const char* name : {"x", "y", "u", "v", "a", "b"})
        EXPECT_FALSE(!is_zero(value) && uses(value, ring->index(name))) << e.text << name;
    }
  }
  EXPECT_GT(levels, 0U);
}

TEST(Scale, AssumptionsThatSurvive) {
  const std::string h = "(u^2 + v^2)/2 + a*x^4 + p*x^2*y^2 + a*y^4";
  const auto kept = [&](const std::string& assumed) {
    const auto x = scaled(planar("'a', 'p'", h, "[assume]\n" + assumed));
    std::vector<Assumption::Says> all;
    for (const Assumption& a : x->system.assumptions)
      all.push_back(a.says);
    return all;
  };
  const Assumption::Says positive = Sign::positive;
  EXPECT_THAT(kept("a = 'positive'\np = 'positive'"), testing::Contains(positive));
  EXPECT_THAT(kept("a = 'positive'\nconditions = ['p < 0']"), testing::Contains(positive));
  EXPECT_THAT(kept("p = 'positive'\nconditions = ['a < 0']"), // a scale that is not real
              testing::Not(testing::Contains(positive)));
  EXPECT_THAT(kept("a = 'real'\np = 'positive'"), testing::Not(testing::Contains(positive)));
  EXPECT_THAT(kept("p = 'positive'\nconditions = ['p > 2*a']"),
              testing::Not(testing::Contains(positive)));
}

// Hill's lunar problem: from one energy to all but one.
TEST(Scale, AllEnergiesButOne) {
  ClassifyOptions options;
  options.check.decide.budget.give(1e8 * 120);
  const auto c = classify_system(
      read_system(parse_document(
          "[system]\nkind = 'hamiltonian'\ncoordinates = ['a', 'b']\nmomenta = ['A', 'B']\n"
          "parameters = ['E', 'c']\nconstants = ['i']\nrelations = ['i^2 = -1']\n"
          "hamiltonian = 'A*B/2 - a*b*i*(a*A - b*B)/2 - a*b*(3*a^4 + 2*a^2*b^2 + 3*b^4)/8 - "
          "E*a*b'\n"
          "[[manifold]]\nname = 'plane'\nequations = ['a = 0', 'B = 0']\n"
          "level = 'A^2/4 - b^6/16 - E*b^2/2 = c'\n",
          "hill.toml")),
      options);
  EXPECT_THAT(places(c, {StratumStatus::open}), testing::ElementsAre("E = 0"));
  EXPECT_THAT(places(c, {StratumStatus::excluded}), testing::ElementsAre("E != 0"));
}

} // namespace
} // namespace kov::scale_test
