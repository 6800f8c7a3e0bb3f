// Elliptic time: periods in closed form, and the relation on a torus with one puncture.

#include "monodromy/elliptic_time.hpp"

#include "exact/error.hpp"

#include <gmock/gmock.h>

#include <algorithm>
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
  EXPECT_TRUE(overlap(e.poles[0].matrix, BallMatrix::identity(2)));
  EXPECT_TRUE(
      overlap(commutator(e.periods[0].matrix, e.periods[1].matrix), BallMatrix::identity(2)));
}

// One puncture: the commutator of the periods is conjugate to the loop around it or its inverse.
TEST(EllipticTime, OnePuncture) {
  const Poly f = Poly(4) * Poly::z() * Poly::z() * Poly::z() - Poly(5) * Poly::z() + Poly(3);
  const EllipticMonodromy e = elliptic_monodromy(q(3, 7) * z() + q(2), f, {20, {}, {}});
  ASSERT_EQ(e.poles.size(), 1U);
  const ComplexBall one = trace(commutator(e.periods[0].matrix, e.periods[1].matrix), 300);
  const ComplexBall two = trace(e.poles[0].matrix, 300);
  EXPECT_TRUE(acb_overlaps(one.raw(), two.raw()) != 0);
  EXPECT_FALSE(overlap(e.poles[0].matrix, BallMatrix::identity(2)));
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

// ---- systems: dY/dt = (B_0 + w B_1) Y

// Y = P Z with P = (1 w + k; 0 1) of d^2y/dt^2 = R y, w' = dw/dt = F'/2: for k != 0 both sheets are mixed.
EllipticSystem transformed(const RationalFunction& r, const Poly& f, long k) {
  const RationalFunction zero(0), square = RationalFunction(f) + q(k * k);
  const RationalFunction c = q(1) - square * r - RationalFunction(derivative(f)) * q(1, 2);
  return {{{q(-k) * r, c}, {r, q(k) * r}}, {{-r, q(-2 * k) * r}, {zero, r}}, f};
}

// P(base)^-1 m P(base)
BallMatrix conjugated(const BallMatrix& m, const ComplexBall& w, long k) {
  BallMatrix p = BallMatrix::identity(2);
  acb_add_si(p.entry(0, 1), w.raw(), k, 300);
  return multiply(inverse(p, 300), multiply(m, p, 300), 300);
}

void expect_transformed(const RationalFunction& r, const Poly& f, long k) {
  const EllipticMonodromy plain = elliptic_monodromy(r, f, {8, {}, {}});
  const EllipticMonodromy other = elliptic_monodromy(transformed(r, f, k), {8, plain.base, {}});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(acb_overlaps(plain.periods[i].period.raw(), other.periods[i].period.raw()) != 0);
    EXPECT_TRUE(
        overlap(conjugated(plain.periods[i].matrix, plain.speed, k), other.periods[i].matrix));
  }
  for (const PoleMatrix& p : plain.poles) {
    const auto same =
        std::find_if(other.poles.begin(), other.poles.end(), [&](const PoleMatrix& x) {
          return x.other_sheet == p.other_sheet && x.place.has_value() == p.place.has_value() &&
                 (!p.place || to_string(*x.place) == to_string(*p.place));
        });
    ASSERT_TRUE(same != other.poles.end());
    EXPECT_TRUE(overlap(conjugated(p.matrix, plain.speed, k), same->matrix));
  }
}

TEST(EllipticTime, ATransformationByAFunctionOnTheCurve) {
  const Poly z3 = Poly::z() * Poly::z() * Poly::z();
  const Poly cubic = Poly(4) * z3 - Poly(5) * Poly::z() + Poly(3),
             quartic = z3 * Poly::z() + Poly(1);
  for (const long k : {0, -3}) {
    expect_transformed(q(3, 7) * z() + q(2), cubic, k);
    expect_transformed(q(1, 5) / (z() - q(1, 2)), cubic, k);
    expect_transformed(q(2, 3) / (z() * z()), lemniscate, k);
    expect_transformed(q(1) - z(), quartic, k);
  }
}

// y' = (a/(z - c) + b w/(z - c)) y: around the pole on the sheet w the factor exp(2 pi i (a/w(c) + b)),
// and its inverse for the first part on the other sheet.
TEST(EllipticTime, ResiduesOfADifferential) {
  const Poly f = Poly::z() * Poly::z() * Poly::z() + Poly(1); // w(2) = +-3
  const RationalFunction at_two = q(1) / (z() - q(2));
  const EllipticMonodromy e =
      elliptic_monodromy({{{at_two}}, {{q(1, 4) * at_two}}, f}, {20, {}, {}});
  ASSERT_EQ(e.poles.size(), 3U); // and infinity
  std::vector<bool> found(2);
  for (std::size_t k = 0; k < 2; ++k)
    for (const long sign : {1, -1}) {
      ComplexBall expected;
      arb_set_fmpq(acb_realref(expected.raw()), Rational(Integer(6 + 8 * sign), Integer(12)).raw(),
                   300);
      acb_exp_pi_i(expected.raw(), expected.raw(), 300);
      if (acb_overlaps(expected.raw(), e.poles[k].matrix.entry(0, 0)) != 0)
        found[sign > 0 ? 1 : 0] = true;
    }
  EXPECT_TRUE(found[0] && found[1]);
}

TEST(EllipticTime, SystemsThatCannotBeDoneAreRefused) {
  const RationalFunction zero(0), one(1);
  using Rows = std::vector<std::vector<RationalFunction>>;
  EXPECT_THROW(std::ignore = elliptic_monodromy({Rows{{zero, one}}, Rows{{zero}}, lemniscate}),
               InvalidArgument);
  EXPECT_THROW(std::ignore = elliptic_monodromy({Rows{}, Rows{}, lemniscate}), InvalidArgument);
  const Rows full(5, std::vector<RationalFunction>(5, one));
  EXPECT_THROW(std::ignore = elliptic_monodromy({full, full, lemniscate}),
               InvalidArgument); // 10 x 10
  Rows odd = full; // by the sign of w the first two unknowns are another kind than the last three
  Rows even = full;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < 5; ++j)
      ((i < 2) == (j < 2) ? even : odd)[i][j] = zero;
  const EllipticMonodromy halves = elliptic_monodromy({even, odd, lemniscate}, {5, {}, {}});
  EXPECT_EQ(halves.periods[0].matrix.size(), 5);
}

} // namespace
