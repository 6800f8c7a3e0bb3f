// "No obstruction" is said of the whole first variational equation, and not of its diagonal blocks.

#include "integrability/check.hpp"

#include "symbol/input_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace kov {
namespace {

using testing::HasSubstr;

ManifoldReport run(const std::string& text) {
  return check_system(read_system(parse_document(text, "test.toml"))).manifolds.at(0);
}

std::string all_reasons(const ManifoldReport& m) {
  std::string text;
  for (const auto& r : m.reasons)
    text += r + "\n";
  return text;
}

/// Along the plane (q1, p1) two normal blocks of the quartic potential, coupled by `coupling`.
std::string blocks(const std::string& coupling, const std::string& more = {}) {
  return R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2", "q3"]
momenta = ["p1", "p2", "p3"]
parameters = ["e"]
hamiltonian = "p1^2/2 + p2*p3 + q1^4/4 + q1^2*q2*q3 + )t" +
         coupling + R"t("
[[manifold]]
name = "plane"
equations = ["q2 = 0", "q3 = 0", "p2 = 0", "p3 = 0"]
level = "H = 1"
)t" + more;
}

// Duval and Maciejewski: a Jordan block at this eigenvalue forbids integrability, so that "no
// obstruction" would be false for every coupling that is not zero.
TEST(Coupling, ACoupledBlockIsNoAbelianGroup) {
  std::mt19937 generator(17);
  std::uniform_int_distribution<int> number(1, 9);
  for (int round = 0; round < 4; ++round) {
    const std::string c =
        std::to_string(number(generator)) + "/" + std::to_string(number(generator));
    for (const char* form : {"*q1^2*q2^2", "*q2^2", "*q1*q2^2", "*p3^2"}) {
      const ManifoldReport m = run(blocks(c + form));
      EXPECT_EQ(m.verdict, VerdictKind::undecided) << c << form;
      EXPECT_THAT(all_reasons(m), HasSubstr("what couples")) << c << form;
    }
  }
}

TEST(Coupling, WithoutOneTheBlocksAreTheWhole) {
  EXPECT_EQ(run(blocks("q2^3 + q3^4")).verdict, VerdictKind::no_obstruction); // of higher order
  EXPECT_EQ(run(blocks("0")).verdict, VerdictKind::no_obstruction);
  EXPECT_EQ(run(blocks("e*q1^2*q2^2")).verdict, VerdictKind::undecided);
  EXPECT_EQ(run(blocks("e*q1^2*q2^2", "[set]\ne = \"0\"\n")).verdict, VerdictKind::no_obstruction);
}

TEST(Coupling, AQuotientIsNotTheWhole) { // Hill's problem: a Lagrangian plane
  const ManifoldReport m = run(R"t([system]
kind = "hamiltonian"
coordinates = ["a", "b"]
momenta = ["A", "B"]
parameters = ["E", "c"]
constants = ["i"]
relations = ["i^2 = -1"]
hamiltonian = "A*B/2 - a*b*i*(a*A - b*B)/2 - a*b*(3*a^4 + 2*a^2*b^2 + 3*b^4)/8 - E*a*b"
[[manifold]]
name = "plane"
equations = ["a = 0", "B = 0"]
level = "A^2/4 - b^6/16 - E*b^2/2 = c"
)t");
  EXPECT_EQ(m.verdict, VerdictKind::undecided);
  EXPECT_THAT(all_reasons(m), HasSubstr("what couples"));
}

// y2 = exp(x^2), y1 = its integral, and t along the curve feels y1.
TEST(Coupling, TheTangentialPartOfAVectorField) {
  const auto field = [](const std::string& speed) {
    return "[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", \"y1\", \"y2\"]\n"
           "[system.field]\nx = \"" +
           speed +
           "\"\ny1 = \"0\"\ny2 = \"2*x*y2\"\n"
           "[[manifold]]\nname = \"m\"\nequations = [\"y1 = 0\", \"y2 = 0\"]\n";
  };
  EXPECT_EQ(run(field("1")).verdict, VerdictKind::no_obstruction);
  EXPECT_EQ(run(field("1 + y2")).verdict, VerdictKind::undecided); // the integral of exp(x^2)
}

} // namespace
} // namespace kov
