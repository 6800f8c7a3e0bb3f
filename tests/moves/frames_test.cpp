#include "moves/frames.hpp"

#include "families.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

const std::string symmetric_top = "(M1^2 + M2^2)/(2*A) + M3^2/(2*C)";
const std::string symmetric_assumed =
    "[assume]\nA = 'positive'\nC = 'positive'\nL1 = 'real'\nL2 = 'real'\nL3 = 'real'\n";

System symmetric_family(const std::string& assume = symmetric_assumed) {
  return on_e3("'A', 'C', 'L1', 'L2', 'L3'", symmetric_top + " + " + weight, assume);
}

TEST(Frames, TwoEqualMoments) {
  const System s = symmetric_family();
  const auto frame = find_frame(s);
  ASSERT_TRUE(frame);
  const std::string zero = s.ring()->name(frame->vanishing);
  EXPECT_TRUE(zero == "L2" || zero == "L1");
  EXPECT_TRUE(frame->to.real);
  EXPECT_TRUE(holds(s, frame->to));
  const MPoly l1 = MPoly::variable(s.ring(), "L1"), l2 = MPoly::variable(s.ring(), "L2"),
              l3 = MPoly::variable(s.ring(), "L3");
  EXPECT_EQ(frame->to.square, l1 * l1 + l2 * l2);
  // the preimage of "the other one is not 0" is L1^2 + L2^2 != 0, of an equation in its square the same
  const MPoly other = zero == "L2" ? l1 : l2;
  EXPECT_EQ(*pulled_back(frame->to, other * other - l3), l1 * l1 + l2 * l2 - l3);
  EXPECT_FALSE(pulled_back(frame->to, other - l3)); // r and -r have different ones
}

// Conditions on r itself: an equation holds for r or for -r, an inequation has to hold for both.
TEST(Frames, StrataThatKnowTheSignOfTheRoot) {
  const System s = symmetric_family();
  const auto frame = find_frame(s);
  ASSERT_TRUE(frame);
  const auto x = [&](const char* name) { return MPoly::variable(s.ring(), name); };
  const MPoly other = s.ring()->name(frame->vanishing) == "L2" ? x("L1") : x("L2");
  const MPoly square = frame->to.square;
  const MPoly one(s.ring(), Integer(1)), two(s.ring(), Integer(2));
  std::vector<std::size_t> parameters;
  for (const char* name : {"A", "C", "L1", "L2", "L3"})
    parameters.push_back(s.ring()->index(name));
  const Set in_frame =
      Set(s.ring(), parameters).where_zero(MPoly::variable(s.ring(), frame->vanishing));
  const auto stratum = [](Set where) {
    return ClassifiedStratum{.where = std::move(where), .status = StratumStatus::excluded};
  };
  const auto away = carried(s, frame->to, stratum(in_frame.where_nonzero(other - one)));
  ASSERT_TRUE(away);
  EXPECT_THAT(away->not_all_zero,
              testing::Contains(testing::ElementsAre(testing::AnyOf(square - one, one - square))));
  const auto at = carried(s, frame->to, stratum(in_frame.where_zero(other - two)));
  ASSERT_TRUE(at);
  EXPECT_THAT(at->zero,
              testing::ElementsAre(testing::AnyOf(square - two * two, two * two - square)));
  // two equations may ask for different signs: nothing is carried
  const MPoly first = x("A") * other - x("L3"), second = x("L3") * other - x("C");
  const Set two_signs = in_frame.where_zero(first).where_zero(second);
  ASSERT_GE(two_signs.equations().size(), 4U);
  EXPECT_FALSE(carried(s, frame->to, stratum(two_signs)));
}

// Three different moments have none, and a free parameter of the tensor does not hide the rotation.
TEST(Frames, ThreeDifferentMomentsHaveNone) { EXPECT_FALSE(find_frame(heavy_top_family())); }

TEST(Frames, ARotorTurnsWithTheBody) {
  const System s = on_e3("'A', 'C', 'L1', 'L2', 'L3', 'k1', 'k2', 'k3'",
                         symmetric_top + " + " + weight + " + k1*M1 + k2*M2 + k3*M3");
  const auto frame = find_frame(s);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->to.parameters.size(), 4U);
  EXPECT_FALSE(frame->to.real); // nothing says so
}

// What is assumed of the parameters does not turn with them.
TEST(Frames, AssumptionsForbidTheRotation) {
  EXPECT_FALSE(find_frame(symmetric_family(symmetric_assumed + "conditions = ['L1 > 0']\n")));
  EXPECT_FALSE(find_frame(symmetric_family(symmetric_assumed + "conditions = ['L1 > L2']\n")));
  EXPECT_TRUE(find_frame(symmetric_family(symmetric_assumed + "conditions = ['L3 > 0']\n")));
}

// A field that depends on the parameters is not a flow of linear maps: it is not used.
TEST(Frames, OnlyConstantRotations) {
  const System s = symmetric_family();
  for (const InfinitesimalSymmetry& y : infinitesimal_symmetries(s))
    for (const auto& [p, value] : y.moving)
      EXPECT_TRUE(uses(*s.field.hamiltonian, p));
  const System one = on_e3("'A', 'C', 'L1', 'L3'", symmetric_top + " + L1*G1 + L3*G3");
  EXPECT_FALSE(find_frame(one)); // it would leave the family
}

// The opposite rotation is not an equivalence: an asymmetric case.
TEST(Frames, TheDirectionOfTheRotation) {
  const System s = symmetric_family();
  auto frame = find_frame(s);
  ASSERT_TRUE(frame);
  const std::size_t m1 = s.ring()->index("M1"), m2 = s.ring()->index("M2");
  Equivalence wrong = frame->to;
  for (MFraction& f : wrong.phase) // M2, G2 -> -M2, -G2 before and after
    f = substitute(f, {{m2, -MFraction::variable(wrong.ring, m2)},
                       {s.ring()->index("G2"), -MFraction::variable(wrong.ring, "G2")}});
  wrong.phase[1] = -wrong.phase[1];
  wrong.phase[4] = -wrong.phase[4];
  EXPECT_FALSE(holds(s, wrong));
  EXPECT_TRUE(uses(frame->to.phase[0], m1));
}

} // namespace
} // namespace kov
