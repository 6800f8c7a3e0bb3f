// "No obstruction" is said of the whole first variational equation, and not of its diagonal blocks.

#include "support/checked.hpp"
#include "symbol/input_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace kov::coupling_test {
namespace {

using testing::HasSubstr;

ManifoldReport run(const std::string& text) { return test::checked(text); }

std::string all_reasons(const ManifoldReport& m) {
  std::string text;
  for (const auto& r : reasons(m))
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
// obstruction" would be false for every coupling that is not zero.  The matrices of the whole prove
// it where they have size <= 8.
TEST(Coupling, ACoupledBlockIsNoAbelianGroup) {
  std::mt19937 generator(17);
  std::uniform_int_distribution<int> number(1, 9);
  const std::string c = std::to_string(number(generator)) + "/" + std::to_string(number(generator));
  for (const char* form : {"*q1^2*q2^2", "*p3^2"}) {
    const ManifoldReport m = run(blocks(c + form));
    EXPECT_EQ(m.verdict, Verdict::non_integrable) << c << form;
    EXPECT_TRUE(m.matrices) << c << form;
    EXPECT_EQ(m.by->integrals.near, IntegralClass::Near::curve);
  }
  for (const char* form : {"*q2^2", "*q1*q2^2"}) {
    const ManifoldReport m = run(blocks(c + form));
    EXPECT_NE(m.verdict, Verdict::no_obstruction) << c << form;
  }
}

TEST(Coupling, OneLevelIsEnoughForTheMatrices) {
  std::string text = blocks("q1^2*q2^2");
  text.replace(text.find("H = 1"), 5, "H = e");
  const ManifoldReport m = run(text);
  EXPECT_EQ(m.verdict, Verdict::non_integrable);
  ASSERT_TRUE(m.matrices);
  EXPECT_EQ(sentence(m.matrices->level), "e = 1");
}

// At a = 0 this is integrable, and the matrices do not show a.
TEST(Coupling, AParameterThatTheMatricesDoNotShow) {
  const std::string text = R"t([system]
kind = "vector-field"
coordinates = ["x", "y", "w1", "w2", "w3"]
parameters = ["a"]
[system.field]
x = "x"
y = "-y"
w1 = "w2*a/(y + a)"
w2 = "w3*y/(y + a)"
w3 = "0"
[[manifold]]
name = "m"
equations = ["w1 = 0", "w2 = 0", "w3 = 0"]
level = "x*y = a"
[reduce]
change = "z = x"
)t";
  EXPECT_EQ(run(text).verdict, Verdict::undecided);
}

TEST(Coupling, TheLevelIsOneThatIsAssumed) {
  std::string text = blocks("q1^2*q2^2");
  text.replace(text.find("H = 1"), 5, "H = e");
  const std::string five = text + "[assume]\nconditions = [\"e = 5\"]\n";
  EXPECT_EQ(run(five).verdict, Verdict::non_integrable); // a value, as `check` reads it
  const study::FileStudy as_written(read_system(parse_document(five, "test.toml")));
  EXPECT_EQ(test::checked(as_written).verdict, Verdict::undecided);
  const ManifoldReport m = run(text + "[assume]\nconditions = [\"e < 0\"]\n");
  ASSERT_TRUE(m.matrices);
  EXPECT_EQ(sentence(m.matrices->level), "e = -1/3");
}

// w3, w2 - L w3, the field and d/dw1: integrable, with the logarithm L that nothing contains.
TEST(Coupling, AFunctionThatTheCurveDoesNotSee) {
  const ManifoldReport m = run(R"t([system]
kind = "vector-field"
coordinates = ["x", "w1", "w2", "w3"]
[system.field]
x = "x"
w1 = "w2*x/(x-1)"
w2 = "w3"
w3 = "0"
[[system.function]]
name = "L"
means = "log(x)"
derivative = { x = "1/x" }
[[manifold]]
name = "m"
equations = ["w1 = 0", "w2 = 0", "w3 = 0"]
)t");
  if (m.verdict == Verdict::non_integrable) {
    EXPECT_THAT(statement(m), HasSubstr("do not depend on L"));
  }
}

// Integrable systems, their coordinates sheared by Q2 = q2 + c q1^k q3: the blocks are coupled, and
// nothing may be proved.
TEST(Coupling, IntegrableSystemsInOtherCoordinates) {
  struct Sheared {
    const char *potential, *shear, *derivative;
  };
  const std::vector<Sheared> all = {{"q1^4/4 + 3*y^2 + q3^2/5", "q1", "1"},
                                    {"(q1^4 + 6*q1^2*y^2 + y^4)/4 + q3^2/2", "2*q1", "2"},
                                    {"(q1^4 + 6*q1^2*y^2 + y^4)/4 + q3^2/2", "q1^2/3", "2*q1/3"},
                                    {"q1^3/3 + q1*y^2 + q3^2", "q1", "1"}, // x^3/3 + x y^2
                                    {"(q1^2 + y^2 + q3^2)^2/4", "q1", "1"}};
  for (const Sheared& x : all) {
    const std::string shear = x.shear, y = "(q2 - (" + shear + ")*q3)";
    std::string potential = x.potential;
    for (std::size_t i = 0; (i = potential.find('y', i)) != std::string::npos; i += y.size())
      potential.replace(i, 1, y);
    const ManifoldReport m =
        run("[system]\nkind = 'hamiltonian'\ncoordinates = ['q1', 'q2', 'q3']\nmomenta = ['p1', "
            "'p2', 'p3']\nhamiltonian = '(p1 + p2*q3*" +
            std::string(x.derivative) + ")^2/2 + p2^2/2 + (p3 + p2*(" + shear + "))^2/2 + " +
            potential +
            "'\n[[manifold]]\nname = 'plane'\nequations = ['q2 = 0', 'q3 = 0', 'p2 = 0', 'p3 = "
            "0']\nlevel = 'H = 1'\n");
    EXPECT_FALSE(m.failure) << potential;
    EXPECT_NE(m.verdict, Verdict::non_integrable) << potential << "\n" << all_reasons(m);
  }
}

TEST(Coupling, WithoutOneTheBlocksAreTheWhole) {
  EXPECT_EQ(run(blocks("q2^3 + q3^4")).verdict, Verdict::no_obstruction); // of higher order
  EXPECT_EQ(run(blocks("0")).verdict, Verdict::no_obstruction);
  EXPECT_EQ(run(blocks("e*q1^2*q2^2")).verdict, Verdict::undecided); // e = 0 is integrable
  EXPECT_EQ(run(blocks("e*q1^2*q2^2", "[set]\ne = \"0\"\n")).verdict, Verdict::no_obstruction);
}

TEST(Coupling, AQuotientIsNotTheWhole) { // Hill's problem: a Lagrangian plane
  const std::string text = R"t([system]
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
)t";
  const ManifoldReport m = run(text);
  EXPECT_EQ(m.verdict, Verdict::undecided);
  EXPECT_THAT(all_reasons(m), HasSubstr("the coupling of"));
  // Morales-Ruiz, Simo, Simon (2005)
  EXPECT_EQ(run(text + "[set]\nE = \"1\"\n").verdict, Verdict::non_integrable);
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
  EXPECT_EQ(run(field("1")).verdict, Verdict::no_obstruction);
  EXPECT_EQ(run(field("1 + y2")).verdict, Verdict::undecided); // the integral of exp(x^2)
}

} // namespace
} // namespace kov::coupling_test
