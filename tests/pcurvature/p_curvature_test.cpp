#include "pcurvature/p_curvature.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

const Poly z = Poly::z();

TEST(PCurvature, ProvesAiry) {
  const auto proof = sl2_by_p_curvature(singularities(RationalFunction(z)));
  ASSERT_TRUE(proof);
  EXPECT_EQ(proof->prime.p, 7U);
}

// An admissible place that reduces to infinity.  G = Dinf for the dihedral r of
// F = (z-2)(7z-1), and p = 7 must not say SL2; nor may 11, 13 for their analogues.
TEST(PCurvature, AnAdmissiblePlaceMayGoToInfinity) {
  for (const long p : {7L, 11L, 13L}) {
    const Poly f = (z - Poly(2)) * (scale(z, NfElem(p)) - Poly(1));
    const RationalFunction F(f);
    const RationalFunction dF = derivative(F);
    const RationalFunction r =
        (RationalFunction(1) + derivative(dF) - RationalFunction(Rational(3, 4)) * dF * dF / F) /
        (RationalFunction(4) * F);
    EXPECT_FALSE(sl2_by_p_curvature(singularities(r), 12)) << p;
  }
}

// Rigid equations have B_p = 0 for all p, also where G = SL2: nothing may be claimed.
TEST(PCurvature, SaysNothingAboutLegendre) {
  const Poly d = z * z - Poly(1);
  EXPECT_FALSE(sl2_by_p_curvature(
      singularities(RationalFunction(scale(d, NfElem(Rational(3, 4))) - Poly(1), d * d))));
}

TEST(PCurvature, SaysNothingAboutReducibleEquations) {
  const RationalFunction w =
      RationalFunction(z * z + Poly(1), z) + RationalFunction(Poly(Rational(1, 3)), z - Poly(1));
  EXPECT_FALSE(sl2_by_p_curvature(singularities(derivative(w) + w * w), 8));
}

} // namespace
} // namespace kov
