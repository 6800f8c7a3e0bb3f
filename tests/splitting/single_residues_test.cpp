// When the residues at z = i and z = -i vanish one by one, on one of the two orbits.

#include "bodies.hpp"

#include <gtest/gtest.h>

using namespace kov;

// Single residues of the heavy top vanish on the Hess-Appelrot line only.
TEST(Residues, SingleResiduesOfTheHeavyTopGiveHessAppelrot) {
  const SplittingData& d = heavy_top();
  const Names x(d);
  const StripResidues& r = residues_of(d, 1, 1);
  const MFraction line = x("beta") * x("L1") + x("alpha") * x("L3");
  const MFraction expected = x("i") * x("delta") * x("L2") - line;
  EXPECT_TRUE(uses(d.space.field.reduce(r.upper / expected), d.space.chart.ring->index("L1")) ==
              false);
}

namespace {

// docs/theory/splitting.md (5), (6): P = p22 S2^2 + (line)(second line) and Q = delta S2 (...).
struct SingleResidues : ::testing::Test, SlidingTopLetters {
  MFraction k1 = 2 * a2 * b2 + 3 * a2 * b - b * b, k3 = 2 * a2 * b2 - 3 * b2 * b - b * b;
  MFraction q1 = a2 * b2 + 3 * a2 * b - 2 * b * b, q3 = a2 * b2 - 3 * b2 * b - 2 * b * b;
  MFraction q = a2 * b2 + b * b;
  MFraction scale = x("m") * b / (12 * x("G") * a2 * b2 * d2);
  MFraction first_mode = 2 * x("F") * x("s") * scale, second_mode = x("s") * x("s") * scale;

  [[nodiscard]] MFraction hess_appelrot(long sign) const { return sign * be * s1 + al * s3; }
  [[nodiscard]] MFraction second_line(long sign) const {
    return sign * be * k1 * s1 + al * k3 * s3;
  }
  [[nodiscard]] MFraction p(long sign) const {
    return d2 * q * s2 * s2 + hess_appelrot(sign) * second_line(sign);
  }
  [[nodiscard]] MFraction q_form(long sign) const {
    return de * s2 * (al * q3 * s3 + sign * be * q1 * s1);
  }
};

} // namespace

TEST_F(SingleResidues, AreTheFormsPAndQ) {
  for (const long sign : {1L, -1L}) {
    const StripResidues &one = residues_of(d, 1, static_cast<int>(sign)),
                        &two = residues_of(d, 2, static_cast<int>(sign));
    const MFraction P = p(sign), Q = q_form(sign);
    EXPECT_TRUE(equal(one.upper, sign * first_mode * (i * Q - P))) << sign;
    EXPECT_TRUE(equal(one.lower, sign * first_mode * (i * Q + P))) << sign;
    EXPECT_TRUE(equal(two.upper, second_mode * (i * P + Q))) << sign;
    EXPECT_TRUE(equal(two.lower, second_mode * (i * P - Q))) << sign;
  }
}

// S2 = 0 and one of two lines, which differ because k1 - k3 > 0; no point with S2 != 0, because
// P > 0 where Q = 0: there (S1, S3) = T (alpha q3, -beta q1), up to the sign of S1.
TEST_F(SingleResidues, VanishForS2ZeroOnTwoLinesOnly) {
  EXPECT_TRUE(equal(k1 - k3, 3 * b * d2));
  EXPECT_TRUE(equal(q1 - q3, 3 * b * d2));
  const MFraction T = x("Y"); // any letter
  for (const long sign : {1L, -1L}) {
    const MFraction there = at(p(sign), {{"L1", sign * al * q3 * T}, {"L3", -be * q1 * T}});
    EXPECT_TRUE(equal(there, q * (d2 * s2 * s2 + 9 * a2 * b2 * b * b * d2 * d2 * T * T)));
  }
}

// The families of (6), seen from here: the two lines of one orbit are those of the other.  The
// second line is its own image for k1 = 0 (L on the first axis), and it is the other orbit's line
// of Hess and Appelrot for k1 + k3 = 0, which is A + C = 4 B.
TEST_F(SingleResidues, LinesOfBothOrbitsMeetInTheFamilies) {
  const MFraction a = b - a2, c = b + b2;
  EXPECT_TRUE(equal(k1, 2 * b * c - 2 * a * c - a * b));
  EXPECT_TRUE(equal(k1 + k3, a * b + b * c - 4 * a * c));
  EXPECT_TRUE(equal(second_line(1) - k3 * hess_appelrot(-1), be * s1 * (k1 + k3)));
  EXPECT_TRUE(equal(second_line(1) - second_line(-1), 2 * be * k1 * s1));
}

// The print takes dz, and has the line of Hess and Appelrot only: rightly so, for on S2 = 0 the
// other factor is complex, its real and imaginary part independent.
TEST_F(SingleResidues, OfDzVanishOnTheHessAppelrotLineOnly) {
  const MFraction scale_dz = x("m") * b * x("F") * x("s") / (12 * al * be * d2);
  for (const long sign : {1L, -1L}) {
    const StripResidues& r = residues_of(d, 1, static_cast<int>(sign));
    const MFraction rest = at_zero(r.upper_dz, {"L2"}) / (scale_dz * hess_appelrot(sign));
    const MFraction real = 3 * al * be * (sign * be * (b - 2 * a2) * s1 + al * (b + 2 * b2) * s3);
    EXPECT_TRUE(equal(rest, sign * (real - 2 * i * second_line(sign)))) << sign;
    // upper - lower vanishes for S2 = 0, or where h = 0 and alpha S1 = +-beta S3, so S1 = S3 = 0
    const MFraction h = hess_appelrot(sign), ab = al * be;
    const MFraction difference = 2 * b * h - 3 * ab * (sign * al * s1 - be * s3) - i * ab * h;
    EXPECT_TRUE(
        equal(r.upper_dz - r.lower_dz, 4 * sign * scale_dz * de * s2 * (b - i * ab) * difference));
    EXPECT_FALSE(equal(at_zero(r.upper_dz, {"L1", "L3"}), x.number(0)));
  }
  EXPECT_TRUE(equal((b + 2 * b2) * k1 - (b - 2 * a2) * k3, d2 * (b * b + 4 * a2 * b2)));
}
