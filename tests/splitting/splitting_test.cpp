// Splitting of separatrices: Andoyer's variables, the orbits, the residues, and the classification.

#include "bodies.hpp"
#include "contour.hpp"
#include "splitting/families.hpp"
#include "support/source_dir.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace kov;

TEST(Andoyer, IsCanonicalAndItsInverseHasTheRightQuadrants) {
  const AndoyerChart c = andoyer_chart({});
  for (const CheckedIdentity& x : check_andoyer(c))
    EXPECT_TRUE(x.holds) << x.statement;
}

// A wrong sign in one component must be seen.
TEST(Andoyer, AWrongChartIsRejected) {
  AndoyerChart c = andoyer_chart({});
  c.gamma[2] = -c.gamma[2];
  EXPECT_FALSE(all_hold(check_andoyer(c)));
}

TEST(Orbits, SolveEulersEquationsAndTheEquationForG) {
  const OrbitSpace o = orbit_space({});
  for (const int sign : {1, -1})
    for (const CheckedIdentity& x : check_orbit(o, doubly_asymptotic(o, sign)))
      EXPECT_TRUE(x.holds) << x.statement;
}

TEST(Orbits, TheOtherSignOfTheSecondComponentIsRejected) {
  const OrbitSpace o = orbit_space({});
  DoublyAsymptotic orbit = doubly_asymptotic(o, 1);
  orbit.momentum[1] = -orbit.momentum[1];
  EXPECT_FALSE(check_orbit(o, orbit)[0].holds);
}

TEST(Perturbation, OfTheSlidingTopIsOfSecondOrderWithAMinusSign) {
  const EulerPerturbation& p = sliding_top().perturbation;
  EXPECT_EQ(p.order, 2);
  // H1 = -(m/2)[Gamma . (Omega x S)]^2 at M = (A, 0, 0), Gamma = (0, 0, 1), S = (0, 1, 0): -m/2
  const Ring& r = p.first.ring();
  Substitution at;
  for (const std::size_t v : used_variables(p.first))
    at[v] = MFraction(r);
  const auto set = [&](const char* n, const MFraction& x) { at[r->index(n)] = x; };
  for (const char* n : {"A", "B", "C", "m"})
    at.erase(r->index(n));
  set("M1", MFraction::variable(r, "A"));
  set("Gamma3", MFraction(r, Rational(1)));
  set("L2", MFraction(r, Rational(1)));
  EXPECT_EQ(substitute(p.first, at),
            Rational(Integer(-1), Integer(2)) * MFraction::variable(r, "m"));
}

TEST(Perturbation, OfAnotherSystemIsRefused) {
  const System s = read_system(test::in_source("/cases/classics/henon_heiles.toml"));
  EXPECT_THROW((void)perturbation_of_euler(s, small), Error);
}

TEST(Modes, OfTheSlidingTopReachFromMinusTwoToTwo) {
  const auto& modes = sliding_top().modes;
  EXPECT_EQ(modes.begin()->first, -2);
  EXPECT_EQ(modes.rbegin()->first, 2);
  // their sum with e^(i k g) is H1 again
  const SplittingData& d = sliding_top();
  const Names x(d);
  MFraction sum;
  for (const auto& [k, h] : modes)
    sum += h * pow(x("cos_g") + x("i") * x("sin_g"), k);
  EXPECT_TRUE(d.space.chart.field.is_zero(sum - d.first));
}

// dz and the principal branch are another condition: L on the first axis with C = 2 (A - B) has
// vanishing sums in the strip, and printed ones that do not vanish.
TEST(Residues, ThePrintedSumsMissAFamily) {
  const SplittingData& d = sliding_top();
  const Names x(d);
  const Ring& r = d.space.chart.ring;
  // 2 alpha^2 beta^2 + 3 alpha^2 b = b^2 at alpha = 1, b = 4, beta^2 = 2
  const Substitution at{{r->index("L2"), x.number(0)},
                        {r->index("L3"), x.number(0)},
                        {r->index("alpha"), x.number(1)},
                        {r->index("b"), x.number(4)}};
  const SurdField root(r, {{r->index("i"), x.number(-1)},
                           {r->index("beta"), x.number(2)},
                           {r->index("delta"), x.number(3)}});
  for (const StripResidues& one : d.residues) {
    EXPECT_TRUE(root.is_zero(substitute(strip_sum(d.space, one), at)));
    EXPECT_FALSE(root.is_zero(substitute(principal_sum(d.space, one), at)));
  }
}

TEST(Families, TheSlidingTopHasExactlyTwoOneOfThemAdmissible) {
  const auto k = classify_families(vanishing_conditions(sliding_top()));
  ASSERT_EQ(k.families.size(), 2U);
  EXPECT_EQ(describe(k.families[0]), "L3 = 0, L2 = 0, 2*A - 2*B - C = 0");
  EXPECT_EQ(k.families[0].triangle, Truth::yes);
  EXPECT_EQ(describe(k.families[1]), "L2 = 0, A - 4*B + C = 0, 4*B^2*L1^2 - 5*B*C*L1^2 - "
                                     "3*B*C*L3^2 + C^2*L1^2 + C^2*L3^2 = 0");
  EXPECT_EQ(k.families[1].triangle, Truth::no);
  for (const SplittingFamily& f : k.families)
    EXPECT_TRUE(f.witness.has_value());
  for (const EmptyBranch& e : k.empty)
    EXPECT_FALSE(is_constant(e.because.factor)) << e.branch;
}

// Every member found must really have vanishing sums, and a random body must not.
TEST(Families, MembersVanishAndOthersDoNot) {
  const SplittingData& d = sliding_top();
  const Names x(d);
  const Ring& r = d.space.chart.ring;
  // A + C = 4 B: A = 1/2, B = 1/7, C = 1/14; a = 2, b = 7, c = 14; alpha^2 = 5, beta^2 = 7;
  // L1^2 A (B - C) = L3^2 C (A - B):  L1^2/28 = L3^2 5/196,  L1 = sqrt(5), L3 = sqrt(7)
  const SurdField root(r, {{r->index("i"), x.number(-1)},
                           {r->index("alpha"), x.number(5)},
                           {r->index("beta"), x.number(7)},
                           {r->index("delta"), x.number(12)}});
  const auto at = [&](const MFraction& l1, const MFraction& l3) {
    return Substitution{{r->index("L2"), x.number(0)},
                        {r->index("L1"), l1},
                        {r->index("L3"), l3},
                        {r->index("b"), x.number(7)}};
  };
  for (const StripResidues& one : d.residues) {
    const MFraction sum = strip_sum(d.space, one);
    EXPECT_TRUE(root.is_zero(substitute(sum, at(x("alpha"), x("beta")))));
    EXPECT_TRUE(root.is_zero(substitute(sum, at(x("alpha"), -x("beta")))));
    EXPECT_FALSE(root.is_zero(substitute(sum, at(x("alpha"), x.number(2) * x("beta")))));
  }
}

// Ziglin's theorem of 1980 on the heavy top, from the same pipeline.
TEST(Families, TheHeavyTopHasNone) {
  const auto k = classify_families(vanishing_conditions(heavy_top()));
  EXPECT_TRUE(k.families.empty());
}

TEST(Cone, SignsAreProvedOrNotClaimed) {
  const Ring r = make_ring({"a", "b", "c", "u", "v"});
  const Cone cone = moment_cone(r);
  const auto x = [&](const char* n) { return MPoly::variable(r, n); };
  EXPECT_EQ(cone.sign(x("b") - x("a")), 1);
  EXPECT_EQ(cone.sign(x("b") * x("b") - x("a") * x("c")), 0); // both signs occur
  EXPECT_EQ(cone.sign(MPoly(r)), 0);
  const MPoly f = x("b") + x("b") - x("a") - x("c");
  EXPECT_EQ(cone.sign(f), 0);
  EXPECT_EQ(cone.sign(f, {x("b") - x("c")}, nullptr), 1); // b - a there
}

namespace {

Rational random_rational(std::mt19937& random) {
  return {Integer(static_cast<long>(random() % 40) + 1),
          Integer(static_cast<long>(random() % 9) + 1)};
}

OrbitPoint random_point(std::mt19937& random, bool gravity) {
  OrbitPoint at;
  at.a =
      random_rational(random) * Rational(Integer(1), Integer(10)); // so that nu stays below 5 or so
  at.b = at.a + random_rational(random) + Rational(1);
  at.c = at.b + random_rational(random) + Rational(1);
  at.F = random_rational(random);
  at.G = at.F + random_rational(random);
  for (const std::string& name : small)
    at.parameters[name] = random_rational(random) - Rational(3);
  if (!gravity) at.parameters["m"] = random_rational(random);
  return at;
}

// Both enclosures have 50 digits and overlap.
void expect_agreement(const SplittingData& d, const OrbitPoint& at) {
  const long bits = 288;
  for (const StripResidues& r : d.residues) {
    const ComplexBall exact =
        evaluate(strip_sum(d.space, r), values_at(d.space.chart.ring, at, bits), bits);
    const ComplexBall integral = strip_integral(d.perturbation, at, r.k, r.sign, bits);
    EXPECT_TRUE(acb_overlaps(exact.raw(), integral.raw())) << r.k << " " << r.sign;
    EXPECT_FALSE(acb_contains_zero(exact.raw()));
    EXPECT_GT(acb_rel_accuracy_bits(integral.raw()), 167); // 50 digits
    EXPECT_GT(acb_rel_accuracy_bits(exact.raw()), 167);
  }
}

} // namespace

// Twenty points in two tests.
TEST(Contours, AgreeWithTheResiduesToFiftyDigits) {
  std::mt19937 random(20240501);
  for (int n = 0; n < 10; ++n)
    expect_agreement(sliding_top(), random_point(random, false));
}

TEST(Contours, AgreeWithTheResiduesAtTenMorePoints) {
  std::mt19937 random(20240503);
  for (int n = 0; n < 10; ++n)
    expect_agreement(sliding_top(), random_point(random, false));
}

TEST(Contours, AgreeForTheHeavyTop) {
  std::mt19937 random(20240502);
  for (int n = 0; n < 5; ++n)
    expect_agreement(heavy_top(), random_point(random, true));
}
