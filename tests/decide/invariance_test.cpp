// What the group does not depend on, for every equation of the pitfall table and random pull-backs:
// coordinates, the scale, the constant field, the choice of a conjugate, the method.

#include "corpus.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov {
namespace {

using namespace testing;

class Invariance : public ::testing::TestWithParam<unsigned> {
protected:
  long uniform(long a, long b) { return std::uniform_int_distribution<long>(a, b)(gen_); }
  Rational small() { return {uniform(-9, 9), uniform(1, 4)}; }
  RationalFunction moebius() {
    for (;;) {
      const Rational a = small();
      const Rational b = small();
      const Rational c = small();
      const Rational d = small();
      if (!is_zero(a * d - b * c))
        return {Poly::from_coefficients({b, a}), Poly::from_coefficients({d, c})};
    }
  }
  RationalFunction map(long degree) { // a rational map that is not constant
    for (;;) {
      std::vector<NfElem> num;
      std::vector<NfElem> den;
      for (long i = 0; i <= degree; ++i) {
        num.emplace_back(uniform(-4, 4));
        den.emplace_back(uniform(-4, 4));
      }
      const Poly bottom = Poly::from_coefficients(den);
      if (is_zero(bottom)) continue;
      const RationalFunction f(Poly::from_coefficients(num), bottom);
      if (!is_zero(derivative(f))) return f;
    }
  }

  std::mt19937 gen_{GetParam()};
};

std::vector<RationalFunction> table() {
  std::vector<RationalFunction> equations;
  for (const Json& entry : corpus("pitfalls.jsonl"))
    equations.push_back(equation_of(entry).r);
  return equations;
}

TEST_P(Invariance, MoebiusMaps) { // sqrt(f') is rational, so that even the scalars stay
  for (const RationalFunction& r : table()) {
    const RationalFunction f = moebius();
    EXPECT_EQ(group_of(pull_back(r, f)), group_of(r)) << to_string(r) << " at " << to_string(f);
  }
}

TEST_P(Invariance, LargerField) {
  const Field k = make_field({-2 - 5 * static_cast<long>(GetParam()), 0, 1}, "s");
  for (const RationalFunction& r : table())
    if (r.field()->is_rational()) {
      EXPECT_EQ(group_of(coerce(r, k)), group_of(r)) << to_string(r);
    }
}

TEST_P(Invariance, IrrationalMoebiusMapsAndTheirConjugates) {
  const Field k = make_field({-2, 0, 0, 1}, "s");
  const NfElem s = NfElem::generator(k);
  for (const RationalFunction& r : table()) {
    if (!r.field()->is_rational()) continue;
    const RationalFunction f(Poly::from_coefficients({s, NfElem(uniform(1, 5), k)}),
                             Poly::from_coefficients({NfElem(1), s * NfElem(uniform(1, 3))}));
    EXPECT_EQ(group_of(pull_back(r, f)), group_of(r)) << to_string(r) << " at " << to_string(f);
  }
}

// Up to scalars: the kind of group, and whether the identity component is abelian.
TEST_P(Invariance, ApparentSingularities) {
  const auto kind = [](const RationalFunction& r) {
    const Decision d = decide({.r = r, .p = RationalFunction()});
    return std::pair(d.kovacic_case, d.abelian);
  };
  for (const RationalFunction& r : table()) {
    const RationalFunction a(Poly::from_coefficients({small(), small()}));
    if (is_zero(r + derivative(a) - a * a)) continue;
    EXPECT_EQ(kind(gauge(r, a)), kind(r)) << to_string(r) << " with a = " << to_string(a);
  }
}

// Engines and Kovacic's algorithm on maps of random degree.  The identity component stays.
TEST_P(Invariance, PullBacksOfFiniteGroupsByBothMethods) {
  const Rational half(1, 2);
  const Rational third(1, 3);
  for (const auto& [a, b, c] :
       {std::tuple(half, third, third), std::tuple(half, third, Rational(1, 4)),
        std::tuple(half, third, Rational(1, 5)), std::tuple(half, half, Rational(2, 7)),
        std::tuple(Rational(2, 3), Rational(2, 3), Rational(2, 3)),
        std::tuple(Rational(2, 3), third, Rational(1, 5))}) {
    const RationalFunction r =
        pull_back(riemann(NfElem(a * a), NfElem(b * b), NfElem(c * c)), map(uniform(1, 3)));
    Options options;
    options.method = Method::all;
    const Decision d = decide({.r = r, .p = RationalFunction()}, options);
    ASSERT_TRUE(d.component) << to_string(r) << ": " << reason(d);
    EXPECT_EQ(*d.component, Connected::trivial) << to_string(r);
  }
}

// Three random exponent differences: Kimura's table, seen by two methods.
TEST_P(Invariance, RandomRiemannEquationsByBothMethods) {
  for (int i = 0; i < 25; ++i) {
    const auto delta = [&] {
      const Rational q(uniform(0, 12), uniform(1, 6));
      return NfElem(q * q);
    };
    const RationalFunction r = riemann(delta(), delta(), delta());
    if (is_zero(r)) continue;
    Options options;
    options.method = Method::all;
    const Decision d = decide({.r = r, .p = RationalFunction()}, options);
    EXPECT_TRUE(d.group) << to_string(r) << ": " << reason(d);
    const RationalFunction f = moebius();
    EXPECT_EQ(group_of(pull_back(r, f)), group_of(r)) << to_string(r) << " at " << to_string(f);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Invariance, ::testing::Range(1u, 5u));

} // namespace
} // namespace kov
