// Equations moved to the barycentre of their poles.

#include "linode/centre.hpp"

#include "exact/fields.hpp"

#include <gtest/gtest.h>

namespace kov::centre_test {
namespace {

using namespace testing;

const Poly Z = Poly::z();

class CentreLaws : public OverFields {};

// A translate of an equation over Q is over Q again, and nothing else has changed.
TEST_P(CentreLaws, ATranslateComesBack) {
  for (int i = 0; i < 5; ++i) {
    const NfElem a = nonzero();
    if (is_rational(a)) continue;
    const Poly q = Z * Z * Z - scale(Z, NfElem(i)) + Poly(3);
    const RationalFunction p(Z, Z - Poly(i));
    for (const RationalFunction& f :
         {RationalFunction(Z * Z + Poly(i), q * q), RationalFunction(pow(Z, 5) - Poly(2) * Z * Z),
          RationalFunction(Poly(2), Z * Z)}) {
      const auto there = centred({moved_by(f, a), moved_by(p, a)});
      ASSERT_TRUE(there);
      EXPECT_EQ(there->equation.p, moved_by(p, there->centre + a));
      EXPECT_FALSE(centred({moved_by(f, a), RationalFunction(Poly(a), Z)}));
      EXPECT_TRUE(there->equation.r.field()->is_rational());
      EXPECT_TRUE(is_rational(there->centre + a));
      EXPECT_EQ(there->equation.r, moved_by(f, there->centre + a));
    }
  }
}

// sqrt(2) is in the coefficients themselves.
TEST(Centre, NoTranslateOfAnEquationOverQ) {
  const NfElem s = NfElem::generator(make_field({-2, 0, 1}, "s"));
  EXPECT_FALSE(centred({RationalFunction(Poly(s), pow(Z - Poly(s), 2)), {}}));
  EXPECT_FALSE(centred({RationalFunction(Poly(1), Z * Z - Poly(s)), {}}));
}

TEST(Centre, ALongNumberIsMovedAway) {
  const NfElem far(Rational(Integer(1), pow(Integer(10), 40)));
  const RationalFunction f(Z + Poly(1), Z * Z * (Z - Poly(1)));
  const auto there = centred({moved_by(f, far), {}});
  ASSERT_TRUE(there);
  EXPECT_EQ(there->equation.r, moved_by(f, NfElem(Rational(1, 3))));
  EXPECT_FALSE(centred({f, {}}));
}

TEST(Centre, ConstantsHaveNone) {
  EXPECT_FALSE(centred({RationalFunction(0), {}}));
  EXPECT_FALSE(
      centred({RationalFunction(Poly(NfElem::generator(make_field({-2, 0, 1}, "s")))), {}}));
}

TEST(Centre, MovingIsAnAction) {
  const RationalFunction f(Z * Z + Poly(1), Z - Poly(5));
  EXPECT_EQ(moved_by(moved_by(f, NfElem(3)), NfElem(-3)), f);
  EXPECT_EQ(evaluate(moved_by(f, NfElem(3)).num(), NfElem(1)), NfElem(17));
}

KOV_OVER_ALL_FIELDS(CentreLaws);

} // namespace
} // namespace kov::centre_test
