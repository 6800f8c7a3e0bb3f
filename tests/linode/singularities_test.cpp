#include "linode/singularities.hpp"

#include <gtest/gtest.h>

namespace kov::singularities_test {
namespace {

const Poly z = Poly::z();

RationalFunction over(const Poly& n, const Poly& d) { return {n, d}; }

TEST(Singularities, BesselAtHalfIntegers) { // r = -1 + 2/z^2: Delta = 3 without logarithm
  const auto s = singularities(over(Poly(2) - z * z, z * z));
  ASSERT_EQ(s.finite.size(), 1U);
  EXPECT_EQ(s.finite[0].kind, PlaceKind::regular);
  EXPECT_EQ(*s.finite[0].delta, Rational(3));
  EXPECT_EQ(s.finite[0].log, Truth::no);
  EXPECT_EQ(s.infinity.kind, PlaceKind::irregular);
  EXPECT_EQ(s.infinity.leading, Poly(-1));
  EXPECT_EQ(*s.infinity.delta, Rational(0));
}

TEST(Singularities, BesselAtIntegersHasALogarithm) { // r = -1 + 3/(4 z^2)
  const auto s = singularities(over(Poly(3) - scale(z * z, NfElem(4)), scale(z * z, NfElem(4))));
  EXPECT_EQ(*s.finite[0].delta, Rational(2));
  EXPECT_EQ(s.finite[0].log, Truth::yes);
}

TEST(Singularities, ConjugateApparentPoles) { // omega = -2z/(z^2-2), pitfall 40
  const RationalFunction w(scale(z, NfElem(-2)), z * z - Poly(2));
  const auto s = singularities(derivative(w) + w * w);
  ASSERT_EQ(s.finite.size(), 1U);
  EXPECT_EQ(*s.finite[0].delta, Rational(3));
  EXPECT_EQ(s.finite[0].log, Truth::no);
}

TEST(Singularities, IrrationalDelta) {
  const auto s = singularities(over(Poly(1), z * z)); // Delta^2 = 5
  EXPECT_FALSE(s.finite[0].delta);
  EXPECT_EQ(s.finite[0].delta_squared, Poly(5));
}

TEST(Singularities, WeberAtInfinity) { // x^2 + 3: a = 1, beta = 3, eps^2 = 9
  const auto s = singularities(RationalFunction(z * z + Poly(3)));
  EXPECT_TRUE(s.finite.empty());
  EXPECT_EQ(s.infinity.nu(), 1);
  EXPECT_EQ(s.infinity.beta, Poly(3));
  EXPECT_EQ(*s.infinity.delta, Rational(3));
  ASSERT_EQ(s.infinity.sqrt_tail.size(), 2U);
  EXPECT_TRUE(is_zero(s.infinity.sqrt_tail[1]));
}

TEST(Singularities, IrregularFinitePlace) {
  // omega = 2/z^3 - 1/z^2 + 3/z + 5z: a = 2, tail (1, -1/2), exponent (3 + eps)/2 = 3 at 0
  const RationalFunction w(Poly(2) - z + scale(z * z, NfElem(3)) + scale(pow(z, 4), NfElem(5)),
                           pow(z, 3));
  const auto s = singularities(derivative(w) + w * w);
  ASSERT_EQ(s.finite.size(), 1U);
  EXPECT_EQ(s.finite[0].order, 6);
  EXPECT_EQ(s.finite[0].leading, Poly(4));
  ASSERT_EQ(s.finite[0].sqrt_tail.size(), 2U);
  EXPECT_EQ(s.finite[0].sqrt_tail[1], Poly(Rational(-1, 2)));
  EXPECT_EQ(*s.finite[0].delta, Rational(3));
  EXPECT_EQ(*s.infinity.delta, Rational(7)); // alpha_inf = 3 = (eps - 1)/2
}

TEST(Singularities, LegendreHasLargeExponentDifferenceAtInfinity) { // n = 40: Delta_inf = 81
  const Poly d = z * z - Poly(1);
  const Poly num = scale(d, NfElem(40 * 41)) - Poly(1);
  const auto s = singularities(over(num, d * d));
  EXPECT_EQ(*s.infinity.delta, Rational(81));
  EXPECT_EQ(s.infinity.log, Truth::no); // P_n and Q_n ~ z^(-n-1) are both free of logarithms there
  ASSERT_EQ(s.finite.size(), 2U);
  EXPECT_EQ(s.finite[0].log, Truth::yes);
}

} // namespace
} // namespace kov::singularities_test
