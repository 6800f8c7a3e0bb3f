// Families of dihedral equations with known answer, on curves of genus 0, 1 and 2.

#include "galois/dihedral.hpp"

#include "exact/fields.hpp"
#include "galois/classify.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

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

// Genus 8 to 10: modulo small primes the order of (0, 1) is beyond reach, p-curvatures decide.
TEST(Dihedral, PointsOfInfiniteOrderOnCurvesOfLargeGenus) {
  for (const unsigned long d : {17UL, 19UL, 20UL, 22UL}) {
    const Poly F0 = pow(z, d) + Poly(2) * pow(z, 3) - z + Poly(1);
    for (const Rational& w : {Rational(1), Rational(2, 3)}) {
      const RationalFunction r = from_square(RationalFunction(F0 * z * z), NfElem(w * w));
      expect_group(r, {GroupType::Dinf, {}});
    }
  }
}

// The same genus with a function of small degree: found although no Jacobian can be counted.
TEST(Dihedral, TorsionOnCurvesOfLargeGenus) {
  for (const unsigned long d : {9UL, 10UL, 11UL})
    for (const long N : {2L, 5L}) {
      const Poly A = pow(z, d) + z - Poly(3);
      const Poly F0 = A * A - Poly(2);
      expect_group(with_ratio(F0, A, Poly(1), 2 * N), {GroupType::D, Integer(N)});
    }
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
// u = h^(k/n), h of the degree of the change of variable: however large k and n are, no function of
// degree k is needed.
TEST(Dihedral, PowersOfASmallFunction) {
  const NfElem quarter(Rational(1, 4));
  for (const RationalFunction& f :
       {RationalFunction(z * z - 3, z + 2), RationalFunction(z * z * z - z + 5),
        RationalFunction(z * z + 7, z * z - z + 3)})
    for (const Integer& n : {Integer(7), Integer(1000003), pow(Integer(10), 15) + Integer(37)})
      for (const Integer& k : {Integer(1), Integer(2), n - Integer(1), n + Integer(2)}) {
        const NfElem square(Rational(k * k, n * n));
        expect_group(pull_back(riemann(quarter, quarter, square), f), {GroupType::D, n});
      }
}

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
  EXPECT_EQ(decide_dihedral(*c.curve, *c.local).n, Integer(5));
}

class DihedralLaws : public OverFields {
protected:
  // dh/h = M eta for h = a + b s: then b = g a'/(M W), and h h* = a^2 - b^2 F0 is a constant.
  static void expect_function(const DihedralCurve& c, const DihedralAnswer& answer) {
    ASSERT_TRUE(answer.a);
    const RationalFunction slope = c.g * derivative(*answer.a);
    const NfElem square = NfElem(Rational(answer.n * answer.n)) * c.w_squared / c.k; // M^2 W^2
    const RationalFunction norm =
        *answer.a * *answer.a - slope * slope * RationalFunction(scale(c.branch, inverse(square)));
    EXPECT_FALSE(is_zero(norm));
    EXPECT_TRUE(is_zero(derivative(norm)));
    EXPECT_FALSE(is_zero(derivative(*answer.a)));
  }
};

// S - c on S^2 = x^m + c^2 vanishes m times at (0, c), for every c != 0 of the field.
TEST_P(DihedralLaws, TorsionFunctionsAreFoundAndHaveTheirDivisor) {
  for (const unsigned long m : {3UL, 5UL}) {
    if (m == 5 && k->degree() > 2) continue; // the same again, and slow
    const NfElem c = nonzero();
    const Poly F0 = pow(z() - Poly(element()), m) + Poly(c * c);
    const long N = number(3, 5);
    const RationalFunction r = with_ratio(F0, Poly(-c), constant(1), N);
    const Classification found = classify(r);
    ASSERT_TRUE(found.group) << to_string(r) << ": " << reason(found);
    EXPECT_EQ(describe(*found.group), describe({GroupType::D, Integer(N)}));
    ASSERT_TRUE(found.curve && found.dihedral);
    EXPECT_EQ(found.curve->genus, static_cast<long>(m / 2));
    EXPECT_EQ(found.dihedral->by, Torsion::function);
    EXPECT_EQ(found.dihedral->n, Integer(N));
    expect_function(*found.curve, *found.dihedral);
  }
}

// Genus 0: h = A + B s on s^2 = F0 of degree 1 or 2 has degree 1 in z; its N-th roots.
TEST_P(DihedralLaws, GenusZero) {
  const NfElem c = nonzero();
  for (const Poly& F0 : {z() + Poly(c * c), z() * z() + Poly(c * c)}) {
    // s - c vanishes once at (0, c), or twice where F0 has no term of degree 1
    const long N = 2 * number(1, 3) + 1;
    const RationalFunction r = with_ratio(F0, Poly(-c), constant(1), N);
    const Classification found = classify(r);
    ASSERT_TRUE(found.dihedral) << to_string(r) << ": " << reason(found);
    EXPECT_EQ(found.dihedral->by, Torsion::genus_zero);
    EXPECT_EQ(found.dihedral->n, Integer(N));
  }
}

// F = (y1 y2)^2 comes back from the quartic invariant up to a constant, with its Wronskian.
TEST_P(DihedralLaws, TheQuarticRootIsTheSquareOfTheProduct) {
  for (int i = 0; i < 3; ++i) {
    const Poly f = (z() * z() + constant(43)) * (z() - constant(5)) * pow(monic_poly(1), 2);
    const RationalFunction r = from_square(RationalFunction(f), nonzero());
    const Singularities s = singularities(r);
    const InvariantSearch quartic = invariants(s, 4);
    ASSERT_EQ(quartic.basis.size(), 1U) << to_string(r);
    const QuarticRoot root = quartic_root(quartic.basis.front(), s);
    RationalFunction F(scale(root.q * root.q, root.k));
    ASSERT_EQ(root.e.size(), s.finite.size());
    for (std::size_t j = 0; j < root.e.size(); ++j)
      F *= pow(RationalFunction(s.finite[j].place), root.e[j]);
    EXPECT_TRUE(is_zero(derivative(F / RationalFunction(f))));
    EXPECT_EQ(from_square(F, root.w_squared), r);
    const DihedralCurve curve = dihedral_curve(root, s);
    EXPECT_EQ(RationalFunction(scale(curve.branch, curve.k)) * curve.g * curve.g, F);
    EXPECT_EQ(degree(gcd(curve.branch, derivative(curve.branch))), 0);
  }
}

KOV_OVER_ALL_FIELDS(DihedralLaws);

} // namespace
} // namespace kov
