#include "parameters/integers.hpp"

#include <gtest/gtest.h>

namespace kov::integers_test {
namespace {

const Ring ring = make_ring({"a", "b", "c"});
MFraction x(const char* name) { return MFraction::variable(ring, name); }
MFraction number(long n, long d = 1) { return {ring, Rational(n, d)}; }

TEST(Integers, OneMembership) {
  const std::vector<Membership> known{{x("a"), true}};
  EXPECT_EQ(is_integral(known, number(7) * x("a") + number(3)), Truth::yes);
  EXPECT_EQ(is_integral(known, x("a") - number(1, 3)), Truth::no);
  EXPECT_EQ(is_integral(known, number(1, 2) * x("a")), Truth::unknown);
  EXPECT_EQ(is_integral(known, number(1, 2) * x("a") + number(1, 2)), Truth::unknown);
  EXPECT_EQ(is_integral(known, number(1, 2) * x("a") + number(1, 3)), Truth::no);
  EXPECT_EQ(is_integral(known, x("b")), Truth::unknown);
  EXPECT_EQ(is_integral(known, x("a") * x("a")), Truth::unknown); // not linear: not looked at
}

TEST(Integers, SumsAndDifferences) { // a + b and a - b in Z: 2a in Z
  const std::vector<Membership> known{{x("a") + x("b"), true}, {x("a") - x("b"), true}};
  EXPECT_EQ(is_integral(known, number(2) * x("a")), Truth::yes);
  EXPECT_EQ(is_integral(known, x("a")), Truth::unknown);
  EXPECT_EQ(is_integral(known, number(2) * x("a") + number(1, 2)), Truth::no);
  EXPECT_EQ(is_integral(known, number(3) * x("a") - x("b")), Truth::yes);
  EXPECT_EQ(is_integral(known, x("c")), Truth::unknown);
}

TEST(Integers, Relations) { // a, b and (a + b)/2 in Z: a - b is even
  std::vector<Membership> known{
      {x("a"), true}, {x("b"), true}, {number(1, 2) * (x("a") + x("b")), true}};
  EXPECT_EQ(is_integral(known, number(1, 2) * (x("a") - x("b"))), Truth::yes);
  EXPECT_EQ(is_integral(known, number(1, 2) * (x("a") - x("b")) + number(1, 2)), Truth::no);
  EXPECT_EQ(is_integral(known, number(1, 2) * x("a")), Truth::unknown);
  EXPECT_FALSE(contradict(known));
  known.push_back({number(1, 2) * (x("b") - x("a")) + number(1, 2), true});
  EXPECT_TRUE(contradict(known));
}

TEST(Integers, WhatIsNoInteger) {
  const std::vector<Membership> known{{x("a"), true}, {number(2) * x("b"), false}};
  EXPECT_EQ(is_integral(known, number(2) * x("b") + number(5) * x("a")), Truth::no);
  EXPECT_EQ(is_integral(known, x("b")), Truth::no); // 2b would be one
  EXPECT_EQ(is_integral(known, number(4) * x("b")), Truth::unknown);
  EXPECT_EQ(is_integral(known, number(2) * x("b") + number(1, 2)), Truth::unknown);
  EXPECT_FALSE(contradict(known));
  EXPECT_TRUE(contradict({{number(2) * x("a"), true}, {number(4) * x("a"), false}}));
  EXPECT_TRUE(contradict({{x("a"), true}, {x("a") + number(1, 2), true}}));
  EXPECT_FALSE(contradict({{x("a"), true}, {number(1, 2) * x("a"), false}}));
  EXPECT_FALSE(contradict({{number(0), true}}));
  EXPECT_FALSE(contradict({{number(3), true}, {number(1, 2), false}}));
  EXPECT_TRUE(contradict({{number(0), false}}));
  EXPECT_TRUE(contradict({{number(1, 2), true}}));
}

TEST(Integers, FunctionsThatAreNotLinear) { // only their linear relations count
  const MFraction f = number(1) / (x("a") + x("b"));
  EXPECT_EQ(is_integral({{f, true}}, number(3) * f), Truth::yes);
  EXPECT_EQ(is_integral({{f, true}, {f + x("c"), true}}, x("c")), Truth::yes);
}

} // namespace
} // namespace kov::integers_test
