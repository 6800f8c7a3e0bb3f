// Systems with parameters whose generic verdict is not the verdict for all parameters: each of
// these was once answered wrongly.

#include "exact/error.hpp"
#include "integrability/conclude.hpp"
#include "strata/words.hpp"
#include "support/checked.hpp"
#include "symbol/input_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace kov::parameter_traps_test {
namespace {

Verdict verdict(const std::string& text) { return test::checked(text).verdict; }

std::string field(const std::string& equations, const std::string& coordinates,
                  const std::string& zero) {
  return "[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", " + coordinates +
         "]\nparameters = [\"a\", \"b\"]\n[system.field]\nx = \"1\"\n" + equations +
         "[[manifold]]\nname = \"m\"\nequations = [" + zero + "]\n[reduce]\nchange = \"z = x\"\n";
}

std::string hamiltonian(const std::string& h, const std::string& more) {
  return "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\n"
         "momenta = [\"p1\", \"p2\"]\nparameters = [\"a\", \"h\"]\nhamiltonian = \"" +
         h + "\"\n" + more;
}

const std::string axis = R"t([[manifold]]
name = "axis"
equations = ["q1 = 0", "p1 = 0"]
level = "H = h"
[reduce]
variable = "q1"
change = "z = q2"
)t";

TEST(ParameterTraps, TheReductionDividesByAParameterThatRDoesNotContain) {
  // a = 0: H depends on q1, q2 only
  EXPECT_NE(verdict(hamiltonian("a*(p1^2 + p2^2)/2 + q2^2/2 + q1^2*q2", axis)),
            Verdict::non_integrable);
  // a = 0: the free particle
  EXPECT_NE(verdict(hamiltonian("(p1^2 + p2^2)/2 + a*(q2^2/2 + q1^2*q2)", axis)),
            Verdict::non_integrable);
  EXPECT_EQ(verdict(hamiltonian("a*(p1^2 + p2^2)/2 + q2^2/2 + q1^2*q2",
                                "[assume]\na = \"positive\"\n" + axis)),
            Verdict::non_integrable);
}

// Each part of the strata is decided by a closed answer ("sqrt(32 a + 1) is ..."), so the system is.
TEST(ParameterTraps, PartsThatAreAllDecidedDecide) {
  for (const char* h :
       {"(p1^2 + p2^2)/2 + a*q1^2*q2 + q2^3/2", "(p1^2 + p2^2)/2 + a*q1^2*q2^2 + q2^4/4"})
    for (const char* level : {"", "[assume]\nh = \"nonzero\"\n"})
      EXPECT_EQ(verdict(hamiltonian(h, level + axis)), Verdict::depends) << h << level;
}

// The diagonal is invariant where a = b.
Verdict of_diagonal(const std::string& conditions) {
  const std::string text = R"t([system]
kind = "hamiltonian"
coordinates = ["x", "y"]
momenta = ["u", "v"]
parameters = ["a", "b", "h"]
hamiltonian = "(u^2 + v^2)/2 + a*x^4 + b*y^4 + x^2*y^2"
[[manifold]]
name = "diagonal"
equations = ["y = x", "v = u"]
level = ["H = h"]
[assume]
conditions = [)t" + conditions +
                           "]\n";
  return test::checked(text).verdict;
}

TEST(ParameterTraps, AQuotientThatIsAssumedToBeSomethingHasAValue) {
  for (const char* none : {R"("a/b = 1", "b = 0")", R"("(a - b)/(a + b) = 0", "b = 0")",
                           R"("b = 0", "a/b = 1")", R"("a = b", "a/b != 3", "a = 0")",
                           R"("a = b", "a/b > 0", "b = 0")", R"("a = b", "1/(a - b) != 5")"})
    EXPECT_THROW(static_cast<void>(of_diagonal(none)), Error) << none;
  EXPECT_NE(of_diagonal(R"("a/b = 1")"), Verdict::no_obstruction);
  EXPECT_EQ(of_diagonal(R"("a/b = 1", "b = 3/2")"), Verdict::non_integrable);
}

TEST(ParameterTraps, AssumptionsThatContradictEachOtherAreTold) {
  for (const char* none :
       {R"("b = 1", "b = 2")", R"("a = b", "a != b")", R"("a = b", "a*b = 0", "a + b = 1")",
        R"("a*b = 1", "a = b", "a = 2")", R"("a = b", "a^2 = -1", "a > 0")",
        R"("a*b*(a - b) = 0", "a != 0", "b != 0", "a != b")"}) {
    SCOPED_TRACE(none);
    try {
      static_cast<void>(of_diagonal(none));
      FAIL();
    } catch (const InvalidArgument& e) {
      EXPECT_STREQ(e.what(), "the assumptions contradict each other");
    }
  }
}

TEST(ParameterTraps, WhereThereIsNoLevelOnTheLocus) {
  // 4 a h + 1 = 0 has no h for a = 0, where p1 is a first integral
  const std::string h = "(p1^2 + p2^2)/2 + q2 + a*q2^2 + a*q1^2*q2";
  EXPECT_NE(verdict(hamiltonian(h, "[assume]\nconditions = [\"a >= 0\"]\n" + axis +
                                       "energy = \"auto\"\n")),
            Verdict::non_integrable);
  EXPECT_EQ(verdict(hamiltonian(h, "[assume]\na = \"positive\"\n" + axis + "energy = \"auto\"\n")),
            Verdict::non_integrable);
}

TEST(ParameterTraps, OneLevelIsEnough) {
  // abelian at h = 0 and at no other level
  const std::string h = "(p1^2 + p2^2)/2 + a*q2^2 + q1^2*(a/4 + q2^2)";
  const std::string positive = "[assume]\na = \"positive\"\n";
  EXPECT_EQ(verdict(hamiltonian(h, positive + axis)), Verdict::non_integrable);
  EXPECT_EQ(verdict(hamiltonian(h, positive + axis + "energy = \"auto\"\n")),
            Verdict::non_integrable);
}

TEST(ParameterTraps, TheReductionDividesByAnIrrationalParameter) {
  // a^2 = 2: y1 is constant, the group is Gm
  EXPECT_NE(verdict(field("y1 = \"(a^2 - 2)*y2\"\ny2 = \"-2*x*y2 + 2*x*y1\"\n", "\"y1\", \"y2\"",
                          "\"y1 = 0\", \"y2 = 0\"")),
            Verdict::non_integrable);
}

TEST(ParameterTraps, OtherBlocksOnASpecialStratum) {
  // a = b = 0: everything is solvable
  EXPECT_NE(verdict(field("y1 = \"a*y2\"\ny2 = \"a*x*y1\"\ny3 = \"y4\"\n"
                          "y4 = \"(b*x + 2/x^2)*y3\"\n",
                          "\"y1\", \"y2\", \"y3\", \"y4\"",
                          "\"y1 = 0\", \"y2 = 0\", \"y3 = 0\", \"y4 = 0\"")),
            Verdict::non_integrable);
}

// At a = 0 the block (y1, y2) is abelian, and (y3, y4), which is none elsewhere, is not.  Elsewhere
// y4 -> y3 -> y5 is a chain of which only the diagonal is looked at.
TEST(ParameterTraps, ANewBlockOnASpecialStratum) {
  const std::string text =
      field("y1 = \"a*y2\"\ny2 = \"y1\"\ny3 = \"y4\"\ny4 = \"2*x*y4\"\ny5 = \"a*y3\"\n",
            "\"y1\", \"y2\", \"y3\", \"y4\", \"y5\"",
            "\"y1 = 0\", \"y2 = 0\", \"y3 = 0\", \"y4 = 0\", \"y5 = 0\"") +
      "variable = \"y1\"\n";
  const ManifoldReport m = test::checked(text);
  EXPECT_EQ(m.verdict, Verdict::undecided);
  ASSERT_TRUE(m.blocks.at(0).strata);
  for (const auto& x : m.blocks[0].strata->strata)
    EXPECT_EQ(x.leaf.abelian, truth(to_string(x.conditions) != "a = 0"));
}

// At a = 0 there is a chain y2 -> y3 -> y4 of first-order equations with the integral of exp(x^2):
// its group is not abelian, and only its diagonal was looked at.
TEST(ParameterTraps, DiagonalBlocksAreNotCalledAGroup) {
  const std::string text =
      field("y1 = \"a*y2\"\ny2 = \"2*x*y2 + a*y1\"\ny3 = \"y2\"\ny4 = \"y3\"\n",
            "\"y1\", \"y2\", \"y3\", \"y4\"", "\"y1 = 0\", \"y2 = 0\", \"y3 = 0\", \"y4 = 0\"") +
      "variable = \"y1\"\n";
  const ManifoldReport m = test::checked(text);
  const auto& strata = m.blocks.at(0).strata;
  ASSERT_TRUE(strata);
  const auto special =
      std::find_if(strata->strata.begin(), strata->strata.end(),
                   [](const strata::Stratum& x) { return to_string(x.conditions) == "a = 0"; });
  ASSERT_NE(special, strata->strata.end());
  EXPECT_EQ(special->leaf.abelian, Truth::unknown);
  EXPECT_THAT(reason(special->leaf), testing::HasSubstr("the coupling of"));
  EXPECT_FALSE(special->leaf.group);
}

// x - a y is an integral that says nothing about y at a = 0... unless it is written as y - x/a.
TEST(ParameterTraps, AnIntegralThatMeansNothingOnASpecialStratum) {
  const std::string text = field("y1 = \"a*y2\"\ny2 = \"a*x*y1\"\ny3 = \"y2\"\n",
                                 "\"y1\", \"y2\", \"y3\"", "\"y1 = 0\", \"y2 = 0\", \"y3 = 0\"") +
                           "[[integral]]\nname = \"F\"\nvalue = \"y3 - y1/a\"\n";
  EXPECT_NE(verdict(text), Verdict::non_integrable);
}

TEST(ParameterTraps, AParameterOfAFunctionLabelsNoLevel) {
  // f' = a: at a = 0 the coefficient f is constant
  EXPECT_NE(verdict("[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", \"y\", \"w\"]\n"
                    "parameters = [\"a\"]\n[system.field]\nx = \"1\"\ny = \"w\"\nw = \"f*y\"\n"
                    "[[system.function]]\nname = \"f\"\nderivative = { x = \"a\" }\n"
                    "[[manifold]]\nname = \"m\"\nequations = [\"y = 0\", \"w = 0\"]\n"
                    "[reduce]\nchange = \"z = f\"\n"),
            Verdict::non_integrable);
}

TEST(ParameterTraps, NothingMovesWhereDzDtVanishes) {
  // a = 0: the free particle on the level H = 0; r does not contain a
  const std::string level_a = R"t([[manifold]]
name = "axis"
equations = ["q1 = 0", "p1 = 0"]
level = "H = a"
[reduce]
variable = "q1"
change = "z = q2"
)t";
  EXPECT_NE(verdict(hamiltonian("(p1^2 + p2^2)/2 + a*q2 + a*q1^2*q2", level_a)),
            Verdict::non_integrable);
}

// Constant coefficients: the group is a torus or additive, for every a.
TEST(ParameterTraps, NothingDependsOnTheTime) {
  EXPECT_EQ(verdict("[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", \"y\", \"w\"]\n"
                    "parameters = [\"a\"]\n[system.field]\nx = \"1\"\ny = \"w\"\nw = \"a*y\"\n"
                    "[[manifold]]\nname = \"m\"\nequations = [\"y = 0\", \"w = 0\"]\n"),
            Verdict::no_obstruction);
}

TEST(ParameterTraps, SeveralComponentsAreRefused) {
  EXPECT_EQ(verdict(hamiltonian("(p1^2 + p2^2)/2 + q1^2*q2^2/2", R"t([[manifold]]
name = "two"
equations = ["q1*q2 = 0", "p1*q2 = 0", "p2*q1 = 0", "p1*p2 = 0"]
level = "H = 1"
)t")),
            Verdict::undecided);
}

TEST(ParameterTraps, AGradientIsClosed) {
  EXPECT_THROW(static_cast<void>(verdict(hamiltonian("(p1^2 + p2^2)/2 + f*q1^2 + q2",
                                                     R"t([[system.function]]
name = "f"
derivative = { q1 = "q2", q2 = "-q1" }
)t"))),
               InputError);
}

ManifoldReport run(const std::string& text) { return test::checked(text); }

// Where the study of a special stratum fails, by its nature or by a limit, nothing is concluded.
TEST(ParameterTraps, AFailureOnAStratumIsNoAnswer) {
  const ManifoldReport dimension = run(R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2", "q3"]
momenta = ["p1", "p2", "p3"]
parameters = ["a"]
hamiltonian = "(p1^2+p2^2+p3^2)/2 + q1^2*q2 + 1/12*q2^3 + a*q3^2"
[[integral]]
name = "I"
value = "a*p3^2/2 + a^2*q3^2"
[[manifold]]
name = "N"
equations = ["q1 = 0","p1 = 0","a*q3 = 0","a*p3 = 0"]
level = "H = 1")t");
  EXPECT_NE(dimension.verdict, Verdict::depends);
  const ManifoldReport invariance = run(R"t([system]
kind = "vector-field"
coordinates = ["x","y1","y2"]
parameters = ["c"]
[system.field]
x = "1"
y1 = "y2"
y2 = "x*y1+c^2*x"
[[manifold]]
name = "N"
equations = ["c*(y1+c^2)= 0","y2 = 0"])t");
  EXPECT_NE(invariance.verdict, Verdict::depends);
}

// A block that is transversal to the symplectic leaves is not an obstruction on them.
TEST(ParameterTraps, ABlockBesideTheLeaf) {
  const ManifoldReport m = run(R"t([system]
kind = "poisson"
coordinates = ["x","p","u","v"]
hamiltonian = "p"
bracket = [["0","1","0","0"],["-1","0","-u/(3*x)-v/(x-1)","-u/(x-1)"],["0","u/(3*x)+v/(x-1)","0","0"],["0","u/(x-1)","0","0"]]
[[manifold]]
name = "N"
equations = ["u = 0","v = 0"]
level = "H = 1")t");
  EXPECT_EQ(m.verdict, Verdict::undecided);
}

// On the leaf c = 0 the integrals H, u, v*V commute.  On dF = 0 the block (u, v) has Borel's group,
// but the leaf meets dF = du + dc = 0 in u = 0 only.  A second Hamiltonian, where c does nothing,
// shows that a block is still seen behind such a restriction.
TEST(ParameterTraps, AnIntegralThatRestrictsTheLeaf) {
  const auto top = [](const std::string& h) {
    return R"t([system]
kind = "poisson"
coordinates = ["x","p","u","U","v","V","c"]
bracket = [["0","1","0","0","0","0","0"],["-1","0","0","0","0","0","0"],["0","0","0","1","0","0","0"],
           ["0","0","-1","0","0","0","0"],["0","0","0","0","0","1","0"],["0","0","0","0","-1","0","0"],
           ["0","0","0","0","0","0","0"]]
hamiltonian = ")t" +
           h +
           R"t("
[[integral]]
name = "F"
value = "u + c"
[[manifold]]
name = "N"
equations = ["u = 0","U = 0","v = 0","V = 0","c = 0"]
level = ["H = 0"]
[[reduce]]
manifold = "N"
variable = "v"
)t";
  };
  EXPECT_EQ(verdict(top("p + v*V + c*V/x")), Verdict::undecided);
  EXPECT_EQ(verdict(top("p + V^2/2 - x*v^2/2")), Verdict::non_integrable); // Airy
}

// A logarithm that nothing contains: integrals that contain it are not excluded.
TEST(ParameterTraps, AFunctionThatNothingContains) {
  const ManifoldReport m = run(R"t([system]
kind = "hamiltonian"
coordinates = ["x","q"]
momenta = ["px","p"]
constants = ["s"]
relations = ["s^2 = 2"]
parameters = ["h"]
hamiltonian = "x*px + p^2/2 - ((s + x/(x-1))^2 - x/(x-1)^2)*q^2/2"
[[system.function]]
name = "L"
means = "log(x)"
derivative = { x = "1/x" }
[[manifold]]
name = "N"
equations = ["q = 0","p = 0"]
level = "H = h")t");
  EXPECT_EQ(m.by->integrals.without.size(), 1U);
}

// A component of the curve on which the new variable is constant, or a divisor vanishes.
TEST(ParameterTraps, ALostComponentIsNoAbsenceOfObstructions) {
  const std::string head = "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'Q']\nmomenta = "
                           "['p', 'P']\nhamiltonian = 'x*p + (P^2 + p*(p-1)*Q^2 + 3*Q^2)/2'\n"
                           "[[manifold]]\nname = 'N'\nequations = ['Q = 0', 'P = 0']\nlevel = 'H = "
                           "0'\n";
  EXPECT_EQ(run(head).verdict, Verdict::undecided);
  EXPECT_EQ(run(head + "[reduce]\nchange = 'z = p'\n").verdict, Verdict::non_integrable);
  const ManifoldReport divisor = run(R"t([system]
kind = "vector-field"
coordinates = ["x","y","Q","P"]
[system.field]
x = "1"
y = "0"
Q = "P + (1-y)*x*Q"
P = "y*Q"
[[integral]]
name = "I"
value = "y^2 - y"
[[manifold]]
name = "N"
equations = ["Q = 0","P = 0"]
level = "I = 0")t");
  EXPECT_EQ(divisor.verdict, Verdict::undecided);
}

// What decided a special stratum had an irregular place.
TEST(ParameterTraps, TheClassOfAStratumWithOtherBlocks) {
  const ManifoldReport m = run(R"t([system]
kind = "vector-field"
coordinates = ["x","y1","y2","y3","y4"]
parameters = ["c"]
[system.field]
x = "1"
y1 = "y2"
y2 = "(1/x^2 + c/(x*(x-1)))*y1"
y3 = "0"
y4 = "y4 + y3/x"
[[integral]]
name = "F"
value = "c*y3"
[[manifold]]
name = "N"
equations = ["y1 = 0","y2 = 0","y3 = 0","y4 = 0"])t");
  EXPECT_EQ(m.by->integrals.near, IntegralClass::Near::closed_curve);
}

// Riemann's equation with a difference that depends on a, and one value of a left open: the general
// answer is told with its exceptions, and the class is that of the equation it rests on.
TEST(ParameterTraps, AnOpenValueDoesNotHideTheGeneralAnswer) {
  const std::string h = "(p1^2 + p2^2)/2 + 3*q1^2*q2^2 + a*q2^4";
  const ManifoldReport m = test::checked(hamiltonian(h, axis));
  EXPECT_EQ(m.verdict, Verdict::undecided);
  EXPECT_THAT(statement(m), testing::HasSubstr("not integrable"));
  EXPECT_THAT(trusted_steps(m), testing::Contains(Trusted{Trusted::Step::closed_answer}));
  EXPECT_THAT(exceptions(m),
              testing::AllOf(testing::HasSubstr("h = 0"), testing::HasSubstr("sqrt((a + 12)/a)")));
}

// k^2 = a^2 + 1 or a^2 + b^2 is not a number: r = z^2 + 1 holds where the coupling c(k) of y and v, which is
// divided by, is not 0.  The same with a pole in the equation of the manifold.
TEST(ParameterTraps, AConstantThatDependsOnAParameterThatRDoesNotContain) {
  const auto exceptions_with = [](const std::string& relation, const std::string& coupling,
                                  const std::string& equation) {
    const ManifoldReport m = test::checked(
        "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
        "parameters = ['a', 'b']\nconstants = ['k']\nrelations = ['" +
        relation + "']\nhamiltonian = 'u^2/2 + x^4/4 + x*u*y*v + (" + coupling +
        ")*u*v^2/2'\n[[manifold]]\nname = 'm'\nequations = ['" + equation +
        " = 0', 'v = 0']\nlevel = ['H = 1']\n");
    EXPECT_EQ(m.verdict, Verdict::undecided) << coupling; // y v is an integral where it is 0
    EXPECT_THAT(statement(m), testing::HasSubstr("not integrable")) << coupling;
    return exceptions(m);
  };
  EXPECT_EQ(exceptions_with("k^2 = a^2 + 1", "k - 1", "y"), "except where a = 0");
  EXPECT_EQ(exceptions_with("k^2 = a^2 + 1", "k - 1", "y/(k - 1)"), "except where a = 0");
  EXPECT_EQ(exceptions_with("k^2 = a^2 + b^2", "k - a", "y"), "except where b = 0");
  EXPECT_EQ(exceptions_with("k^2 = a^2 + 1", "a", "y"), "except where a = 0");
}

// A level that decides chooses an orbit: its equation excepts no parameters.  Here the body with C = A is
// integrable and has to be among the exceptions.
TEST(ParameterTraps, TheEquationOfALevelIsNoException) {
  for (const std::string h : {"h", "e"}) {
    const ManifoldReport m =
        test::checked("[system]\nkind = 'lagrangian'\n"
                      "coordinates = ['M1', 'M2', 'M3', 'Gamma1', 'Gamma2', 'Gamma3']\n"
                      "angular_velocity = ['Omega1', 'Omega2', 'Omega3']\n"
                      "parameters = ['A', 'C', '" +
                      h +
                      "']\nlagrangian = '(A*Omega1^2 + A*Omega2^2 + C*Omega3^2)/2 + "
                      "(Gamma2*Omega3 - Gamma3*Omega2)^2/2 - Gamma1'\n[assume]\nA = 'positive'\n"
                      "C = 'positive'\nconditions = ['2*A >= C']\n"
                      "[[casimir]]\nname = 'F1'\nvalue = 'Gamma1^2 + Gamma2^2 + Gamma3^2'\n"
                      "[[casimir]]\nname = 'F2'\n"
                      "value = 'M1*Gamma1 + M2*Gamma2 + M3*Gamma3'\n[[manifold]]\nname = 'N'\n"
                      "equations = ['M1 = 0', 'M3 = 0', 'Gamma2 = 0']\nlevel = ['F1 = 1', 'H = " +
                      h +
                      "']\n[reduce]\nmanifold = 'N'\nvariable = 'M1'\n"
                      "change = 'z = Gamma3/(1 + Gamma1)'\nenergy = 'auto'\n");
    EXPECT_EQ(m.verdict, Verdict::depends);
    EXPECT_THAT(exceptions(m), testing::HasSubstr("where C = " + h + "^2 - 1"));
    EXPECT_THAT(exceptions(m), testing::Not(testing::HasSubstr("A = " + h + "^2")));
  }
}

} // namespace
} // namespace kov::parameter_traps_test
