// The bounds hold for every solution that can be constructed, and are sharp for the classical ones.

#include "linode/degree_bounds.hpp"

#include "exact/error.hpp"
#include "exact/fields.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov::degree_bounds_test {
namespace {

using namespace testing;

class DegreeBoundLaws : public OverFields {
protected:
  [[nodiscard]] RationalFunction over_line(const NfElem& top, const NfElem& c, long e = 1) const {
    return RationalFunction(Poly(top)) / pow(RationalFunction(z() - Poly(c)), e);
  }
};

// y = exp int omega for any omega: an exponential solution must be possible, its logarithmic
// derivative has no longer denominator than allowed beyond the ordinary zeros of y, and their
// number is at most the degree.
TEST_P(DegreeBoundLaws, EveryExponentialSolutionFits) {
  for (int i = 0; i < 10; ++i) {
    SCOPED_TRACE(i);
    RationalFunction omega;
    for (long c = 0; c < 3; ++c) {
      const NfElem at = NfElem(c) + (c == 2 ? NfElem::generator(k) : NfElem(0));
      omega += over_line(number(0, 1) == 0 ? NfElem(rational()) : NfElem(number(-3, 3)), at);
      if (number(0, 2) == 0) omega += over_line(element(), at, number(2, 3));
    }
    if (number(0, 2) == 0) omega += RationalFunction(poly(2));
    const Poly zeros = monic_poly(number(0, 2));
    omega += RationalFunction(derivative(zeros), zeros);
    const RationalFunction r = from_omega(omega);
    if (is_zero(r)) continue;
    const Singularities s = singularities(r);
    const ExponentialShape shape = exponential_shape(s);
    EXPECT_FALSE(shape.obstruction.has_value()) << shape.degree;
    Poly outside = omega.den();
    for (const Singularity& p : s.finite)
      outside = degree(outside) > 0 ? remove_factor(outside, p.place).second : outside;
    EXPECT_GE(shape.degree, degree(outside)); // simple zeros of y at ordinary points
    EXPECT_LE(degree(omega.den()) - degree(outside), shape.denominator);
    EXPECT_GE(shape.nu_infinity, is_zero(omega) ? 0 : -order_at_infinity(omega));
  }
}

// v with v^2 = f and any Wronskian: f is a value of an invariant of degree 4, and v of degree 2
// where it is rational.
TEST_P(DegreeBoundLaws, EveryInvariantFits) {
  for (int i = 0; i < 8; ++i) {
    SCOPED_TRACE(i);
    const bool square = i % 2 == 0;
    RationalFunction v(monic_poly(2), monic_poly(number(0, 1)));
    const RationalFunction f = square ? v * v : v;
    const RationalFunction r = from_square(f, nonzero());
    const Singularities s = singularities(r);
    for (const long m : {2L, 4L}) {
      if (m == 2 && !square) continue;
      const RationalFunction value = m == 2 ? v : f;
      const InvariantShape shape = invariant_shape(s, m);
      ASSERT_FALSE(shape.obstruction.has_value()) << shape.degree;
      EXPECT_EQ(shape.m, m);
      ASSERT_EQ(shape.e.size(), s.finite.size());
      long rest = degree(value.num()) - degree(value.den());
      for (std::size_t j = 0; j < s.finite.size(); ++j) {
        const Poly& q = s.finite[j].place;
        const long order =
            remove_factor(value.num(), q).first - remove_factor(value.den(), q).first;
        EXPECT_LE(shape.e[j], order);
        rest -= shape.e[j] * degree(q);
      }
      EXPECT_LE(rest, shape.degree);
      EXPECT_LE(-order_at_infinity(value), shape.tau);
    }
  }
}

TEST_P(DegreeBoundLaws, RealPartsAreBoundedFromAboveAndClosely) {
  for (const long square : {0L, 1L, 4L, 5L, 9L, 43L, -1L, -7L}) {
    const RationalFunction r =
        RationalFunction(Poly(Rational(square - 1, 4))) / RationalFunction(z() * z()) +
        RationalFunction(constant(1)) / RationalFunction(z() - constant(1));
    const Singularities s = singularities(coerce(r, k));
    for (const Singularity& p : s.finite) {
      if (!(p.place == z())) continue;
      const Rational bound = real_part_sum(p);
      if (square >= 0) {
        EXPECT_GE(bound * bound, Rational(square));
        const Rational less = bound - Rational(Integer(1), pow(Integer(2), 38));
        EXPECT_TRUE(sign(less) < 0 || less * less < Rational(square) || is_zero(bound));
      } else { // purely imaginary
        EXPECT_GE(sign(bound), 0);
        EXPECT_LT(bound, Rational(Integer(1), pow(Integer(2), 20)));
      }
    }
  }
}

KOV_OVER_ALL_FIELDS(DegreeBoundLaws);

// H_n exp(-z^2/2), Legendre's and Laguerre's polynomials: the bound is the degree.
TEST(DegreeBounds, SharpForTheClassicalPolynomials) {
  const Poly z = Poly::z();
  for (long n = 0; n <= 30; n += 3) {
    const auto hermite =
        exponential_shape(singularities(RationalFunction(z * z - Poly(2 * n + 1))));
    EXPECT_EQ(hermite.degree, n);
    EXPECT_EQ(hermite.nu_infinity, 1);
    const RationalFunction whittaker =
        RationalFunction(Rational(1, 4)) - RationalFunction(Poly(n + 1), z); // k = n + 1, m = 1/2
    EXPECT_EQ(exponential_shape(singularities(whittaker)).degree, n);
  }
  EXPECT_FALSE(
      exponential_shape(singularities(RationalFunction(z * z + Poly(3)))).obstruction.has_value());
  EXPECT_TRUE(
      exponential_shape(singularities(RationalFunction(z))).obstruction.has_value()); // Airy
  EXPECT_LT(exponential_shape(singularities(RationalFunction(z * z - Poly(2)))).degree, 1);
}

TEST(DegreeBounds, RefusalsNameThePlace) {
  const Poly z = Poly::z();
  const auto expect_named = [](const auto& shape, const Singularities& s, const std::string& name) {
    ASSERT_TRUE(shape.obstruction.has_value()) << name;
    const std::string why = to_string(*shape.obstruction, s);
    EXPECT_NE(why.find(name), std::string::npos) << why;
  };
  const Singularities airy = singularities(RationalFunction(z));
  expect_named(exponential_shape(airy), airy, "infinity");
  const Singularities odd = singularities(RationalFunction(Poly(1), pow(z * z - Poly(2), 3)));
  expect_named(exponential_shape(odd), odd, "z^2 - 2 = 0");
  const Singularities cube = singularities(RationalFunction(Poly(1), pow(z - Poly(1), 3)));
  expect_named(invariant_shape(cube, 2), cube, "z = 1");
  EXPECT_THROW((void)invariant_shape(singularities(RationalFunction(z)), 3), InternalError);
}

// The roots of a place lie anywhere in the plane: the sum over them against the exact values.
TEST(DegreeBounds, SumsOverConjugateRoots) {
  const Poly z = Poly::z();
  // Delta^2 = 1 + 4c at the roots +-sqrt 2 of z^2 - 2: sqrt(1 + 4 sqrt 2) + 0
  const Poly q = z * z - Poly(2);
  const RationalFunction r(Poly(8) * z, q * q); // b = 8c/(2c)^2 = 8c/8 = c
  const Singularities s = singularities(r);
  ASSERT_EQ(s.finite.size(), 1U);
  ASSERT_EQ(s.finite[0].delta_squared, Poly(1) + Poly(4) * z);
  const Rational bound = real_part_sum(s.finite[0]);
  // x = bound^2: (x - 1)^2 = 32 up to what the bound has to spare
  const Rational x = bound * bound - Rational(1);
  EXPECT_GE(x * x, Rational(32));
  EXPECT_LT(x * x, Rational(32) + Rational(1, 100000));
}

} // namespace
} // namespace kov::degree_bounds_test
