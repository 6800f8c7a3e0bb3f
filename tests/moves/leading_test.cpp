#include "moves/leading.hpp"

#include "families.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

std::optional<std::string> lowest(const System& s) {
  const auto part = leading_part(s);
  if (!part) return std::nullopt;
  return to_string(*part->system.field.hamiltonian);
}

// Weights 1 for M and 2 for Gamma: the weight of the body, and nothing of higher order.
TEST(LeadingPart, APotentialOfHigherDegree) {
  const System s = on_e3("'a', 'k'", "(M1^2 + M2^2 + 2*M3^2)/2 + a*G1 + k*G3^2");
  EXPECT_EQ(*leading_part(s)->system.field.hamiltonian,
            formula(s, "(M1^2 + M2^2 + 2*M3^2)/2 + a*G1"));
}

TEST(LeadingPart, WhatIsHomogeneousHasNone) {
  EXPECT_FALSE(lowest(heavy_top_family()));
  EXPECT_FALSE(lowest(on_e3("'k'", "(M1^2 + M2^2 + 2*M3^2)/2 + k*G3^2")));
  EXPECT_FALSE(lowest(on_e3("", "(M1^2 + M2^2 + 2*M3^2)/2")));
}

// A rotor: M alone is of the lowest order.
TEST(LeadingPart, ALinearTermInTheMomentum) {
  const System s = on_e3("'k'", "(M1^2 + M2^2 + 2*M3^2)/2 + k*M3 + G1");
  const auto part = leading_part(s);
  ASSERT_TRUE(part);
  EXPECT_EQ(*part->system.field.hamiltonian,
            formula(s, "k*M3 + G1")); // integrable: it says nothing
}

TEST(LeadingPart, APoleAtTheOrigin) {
  EXPECT_FALSE(lowest(on_e3("'a'", "(M1^2 + M2^2 + 2*M3^2)/2 + a*G1 + 1/G3")));
  const System s = on_e3("'a', 'b'", "(M1^2 + M2^2 + 2*M3^2)/2 + a*G1 + G2^2/(b + G3)");
  const auto part = leading_part(s);
  ASSERT_TRUE(part);
  EXPECT_EQ(to_string(part->nonzero), "b"); // where it has one nothing is said
}

// The terms of the largest weight: what is left of a rotor is the heavy top, of a potential its highest power.
TEST(HighestPart, OfPolynomials) {
  const auto highest = [](const System& s, const std::string& expected) {
    const auto part = leading_part(s, Order::highest);
    return part && *part->system.field.hamiltonian == formula(s, expected);
  };
  const std::string body = "(M1^2 + M2^2 + 2*M3^2)/2 + ";
  EXPECT_TRUE(highest(on_e3("'k'", body + "k*M3 + G1 + k^2"), body + "G1"));
  EXPECT_TRUE(highest(on_e3("'a'", body + "a*G1 + G3^2 + a*M2"), body + "G3^2"));
  EXPECT_TRUE(highest(on_e3("'a'", body + "a*G1 + G3^3"), body + "G3^3"));
  EXPECT_TRUE(highest(on_e3("'a'", body + "a*M1*G3 + a*G1"), body + "a*M1*G3") ||
              highest(on_e3("'a'", body + "a*M1*G3 + a*G1"), "a*M1*G3"));
  EXPECT_FALSE(leading_part(heavy_top_family(), Order::highest)); // homogeneous
  EXPECT_FALSE(leading_part(on_e3("'a'", body + "a*G1/(2 + G3)"), Order::highest));
}

TEST(LeadingPart, OtherBracketsHaveOtherWeights) {
  EXPECT_FALSE(lowest(in_the_plane("'a'", "(p1^2 + p2^2)/2 + a*q1^2*q2 + q2^4")));
}

ClassifiedStratum excluded(const System& s, const std::string& level) {
  Set all(s.ring(), s.field.parameters);
  ClassifiedStratum x{.where = all, .status = StratumStatus::excluded};
  x.by = {{.solution = "a curve", .level = {}, .order = 1, .reason = "a reason", .unchecked = ""}};
  x.by.front().integrals.on_leaf = true;
  ManifoldSpec m;
  m.name = "a curve";
  m.levels = {{formula(s, level), level + " = 0"}};
  x.along = m;
  return x;
}

// One leaf says something of the phase space only if the Casimir functions are independent there.
TEST(LeadingPart, OnlyFromRegularLeaves) {
  const System s = on_e3("'a', 'k'", "(M1^2 + M2^2 + 2*M3^2)/2 + a*G1 + k*G3^2");
  const auto part = *leading_part(s);
  const std::string square = "G1^2 + G2^2 + G3^2";
  const auto said = said_by(s, part, excluded(s, square + " - 1"));
  ASSERT_TRUE(said);
  EXPECT_EQ(said->stratum.by.front().integrals.near, IntegralClass::Near::origin);
  EXPECT_FALSE(said->stratum.by.front().integrals.on_leaf);
  EXPECT_FALSE(said_by(s, part, excluded(s, square)));
  EXPECT_FALSE(said_by(s, part, excluded(s, "M1*G1 + M2*G2 + M3*G3 - 1")));
}

// Real-analytic functions on the real phase space: rational ones have poles.
TEST(HighestPart, ExcludesRationalIntegralsOnly) {
  const System s = on_e3("'k'", "(M1^2 + M2^2 + 2*M3^2)/2 + k*M3 + G1");
  const auto part = leading_part(s, Order::highest);
  ASSERT_TRUE(part);
  const auto said = said_by(s, *part, excluded(part->system, "G1^2 + G2^2 + G3^2 - 1"));
  ASSERT_TRUE(said);
  EXPECT_EQ(sentence(said->stratum.by.front().integrals), "rational");
  EXPECT_FALSE(said_by(s, *part, excluded(part->system, "G1^2 + G2^2 + G3^2")));
}

TEST(LeadingPart, TheClassHasAllRationalIntegrals) {
  const System s = on_e3("'a', 'k'", "(M1^2 + M2^2 + 2*M3^2)/2 + a*G1 + k*G3^2");
  const auto part = *leading_part(s);
  const auto with = [&](const auto& change) {
    auto x = excluded(s, "G1^2 + G2^2 + G3^2 - 1");
    change(x.by.front().integrals);
    return said_by(s, part, x).has_value();
  };
  EXPECT_TRUE(with([](IntegralClass& c) { c.near = IntegralClass::Near::closed_curve; }));
  EXPECT_FALSE(with([](IntegralClass& c) { c.kind = IntegralClass::Kind::real_analytic; }));
  EXPECT_FALSE(with([](IntegralClass& c) { c.without = {"M1"}; }));
  EXPECT_FALSE(with([](IntegralClass& c) { c.near = IntegralClass::Near::level; }));
}

} // namespace
} // namespace kov
