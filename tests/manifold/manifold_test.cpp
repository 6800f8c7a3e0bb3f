#include "manifold/find.hpp"
#include "manifold/invariant_manifold.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::manifold_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

System henon_heiles(const std::string& manifold) {
  return read_system(parse_document(R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
parameters = ["b", "h"]
hamiltonian = "(p1^2 + p2^2)/2 + (q1^2 + q2^2)/2 + q1^2*q2 + b/3*q2^3"
)t" + manifold,
                                    "test.toml"));
}

std::string failure(const std::string& manifold) {
  const System s = henon_heiles(manifold);
  const auto result = prove_invariant(s.field, s.manifolds.at(0));
  if (const auto* f = std::get_if<ManifoldFailure>(&result)) return f->message;
  return "proved";
}

TEST(Manifold, ProvedOrToldWhyNot) {
  EXPECT_EQ(failure(R"t([[manifold]]
equations = ["q1 = 0", "p1 = 0"]
level = "H = h")t"),
            "proved");
  EXPECT_THAT(failure(R"t([[manifold]]
equations = ["q2 = 0", "p2 = 0"]
level = "H = h")t"),
              HasSubstr("'p2 = 0' is -q1^2, not 0"));
  EXPECT_THAT(failure(R"t([[manifold]]
equations = ["q1 = 0", "p1 = 0"])t"),
              HasSubstr("a set of dimension 2"));
  EXPECT_THAT(failure(R"t([[manifold]]
equations = ["q1 = 0", "p1 = 0"]
level = "q2 = 1")t"),
              HasSubstr("its derivative is p2, not 0"));
  EXPECT_THAT(failure(R"t([[manifold]]
equations = ["q1 = 0", "q1 = 1"])t"),
              HasSubstr("contradict"));
  EXPECT_THAT(failure(R"t([[manifold]]
equations = ["q1 = 0", "p1 = 0", "q2 = 0", "p2 = 0"])t"),
              HasSubstr("points"));
}

// q1 = q2 is invariant at b = 1, which may be assumed: then "not invariant" would be false.
TEST(Manifold, WhatFailsForSomeParametersIsSaidSo) {
  EXPECT_THAT(failure(R"t([[manifold]]
equations = ["q1 - q2 = 0", "p1 - p2 = 0"])t"),
              HasSubstr("not invariant for all parameters: on it"));
  EXPECT_THAT(failure(R"t([[manifold]]
equations = ["q2 = 0", "p2 = 0"])t"),
              HasSubstr("not invariant: on it"));
}

// Nothing depends on x, and x moves: the phase curve is a line, not a point.
TEST(Manifold, ACyclicCoordinateMayBeTheTime) {
  const auto proved = [](const std::string& speed) {
    const System s = read_system(parse_document("[system]\nkind = \"vector-field\"\n"
                                                "coordinates = [\"x\", \"y\", \"w\"]\n"
                                                "parameters = [\"a\"]\n[system.field]\nx = \"" +
                                                    speed +
                                                    "\"\ny = \"w\"\nw = \"a*y\"\n[[manifold]]\n"
                                                    "equations = [\"y = 0\", \"w = 0\"]\n",
                                                "test.toml"));
    return std::holds_alternative<InvariantManifold>(prove_invariant(s.field, s.manifolds[0]));
  };
  EXPECT_TRUE(proved("1"));
  EXPECT_TRUE(proved("a"));
  EXPECT_FALSE(proved("0"));
  EXPECT_FALSE(proved("y"));
}

TEST(Manifold, EquationsNeedNotBeCoordinates) {
  const System s = henon_heiles(R"t([set]
b = "1"
[[manifold]]
equations = ["q2 = q1", "p2 = p1"]
level = "H = h")t");
  EXPECT_TRUE(std::holds_alternative<InvariantManifold>(prove_invariant(s.field, s.manifolds[0])));
}

std::vector<std::string> found(const System& s) {
  std::vector<std::string> all;
  for (const auto& m : find_manifolds(s.field, {*s.field.hamiltonian}).proved) {
    std::string text;
    for (const auto& e : m.equations)
      text += (text.empty() ? "" : ", ") + e.text;
    all.push_back(text);
  }
  return all;
}

TEST(FindManifolds, AxesAndLines) {
  EXPECT_THAT(found(henon_heiles("")), testing::Contains("q1 = 0, p1 = 0"));
  const System separable = henon_heiles("[set]\nb = \"1\"");
  EXPECT_THAT(found(separable), testing::Contains("q2 = q1, p2 = p1"));
  EXPECT_THAT(found(separable), testing::Contains("q2 = -q1, p2 = -p1"));
}

// Where a component vanishes at a value of a coordinate, that need not be 0: a number, or one that
// depends on parameters; and a coordinate may have to stay for that (Falkner-Skan).
TEST(FindManifolds, CoordinatesAtConstantValues) {
  const auto in = [](const std::string& x, const std::string& y, const std::string& z) {
    const System s = read_system(parse_document(
        "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z']\nparameters = ['a']\n"
        "[system.field]\nx = '" +
            x + "'\ny = '" + y + "'\nz = '" + z + "'\n",
        "test.toml"));
    std::vector<std::string> all;
    for (const auto& m : find_manifolds(s.field, {}).proved) {
      all.emplace_back();
      for (const auto& e : m.equations)
        all.back() += (all.back().empty() ? "" : ", ") + e.text;
    }
    return all;
  };
  EXPECT_THAT(in("y", "z", "-x*z - a*(1 - y^2)"),
              UnorderedElementsAre("y = 1, z = 0", "y = -1, z = 0"));
  EXPECT_THAT(in("y + x^2", "(y - a)*(z + x)", "y*x + 1"), ElementsAre("y = a"));
  EXPECT_THAT(in("y + x^2", "(y^2 + 1)*(z + x)", "y*x + 1"), IsEmpty());   // no rational root
  EXPECT_THAT(in("y + x^2 + 1", "(y - x)*(z + x)", "y*x + 1"), IsEmpty()); // no constant value
}

// The energy of an extended phase space is contained in H, and in nothing that moves.
TEST(FindManifolds, LevelsOfAnExtendedPhaseSpaceCutOutCurves) {
  const auto curves = [](const std::string& coordinates, const std::string& momenta,
                         const std::string& hamiltonian) {
    const System s = read_system(parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = [" +
                                                    coordinates + "]\nmomenta = [" + momenta +
                                                    "]\nhamiltonian = '" + hamiltonian + "'\n",
                                                "forced.toml"));
    std::size_t count = 0;
    for (const auto& m : find_manifolds(s.field, {*s.field.hamiltonian}).proved)
      if (m.leaf_dimension() == 1 && !m.equilibria) {
        ++count;
        ManifoldSpec spec;
        spec.equations = m.equations;
        spec.levels = {{*s.field.hamiltonian, "H = 0"}};
        EXPECT_TRUE(std::holds_alternative<InvariantManifold>(prove_invariant(s.field, spec)))
            << hamiltonian;
      }
    return count;
  };
  for (const std::string force :
       {"cos(q)*(1 + cos(t)/2)", "cos(q)*(3 + sin(2*t))", "sin(q)^2*exp(t)", "q^2*cos(t) + q^4"})
    EXPECT_GE(curves("'q', 't'", "'p', 'E'", "p^2/2 + E + " + force), 1U) << force;
  EXPECT_GE(curves("'x', 'y', 't'", "'u', 'v', 'E'",
                   "(u^2 + v^2)/2 + E + (1 - cos(y))*(2 + sin(x) + sin(t))"),
            1U);
}

TEST(FindManifolds, FixedPointsOfAPermutation) {
  const System s = read_system(parse_document(R"t([system]
kind = "vector-field"
coordinates = ["x", "y", "w"]
[system.field]
x = "y*w + x"
y = "x*w + y"
w = "x*y"
)t",
                                              "test.toml"));
  bool seen = false;
  for (const auto& m : find_manifolds(s.field, {}).proved)
    seen = seen || (m.equations.size() == 1 && m.equations[0].text == "x = y");
  EXPECT_TRUE(seen);
}

// Two particles in exponential potentials e^x, e^(a y): x - a y may rest on the set where its force,
// e^x - a^2 e^(a y), is 0.  Without a force on the difference there is no such set.
TEST(Manifold, ExponentialsInAConstantRatioAreProposedAndProved) {
  const auto found = [](const std::string& potential) {
    const System s = read_system(parse_document(R"t([system]
kind = "hamiltonian"
coordinates = ["x", "y"]
momenta = ["u", "v"]
parameters = ["a"]
hamiltonian = "(u^2 + v^2)/2 + )t" + potential + R"t("
[[system.function]]
name = "s"
derivative = {x = "s"}
[[system.function]]
name = "t"
derivative = {y = "a*t"}
)t",
                                                "exponentials.toml"));
    std::size_t count = 0;
    for (const FoundManifold& m : find_manifolds(s.field, {}).proved)
      count += m.kind == "exponentials in a constant ratio" ? 1 : 0;
    return count;
  };
  EXPECT_EQ(found("s + t"), 1U);
  EXPECT_EQ(found("s"), 0U);
}

// A reflection takes exp(x) to 1/exp(x), and the angles themselves say nothing.
// exp(q) exp(-q) = 1 beside exp(q) = 0: an empty set among those that are tried.
TEST(FindManifolds, SetsWithoutPointsAreNoErrors) {
  const System s = read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['q', 'x']\nmomenta = ['p', 'v']\n"
      "hamiltonian = '(p^2 + v^2)/2 + exp(q)*x^2 + exp(q - x)'\n",
      "test.toml"));
  EXPECT_NO_THROW(static_cast<void>(find_manifolds(s.field, {*s.field.hamiltonian})));
}
// Twelve variables: functions follow their coordinates, so that few maps are tried.
TEST(FindManifolds, ThreePendulaAreExchanged) {
  const System s = read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\n"
      "momenta = ['u', 'v', 'w']\nhamiltonian = '(u^2 + v^2 + w^2)/2 - cos(x) - cos(y) - cos(z) - "
      "cos(x - y) - cos(y - z) - cos(z - x)'\n",
      "test.toml"));
  const FoundManifolds found = find_manifolds(s.field, {*s.field.hamiltonian});
  EXPECT_TRUE(found.left_out.empty());
  const auto has = [&](const std::string& equation) {
    for (const FoundManifold& m : found.proved)
      for (const Equation& e : m.equations)
        if (e.text == equation) return true;
    return false;
  };
  EXPECT_TRUE(has("cos_x = cos_y"));
  EXPECT_TRUE(has("sin_x = -sin_y"));
}
TEST(FindManifolds, FunctionsAreReflectedWithTheCoordinates) {
  const auto has = [](const std::string& text, const std::string& set) {
    const System s = read_system(parse_document(text, "test.toml"));
    for (const FoundManifold& m : find_manifolds(s.field, {*s.field.hamiltonian}).proved) {
      std::string equations;
      for (const Equation& e : m.equations)
        equations += (equations.empty() ? "" : ", ") + e.text;
      if (equations == set && m.leaf_dimension() == 1) return true;
    }
    return false;
  };
  const std::string planar = "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\n"
                             "momenta = ['u', 'v']\nhamiltonian = '(u^2 + v^2)/2 + ";
  const std::string exponentials = "'\n[[system.function]]\nname = 'e'\nderivative = {x = 'e'}\n"
                                   "[[system.function]]\nname = 'f'\nderivative = {y = 'f'}\n";
  const std::string even = planar + "e + 1/e + f + 1/f + e*f + 1/(e*f)" + exponentials;
  EXPECT_TRUE(has(even, "u = v, e = f"));
  EXPECT_TRUE(has(even, "u = -v, e*f = 1"));
  EXPECT_TRUE(has(planar + "e + 1/e + f + e*f + f/e" + exponentials, "u = 0, e = 1"));
  EXPECT_FALSE(has(planar + "e + 2/e + f + e*f + f/e" + exponentials, "u = 0, e = 1"));
}

} // namespace
} // namespace kov::manifold_test
