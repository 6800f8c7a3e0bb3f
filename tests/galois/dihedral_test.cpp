// Families of dihedral equations with known answer, on curves of genus 0, 1 and 2.

#include "galois/dihedral.hpp"

#include "galois/classify.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using testing::from_square;
using testing::pull_back;
using testing::riemann;

const Poly z = Poly::z();

// The equation with u = y1/y2 = (h/h*)^(1/N), h = A + B s on s^2 = F0 and h* = A - B s: from
// du/u = E dz/(N n s), n = A^2 - B^2 F0, E = 2 (A B' F0 + A B F0'/2 - A' B F0).
RationalFunction with_ratio(const Poly& F0, const Poly& A, const Poly& B, long N) {
  const Poly E =
      Poly(2) * (A * derivative(B) * F0 - derivative(A) * B * F0) + A * B * derivative(F0);
  const Poly n = A * A - B * B * F0;
  const RationalFunction g(scale(n, NfElem(N)), E);
  return from_square(RationalFunction(F0) * g * g, NfElem(1));
}

Classification decided(const RationalFunction& r) { return classify(r); }

void expect_group(const RationalFunction& r, const GaloisGroup& expected) {
  const Classification c = decided(r);
  ASSERT_TRUE(c.group) << to_string(r) << ": " << reason(c);
  EXPECT_EQ(describe(*c.group), describe(expected)) << to_string(r);
}

// S - 1 on S^2 = z^m + 1 vanishes m times at (0, 1): (h/h*)^(1/N) has the divisor m/N (P - P*),
// where 2P has the odd order m; so n eta is a logarithmic derivative exactly for N | n.
TEST(Dihedral, RootsOfATorsionFunction) {
  for (const long m : {1L, 3L, 5L})
    for (const long N : {2L, 3L, 4L, 5L, 7L}) {
      SCOPED_TRACE("m = " + std::to_string(m) + ", N = " + std::to_string(N));
      const Poly F0 = pow(z, static_cast<unsigned long>(m)) + Poly(1);
      const RationalFunction r = with_ratio(F0, Poly(-1), Poly(1), N);
      expect_group(r, {GroupType::D, Integer(N)});
    }
}

// (0, 1) on S^2 = z^3 + z + 1 has infinite order: residues +-w at P and P*, for any rational w.
TEST(Dihedral, PointsOfInfiniteOrder) {
  const Poly F0 = pow(z, 3) + z + Poly(1);
  for (const Rational& w : {Rational(1), Rational(1, 2), Rational(3, 5)})
    expect_group(from_square(RationalFunction(F0 * z * z), NfElem(w * w)), {GroupType::Dinf, {}});
}

// No pole at all, or poles of higher order, or residues that are not rational: infinite.
TEST(Dihedral, DifferentialsThatAreNotLogarithmic) {
  for (const Poly& F0 : {pow(z, 3) - Poly(2), pow(z, 5) + z + Poly(3)})
    expect_group(from_square(RationalFunction(F0), NfElem(1)), {GroupType::Dinf, {}});
  expect_group(from_square(RationalFunction((z + Poly(1)) * pow(z, 4)), NfElem(1)),
               {GroupType::Dinf, {}});
  expect_group(from_square(RationalFunction((z + Poly(1)) * z * z), NfElem(2)),
               {GroupType::Dinf, {}});
}

// Riemann's equations with differences 1/2, 1/2, k/n.
TEST(Dihedral, RiemannEquations) {
  for (long n = 3; n <= 9; ++n)
    for (long k = 1; k < n; ++k) {
      if (n_gcd(static_cast<ulong>(k), static_cast<ulong>(n)) != 1) continue;
      const NfElem quarter(Rational(1, 4));
      const NfElem square(Rational(k * k, n * n));
      expect_group(riemann(quarter, quarter, square), {GroupType::D, Integer(n)});
    }
}

// A change of variable of degree one changes nothing; z^2 may make the group smaller.
TEST(Dihedral, MoebiusInvariance) {
  const Poly F0 = pow(z, 3) + Poly(1);
  const RationalFunction r = with_ratio(F0, Poly(-1), Poly(1), 4);
  expect_group(pull_back(r, RationalFunction(z - Poly(3), Poly(2) * z + Poly(5))),
               {GroupType::D, Integer(4)});
  expect_group(pull_back(r, RationalFunction(Poly(1), z)), {GroupType::D, Integer(4)});
}

TEST(Dihedral, TheCurveAndTheDifferentialAreThoseThatWerePut) {
  const Poly F0 = pow(z, 3) + Poly(1);
  const Classification c = decided(with_ratio(F0, Poly(-1), Poly(1), 5));
  ASSERT_TRUE(c.curve);
  EXPECT_EQ(c.curve->branch, F0);
  EXPECT_EQ(c.curve->genus, 1);
  ASSERT_TRUE(c.dihedral);
  EXPECT_EQ(c.dihedral->finite, Truth::yes);
  EXPECT_EQ(c.dihedral->n, Integer(5));
  // k F0 g^2 = F solves Sym^4 with the Wronskian w: the equation comes back from it
  const RationalFunction F = RationalFunction(scale(F0, c.curve->k)) * c.curve->g * c.curve->g;
  EXPECT_EQ(from_square(F, c.curve->w_squared), with_ratio(F0, Poly(-1), Poly(1), 5));
  EXPECT_EQ(decide_dihedral(*c.curve).n, Integer(5));
}

} // namespace
} // namespace kov
