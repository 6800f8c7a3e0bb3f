#include "moves/discrete.hpp"

#include "families.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace kov {
namespace {

struct Counts {
  std::size_t maps, pairs, sigmas;
  friend bool operator==(const Counts&, const Counts&) = default;
};
void PrintTo(const Counts& c, std::ostream* out) {
  *out << c.maps << "/" << c.pairs << "/" << c.sigmas;
}

Counts counts(const System& s) {
  std::set<std::pair<std::vector<std::size_t>, std::vector<int>>> maps;
  std::set<std::string> sigmas;
  const auto all = family_symmetries(s);
  for (const FamilySymmetry& y : all) {
    maps.emplace(y.place, y.sign);
    sigmas.insert(in_words(equivalence(s, y)));
  }
  return {maps.size(), all.size(), sigmas.size()};
}

// The numbers of an independent program.
TEST(FamilySymmetries, CountsOfKnownFamilies) {
  EXPECT_EQ(counts(heavy_top_family()), (Counts{96, 96, 48}));
  EXPECT_EQ(counts(on_e3("'A', 'B', 'C', 'L1', 'L2', 'L3', 'k1', 'k2', 'k3'",
                         free_top + " + " + weight + " + k1*M1 + k2*M2 + k3*M3")),
            (Counts{96, 96, 96}));
  EXPECT_EQ(counts(in_the_plane("'u', 'v', 'w'",
                                "(p1^2 + p2^2)/2 + (u*q1^2 + v*q2^2)/2 + q1^2*q2 + w*q2^3/3")),
            (Counts{4, 4, 1}));
  EXPECT_EQ(counts(in_the_plane("'a', 'b', 'c', 'd'", "(p1^2 + p2^2)/2 + a*q1^3 + b*q1^2*q2 + "
                                                      "c*q1*q2^2 + d*q2^3")),
            (Counts{16, 16, 8}));
}

TEST(FamilySymmetries, KirchhoffHasThreeAxesAndOneSign) {
  EXPECT_EQ(counts(on_e3("'a1', 'a2', 'a3', 'b1', 'b2', 'b3', 'c1', 'c2', 'c3'",
                         "(a1*M1^2 + a2*M2^2 + a3*M3^2 + c1*G1^2 + c2*G2^2 + c3*G3^2)/2 + "
                         "b1*M1*G1 + b2*M2*G2 + b3*M3*G3")),
            (Counts{96, 96, 12}));
}

// (g, L) -> (-g, -L) does nothing to products of the two.
TEST(FamilySymmetries, AParameterMapNeedNotBeUnique) {
  const System s =
      on_e3("'A', 'B', 'C', 'g', 'L1', 'L2', 'L3'", free_top + " + g*(" + weight + ")");
  EXPECT_EQ(counts(s), (Counts{96, 192, 96}));
}

// H(phi x; p) = -H(x; sigma p) is not looked for: a level H = 1 would not stay.
TEST(FamilySymmetries, TheHamiltonianKeepsItsSign) {
  const System s = in_the_plane("'a'", "p1*p2 + a*q1*q2");
  for (const FamilySymmetry& y : family_symmetries(s))
    EXPECT_TRUE(y.parameters.empty()) << in_words(equivalence(s, y));
}

TEST(FamilySymmetries, EachIsAnEquivalence) {
  const System s = heavy_top_family();
  for (const FamilySymmetry& y : family_symmetries(s))
    EXPECT_TRUE(holds(s, equivalence(s, y))) << in_words(equivalence(s, y));
}

// Asymmetric ones: integrable where a certain body is, but a wrong direction of the map does not show
// where it is its own inverse.
TEST(FamilySymmetries, ACyclicPermutationMovesInOneDirection) {
  const System s = heavy_top_family();
  const Ring& ring = s.ring();
  const MFraction a = MFraction::variable(ring, "A"), b = MFraction::variable(ring, "B"),
                  c = MFraction::variable(ring, "C");
  for (const FamilySymmetry& y : family_symmetries(s)) {
    const Equivalence e = equivalence(s, y);
    const auto at = [&](const MFraction& f) { return substitute(f, e.parameters); };
    if (!(at(a) == b && at(b) == c && at(c) == a)) continue;
    // Phi takes the axis of the moment at p to the axis of the same moment at sigma p
    EXPECT_TRUE(holds(s, e));
    Equivalence wrong = e; // the inverse of Phi with the same sigma
    for (std::size_t k = 0; k < 6; ++k)
      wrong.phase[k] =
          Rational(y.sign[k]) * MFraction::variable(ring, s.field.coordinates[y.place[k]]);
    EXPECT_FALSE(holds(s, wrong));
    return;
  }
  FAIL() << "no cyclic permutation";
}

TEST(FamilySymmetries, AssumptionsCutTheOrbit) {
  const auto kept = [](const std::string& more) {
    const System s = heavy_top_family(body_assumed + more);
    std::set<std::string> all;
    for (const FamilySymmetry& y : family_symmetries(s))
      if (keeps_assumptions(s, y)) all.insert(in_words(equivalence(s, y)));
    return all.size();
  };
  EXPECT_EQ(kept(""), 48U);
  EXPECT_EQ(kept("conditions = ['A > B']"), 8U); // signs of L
  EXPECT_EQ(kept("conditions = ['A >= B', 'B >= C']"), 8U);
  EXPECT_EQ(kept("conditions = ['A + B >= C', 'B + C >= A', 'C + A >= B']"), 48U);
  EXPECT_EQ(kept("conditions = ['L1 > 0']"), 8U); // the other two axes, and their signs
  EXPECT_EQ(kept("conditions = ['L1 != L2']"), 8U);
}

TEST(FamilySymmetries, AComplexParameterIsNoImageOfARealOne) {
  const System s = heavy_top_family("[assume]\nA = 'positive'\nB = 'positive'\nC = 'positive'\n"
                                    "L1 = 'real'\n");
  for (const FamilySymmetry& y : family_symmetries(s))
    if (keeps_assumptions(s, y)) {
      EXPECT_EQ(substitute(MFraction::variable(s.ring(), "A"), y.parameters),
                MFraction::variable(s.ring(), "A"));
    }
}

} // namespace
} // namespace kov
