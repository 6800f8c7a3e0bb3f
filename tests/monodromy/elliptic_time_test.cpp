// Elliptic time: periods in closed form, and the relation on a torus with one puncture.

#include "monodromy/elliptic_time.hpp"

#include "exact/error.hpp"

#include <gmock/gmock.h>

#include <tuple>

namespace {

using namespace kov;
using namespace kov::monodromy;

RationalFunction z() { return {Poly::z(), Poly(1)}; }
RationalFunction q(long n, long d = 1) { return {Rational(Integer(n), Integer(d))}; }

const Poly lemniscate = Poly(4) * Poly::z() * Poly::z() * Poly::z() - Poly(4) * Poly::z();

BallMatrix commutator(const BallMatrix& a, const BallMatrix& b) {
  return multiply(multiply(a, b, 300), multiply(inverse(a, 300), inverse(b, 300), 300), 300);
}

// The lattice of z'^2 = 4 z^3 - 4 z is square: pi/agm(1, sqrt 2) = 2.62205...
TEST(EllipticTime, Periods) {
  const EllipticMonodromy e = elliptic_monodromy(q(2) * z(), lemniscate, {40, {}, {}});
  Ball expected;
  arb_sqrt_ui(expected.raw(), 2, 300);
  Ball one, pi;
  arb_one(one.raw());
  arb_agm(expected.raw(), one.raw(), expected.raw(), 300);
  arb_const_pi(pi.raw(), 300);
  arb_div(expected.raw(), pi.raw(), expected.raw(), 300);
  ASSERT_EQ(e.periods.size(), 2U);
  for (const PeriodMatrix& p : e.periods) {
    Ball length;
    acb_abs(length.raw(), p.period.raw(), 300);
    EXPECT_TRUE(arb_overlaps(length.raw(), expected.raw()) != 0);
  }
}

// Lame: n (n + 1) z + B. For an integer n solutions are meromorphic in t and the periods commute.
TEST(EllipticTime, IntegerLame) {
  const EllipticMonodromy e = elliptic_monodromy(q(6) * z() + q(1), lemniscate, {20, {}, {}});
  ASSERT_EQ(e.poles.size(), 1U);
  EXPECT_TRUE(contains_identity(e.poles[0].matrix));
  EXPECT_TRUE(contains_identity(commutator(e.periods[0].matrix, e.periods[1].matrix)));
}

// One puncture: the commutator of the periods is conjugate to the loop around it or its inverse.
TEST(EllipticTime, OnePuncture) {
  const Poly f = Poly(4) * Poly::z() * Poly::z() * Poly::z() - Poly(5) * Poly::z() + Poly(3);
  const EllipticMonodromy e = elliptic_monodromy(q(3, 7) * z() + q(2), f, {20, {}, {}});
  ASSERT_EQ(e.poles.size(), 1U);
  const ComplexBall one = trace(commutator(e.periods[0].matrix, e.periods[1].matrix), 300);
  const ComplexBall two = trace(e.poles[0].matrix, 300);
  EXPECT_TRUE(acb_overlaps(one.raw(), two.raw()) != 0);
  EXPECT_FALSE(contains_identity(e.poles[0].matrix));
}

TEST(EllipticTime, PolesOnBothSheets) {
  Poly f = Poly::z() * Poly::z() * Poly::z() * Poly::z() + Poly(1);
  EXPECT_EQ(elliptic_monodromy(q(1) / (z() - q(1, 3)), f, {10, {}, {}}).poles.size(), 2U);
  EXPECT_EQ(elliptic_monodromy(z() * z(), f, {10, {}, {}}).poles.size(), 2U);
  EXPECT_EQ(elliptic_monodromy(q(1) / z(), lemniscate, {10, {}, {}}).poles.size(), 1U);
  EXPECT_EQ(elliptic_monodromy(q(5), lemniscate, {10, {}, {}}).poles.size(), 0U);
}

TEST(EllipticTime, OtherCurvesAreRefused) {
  const Poly z2 = Poly::z() * Poly::z();
  for (const Poly& f : {z2 + Poly(1), z2 * Poly::z(), z2 * z2 * Poly::z() + Poly(1), Poly(1)})
    EXPECT_THROW(std::ignore = elliptic_monodromy(z(), f, {10, {}, {}}), InvalidArgument);
}

} // namespace
