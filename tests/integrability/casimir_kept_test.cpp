// The variation of a Casimir function kept: what the symplectic leaf does not see.
// docs/theory/mechanics.md (9.9)

#include "integrability/conclude.hpp"
#include "support/checked.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::casimir_kept_test {
namespace {

using testing::HasSubstr;

// Two equal moments, L in their plane, the third moment 1/c, on the energy h.
ManifoldReport top(const std::string& c, const std::string& h, const std::string& change,
                   const std::string& on = "\"M1 = 0\", \"M3 = 0\", \"G2 = 0\"") {
  const std::string text = R"(
format = "equation/1"
[system]
kind = "euler-poisson"
coordinates = ["M1", "M2", "M3", "G1", "G2", "G3"]
hamiltonian = "(M1^2 + M2^2 + )" +
                           c + R"(*M3^2)/2 + G1"
[[casimir]]
name = "F1"
value = "G1^2 + G2^2 + G3^2"
[[casimir]]
name = "F2"
value = "M1*G1 + M2*G2 + M3*G3"
[[manifold]]
name = "N"
equations = [)" + on + R"(]
level = ["F1 = 1", "H = )" +
                           h +
                           R"("]
[reduce]
manifold = "N"
variable = "M1"
change = ")" + change + R"("
)";
  return test::checked(text);
}
const std::string rational = "z = G3/(1 + G1)";

TEST(CasimirKept, GoryachevAndChaplyginAreExcludedOnTheWholePhaseSpace) {
  const ManifoldReport m = top("4", "1", rational);
  EXPECT_EQ(m.blocks.at(0).abelian, Truth::yes); // the leaf says nothing
  ASSERT_NE(m.matrices, nullptr);
  EXPECT_TRUE(m.matrices->keeps_casimirs);
  EXPECT_EQ(m.verdict, Verdict::non_integrable);
  EXPECT_EQ(m.by->id(), "Ayoul-Zung");
  EXPECT_EQ(sentence(m.by->integrals), "meromorphic");
  EXPECT_TRUE(m.by->integrals.liouville);
  EXPECT_THAT(statement(m), HasSubstr("Liouville"));
  EXPECT_FALSE(trusted_steps(m).empty()); // the way to the matrices
}

// Kovalevskaya and the ball: integrable, with integrals of the whole phase space.
TEST(CasimirKept, IntegrableTopsStay) {
  for (const char* c : {"2", "1"}) {
    const ManifoldReport m = top(c, "1", rational);
    EXPECT_EQ(m.matrices, nullptr) << c;
    EXPECT_NE(m.verdict, Verdict::non_integrable) << c;
  }
}

// On every energy: at 0 in another variable.
TEST(CasimirKept, AtAnotherEnergy) {
  const ManifoldReport m = top("4", "0", "z = G1");
  ASSERT_NE(m.matrices, nullptr);
  EXPECT_TRUE(m.matrices->keeps_casimirs);
}

// A finite group on the leaf leaves a vector group: nothing is asked.  (M3 along the axis, energy 0.)
TEST(CasimirKept, NothingFollowsFromAFiniteGroup) {
  const ManifoldReport m = top("4", "0", "z = G1", "\"M1 = 0\", \"M2 = 0\", \"G3 = 0\"");
  EXPECT_EQ(m.blocks.at(0).abelian, Truth::yes);
  EXPECT_EQ(m.matrices, nullptr);
  EXPECT_NE(m.verdict, Verdict::non_integrable);
}

} // namespace
} // namespace kov::casimir_kept_test
