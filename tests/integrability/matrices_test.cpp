// Certified matrices of a block of order three and more: on the symplectic leaf.

#include "support/checked.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::matrices_test {
namespace {

using testing::ElementsAre;

ManifoldReport run(const std::string& text) { return test::checked(text); }

/// A rigid body on a circular orbit: M the angular momentum, G the direction to the centre, S that
/// of the normal of the orbit, all in the axes of the body.
std::string satellite(const std::string& a, const std::string& b, const std::string& c,
                      const std::string& more) {
  return R"t([system]
kind = "poisson"
coordinates = ["M1", "M2", "M3", "G1", "G2", "G3", "S1", "S2", "S3"]
hamiltonian = "(M1^2/)t" +
         a + " + M2^2/" + b + " + M3^2/" + c + ")/2 - M1*S1 - M2*S2 - M3*S3 + 3*(" + a +
         "*G1^2 + " + b + "*G2^2 + " + c + R"t(*G3^2)/2"
bracket = [["0", "-M3", "M2", "0", "-G3", "G2", "0", "-S3", "S2"],
  ["M3", "0", "-M1", "G3", "0", "-G1", "S3", "0", "-S1"],
  ["-M2", "M1", "0", "-G2", "G1", "0", "-S2", "S1", "0"],
  ["0", "-G3", "G2", "0", "0", "0", "0", "0", "0"],
  ["G3", "0", "-G1", "0", "0", "0", "0", "0", "0"],
  ["-G2", "G1", "0", "0", "0", "0", "0", "0", "0"],
  ["0", "-S3", "S2", "0", "0", "0", "0", "0", "0"],
  ["S3", "0", "-S1", "0", "0", "0", "0", "0", "0"],
  ["-S2", "S1", "0", "0", "0", "0", "0", "0", "0"]]
[[manifold]]
name = "in the orbital plane"
equations = ["M1 = 0", "M2 = 0", "G3 = 0", "S1 = 0", "S2 = 0", "S3 = 1"]
level = ["G1^2 + G2^2 = 1", "H = 1"]
)t" + more;
}

const char* const casimirs = R"t([[casimir]]
value = "S1^2 + S2^2 + S3^2"
[[casimir]]
value = "G1*S1 + G2*S2 + G3*S3"
[[casimir]]
value = "G1^2 + G2^2 + G3^2"
)t";

TEST(Matrices, OfANormalBlockOfOrderFour) {
  const ManifoldReport m = run(satellite("2", "3", "4", casimirs));
  EXPECT_EQ(m.verdict, Verdict::non_integrable);
  ASSERT_TRUE(m.matrices);
  EXPECT_THAT(m.matrices->part, ElementsAre("M1", "M2", "G3", "S1"));
  EXPECT_EQ(m.by->integrals.near, IntegralClass::Near::curve);
}

TEST(Matrices, NothingOfABlockThatTheLeafDoesNotSee) {
  const ManifoldReport m = run(satellite("2", "3", "4", ""));
  EXPECT_EQ(m.verdict, Verdict::undecided);
  EXPECT_FALSE(m.matrices);
}

TEST(Matrices, TheRoundSatelliteIsIntegrable) {
  EXPECT_NE(run(satellite("2", "2", "2", casimirs)).verdict, Verdict::non_integrable);
}

// y2 is of degree two in y1 and the constant: the standard monomials are not products.
TEST(Matrices, OverAQuadraticField) {
  const ManifoldReport m = run(R"t([system]
kind = "hamiltonian"
coordinates = ["x1", "y1", "x2", "y2"]
momenta = ["u1", "v1", "u2", "v2"]
constants = ["k"]
relations = ["k^2 = 5"]
hamiltonian = """(u1^2 + v1^2 + u2^2 + v2^2)/2 - y1 - y2
  + (sqrt(x1^2 + y1^2) - 1)^2/2 + (sqrt((x2 - x1)^2 + (y2 - y1)^2) - 1)^2/2"""
[[manifold]]
name = "mode"
equations = ["y2 - 5 = (k + 1)/2*(y1 - 3)", "v2 = (k + 1)/2*v1", "x1 = 0", "x2 = 0", "u1 = 0",
             "u2 = 0", "root1 = y1", "root2 = y2 - y1"]
level = ["H = 1"]
)t");
  EXPECT_EQ(m.verdict, Verdict::non_integrable);
  ASSERT_TRUE(m.matrices);
  EXPECT_EQ(m.matrices->size, 8);
}

/// Integrable on the leaf c = 1 and, by its variations beside this leaf, not near it.
std::string on_a_leaf(const std::string& kind) {
  return "[system]\nkind = \"" + kind + R"t("
coordinates = ["q1", "p1", "q2", "p2", "c"]
)t" +
         (kind == "poisson" ? R"t(hamiltonian = "(p1^2 + p2^2)/2 + q1^4/4 + (c - 1)*q1^2*q2"
bracket = [["0", "1", "0", "0", "0"], ["-1", "0", "0", "0", "0"],
  ["0", "0", "0", "1", "0"], ["0", "0", "-1", "0", "0"], ["0", "0", "0", "0", "0"]]
)t"
                            : R"t([system.field]
q1 = "p1"
p1 = "-q1^3 - 2*(c - 1)*q1*q2"
q2 = "p2"
p2 = "-(c - 1)*q1^2"
c = "0"
)t") + R"t([[manifold]]
name = "m"
equations = ["q2 = 0", "p2 + c = 1", "c + q2 = 1"]
level = "p1^2/2 + q1^4/4 = 1"
)t";
}

TEST(Matrices, ABlockMayMixTheLeafWithItsNeighbours) {
  EXPECT_NE(run(on_a_leaf("poisson")).verdict, Verdict::non_integrable);
  const ManifoldReport m = run(on_a_leaf("vector-field"));
  EXPECT_EQ(m.verdict, Verdict::non_integrable);
}

} // namespace
} // namespace kov::matrices_test
