#include "symbol/input_error.hpp"
#include "system/claims.hpp"
#include "system/system.hpp"
#include "system/weights.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::read_system_test {
namespace {

using testing::HasSubstr;

System read(const std::string& text, const ParameterValues& values = {}) {
  return read_system(parse_document(text, "test.toml"), values);
}

const std::string oscillator = R"t(
[system]
kind        = "hamiltonian"
coordinates = ["q1", "q2"]
momenta     = ["p1", "p2"]
parameters  = ["a", "b"]
hamiltonian = "(p1^2 + p2^2)/2 + (a*q1^2 + b*q2^2)/2"
)t";

std::string complaint(const std::string& text, const ParameterValues& values = {}) {
  try {
    static_cast<void>(read(text, values));
  } catch (const InputError& e) {
    return std::to_string(e.line()) + ": " + e.message() + " / " + e.hint();
  }
  return "no complaint";
}

TEST(ReadSystem, Hamiltonian) {
  const System s = read(oscillator);
  EXPECT_EQ(s.field.dimension(), 4U);
  EXPECT_EQ(to_string(s.field.components[0]), "p1");
  EXPECT_EQ(to_string(s.field.components[3]), "-q2*b");
  EXPECT_EQ(to_string(poisson_bracket(s.field, formula(s, "q1"), formula(s, "p1"))), "1");
}

TEST(ReadSystem, FixedParametersArePutInEverywhere) {
  const System s = read(oscillator, {{"a", "2*b"}, {"b", "1/3"}});
  EXPECT_EQ(to_string(s.field.components[2]), "-2*q1/3");
  EXPECT_TRUE(s.field.parameters.empty());
  EXPECT_THAT(complaint(oscillator, {{"a", "b"}, {"b", "a"}}), HasSubstr("defined by itself"));
  EXPECT_THAT(complaint(oscillator, {{"alpha", "1"}}), HasSubstr("is not a parameter"));
  EXPECT_THAT(complaint(oscillator, {{"a", "q1"}}), HasSubstr("cannot depend on 'q1'"));
}

TEST(ReadSystem, MistakesAreTold) {
  EXPECT_THAT(complaint(R"t([system]
kind = "hamiltonion")t"),
              HasSubstr("did you mean 'hamiltonian'"));
  EXPECT_THAT(complaint(R"t([system]
kind = "hamiltonian"
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/2 + Q^2")t"),
              HasSubstr("5: unknown name 'Q' in hamiltonian / did you mean 'q'?"));
  EXPECT_THAT(complaint(R"t([system]
kind = "hamiltonian"
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/2 - wp(q)")t"),
              HasSubstr("the relation of wp(q) is missing"));
  EXPECT_THAT(complaint(R"t([system]
kind = "hamiltonian"
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/(q - q)")t"),
              HasSubstr("division by zero"));
  EXPECT_THAT(complaint(R"t([system]
kind = "vector-field"
coordinates = ["x", "y"]
[system.field]
x = "y")t"),
              HasSubstr("the derivative of 'y' is missing"));
  EXPECT_THAT(complaint(R"t([system]
kind = "vector-field"
coordinates = ["x", "x"]
[system.field]
x = "1")t"),
              HasSubstr("declared twice"));
  EXPECT_THAT(complaint(oscillator + "[assume]\na = \"positive\"", {{"a", "-1"}}),
              HasSubstr("the assumption 'a positive' is violated"));
  EXPECT_THAT(complaint(oscillator + "[reduce]\nchange = \"q1^2\""), HasSubstr("z = "));
  EXPECT_THAT(complaint(oscillator + "[[manifolds]]"), HasSubstr("did you mean 'manifold'?"));
  EXPECT_THAT(complaint(R"t([system]
kind = "hamiltonian"
coordinates = ["q"]
momenta = ["p"]
parameters = ["a", "b"]
hamiltonian = "p^2/2 + a*q^2"
relations = ["a*b = 1"])t"),
              HasSubstr("a relation between parameters is an assumption"));
  EXPECT_THAT(complaint(R"t([system]
kind = "hamiltonian"
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/2 + z*q^2")t"),
              HasSubstr("unknown name 'z'")); // the name of the new variable is not a parameter
}

TEST(ReadSystem, FunctionsAndTheirRelations) {
  const std::string pendulum = R"t([system]
kind = "hamiltonian"
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/2 - cos(q)"
relations = ["s^2 + c^2 = 1"]
[[system.function]]
name = "s"
means = "sin(q)"
derivative = { q = "c" }
[[system.function]]
name = "c"
means = "cos(q)"
derivative = { q = "SIGNs" }
)t";
  std::string right = pendulum;
  right.replace(right.find("SIGN"), 4, "-");
  const System s = read(right);
  EXPECT_EQ(to_string(s.field.components[1]), "-s");
  std::string wrong = pendulum;
  wrong.replace(wrong.find("SIGN"), 4, "");
  EXPECT_THAT(complaint(wrong), HasSubstr("does not agree with the derivatives"));
}

TEST(ReadSystem, BracketsMustBePoisson) {
  EXPECT_THAT(complaint(R"t([system]
kind = "poisson"
coordinates = ["x", "y", "z1"]
bracket = [["0", "x", "y"], ["-x", "0", "1"], ["-y", "-1", "0"]]
hamiltonian = "x")t"),
              HasSubstr("not a Poisson bracket"));
  const System so3 = read(R"t([system]
kind = "poisson"
coordinates = ["x", "y", "w"]
parameters = ["a", "b", "c"]
bracket = [["0", "-w", "y"], ["w", "0", "-x"], ["-y", "x", "0"]]
hamiltonian = "(a*x^2 + b*y^2 + c*w^2)/2"
[[casimir]]
name = "F"
value = "x^2 + y^2 + w^2"
)t");
  EXPECT_TRUE(check_claim(so3, so3.claims[0]).proved);
}

TEST(Claims, RefutationsShowTheDerivative) {
  const System s = read(oscillator + R"t(
[[integral]]
name  = "L"
value = "q1*p2 - q2*p1"
[[integral]]
name  = "E1"
value = "p1^2 + a*q1^2"
[[darboux]]
name  = "the axis"
value = "q1"
[[integral]]
name  = "on an empty promise"
value = "p1"
on    = "q1 = 0"
)t");
  const ClaimResult l = check_claim(s, s.claims[0]);
  EXPECT_FALSE(l.proved);
  EXPECT_EQ(l.witness, formula(s, "(a - b)*q1*q2"));
  EXPECT_TRUE(check_claim(s, s.claims[1]).proved);
  const ClaimResult level = check_claim(s, s.claims[2]);
  EXPECT_FALSE(level.proved);
  EXPECT_THAT(level.detail, HasSubstr("the level q1 = 0 is not invariant"));
  EXPECT_FALSE(check_claim(s, s.claims[3]).proved); // X(q1) = p1
}

TEST(Claims, DarbouxCofactor) {
  const System s = read(R"t([system]
kind = "vector-field"
coordinates = ["x", "y"]
parameters = ["a"]
[system.field]
x = "x*(1 - y)"
y = "y*(x - a)"
[[darboux]]
name = "x axis"
value = "y"
)t");
  const ClaimResult r = check_claim(s, s.claims[0]);
  EXPECT_TRUE(r.proved);
  EXPECT_EQ(r.witness, formula(s, "x - a"));
}

const std::string double_pendulum = R"t([system]
kind = "lagrangian"
coordinates = ["a", "b"]
velocities = ["da", "db"]
parameters = ["m", "g"]
lagrangian = "(1 + m)*da^2/2 + m*db^2/2 + m*da*db*cos(a - b) + g*(1 + m)*cos(a) + g*m*cos(b)"
)t";

TEST(Lagrangian, OfAnyCoordinates) {
  const System s = read(double_pendulum);
  EXPECT_EQ(s.kind, SystemKind::hamiltonian);
  EXPECT_EQ(s.field.name(2), "p_a");
  // the published Hamiltonian
  EXPECT_EQ(*s.field.hamiltonian,
            formula(s, "(m*p_a^2 + (1 + m)*p_b^2 - 2*m*p_a*p_b*(cos_a*cos_b + sin_a*sin_b))/"
                       "(2*m*(1 + m - m*(cos_a*cos_b + sin_a*sin_b)^2)) - "
                       "g*(1 + m)*cos_a - g*m*cos_b"));
  EXPECT_EQ(s.field.components[0], formula(s, "da"));
}

// Terms linear in the velocities, and names of the momenta; a field of force that is magnetic.
TEST(Lagrangian, LinearTerms) {
  const System s = read(R"t([system]
kind = "lagrangian"
coordinates = ["x", "y"]
velocities = ["dx", "dy"]
momenta = ["u", "v"]
parameters = ["w"]
lagrangian = "(dx^2 + dy^2)/2 + w*(x*dy - y*dx) - x^2*y"
)t");
  EXPECT_EQ(*s.field.hamiltonian, formula(s, "((u + w*y)^2 + (v - w*x)^2)/2 + x^2*y"));
}

TEST(Lagrangian, MistakesAreTold) {
  const std::string begin = "[system]\nkind = \"lagrangian\"\ncoordinates = [\"x\", \"y\"]\n";
  EXPECT_THAT(complaint(begin + "velocities = [\"dx\"]\nlagrangian = \"dx^2\""),
              HasSubstr("as many velocities as coordinates"));
  EXPECT_THAT(complaint(begin + "velocities = [\"dx\", \"dy\"]\nlagrangian = \"dx^3 + dy^2\""),
              HasSubstr("not quadratic in the velocities"));
  EXPECT_THAT(complaint(begin + "velocities = [\"dx\", \"dy\"]\nlagrangian = \"(dx + dy)^2\""),
              HasSubstr("the kinetic energy is degenerate"));
  EXPECT_THAT(complaint("[system]\nkind = \"hamiltonian\"\ncoordinates = [\"x\"]\nmomenta = "
                        "[\"p\"]\nvelocities = [\"dx\"]\nhamiltonian = \"p^2\""),
              HasSubstr("'velocities' is not for a system of kind"));
}

TEST(Weights, SeriesOfARationalFunction) {
  const System s = read(oscillator);
  const Weights w{{s.ring()->index("q1"), 1}, {s.ring()->index("q2"), 2}};
  const auto terms = weight_expansion(formula(s, "q1/(1 - q2)"), w, 3);
  ASSERT_EQ(terms.size(), 3U);
  EXPECT_EQ(terms[1].degree, 3);
  EXPECT_EQ(terms[2].value, formula(s, "q1*q2^2"));
  EXPECT_EQ(weight_expansion(formula(s, "q1 + q2"), w, 5).size(), 2U);
}

// A key that a kind does not read would be passed over in silence.
TEST(ReadSystem, KeysOfOtherKindsAreTold) {
  const auto error_of = [](const std::string& text) -> std::string {
    try {
      static_cast<void>(read_system(parse_document(text, "test.toml")));
      return "";
    } catch (const InputError& e) {
      return e.what();
    }
  };
  const std::string small = "[system]\nkind = 'hamiltonian'\ncoordinates = ['q']\n"
                            "momenta = ['p']\nhamiltonian = 'p^2 + q^2'\n";
  EXPECT_EQ(error_of(small), "");
  for (const std::string more : {"lagrangian = 'q'\n", "gyrostat = [0, 0, 1]\n",
                                 "bracket = [[0, 1], [-1, 0]]\n", "[system.field]\nq = 'p'\n"})
    EXPECT_THAT(error_of(small + more), HasSubstr("is not for a system of kind")) << more;
  EXPECT_THAT(error_of("[system]\nkind = 'vector-field'\ncoordinates = ['q']\nhamiltonian = 'q'\n"
                       "[system.field]\nq = 'q^2'\n"),
              HasSubstr("'hamiltonian' is not for a system of kind vector-field"));
  EXPECT_THAT(error_of("[system]\nkind = 'lagrangian'\ncoordinates = ['q']\nvelocities = ['v']\n"
                       "lagrangian = 'v^2'\nangular_velocity = ['v']\n"),
              HasSubstr("rigid body"));
}

TEST(ReadSystem, NewtonsEquationsAreAFieldOfPositionsAndVelocities) {
  const auto newton = [](const std::string& velocities, const std::string& y) {
    return read_system(parse_document("[system]\nkind = 'newton'\ncoordinates = ['x', 'y']\n" +
                                          velocities + "parameters = ['a']\n" +
                                          "[system.acceleration]\nx = '-a*x + v*y'\n" + y,
                                      "test.toml"));
  };
  const System s = newton("velocities = ['u', 'v']\n", "y = '-y^2 - u'\n");
  EXPECT_EQ(s.kind, SystemKind::vector_field);
  std::vector<std::string> field;
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    field.push_back(s.field.name(j) + "' = " + to_string(s.field.components[j]));
  EXPECT_THAT(field, testing::ElementsAre("x' = u", "y' = v", "u' = -x*a + y*v", "v' = -y^2 - u"));
  const auto complaint_of = [&](const std::string& velocities,
                                const std::string& y) -> std::string {
    try {
      static_cast<void>(newton(velocities, y));
      return "";
    } catch (const InputError& e) {
      return e.what();
    }
  };
  EXPECT_THAT(complaint_of("velocities = ['u', 'v']\n", ""),
              HasSubstr("the acceleration of 'y' is missing"));
  EXPECT_THAT(complaint_of("velocities = ['v']\n", "y = '0'\n"), HasSubstr("as many velocities"));
  EXPECT_THAT(complaint_of("velocities = ['u', 'v']\n", "y = '0'\nu = '1'\n"),
              HasSubstr("'u' is not a coordinate"));
  EXPECT_THAT(complaint_of("momenta = ['u', 'v']\n", "y = '0'\n"),
              HasSubstr("'momenta' is not for a system of kind newton"));
}

} // namespace
} // namespace kov::read_system_test
