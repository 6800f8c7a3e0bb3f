// A point of the ideal need not be one for the functions that are meant.

#include "manifold/existence.hpp"
#include "manifold/find.hpp"

#include "symbol/input_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::existence_test {
namespace {

/// H = (p^2 + r^2)/2 + potential in x, y with functions u, v of x, on y = r = 0 and `more`.
System system_with(const std::string& u, const std::string& v, const std::string& relations,
                   const std::string& more, const std::string& potential = "u^2 + v*y^2") {
  return read_system(parse_document(
      "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"x\", \"y\"]\nmomenta = [\"p\", \"r\"]\n" +
          relations + "hamiltonian = \"(p^2 + r^2)/2 + " + potential +
          "\"\n[[system.function]]\nname = \"u\"\n" + u + "[[system.function]]\nname = \"v\"\n" +
          v + "[[manifold]]\nequations = [\"y = 0\", \"r = 0\"" + more + "]\nlevel = \"H = 1\"\n",
      "test.toml"));
}

std::string unchecked(const System& s) {
  const auto m = prove_invariant(s.field, s.manifolds.at(0));
  if (const auto* failure = std::get_if<ManifoldFailure>(&m)) return failure->message;
  return unchecked_functions(s.field, std::get<InvariantManifold>(m));
}

const std::string exp_u = "derivative = { x = \"u\" }\n";
const std::string exp_v = "derivative = { x = \"v\" }\n";

TEST(Existence, TwoFunctionsWithARatioOfTheirOwn) {
  for (const char* more : {", \"u = 2*v\"", ", \"3*u = v\"", ", \"u = 0\"", ""})
    EXPECT_EQ(unchecked(system_with(exp_u, exp_v, "", more)).empty(), false) << more;
}

TEST(Existence, OneFunctionHasNoTwoNames) {
  EXPECT_THROW(static_cast<void>(system_with("means = \"exp(x)\"\n" + exp_u,
                                             "means = \"exp(2*x/2)\"\n" + exp_v, "", "")),
               InputError);
}

TEST(Existence, APeriodicFunctionTakesItsValues) {
  const std::string circle = "relations = [\"u^2 + v^2 = 1\"]\n";
  const std::string u = "derivative = { x = \"v\" }\n";
  const std::string v = "derivative = { x = \"-u\" }\n";
  EXPECT_EQ(unchecked(system_with(u, v, circle, "", "v*(1 + y^2)")), "");
}

// The equations say x = 0, and what the functions are there.
TEST(Existence, AFunctionHasItsValueAtZero) {
  const auto with = [](const std::string& u, const std::string& v, const std::string& value) {
    return read_system(parse_document(
        "[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", \"y\"]\n"
        "relations = [\"u^2 + v^2 = 1\"]\n[system.field]\nx = \"u*y\"\ny = \"v\"\n"
        "[[system.function]]\nname = \"u\"\nmeans = \"" +
            u + "\"\nderivative = { x = \"v\" }\n[[system.function]]\nname = \"v\"\nmeans = \"" +
            v + "\"\nderivative = { x = \"-u\" }\n[[manifold]]\n" +
            "equations = [\"x = 0\", \"u = 0\", \"v = " + value + "\"]\n",
        "test.toml"));
  };
  EXPECT_EQ(unchecked(with("sin(x)", "cos(x)", "1")), "");
  EXPECT_EQ(unchecked(with("sin(x)", "cos(x)", "-1")), "u, v"); // cos(0) is 1
  EXPECT_EQ(unchecked(with("f(x)", "g(x)", "1")), "u, v");
}

TEST(Existence, AlgebraicFunctionsHaveTheirPoints) {
  const std::string roots = "relations = [\"u^2 = x\", \"v^2 = x + 1\"]\n";
  EXPECT_EQ(unchecked(system_with("derivative = { x = \"1/(2*u)\" }\n",
                                  "derivative = { x = \"1/(2*v)\" }\n", roots, "")),
            "");
}

// y^k u = x leaves u open where x = y = 0, and there it has no derivative.
TEST(Existence, WhereAFunctionHasNoDerivativeThereIsNoManifold) {
  for (const std::string k : {"1", "2", "3"}) {
    const std::string u = "derivative = { x = \"1/y^" + k + "\", y = \"-" + k + "*u/y\" }\n";
    const System s = system_with(u, exp_v, "relations = [\"y^" + k + "*u = x\"]\n", "",
                                 "y^(2*" + k + ")*u^2 + v");
    EXPECT_THAT(unchecked(s), testing::HasSubstr("is not defined on the manifold")) << k;
  }
}

TEST(FindManifolds, WhereTheFieldHasPolesThereIsNone) {
  const std::vector<std::pair<std::string, std::string>> potentials{
      {"1/(x - y)^2", "x = y"},
      {"1/(x + y)^2 + 1/(x - y)^2", "x = -y"},
      {"1/x^2 + 1/y^2", "x = 0"}};
  for (const auto& [potential, pole] : potentials) {
    const System s = read_system(
        parse_document("[system]\nkind = \"hamiltonian\"\ncoordinates = [\"x\", \"y\"]\n"
                       "momenta = [\"p\", \"r\"]\nhamiltonian = \"(p^2 + r^2)/2 + " +
                           potential + "\"\n",
                       "test.toml"));
    for (const FoundManifold& m : find_manifolds(s.field, {*s.field.hamiltonian}).proved)
      for (const Equation& e : m.equations)
        EXPECT_NE(e.text, pole) << potential;
  }
}

// Roots are algebraic, beside algebraic constants, too.
TEST(Existence, RootsOverAConstant) {
  const auto with = [](const std::string& more, const std::string& slope) {
    return read_system(parse_document(
        "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"x\", \"y\"]\nmomenta = [\"p\", "
        "\"r\"]\n" +
            more +
            "hamiltonian = \"(p^2 + r^2)/2 - 1/sqrt(x^2 + y^2)\"\n[[manifold]]\n"
            "equations = [\"y = " +
            slope + "*x\", \"r = " + slope +
            "*p\", \"root1 = 2*x\"]\n"
            "level = \"H = 1\"\n",
        "test.toml"));
  };
  EXPECT_EQ(unchecked(with("constants = [\"s\"]\nrelations = [\"s^2 = 3\"]\n", "s")), "");
  EXPECT_EQ(unchecked(with("parameters = [\"a\"]\nconstants = [\"s\"]\n"
                           "relations = [\"s^2 + a*s = 3 + a*s\"]\n",
                           "s")),
            "");
}

} // namespace
} // namespace kov::existence_test
