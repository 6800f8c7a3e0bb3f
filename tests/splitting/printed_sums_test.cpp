// What [PrzybylskaMaciejewski2024] prints about the sums of residues, from our own residues.
//
// The printed sums are those of h_k dz at z = i and z = -i on the principal branch, and twice ours
// (the printed H_1 has a factor 2); they are not the sums that the criterion needs.  With
// E = e^(pi b/(alpha beta)) = 1/Y and e^(i g0) = (alpha - i beta)/delta dropped on both sides, the
// print writes them as a factor times a bracket R_k^+-, and takes real and imaginary parts of the
// brackets.  Where the print is wrong both it and the right formula are here.

#include "bodies.hpp"

#include <gtest/gtest.h>

using namespace kov;

namespace {

struct PrintedSums : ::testing::Test, SlidingTopLetters {
  MFraction one = x.number(1), E = pow(x("Y"), -1);
  MFraction ab = al * be, t = s2 * s2 * d2;
  MFraction w = be * s1 + al * s3; ///< first orbit
  MFraction v = al * s3 - be * s1; ///< second orbit

  // The bracket R_k^+- from our residues.
  [[nodiscard]] MFraction bracket(long k, int sign) const {
    const MFraction ours = 2 * principal_sum(d.space, residues_of(d, k, sign));
    const MFraction factor = k == 1 ? x("m") * b * x("F") * x("s") / (6 * ab * d2)
                                    : x("m") * x("s") * x("s") / (24 * ab * d2);
    return d.space.field.reduce(ours / factor);
  }
};

} // namespace

TEST_F(PrintedSums, FirstModeOnTheFirstOrbit) {
  const MFraction printed =
      (E + one) *
          (2 * i * b * b * (w * w - t) +
           3 * ab * b * (-t + w * (s1 * (be - 2 * i * al) + s3 * (al + 2 * i * be))) -
           2 * ab * ab * ((s1 * (3 * al + 2 * i * be) + s3 * (2 * i * al - 3 * be)) * w + i * t)) +
      2 * de * s2 * (one - E) * (b - i * ab) *
          (2 * b * w - ab * (s1 * (3 * al + i * be) + s3 * (i * al - 3 * be)));
  EXPECT_TRUE(equal(printed, bracket(1, 1)));
}

TEST_F(PrintedSums, SecondModeOnTheFirstOrbit) {
  const MFraction printed =
      (E * E - one) *
          (4 * pow(b, 3) * (t - w * w) +
           6 * ab * b * b * ((s1 * (2 * al + i * be) + i * s3 * (al + 2 * i * be)) * w - i * t) +
           4 * ab * ab * b * (t + w * (s1 * (2 * be - 3 * i * al) + s3 * (2 * al + 3 * i * be))) -
           3 * i * pow(ab, 3) * (w * w + t)) -
      4 * i * de * b * s2 * (E * E + one) * (b - i * ab) *
          (2 * b * w - ab * (s1 * (3 * al + i * be) + i * s3 * (al + 3 * i * be)));
  EXPECT_TRUE(equal(printed, bracket(2, 1)));
}

TEST_F(PrintedSums, FirstModeOnTheSecondOrbit) {
  const MFraction printed =
      (E + one) *
          (2 * i * b * b * (t - v * v) +
           3 * ab * b * (t + v * (s1 * (be - 2 * i * al) - s3 * (al + 2 * i * be))) -
           2 * ab * ab * ((s1 * (3 * al + 2 * i * be) + s3 * (3 * be - 2 * i * al)) * v - i * t)) +
      2 * s2 * de * (E - one) * (b - i * ab) *
          (2 * b * v + ab * (s1 * (3 * al + i * be) + s3 * (3 * be - i * al)));
  EXPECT_TRUE(equal(printed, bracket(1, -1)));
}

TEST_F(PrintedSums, SecondModeOnTheSecondOrbit) {
  const MFraction printed =
      (E * E - one) *
          (4 * pow(b, 3) * (t - v * v) +
           6 * ab * b * b * (-v * (s1 * (2 * al + i * be) + s3 * (2 * be - i * al)) - i * t) +
           4 * ab * ab * b * (t + (s1 * (-2 * be + 3 * i * al) + s3 * (2 * al + 3 * i * be)) * v) -
           3 * i * pow(ab, 3) * (v * v + t)) +
      4 * b * s2 * de * (E * E + one) * (b - i * ab) *
          (ab * (s1 * (be - 3 * i * al) - s3 * (al + 3 * i * be)) - 2 * i * b * v);
  EXPECT_TRUE(equal(printed, bracket(2, -1)));
}

// Real and imaginary parts over both orbits; the print solves them for S2, S3 when S1 != 0.
TEST_F(PrintedSums, MatrixA) {
  const MFraction plus = bracket(1, 1), minus = bracket(1, -1);
  const MFraction a11 = de * (E - one) * (a2 * b2 - 2 * b * b + 3 * a2 * b);
  const MFraction a12 = 3 * a2 * be * (E + one) * (b2 - a2 + b);
  const MFraction a21 = -3 * be * de * (a2 - b) * (E - one);
  const MFraction a22 = (E + one) * (b2 * (3 * b - 4 * a2) + b * (2 * b - 3 * a2));
  EXPECT_TRUE(equal(re(plus + minus), 4 * be * s1 * (a11 * s2 + a12 * s3)));
  EXPECT_TRUE(equal(im(plus + minus), 4 * ab * s1 * (a21 * s2 + a22 * s3)));
  const MFraction w1 = b * b * pow(2 * b - 3 * a2, 2) +
                       b2 * (9 * pow(a2, 3) + 6 * pow(b, 3) - 10 * a2 * b * b - 3 * a2 * a2 * b) +
                       a2 * b2 * b2 * (6 * b - 5 * a2);
  EXPECT_TRUE(equal(a11 * a22 - a12 * a21, de * (one - E * E) * w1));
}

// The print has 8 beta S1 twice: before the bracket and in B_21, B_22.
TEST_F(PrintedSums, MatrixBWhoseSecondRowIsMisprinted) {
  const MFraction difference = bracket(2, 1) - bracket(2, -1);
  const MFraction f = a2 * b2 - 2 * b * b + 3 * a2 * b;
  const MFraction g = a2 * b2 - 2 * b * b + 2 * b * (a2 - b2);
  const MFraction b11 = -3 * be * de * (a2 - b) * (E * E + one);
  const MFraction b12 = (E * E - one) * (b2 * (3 * b - 4 * a2) + b * (2 * b - 3 * a2));
  const MFraction b21 = 8 * b * be * s1 * de * (E * E + one) * f;
  const MFraction b22 = -12 * a2 * b2 * s1 * (E * E - one) * g;
  EXPECT_TRUE(equal(re(difference), -8 * b * ab * s1 * (b11 * s2 + b12 * s3)));
  EXPECT_TRUE(equal(im(difference), b21 * s2 + b22 * s3));
  EXPECT_FALSE(equal(im(difference), 8 * be * s1 * (b21 * s2 + b22 * s3)));
  const MFraction w2 =
      2 * pow(b, 3) * pow(2 * b - 3 * a2, 2) +
      a2 * b2 * b2 * (9 * a2 * a2 + 12 * b * b - 19 * a2 * b) +
      2 * b * b2 * (9 * pow(a2, 3) + 6 * pow(b, 3) - 10 * a2 * b * b - 3 * a2 * a2 * b);
  EXPECT_TRUE(equal(b11 * b22 - b12 * b21, 4 * be * s1 * de * (pow(E, 4) - one) * w2));
}

// L on an axis.  The second line for S1 is the imaginary part, and twice what is printed.
TEST_F(PrintedSums, OnTheAxes) {
  const MFraction first = at_zero(bracket(1, 1), {"L2", "L3"});
  const MFraction printed = b2 * (b * b - 2 * a2 * b2 - 3 * a2 * b) * (E + one) * s1 * s1;
  EXPECT_TRUE(equal(re(first), 3 * al * pow(be, 3) * (b - 2 * a2) * (E + one) * s1 * s1));
  EXPECT_FALSE(equal(re(first), printed));
  EXPECT_TRUE(equal(im(first), 2 * printed));
  EXPECT_TRUE(equal(re(at_zero(bracket(1, 1), {"L1", "L3"})), -3 * ab * b * (E + one) * t));
  EXPECT_TRUE(equal(re(at_zero(bracket(1, 1), {"L1", "L2"})),
                    3 * pow(al, 3) * be * (2 * b2 + b) * (E + one) * s3 * s3));
}

namespace {

// What the print has for S1 = 0: two combinations that have the factor S3, and two with S2.
struct PrintedMinors : PrintedSums {
  MFraction r1 = at_zero(bracket(1, 1), {"L1"}), r2 = at_zero(bracket(2, 1), {"L1"});
  MFraction k = 9 * b2 * b2 + 4 * b * b + b2 * (a2 + 12 * b);
  MFraction n = 2 * b * b * (b - 2 * a2) - a2 * b2 * (a2 + b);
  MFraction u = 4 * pow(b, 4) + b2 * b * b * (11 * a2 + 6 * b) + a2 * b2 * b2 * (15 * b - 2 * a2);
  MFraction v1 = 18 * a2 * pow(b2, 3) + 4 * pow(b, 4) + b * b * b2 * (18 * b - a2) +
                 b2 * b2 * (4 * a2 * a2 + 18 * b * b + 9 * a2 * b);
  // e^(3x/2) cosh(x/2) and cosh x for E = e^x
  MFraction envelope = (E * E + E) / (2 * one), X = (E + pow(E, -1)) / (2 * one);
  // C_1, C_2, D_1, D_2 as printed
  MFraction c_1 = a2 * pow(a2 * b2 + b * b, 2) * k, c_2 = -(n * u);
  MFraction d_1 = 2 * a2 * (a2 * b2 + b * b) * (2 * a2 * b2 - b * b - 3 * b2 * b) * k;
  MFraction d_2 = n * v1;
};

} // namespace

TEST_F(PrintedMinors, MatrixCWhoseSecondCombinationIsMisprinted) {
  const MFraction q = a2 * b2 + b * b;
  const MFraction c11 = -(de * (E - one) * u);
  const MFraction c12 = 3 * a2 * pow(be, 3) * (E + one) * (2 * a2 * b2 - b * b + 3 * a2 * b);
  const MFraction c21 =
      -(de * (E * E + one) *
        (9 * a2 * a2 * pow(b2, 3) + 8 * pow(b, 5) + 2 * pow(b, 3) * b2 * (11 * a2 + 6 * b) +
         5 * a2 * b * b2 * b2 * (a2 + 6 * b)));
  const MFraction c22 = -3 * a2 * pow(be, 3) * (E * E - one) * n;
  EXPECT_TRUE(equal(2 * q * re(r1) - 3 * ab * b * im(r1), 2 * al * s3 * (c11 * s2 + c12 * s3)));
  const MFraction right = 4 * b * al * s3 * (c21 * s2 + c22 * s3);
  const MFraction real = 3 * (q + b * b) * re(r2), imaginary = 4 * b * q * im(r2);
  EXPECT_FALSE(equal(real + imaginary, right));
  EXPECT_TRUE(equal(ab * real + imaginary, right));
  // The right C_1 is twice the printed one.
  const MFraction factor = 12 * a2 * pow(be, 3) * de * envelope;
  const MFraction determinant = c11 * c22 - c12 * c21;
  EXPECT_FALSE(equal(determinant, factor * (c_1 * X + c_2)));
  EXPECT_TRUE(equal(determinant, factor * (2 * c_1 * X + c_2)));
}

TEST_F(PrintedMinors, MatrixD) {
  const MFraction e = b * b + b2 * (3 * b - 2 * a2);
  const MFraction d11 = 3 * pow(be, 3) * d2 * (E + one) * (b * b - 2 * a2 * b2 - 3 * a2 * b);
  const MFraction d12 = de * (E - one) * v1;
  const MFraction d21 = -3 * pow(be, 3) * d2 * (E * E - one) * n;
  const MFraction d22 =
      de * (E * E + one) *
      (-8 * pow(b, 5) + 2 * pow(b, 3) * b2 * (a2 - 18 * b) +
       b * b2 * b2 * (a2 * a2 - 36 * b * b - 18 * a2 * b) + 9 * a2 * pow(b2, 3) * (a2 - 4 * b));
  EXPECT_TRUE(
      equal(2 * e * re(r1) - 3 * ab * (2 * b2 + b) * im(r1), -2 * al * s2 * (d11 * s2 + d12 * s3)));
  EXPECT_TRUE(equal(3 * ab * (2 * b * b + b2 * (4 * b - a2)) * re(r2) + 4 * b * e * im(r2),
                    4 * al * b * s2 * (d21 * s2 + d22 * s3)));
  EXPECT_TRUE(
      equal(d11 * d22 - d12 * d21, -12 * pow(be, 3) * pow(de, 3) * envelope * (d_1 * X + d_2)));
}

// With the right C_1; the printed third factor of R is another, and the constant is missing.
TEST_F(PrintedMinors, TheirResultantIsMisprinted) {
  const MFraction a = b - a2, c = b + b2;
  const MFraction resultant = 2 * c_1 * d_2 - c_2 * d_1;
  const MFraction rest = c * pow(a - b, 2) * pow(b - c, 2) * (a * b + c * (9 * c - 5 * b - a)) *
                         (a * b + 2 * a * c - 2 * b * c) *
                         (a * a * b - a * a * c + a * b * b + 3 * a * b * c - 2 * b * b * c);
  EXPECT_TRUE(equal(resultant, -18 * (a * b - a * c + b * c) * rest));
  const MFraction printed = a * b + c * (b - a) - a * c + b * c;
  EXPECT_FALSE(equal(resultant, printed * rest));
  EXPECT_FALSE(equal(resultant, -18 * printed * rest));
  EXPECT_FALSE(equal(c_1 * d_2 - c_2 * d_1, printed * rest));
}
