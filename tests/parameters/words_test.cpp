// An answer rests on everything that is assumed: nothing of it may be lost in words.

#include "parameters/conditions.hpp"

#include <gtest/gtest.h>

namespace kov::words_test {
namespace {

const Ring ring = make_ring({"a", "l", "n", "x", "z"});
MFraction x(const char* name) { return MFraction::variable(ring, name); }

TEST(Assumptions, AreAllSaid) {
  Assumptions all;
  all.require(x("a"), Sign::positive);
  all.require_integral(x("n"), true);
  all.require_integral(x("l") - MFraction(ring, Rational(1, 2)), false);
  all.real = {ring->index("a"), ring->index("l"), ring->index("n"), ring->index("x")};
  all.rational = {ring->index("l"), ring->index("n")};
  const std::vector<std::string> said{"a > 0", "n is an integer", "(2*l - 1)/2 is not an integer",
                                      "l is rational", "x is real"};
  EXPECT_EQ(in_words(all, ring), said);
}

// Rational says more than real, an integer more than rational: the strongest is said, once.
TEST(Assumptions, TheStrongestIsSaid) {
  for (const bool rational : {false, true}) {
    Assumptions all;
    all.real = {ring->index("l")};
    if (rational) all.rational = {ring->index("l")};
    EXPECT_EQ(in_words(all, ring),
              std::vector<std::string>{rational ? "l is rational" : "l is real"});
  }
  Assumptions twice; // n/2 in Z: n is no less rational
  twice.require_integral(Rational(1, 2) * x("n"), true);
  twice.rational = {ring->index("n")};
  EXPECT_EQ(in_words(twice, ring),
            (std::vector<std::string>{"n/2 is an integer", "n is rational"}));
}

// "a*l > 0" alone leaves a and l complex, and what is real of them is said.
TEST(Assumptions, WhatIsRealBesideAnInequalityIsSaid) {
  Assumptions all;
  all.require(x("a") * x("l"), Sign::positive);
  all.declare_real(x("a"));
  EXPECT_EQ(in_words(all, ring), (std::vector<std::string>{"a*l > 0", "a is real"}));
  all.declare_real(x("l"));
  EXPECT_EQ(in_words(all, ring), (std::vector<std::string>{"a*l > 0"}));
}

// b = a and b = -a are b^2 = a^2, and so are b != a and b != -a; with any other factor they stay apart.
TEST(Conditions, UpToSign) {
  const MPoly a = x("a").num(), n = x("n").num(), l = x("l").num(), two(ring, Integer(2)),
              one(ring, Integer(1));
  const auto zero = [](const MPoly& p) { return Condition{p, Sign::zero}; };
  const auto nonzero = [](const MPoly& p) { return Condition{p, Sign::nonzero}; };
  EXPECT_EQ(to_string(in_pairs({nonzero(n - a), nonzero(l), nonzero(n + a)})),
            "n^2 != a^2, l != 0");
  EXPECT_EQ(to_string(in_pairs({nonzero(two * n - a), nonzero(two * n + a)})), "n^2 != a^2/4");
  EXPECT_EQ(to_string(in_pairs({nonzero(two * n - one), nonzero(two * n + one)})), "n^2 != 1/4");
  EXPECT_EQ(in_pairs({nonzero(n - a), nonzero(n - two * a)}).size(), 2U);
  EXPECT_EQ(in_pairs({nonzero(n), nonzero(a)}).size(), 2U);
  EXPECT_EQ(in_pairs({zero(n - a), nonzero(n + a)}).size(), 2U);
  const auto both = [&](const std::vector<Condition>& s, const std::vector<Condition>& t) {
    const auto all = up_to_sign(s, t);
    return all ? to_string(*all) : std::string("two");
  };
  EXPECT_EQ(both({zero(n - a)}, {zero(n + a)}), "n^2 = a^2");
  EXPECT_EQ(both({zero(n - a)}, {zero(n + a), nonzero(n - a)}), "n^2 = a^2");
  EXPECT_EQ(both({zero(n + a), nonzero(n - a)}, {zero(n - a)}), "n^2 = a^2");
  EXPECT_EQ(both({zero(n - a), nonzero(l)}, {zero(n + a), nonzero(l)}), "l != 0, n^2 = a^2");
  // n = a = 0 is in neither
  EXPECT_EQ(both({zero(n - a), nonzero(n + a)}, {zero(n + a), nonzero(n - a)}), "two");
  EXPECT_EQ(both({zero(n - a), nonzero(l)}, {zero(n + a)}), "two");
  EXPECT_EQ(both({zero(n - a)}, {zero(n - two * a)}), "two");
}

TEST(Conditions, TwoTermsAreSolved) {
  const MPoly a = x("a").num(), n = x("n").num(), three(ring, Integer(3)), four(ring, Integer(4));
  const auto said = [](const MPoly& p) { return to_string(Condition{p, Sign::zero}); };
  EXPECT_EQ(said(four * n * n - three), "n^2 = 3/4");
  EXPECT_EQ(said(n * n + four), "n^2 = -4");
  EXPECT_EQ(said(n * n - a * a * a), "n^2 = a^3");
  EXPECT_EQ(said(n * n + a * a), "a^2 + n^2 = 0");
}

} // namespace
} // namespace kov::words_test
