// "Case g != 0" for all bodies at once: Lame's equation found in the normal variational equation
// with symbolic C and h, and the ratios A/C at which the identity component can be abelian.

#include "sliding_top.hpp"

#include "closed/lame.hpp"
#include "closed/lame_family.hpp"

namespace kov::lemmas {
namespace {

class GravityLame : public testing::Test {
protected:
  MFraction f(const std::string& text) const { return formula(s, text); }
  System s = sliding_top("gravity.toml");
  ManifoldReport m = stages(s);
  std::size_t h = s.ring()->index("h");
};

TEST_F(GravityLame, NoLameAtAGenericEnergy) { EXPECT_FALSE(recognize_lame(equation(m).r, s.z)); }

TEST_F(GravityLame, FoundAtTheSpecialEnergy) { // eq. (lamiak), without the paper's substitution
  const MFraction r = substitute(equation(m).r, {{s.ring()->index("A"), f("h^2 - 1")}});
  const auto lame = recognize_lame(r, s.z);
  ASSERT_TRUE(lame);
  EXPECT_TRUE(lame->squared);
  EXPECT_TRUE(equal(lame->alpha, f("2*(C-h^2+1)/C")));
  const MFraction beta = f("-h*(C-h^2+1)/(3*C)");
  const MFraction g2 = f("h^2/3+1");
  const MFraction g3 = f("-h*(h^2-9)/27");
  const auto& p = lame->parameters; // equal up to (cB, c^2 g2, c^3 g3)
  EXPECT_TRUE(equal(p.b * p.b * g2, beta * beta * p.g2));
  EXPECT_TRUE(equal(p.b * p.g2 * g3, beta * g2 * p.g3));
}

// The values |2n+1| of the families with an abelian identity component, (2n+1)^2 <= bound, ascending.
std::vector<Rational> lame_candidates(const Rational& bound) {
  std::vector<Rational> roots;
  for (const LameFamily& family : lame_families())
    for (long j = 1;; ++j) {
      const Rational root = Rational(j) * Rational(family.numerator, family.denominator);
      if (root * root > bound) break;
      if (lame_index((root - Rational(1)) / Rational(2)).kind != LameCase::other)
        roots.push_back(root);
    }
  std::ranges::sort(roots);
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  return roots;
}

// A = a C, a > 0: (2n+1)^2 = 9 - 8a < 9.  Each value that leaves a chance is tried; the equation is
// taken at h^2 = 1 + A > 1.
TEST_F(GravityLame, AbelianForTheBallOnly) {
  const Ring ring = make_ring({"h"});
  const MFraction e = MFraction::variable(ring, std::string_view("h"));
  const MFraction one(ring, Rational(1));
  int abelian = 0;
  const std::vector<Rational> roots = lame_candidates(Rational(9));
  for (const Rational& root : roots) {
    if (root == Rational(3)) continue; // a = 0
    const LameIndex index = lame_index((root - Rational(1)) / Rational(2));
    const Rational a = (Rational(9) - root * root) / Rational(8);
    const LameParameters<MFraction> p{(a - Rational(1)) / Rational(3) * e,
                                      Rational(1, 3) * (e * e) + one,
                                      Rational(-1, 27) * (e * (e * e - Rational(9) * one))};
    const LameConditions c = lame_conditions(index, p);
    if (c.always()) {
      EXPECT_EQ(a, Rational(1));
      ++abelian;
      continue;
    }
    MPoly common(ring);
    for (const MPoly& condition : c.abelian)
      common = gcd(common, condition);
    // the common zeros h: only h = 0, h^2 = 1 or smaller values, never h^2 = 1 + A
    for (const MFactor& zero : factor(common).second) {
      const auto coefficient = coefficients(zero.base, 0);
      ASSERT_LE(coefficient.size(), 3U) << to_string(zero.base);
      if (coefficient.size() == 2) {
        const Rational value = -to_rational(MFraction(coefficient[0], coefficient[1]));
        EXPECT_LE(value * value, Rational(1)) << to_string(zero.base);
      } else {
        ASSERT_TRUE(is_zero(coefficient[1])) << to_string(zero.base);
        EXPECT_LE(-to_rational(MFraction(coefficient[0], coefficient[2])), Rational(1))
            << to_string(zero.base);
      }
    }
  }
  EXPECT_EQ(abelian, 1); // n = 0, A = C
  EXPECT_GE(roots.size(), 10U);
}

} // namespace
} // namespace kov::lemmas
