// The unknown of second order may be a combination of two, where that has fewer apparent singularities.

#include "support/checked.hpp"

#include <gtest/gtest.h>

namespace kov::cyclic_vector_test {
namespace {

// A symmetric top with moments 1, 1, C that slides without friction or gravity, its centre of mass at (1, 0, L3).
std::string sliding(const std::string& more) {
  return R"t([system]
kind = "lagrangian"
coordinates = ["M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"]
angular_velocity = ["Omega1", "Omega2", "Omega3"]
parameters = ["C", "L3", "h"]
lagrangian = "(Omega1^2 + Omega2^2 + C*Omega3^2)/2 + (Gamma1*Omega2*L3 + Gamma2*(Omega3 - Omega1*L3) - Gamma3*Omega2)^2/2"
[[casimir]]
name = "F1"
value = "Gamma1^2 + Gamma2^2 + Gamma3^2"
[[casimir]]
name = "F2"
value = "M1*Gamma1 + M2*Gamma2 + M3*Gamma3"
[[manifold]]
name = "N"
equations = ["M1 = 0", "M3 = 0", "Gamma2 = 0"]
level = ["F1 = 1", "H = h"]
)t" + more;
}
const std::string change = "[reduce]\nchange = 'z = Gamma3/(1 + Gamma1)'\n";
const std::string assumed =
    "[assume]\nL3 = 'real'\nconditions = ['C > 0', 'C != 1', 'L3 != 0', 'h != 0']\n";

BlockReport block(const std::string& text) {
  CheckOptions options;
  options.decide.want_certificate = true;
  return test::checked(text, options).blocks.at(0);
}

TEST(CyclicVector, IsTheMomentumAlongTheCentreOfMass) {
  const BlockReport b = block(sliding(assumed + change));
  ASSERT_TRUE(b.ode);
  EXPECT_EQ(b.ode->unknown, "M1 + L3*M3");
  EXPECT_EQ(b.ode->singular_places, 6); // z^2 + 1 and a polynomial of degree 4
  EXPECT_EQ(b.abelian, Truth::no);      // for all C and L3 at once
}

TEST(CyclicVector, GivesTheGroupOfEachUnknown) {
  for (const char* values : {"C = '3'\nL3 = '1/2'\nh = '1'\n", "C = '1/2'\nL3 = '2'\nh = '2'\n",
                             "C = '5'\nL3 = '-3'\nh = '1/3'\n"}) {
    const std::string set = "[set]\n" + std::string(values);
    const BlockReport combined = block(sliding(set + change));
    const BlockReport alone = block(sliding(set + change + "variable = 'M1'\n"));
    ASSERT_TRUE(combined.decision && alone.decision) << values;
    EXPECT_NE(combined.ode->unknown, "M1") << values;
    EXPECT_EQ(alone.ode->unknown, "M1") << values;
    EXPECT_LT(combined.ode->singular_places, alone.ode->singular_places) << values;
    EXPECT_EQ(combined.abelian, alone.abelian) << values;
    EXPECT_EQ(combined.decision->group->type, alone.decision->group->type) << values;
  }
}

TEST(CyclicVector, HasACertificateOfTheWholeWay) {
  const BlockReport b = block(sliding("[set]\nC = '3'\nL3 = '1/2'\nh = '1'\n" + change));
  EXPECT_TRUE(b.way) << sentence(b.no_way.value_or(NoWay{}));
  EXPECT_FALSE(b.no_way);
}

TEST(CyclicVector, TheUnknownOfTheFileStays) {
  const BlockReport b =
      block(sliding("[set]\nC = '3'\nL3 = '1/2'\nh = '1'\n" + change + "variable = 'M3'\n"));
  ASSERT_TRUE(b.ode);
  EXPECT_EQ(b.ode->unknown, "M3");
}

} // namespace
} // namespace kov::cyclic_vector_test
