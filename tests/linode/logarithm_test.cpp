#include "linode/logarithm.hpp"

#include "exact/fields.hpp"
#include "linode/series.hpp"
#include "linode/singularities.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov::logarithm_test {
namespace {

using namespace testing;

class LogarithmLaws : public OverFields {
protected:
  // The equation with the solutions R^(-1/2) and R^(-1/2) int R.
  [[nodiscard]] static RationalFunction with_wronskian(const RationalFunction& R) {
    return from_omega(-derivative(R) / (RationalFunction(2) * R));
  }
  // The residue of R = num/(t^m g) at a rational place, by the series of num/g.
  [[nodiscard]] static NfElem residue(const RationalFunction& R, const NfElem& c) {
    const auto [m, g] = remove_factor(R.den(), Poly::z() - Poly(c));
    if (m == 0) return NfElem(0);
    return series_at(RationalFunction(R.num(), g), c, m).coeff(m - 1);
  }
};

// int R has a logarithm at a pole exactly when R has a residue there; the exponent difference is
// the order of the pole minus 1, or the order of the zero plus 1, and zeros give no logarithm.
TEST_P(LogarithmLaws, LogarithmsAreResidues) {
  int with = 0;
  int without = 0;
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const long m = number(1, 5);
    const long e = number(2, 3);
    const NfElem zero = NfElem(number(1, 3));
    // about half of the time the numerator is chosen such that the residue at 0 vanishes
    Poly num = pow(z() - Poly(zero), static_cast<unsigned long>(e));
    RationalFunction R(num, pow(z(), static_cast<unsigned long>(m)) * (z() + constant(2)));
    if (i % 2 == 0 && m > 1) R -= RationalFunction(Poly(residue(R, NfElem(0))), z());
    const Singularities s = singularities(with_wronskian(R));
    for (const Singularity& p : s.finite) {
      if (degree(p.place) != 1) continue;
      const NfElem c = -p.place.coeff(0);
      const auto pole = remove_factor(R.den(), z() - Poly(c)).first;
      const auto order = remove_factor(R.num(), z() - Poly(c)).first;
      EXPECT_EQ(p.delta, Rational(pole > 0 ? pole - 1 : order + 1));
      const bool expected = pole > 0 && !is_zero(residue(R, c));
      EXPECT_EQ(p.log, truth(expected)) << to_string(R) << " at " << to_string(c);
      ++(expected ? with : without);
    }
    // a pole whose exponent difference is 1 and that has no residue is not a singularity at all
    if (m == 2 && is_zero(residue(R, NfElem(0)))) {
      for (const Singularity& p : s.finite)
        EXPECT_FALSE(p.place == z());
    }
  }
  EXPECT_GT(with, 3);
  EXPECT_GT(without, 3);
}

// If the ratio of two solutions is a rational function f, nothing has a logarithm, conjugate places
// and infinity included.
TEST_P(LogarithmLaws, RationalRatiosHaveNone) {
  for (int i = 0; i < 4; ++i) {
    const RationalFunction f(monic_poly(3), monic_poly(number(0, 2)));
    if (is_zero(derivative(f))) continue;
    const RationalFunction r = with_wronskian(derivative(f));
    if (is_zero(r)) continue;
    const Singularities s = singularities(r);
    for (const Singularity& p : s.finite) {
      EXPECT_EQ(p.log, Truth::no) << to_string(f);
      EXPECT_EQ(p.kind, PlaceKind::regular);
      ASSERT_TRUE(p.delta);
      EXPECT_TRUE(is_integer(*p.delta));
      EXPECT_GE(*p.delta, Rational(2));
    }
    EXPECT_EQ(s.infinity.log, Truth::no);
  }
}

KOV_OVER_ALL_FIELDS(LogarithmLaws);

// Bessel's equation: Delta = 2n, and never without a logarithm; r = -1 + (n^2 - 1/4)/z^2.
TEST(Logarithm, BesselUpToLargeOrders) {
  const Poly z = Poly::z();
  for (const long n : {1L, 2L, 3L, 7L, 40L, 400L}) {
    const Poly num = Poly(Rational(4 * n * n - 1, 4)) - z * z;
    EXPECT_EQ(has_logarithm(num, z * z, z, 2 * n), Truth::yes) << n;
    // half-integers: Delta = 2n - 1, elementary functions
    const Poly half =
        Poly((Rational(2 * n - 1) * Rational(2 * n - 1) - Rational(1)) / Rational(4)) - z * z;
    EXPECT_EQ(has_logarithm(half, z * z, z, 2 * n - 1), Truth::no) << n;
  }
}

TEST(Logarithm, LimitsAreSaid) {
  const Poly z = Poly::z();
  const Poly num = Poly(Rational(9999L * 9999L - 1, 4)) - z * z; // no logarithm, too long to prove
  EXPECT_EQ(has_logarithm(num, z * z, z, 9999), Truth::unknown);
  Budget small;
  small.max_degree = 10;
  EXPECT_EQ(has_logarithm(Poly(120) - z * z, z * z, z, 22, small), Truth::unknown);
  EXPECT_EQ(has_logarithm(Poly(Rational(-1, 4)), z * z, z, 0), Truth::yes);
}

} // namespace
} // namespace kov::logarithm_test
