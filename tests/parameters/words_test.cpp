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

} // namespace
} // namespace kov::words_test
