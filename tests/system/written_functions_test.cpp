// Functions that formulas write and nobody declares.

#include "system/system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace kov::written_functions_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

System with(const std::string& potential, const std::string& more = "",
            const ParameterValues& values = {}) {
  return read_system(parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\n"
                                    "momenta = ['u', 'v']\nparameters = ['a', 'k']\n"
                                    "hamiltonian = '(u^2 + v^2)/2 + " +
                                        potential + "'\n" + more,
                                    "test.toml"),
                     values);
}

std::vector<std::string> meanings(const System& s) {
  std::vector<std::string> all;
  for (const FunctionSymbol& f : s.field.functions)
    all.push_back(s.ring()->name(f.variable) + " = " + f.meaning);
  return all;
}

std::vector<std::string> relations(const System& s) {
  std::vector<std::string> all;
  for (const MPoly& f : s.field.relations)
    all.push_back(to_string(f));
  return all;
}

std::string complaint(const std::string& potential, const std::string& more = "") {
  try {
    static_cast<void>(with(potential, more));
    return "no complaint";
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(WrittenFunctions, SinesAndCosines) {
  const System s = with("cos(x) + y^2*tan(x)");
  EXPECT_THAT(meanings(s), ElementsAre("sin_x = sin(x)", "cos_x = cos(x)"));
  EXPECT_THAT(relations(s), ElementsAre("sin_x^2 + cos_x^2 - 1"));
  EXPECT_EQ(s.field.components[2], formula(s, "sin_x - y^2*(sin_x^2 + cos_x^2)/cos_x^2")); // -dH/dx
}

TEST(WrittenFunctions, AsIfTheyWereDeclared) {
  const System declared = with("c + y*s*c", R"t(relations = ["s^2 + c^2 = 1"]
[[system.function]]
name = "s"
means = "sin(x)"
derivative = { x = "c" }
[[system.function]]
name = "c"
means = "cos(x)"
derivative = { x = "-s" }
)t");
  const System written = with("cos(x) + y*sin(2*x)/2");
  ASSERT_EQ(written.field.functions.size(), 2U);
  EXPECT_EQ(meanings(written)[0], "sin_x = sin(x)");
  for (std::size_t j = 0; j < 4; ++j) {
    const std::string text = std::regex_replace(
        std::regex_replace(to_string(declared.field.components[j]), std::regex("\\bs\\b"), "sin_x"),
        std::regex("\\bc\\b"), "cos_x");
    EXPECT_EQ(formula(written, text), written.field.components[j]) << text;
  }
}

TEST(WrittenFunctions, AnglesAreCombinationsOfABasis) {
  const System s = with("cos(x - y) + sin(y - x) + cos(3*x - 3*y)");
  ASSERT_EQ(s.field.functions.size(), 2U);
  EXPECT_EQ(*s.field.hamiltonian,
            formula(s, "(u^2 + v^2)/2 + cos1 - sin1 + cos1^3 - 3*cos1*sin1^2"));
  EXPECT_EQ(with("cos(x) + cos(x/2)").field.functions.size(), 2U);
  EXPECT_EQ(with("cos(x) + cos(y) + cos(x + y)").field.functions.size(), 4U);
  EXPECT_EQ(with("cos(a*x) + cos(y)").field.functions.size(), 4U);
}

// The symmetry x -> -x is one of sin_x and cos_x.
TEST(WrittenFunctions, AnglesThatDependOnOneAnotherAreOfTheCoordinates) {
  const System s = with("cos(x + y) + cos(x - y) + cos(2*x)");
  EXPECT_THAT(meanings(s),
              ElementsAre("sin_x = sin(x)", "cos_x = cos(x)", "sin_y = sin(y)", "cos_y = cos(y)"));
  EXPECT_EQ(*s.field.hamiltonian, formula(s, "(u^2 + v^2)/2 + 2*cos_x*cos_y + cos_x^2 - sin_x^2"));
  const auto first = [](const std::string& potential) { return meanings(with(potential)).at(0); };
  EXPECT_EQ(first("cos(x + y) + cos(x - y)"), "sin1 = sin(x + y)");     // independent
  EXPECT_EQ(first("cos(x - y) + cos(2*x - 2*y)"), "sin1 = sin(x - y)"); // of one angle only
  EXPECT_EQ(first("cos(a*x + y) + cos(a*x - y) + cos(2*y)"), "sin1 = sin(x*a + y)");
  EXPECT_EQ(first("cos(x/2 + y) + cos(x/2 - y) + cos(x)"), "sin_x = sin(x/2)");
}

TEST(WrittenFunctions, ExponentialsArePowersOfABasis) {
  const System s = with("exp(x) + exp(-x/2) + cosh(x)*exp(y - x) + exp(x - y)");
  ASSERT_EQ(s.field.functions.size(), 2U);
  EXPECT_THAT(relations(s), IsEmpty());
  EXPECT_EQ(meanings(s)[0], "exp_x = exp(x/2)");
  EXPECT_EQ(
      *s.field.hamiltonian,
      formula(s, "(u^2 + v^2)/2 + exp_x^2 + 1/exp_x + (exp_x^2 + 1/exp_x^2)/2*exp2 + 1/exp2"));
  EXPECT_EQ(s.field.functions[0].gradient[0], formula(s, "exp_x/2"));
  EXPECT_EQ(with("exp(x) + exp(a*y) + exp(x + a*y)").field.functions.size(), 2U);
}

TEST(WrittenFunctions, Roots) {
  const System s = with("a/sqrt(x^2 + y^2) + (x^2 + y^2)^(-3/2) + sqrt(4*x^2 + 4*y^2)");
  ASSERT_EQ(meanings(s), std::vector<std::string>{"root1 = sqrt(x^2 + y^2)"});
  EXPECT_EQ(*s.field.hamiltonian, formula(s, "(u^2 + v^2)/2 + a/root1 + 1/root1^3 + 2*root1"));
  EXPECT_EQ(s.field.functions[0].gradient[0], formula(s, "x*root1/(x^2 + y^2)"));
  const System third = with("x^(1/3) + x^(-1/2)");
  EXPECT_THAT(meanings(third), ElementsAre("root_x = root6(x)"));
  EXPECT_EQ(*third.field.hamiltonian, formula(third, "(u^2 + v^2)/2 + root_x^2 + 1/root_x^3"));
  const System inner = with("sqrt(1 + sqrt(x)) + sqrt(1 - k*sin(y)^2)");
  EXPECT_EQ(inner.field.functions.size(), 5U);
}

TEST(WrittenFunctions, RootsOfParametersAreConstants) {
  const System s = with("sqrt(a)*x^2 + sqrt(2)*y");
  EXPECT_THAT(meanings(s), IsEmpty());
  EXPECT_EQ(s.field.constants.size(), 2U);
  EXPECT_THAT(relations(s), ElementsAre("root_a^2 - a", "root1^2 - 2"));
  const System set = with("sqrt(a)*x^2", "", {{"a", "9/4"}});
  EXPECT_THAT(set.field.constants, IsEmpty());
  EXPECT_EQ(*set.field.hamiltonian, formula(set, "(u^2 + v^2)/2 + 3/2*x^2"));
}

// Two ways to write one argument are not two functions.
TEST(WrittenFunctions, ArgumentsWithRoots) {
  EXPECT_THAT(complaint("exp(sqrt(x)^2) + exp(x)"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("exp(x/sqrt(x)) + exp(sqrt(x))"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("exp(a*x) + exp(sqrt(a)^2*x)"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("exp(sqrt(-1)*x) + cos(x)"), HasSubstr("is missing"));
  EXPECT_EQ(complaint("exp(a*x) + cos(y)"), "no complaint");
  EXPECT_EQ(complaint("exp(sqrt(x)) + exp(y)"), "no complaint");
  EXPECT_EQ(complaint("exp(sqrt(x)^2)"), "no complaint");
}

// Functions of one thing do not take all values at once, and some values of the parameters relate
// them: cos(a x) and cos(b x) for a = b, 2 b, ...
TEST(WrittenFunctions, ArgumentsThatDependOnOneAnother) {
  for (const char* potential :
       {"cos(a*x) - cos(k*x)", "cos(a*x) + cos(x)", "exp(x) + exp(a*x)", "exp(x)*cos(x)",
        "exp(x) + exp(x^2)", "cos(x*y) + cos(a*x*y)", "cos(x) + cos(y) + cos(a*x + y)",
        "exp(sqrt(x)) + exp(x)", "log(x) + cos(x)", "exp(x) + cos(x/2 + y) + exp(y)"})
    EXPECT_THAT(complaint(potential), HasSubstr("depend on one another")) << potential;
  const auto assumed = [](const System& s) {
    std::string all;
    for (const Assumption& a : s.assumptions)
      all += a.text + ";";
    return all;
  };
  EXPECT_EQ(assumed(with("cos(x) + cos(y + a*x)")), "");
  EXPECT_EQ(assumed(with("cos(a*x)")), "a != 0;");
  EXPECT_EQ(assumed(with("cos(a*x) + exp(k*y)")), "a != 0;a*k != 0;");
  EXPECT_EQ(assumed(with("cos(a*x + y)")), "");
  EXPECT_EQ(assumed(with("cos(a*x + k*y) + cos(x)")), "k != 0;");
  EXPECT_EQ(assumed(with("cos(a*x)", "", {{"a", "2"}})), "");
}
// A declared function beside a written one: related, or of unknown meaning.
TEST(WrittenFunctions, BesideDeclaredFunctions) {
  const auto declare = [](const std::string& name, const std::string& means,
                          const std::string& derivative) {
    return "[[system.function]]\nname = \"" + name + "\"\n" +
           (means.empty() ? "" : "means = \"" + means + "\"\n") + "derivative = " + derivative +
           "\n";
  };
  const std::string sine =
      declare("s", "sin(x)", "{ x = \"c\" }") + declare("c", "cos(x)", "{ x = \"-s\" }");
  EXPECT_EQ(complaint("s + cos(y)", sine), "no complaint");
  EXPECT_EQ(complaint("s + sin(x)", sine), "no complaint");
  EXPECT_THAT(complaint("s*c - sin(2*x)", sine), HasSubstr("depend on one another"));
  EXPECT_THAT(complaint("s + exp(x)", sine), HasSubstr("depend on one another"));
  EXPECT_THAT(complaint("s + log(x)", sine), HasSubstr("depend on one another"));
  const std::string logarithm = declare("l", "log(x)", "{ x = \"1/x\" }");
  EXPECT_THAT(complaint("exp(l) - x", logarithm), HasSubstr("is missing"));
  EXPECT_THAT(complaint("log(l) - x", logarithm), HasSubstr("is missing"));
  const std::string unknown = declare("l", "", "{ x = \"1/x\" }");
  EXPECT_THAT(complaint("l + exp(y)", unknown), HasSubstr("is not known"));
  EXPECT_THAT(complaint("l + cos(y)", declare("l", "atan(x)", "{ x = \"1/(1 + x^2)\" }")),
              HasSubstr("is not known"));
  const std::string root = declare("r", "sqrt(x^2 + y^2)", "{ x = \"x/r\", y = \"y/r\" }");
  EXPECT_EQ(complaint("r + cos(y)", "relations = [\"r^2 = x^2 + y^2\"]\n" + root), "no complaint");
}
TEST(WrittenFunctions, VelocitiesAreUnderNoFunction) {
  const auto error = [](const std::string& lagrangian) -> std::string {
    try {
      static_cast<void>(read_system(
          parse_document("[system]\nkind = \"lagrangian\"\ncoordinates = [\"x\", \"y\"]\n"
                         "velocities = [\"v\", \"w\"]\nlagrangian = \"" +
                             lagrangian + "\"\n",
                         "test.toml")));
      return "none";
    } catch (const Error& e) {
      return e.what();
    }
  };
  for (const char* l :
       {"v^2/2 + w^2/2 - sqrt(1 - v^2)", "(1 - v^2 - w^2)^(3/2)", "v^2/2 + w^2/2 + exp(w)",
        "v^2 + w^2 + cos(x*v)", "v^2 + w^2 + log(v)", "v^2 + w^2 + sqrt(sqrt(v))"})
    EXPECT_THAT(error(l), HasSubstr("is under a function")) << l;
  EXPECT_THAT(error("v^2/2 + sin(x)*v*w + (1 - cos(x)^2)*w^2/2 - y^2"),
              HasSubstr("is 0 by the relations"));
  EXPECT_EQ(error("(v^2 + cos(x)^2*w^2)/2 - y^2"), "none");
}

TEST(WrittenFunctions, LagrangiansHaveValues) {
  const System s = read_system(parse_document(
      "[system]\nkind = 'lagrangian'\ncoordinates = ['x', 'y']\nvelocities = ['v', 'w']\n"
      "parameters = ['m']\nlagrangian = '(v^2 + w^2/m)/2 - x^2*y'\n",
      "test.toml"));
  ASSERT_EQ(s.assumptions.size(), 1U); // H = (p_x^2 + m p_y^2)/2 + ... would be defined for m = 0
  EXPECT_EQ(s.assumptions.front().text, "m != 0");
}
// What a symbol means tells its derivative.
TEST(WrittenFunctions, MeaningsAndDerivatives) {
  const auto error = [](const std::string& means, const std::string& slope,
                        const std::string& more = "") {
    return complaint("y*f", more + "[[system.function]]\nname = \"f\"\nmeans = \"" + means +
                                "\"\nderivative = { x = \"" + slope + "\" }\n");
  };
  const std::string cosine = "[[system.function]]\nname = \"c\"\nmeans = \"cos(2*x)\"\n"
                             "derivative = { x = \"-2*f\" }\n";
  EXPECT_EQ(error("exp(a*x)", "a*f"), "no complaint");
  EXPECT_THAT(error("exp(a*x)", "2*f"), HasSubstr("is not that of exp(a*x)"));
  EXPECT_EQ(error("sin(2*x)", "2*c", cosine), "no complaint");
  EXPECT_THAT(error("sin(2*x)", "c", cosine), HasSubstr("derivative"));
  EXPECT_THAT(error("sin(x)", "f"), HasSubstr("is not that of"));
  EXPECT_EQ(error("log(x)", "1/x"), "no complaint");
  EXPECT_THAT(error("log(x)", "x"), HasSubstr("is not that of"));
  EXPECT_EQ(error("tan(x)", "1 + f^2"), "no complaint");
  EXPECT_THAT(error("tanh(x)", "1 + f^2"), HasSubstr("is not that of"));
  EXPECT_EQ(error("lemniscate(x)", "f^2"), "no complaint");
  EXPECT_EQ(error("rootabc(x)", "f^2"), "no complaint");
  EXPECT_THAT(error("sqrt(x)", "f"), HasSubstr("derivative"));
}
// A definition that is first seen where a function in it is not known yet.
TEST(WrittenFunctions, DefinitionsWithFunctions) {
  const System s = with("sqrt(1 + g^2)", "[system.define]\ng = \"sin(x)\"\n");
  EXPECT_EQ(s.field.functions.size(), 3U);
}

TEST(WrittenFunctions, OfZero) {
  const System s = with("exp(a*x)*x + cos(a*y) + sin(a*y)", "", {{"a", "0"}});
  EXPECT_EQ(*s.field.hamiltonian, formula(s, "(u^2 + v^2)/2 + x + 1"));
}

TEST(WrittenFunctions, Logarithms) {
  const System s = with("log(x) + ln(y)");
  EXPECT_THAT(meanings(s), ElementsAre("log_x = log(x)", "log_y = log(y)"));
  EXPECT_EQ(s.field.components[2], formula(s, "-1/x"));
}

// No relation is missing: what could hide one is left to the author.
TEST(WrittenFunctions, WhatIsNotTreatedIsTold) {
  EXPECT_THAT(complaint("cos(x) + cos(x + a)"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("exp(x) + exp(x + 1)"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("log(x) + log(x*y)"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("log(x) + log(sqrt(x))"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("exp(a)*x"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("exp(log(x))"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("cos(x) + cos(1000*x)"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("exp(1/x) + exp(2/x)"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("wp(x)"), HasSubstr("is missing"));
  EXPECT_THAT(complaint("sqrt(x^2)"), HasSubstr("several solutions"));
  EXPECT_THAT(complaint("sqrt(1 - sin(x)^2)"), HasSubstr("several solutions"));
  EXPECT_THAT(complaint("sqrt(x)*sqrt(y)*sqrt(x*y)"), HasSubstr("several solutions"));
}

// cos(x - y) is written with the symbols of x and y, and has none itself.
TEST(WrittenFunctions, NamesThatAreNotNeededAreUnknown) {
  const std::string level = "[[manifold]]\nname = 'm'\nequations = ['cos1 = 0']\n";
  EXPECT_THAT(complaint("cos(x - y) + cos(x) + cos(y)", level), HasSubstr("unknown name 'cos1'"));
  EXPECT_EQ(complaint("cos(x - y)", level), "no complaint");
}

TEST(WrittenFunctions, NamesThatAreTaken) {
  const System s = read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['sin_cos_x', 'x']\nmomenta = ['cos_x', "
      "'sin_x']\nhamiltonian = '(sin_x^2 + cos_x^2)/2 + cos(x)*sin_cos_x'",
      "test.toml"));
  EXPECT_THAT(meanings(s), ElementsAre("sin_x_ = sin(x)", "cos_x_ = cos(x)"));
}

// sin and cos are not 0 at the same place, though nobody said so.
TEST(WrittenFunctions, RelationsThatWereNotDeclared) {
  const std::string two = R"t([[system.function]]
name = "s"
means = "sin(x)"
derivative = { x = "c" }
[[system.function]]
name = "c"
means = "cos(x)"
derivative = { x = "-s" }
)t";
  EXPECT_THAT(relations(with("c + s*y", two)), ElementsAre("s^2 + c^2 - 1"));
  EXPECT_THAT(
      relations(with("s + y", "relations = ['(s^2 + c^2)^2 = s^2 + c^2', 's^2+c^2 = 1']\n" + two)),
      testing::SizeIs(2));
  EXPECT_THAT(relations(with("s + y*c", R"t([[system.function]]
name = "s"
means = "exp(x)"
derivative = { x = "s" }
[[system.function]]
name = "c"
means = "exp(-x)"
derivative = { x = "-c" }
)t")),
              ElementsAre("s*c - 1"));
}

} // namespace
} // namespace kov::written_functions_test
