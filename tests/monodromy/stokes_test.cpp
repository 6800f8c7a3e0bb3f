// Stokes matrices: multipliers that are known, one basis carried to another, and what they generate.

#include "monodromy/stokes.hpp"

#include "monodromy/words.hpp"

#include <gmock/gmock.h>

namespace {

using namespace kov;
using namespace kov::monodromy;
using testing::SizeIs;

RationalFunction z() { return {Poly::z(), Poly(1)}; }
RationalFunction q(long n, long d = 1) { return {Rational(Integer(n), Integer(d))}; }

constexpr long digits = 25;

Point point(long x, long y) { return {Real(x), Real(y)}; }

Stokes of(const RationalFunction& r, const Point& base) {
  return stokes_at_infinity(RationalFunction(0), -r, base, {digits, {}, {}}).value();
}

ComplexBall number(const Rational& x) {
  ComplexBall b;
  acb_set_fmpq(b.raw(), x.raw(), 200);
  return b;
}

ComplexBall times_i(ComplexBall x) {
  acb_mul_onei(x.raw(), x.raw());
  return x;
}

bool meet(const ComplexBall& a, const ComplexBall& b) {
  return acb_overlaps(a.raw(), b.raw()) != 0;
}

TEST(Stokes, AiryMultipliersAreMinusI) {
  for (const RationalFunction& r : {z(), q(1) - q(7, 3) * z()}) {
    const Stokes s = of(r, point(1, 0));
    EXPECT_EQ(s.family, "Airy");
    ASSERT_THAT(s.matrices, SizeIs(3));
    for (const StokesMatrix& m : s.matrices)
      EXPECT_TRUE(meet(m.multiplier, times_i(number(-1))));
  }
}

// r = x^2/4 + a with a = -n - 1/2: exp(-x^2/4) He_n(x) is recessive in both real directions.
TEST(Stokes, HermiteFunctionsCrossTheRealDirectionsUnchanged) {
  const RationalFunction r = z() * z() / q(4) - q(7, 2); // n = 3
  const Stokes s = of(r, point(1, 1));
  ASSERT_THAT(s.matrices, SizeIs(4));
  for (const std::size_t imaginary : {1U, 3U})
    EXPECT_TRUE(meet(s.matrices[imaginary].multiplier, number(0)));
  for (const std::size_t real : {0U, 2U})
    EXPECT_FALSE(meet(s.matrices[real].multiplier, number(0)));
}

// W_(k, m): the product of both multipliers is -4 cos(pi (m + k)) cos(pi (m - k)) exp(2 pi i k).
TEST(Stokes, BesselMultipliers) {
  const Stokes s = of(q(-1) + (q(1, 9) - q(1, 4)) / (z() * z()), point(0, -3));
  ComplexBall product;
  acb_mul(product.raw(), s.matrices.at(0).multiplier.raw(), s.matrices.at(1).multiplier.raw(), 200);
  EXPECT_TRUE(meet(product, number(-1))); // -4 cos(pi/3)^2
}

// Bessel's equation of half-integral order has no Stokes phenomenon.
TEST(Stokes, HalfIntegralOrder) {
  for (const StokesMatrix& m : of(q(-1) + q(6) / (z() * z()), point(0, -3)).matrices)
    EXPECT_TRUE(overlap(m.matrix, BallMatrix::identity(2)));
}

// The equation y'' + p y' + q y = 0 of the normal form u'' = r u, y = u/z.
TEST(Stokes, AFirstDerivativeChangesTheBasisOnly) {
  const RationalFunction r = q(1, 4) - q(2, 3) / z() + q(1, 7) / (z() * z());
  const RationalFunction p = q(2) / z();
  const RationalFunction s = p * p / q(4) + derivative(p) / q(2) - r;
  const Stokes by_y = stokes_at_infinity(p, s, point(2, -1), {digits, {}, {}}).value();
  const Stokes by_u = of(r, point(2, -1));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(meet(by_y.matrices[k].multiplier, by_u.matrices[k].multiplier));
    EXPECT_TRUE(meet(trace(by_y.matrices[k].matrix, 200), number(2)));
    EXPECT_FALSE(overlap(by_y.matrices[k].matrix, by_u.matrices[k].matrix));
  }
}

// a x^(n-2) + c/x^2: -2 i cos(pi nu), nu = (1 + 4 c)^(1/2)/n; 1 + 4 c = 4/9 n^2 has the cosine -1/2.
TEST(Stokes, BesselMultipliersAtEverySlope) {
  for (const long n : {1L, 3L, 4L, 5L, 6L, 8L}) {
    const RationalFunction c = (q(4 * n * n, 9) - q(1)) / q(4);
    const Stokes s = of(q(2, 3) * pow(z(), n - 2) + c / (z() * z()), point(0, -1));
    EXPECT_EQ(s.family, "Bessel");
    ASSERT_THAT(s.matrices, SizeIs(static_cast<std::size_t>(n)));
    for (const StokesMatrix& m : s.matrices)
      EXPECT_TRUE(meet(m.multiplier, times_i(number(1))));
  }
}

// (2 cos(pi/5))^2 = 2 cos(pi/5) + 1, with and without a value at the origin.
TEST(Stokes, PowersWithoutASingularity) {
  for (const Point& base : {point(0, 0), point(1, 2)})
    for (const StokesMatrix& m : of(q(-3) * pow(z() - q(1), 3), base).matrices) {
      const ComplexBall cosine = times_i(m.multiplier);
      ComplexBall square;
      acb_mul(square.raw(), cosine.raw(), cosine.raw(), 200);
      acb_sub_ui(square.raw(), square.raw(), 1, 200);
      EXPECT_TRUE(meet(square, cosine));
    }
}

// x = t^2, y = t^(1/2) u: slope 1/2 becomes Whittaker's equation u'' = (4 b + (4 c + 3/4)/t^2) u,
// whose second direction is the only one of y, one turn later.
TEST(Stokes, ThePullBackOfSlopeOneHalf) {
  for (const RationalFunction& c : {q(0), q(1, 7), q(-2, 3), q(-1, 4)}) {
    const RationalFunction r = q(1) / z() + c / (z() * z());
    const RationalFunction above = q(4) + (q(4) * c + q(3, 4)) / (z() * z());
    const Point base = point(-3, -4); // of t = 1 - 2 i
    const BallMatrix s = of(r, base).matrices.at(0).matrix;
    const BallMatrix m =
        monodromy::monodromy(RationalFunction(0), -r, {digits, base, {}}).loops.at(0).matrix;
    ComplexBall t;
    acb_set_si_si(t.raw(), 1, -2);
    BallMatrix l = BallMatrix::identity(2); // (y, dy/dx) from (u, du/dt), without t^(1/2)
    acb_mul_2exp_si(l.entry(1, 1), t.raw(), 1);
    acb_inv(l.entry(1, 1), l.entry(1, 1), 200);
    acb_mul(l.entry(1, 0), l.entry(1, 1), l.entry(1, 1), 200);
    const auto below = [&](const BallMatrix& x) {
      return multiply(multiply(l, x, 200), inverse(l, 200), 200);
    };
    const Stokes pulled_back = of(above, point(1, -2));
    EXPECT_EQ(pulled_back.family, "Whittaker");
    EXPECT_TRUE(overlap(s, below(pulled_back.matrices.at(0).matrix)));
    EXPECT_TRUE(overlap(multiply(multiply(inverse(m, 200), s, 200), m, 200),
                        below(pulled_back.matrices.at(1).matrix)));
  }
}

// On a direction, beside one, and behind the cut of the square root.
TEST(Stokes, AnyBaseOfARamifiedPointWillDo) {
  const std::vector<RationalFunction> equations{q(1) / z(), q(-2) / z() + q(1, 7) / (z() * z()),
                                                z() + q(1) / (z() * z())};
  for (const RationalFunction& r : equations)
    for (const Point& base : {point(2, 0), point(-2, 0), point(0, 2), point(5, 1), point(5, -1)})
      EXPECT_FALSE(of(r, base).self_tests.empty());
}

TEST(Stokes, OtherEquationsAreLeftAlone) {
  const std::vector<RationalFunction> others{q(3),
                                             q(1) / pow(z(), 4),
                                             pow(z(), 3) + q(1),
                                             pow(z(), 23),
                                             z() + q(1) / z(),
                                             q(1) / z() + q(1) / (z() - q(1)),
                                             q(1) + q(1) / (z() * (z() - q(1))),
                                             q(1) / (z() * z())};
  for (const RationalFunction& r : others)
    EXPECT_FALSE(stokes_at_infinity(RationalFunction(0), -r, point(0, -3), {digits, {}, {}}));
}

// Where the group is a Borel group, or smaller, the matrices must not say SL(2, C).
TEST(Stokes, TheGroupIsNotOverstated) {
  const std::vector<std::pair<RationalFunction, bool>> equations{
      {z(), true},                                  // Airy
      {z() * z() + q(1), false},                    // exp(z^2/2)
      {z() * z() + q(1, 2), true},                  // Weber
      {q(-1) + q(2) / (z() * z()), false},          // Bessel, order 3/2
      {q(-1) - q(1, 4) / (z() * z()), true},        // Bessel, order 0
      {q(1, 4) - q(1) / z(), false},                // exp(-z/2) z
      {q(1) / z(), true},                           // Bessel, slope 1/2
      {pow(z(), 3), true},                          // slope 5/2
      {q(1) / z() - q(3, 16) / (z() * z()), false}, // exp(2 z^(1/2)) z^(1/4)
      {z() + q(5, 16) / (z() * z()), false}};       // exp(2/3 z^(3/2)) z^(-1/4)
  for (const auto& [r, whole] : equations) {
    Monodromy m = monodromy::monodromy(RationalFunction(0), -r, {digits, {}, {}});
    for (const StokesMatrix& x : of(r, m.base).matrices)
      m.loops.push_back({{}, x.matrix});
    EXPECT_EQ(prove_sl2(m).has_value(), whole);
  }
}

} // namespace
