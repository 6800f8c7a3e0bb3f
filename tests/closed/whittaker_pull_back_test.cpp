// Whittaker's and Bessel's equations come back from their pull-backs, whatever the exponents.

#include "closed/whittaker_pull_back.hpp"

#include "decide/decide.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov::whittaker_pull_back_test {
namespace {

const Poly z = Poly::z();

RationalFunction whittaker(const Rational& a, const Rational& b, const Rational& c) {
  return RationalFunction(Poly::from_coefficients({NfElem(c), NfElem(b), NfElem(a)}), z * z);
}

std::vector<RationalFunction> changes() {
  return {RationalFunction(z * z + Poly(1)), RationalFunction(z * z - Poly(2), z),
          RationalFunction(z, (z - Poly(1)) * (z - Poly(3))),
          RationalFunction(pow(z, 3) - z + Poly(5)),
          RationalFunction(z * (z + Poly(4)), (z - Poly(2)) * (z + Poly(1))),
          RationalFunction(z - Poly(2), pow(z, 3)),
          // no pole over Q: a is known up to squares from a norm, or a norm and a trace
          RationalFunction(z * z + Poly(3), z * z - z + Poly(5)),
          RationalFunction(z - Poly(7), z * z - Poly(2)),
          RationalFunction(Poly(3), z * z - Poly(2)), // opposite principal parts
          RationalFunction(z * z + Poly(1), z * z + z + Poly(1)),
          RationalFunction(z * z + z - Poly(3), pow(z, 3) - z - Poly(1))};
}

TEST(WhittakerPullBack, ComesBack) {
  const RationalFunction half(Rational(1, 2));
  for (const RationalFunction& f : changes())
    for (const Rational& b : {Rational(0), Rational(3, 7)})
      for (const Rational& c : {Rational(-2, 9), Rational(pow(Integer(10), 40)), Rational(2)}) {
        const RationalFunction r = testing::pull_back(whittaker(Rational(5), b, c), f);
        const auto found = whittaker_pull_back(singularities(r));
        ASSERT_TRUE(found) << to_string(f) << ", " << to_string(r);
        const RationalFunction slope = derivative(found->f);
        const RationalFunction u = derivative(slope) / slope;
        const auto number = [](const NfElem& x) { return RationalFunction(Poly(x)); };
        EXPECT_EQ(slope * slope *
                          (number(found->a) + number(found->b) / found->f +
                           number(found->c) / (found->f * found->f)) -
                      half * (derivative(u) - half * u * u),
                  r);
        EXPECT_EQ(found->c, NfElem(c)); // f is determined up to a factor
      }
}

// The constant a is not a square at a place that is conjugate to others.
TEST(WhittakerPullBack, ConstantsUpToSquares) {
  for (const RationalFunction& f : changes())
    for (const long a : {1L, 2L, -1L, -3L, 5L, 12L}) {
      const RationalFunction r =
          testing::pull_back(whittaker(Rational(a), Rational(0), Rational(3, 4)), f);
      EXPECT_TRUE(whittaker_pull_back(singularities(r))) << to_string(f) << ", " << a;
    }
}

// n(n+1)/x^2 - 1 with n of twenty digits: no polynomial of that degree is needed.
TEST(WhittakerPullBack, ImmenseExponentsAreDecided) {
  const Rational n(pow(Integer(10), 20) + Integer(7), Integer(1));
  for (const RationalFunction& f : changes()) {
    const auto group = [&](const Rational& c) {
      const RationalFunction r = testing::pull_back(whittaker(Rational(-1), Rational(0), c), f);
      Options options;
      options.ask_the_judge = true; // who has nothing to say about a formula
      return decide({.r = r, .p = RationalFunction()}, options).group;
    };
    EXPECT_EQ(group(n * (n + Rational(1))), (GaloisGroup{GroupType::Gm, {}})) << to_string(f);
    EXPECT_EQ(group(n * (n + Rational(2))), (GaloisGroup{GroupType::SL2, {}})) << to_string(f);
  }
}

// Not only beyond every limit: where the search is a matter of minutes, too.
TEST(WhittakerPullBack, LargeExponentsNeedNoSearch) {
  const Poly x = Poly::z();
  const RationalFunction f(x * x * x - Poly(2), x * x + Poly(3));
  for (const long n : {2500L, 25000L}) {
    const RationalFunction bessel(Poly(n * (n + 1)) - scale(x * x, NfElem(3)), x * x);
    const Decision d =
        decide({testing::pull_back(bessel, f), {}}, {.budget = Budget::of_seconds(20)});
    ASSERT_TRUE(d.group) << n;
    EXPECT_EQ(d.group->type, GroupType::Gm) << n;
    EXPECT_LT(d.seconds, 10) << n;
  }
}

TEST(WhittakerPullBack, OtherEquationsAreNone) {
  for (const RationalFunction& r :
       {RationalFunction(z), RationalFunction(pow(z, 4) + z), RationalFunction(Poly(1), z * z),
        RationalFunction(z * z + Poly(1), z * z - Poly(1)),
        whittaker(Rational(1), Rational(0), Rational(2)) + RationalFunction(Poly(1), z - Poly(1))})
    EXPECT_FALSE(whittaker_pull_back(singularities(r))) << to_string(r);
}

} // namespace
} // namespace kov::whittaker_pull_back_test
