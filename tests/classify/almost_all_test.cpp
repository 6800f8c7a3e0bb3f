// Matrices at one point of the parameters, and what they say of the others.

#include "classify/almost_all.hpp"
#include "classify/classify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::almost_all_test {
namespace {

using testing::HasSubstr;
using testing::Not;

SystemClassification classified(const std::string& text) {
  ClassifyOptions options;
  options.check.decide.budget.give(1e8 * 60);
  options.degree = 2;
  return classify_system(read_system(parse_document(text, "test.toml")), options);
}

// A rigid body on a circular orbit.
std::string satellite(const std::string& more, const std::string& a = "a") {
  return R"t([system]
kind = "poisson"
coordinates = ["M1", "M2", "M3", "G1", "G2", "G3", "S1", "S2", "S3"]
parameters = ["a", "b", "c"]
hamiltonian = "(M1^2/)t" +
         a + R"t( + M2^2/b + M3^2/c)/2 - M1*S1 - M2*S2 - M3*S3 + 3*(a*G1^2 + b*G2^2 + c*G3^2)/2"
bracket = [["0", "-M3", "M2", "0", "-G3", "G2", "0", "-S3", "S2"],
  ["M3", "0", "-M1", "G3", "0", "-G1", "S3", "0", "-S1"],
  ["-M2", "M1", "0", "-G2", "G1", "0", "-S2", "S1", "0"],
  ["0", "-G3", "G2", "0", "0", "0", "0", "0", "0"],
  ["G3", "0", "-G1", "0", "0", "0", "0", "0", "0"],
  ["-G2", "G1", "0", "0", "0", "0", "0", "0", "0"],
  ["0", "-S3", "S2", "0", "0", "0", "0", "0", "0"],
  ["S3", "0", "-S1", "0", "0", "0", "0", "0", "0"],
  ["-S2", "S1", "0", "0", "0", "0", "0", "0", "0"]]
)t" + more;
}
const char* const positive = "[assume]\nconditions = [\"a > 0\", \"b > 0\", \"c > 0\"]\n";

TEST(AlmostAll, ASatelliteOnACircularOrbit) {
  const auto c = classified(satellite(positive));
  EXPECT_EQ(c.status(), Verdict::undecided);
  ASSERT_TRUE(c.almost_all);
  EXPECT_EQ(c.almost_all->at, "a = 2, b = 3, c = 5");
  EXPECT_THAT(statement(c), HasSubstr("For almost all parameters (all but a set of measure zero"));
  EXPECT_THAT(statement(c), HasSubstr("on the symplectic leaf"));
}

// Equations between parameters and rational values are sets of measure zero themselves.
TEST(AlmostAll, NotWhereTheParametersAreFew) {
  for (const char* conditions :
       {"conditions = [\"a = b + 1\", \"b > 0\", \"c > 0\"]",
        "a = \"rational\"\nconditions = [\"a > 0\", \"b > 0\", \"c > 0\"]",
        "conditions = [\"a < 0\", \"b < 0\", \"c > 0\"]"}) { // no point is tried there
    const auto c = classified(satellite(std::string("[assume]\n") + conditions + "\n"));
    EXPECT_FALSE(c.almost_all) << conditions;
    EXPECT_THAT(statement(c), Not(HasSubstr("almost all"))) << conditions;
  }
}

// The set is invariant for a = 2 only, the first number that is tried: not a family of solutions.
TEST(AlmostAll, AlongSolutionsThatExistForAllParameters) {
  const System s = read_system(parse_document(R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2", "q3"]
momenta = ["p1", "p2", "p3"]
parameters = ["a"]
hamiltonian = "p1^2/2 + p2*p3 + q1^4/4 + q1^2*q2*q3 + q1^2*q2^2 + (a - 2)*q2*q1^3"
[[manifold]]
name = "plane"
equations = ["q2 = 0", "q3 = 0", "p2 = 0", "p3 = 0"]
level = "H = 1"
)t",
                                              "test.toml"));
  EXPECT_FALSE(almost_all(s, s.manifolds, {}, {}, {}));
  System through = s;
  const MFraction a = MFraction::variable(s.ring(), "a");
  through.field.components[4] +=
      (a - MFraction(s.ring(), Rational(2))) * pow(MFraction::variable(s.ring(), "q1"), 3);
  EXPECT_TRUE(almost_all(through, s.manifolds, {}, {}, {}));
}

} // namespace
} // namespace kov::almost_all_test
