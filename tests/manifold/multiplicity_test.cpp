// A set is the same for f = 0 and f^k = 0; whether it is invariant is so, too.

#include "manifold/invariant_manifold.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace kov::multiplicity_test {
namespace {

using testing::HasSubstr;

/// The plane with x' and y', and whatever else.
System plane(const std::string& x, const std::string& y, const std::string& more) {
  return read_system(parse_document("[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", "
                                    "\"y\"]\n[system.field]\nx = \"" +
                                        x + "\"\ny = \"" + y + "\"\n" + more,
                                    "test.toml"));
}

std::string manifold(const std::string& equation) {
  return "[[manifold]]\nequations = [\"" + equation + " = 0\"]\n";
}

bool is_invariant(const System& s) {
  return std::holds_alternative<InvariantManifold>(prove_invariant(s.field, s.manifolds.at(0)));
}

bool is_claimed(const System& s) { return check_claim(s.field, s.claims.at(0)).proved; }

/// f = y - a x^2 - b x is invariant for x' = 1, y' = 2 a x + b + g f, and not for y' + c, c != 0.
struct Parabola {
  explicit Parabola(std::mt19937& generator) {
    std::uniform_int_distribution<int> number(-3, 3);
    const std::string a = std::to_string(number(generator));
    const std::string b = std::to_string(number(generator));
    f = "(y - (" + a + ")*x^2 - (" + b + ")*x)";
    slope = "2*(" + a + ")*x + (" + b + ") + (x + (" + b + "))*" + f;
    other = slope + " + " + std::to_string(number(generator) + 4);
  }
  std::string f, slope, other;
};

TEST(Multiplicity, OfAManifoldAndADarbouxPolynomial) {
  std::mt19937 generator(5);
  for (int round = 0; round < 5; ++round) {
    const Parabola p(generator);
    for (const char* power : {"", "^2", "^3", "^6"}) {
      const std::string g = p.f + power;
      EXPECT_TRUE(is_invariant(plane("1", p.slope, manifold(g)))) << g;
      EXPECT_FALSE(is_invariant(plane("1", p.other, manifold(g)))) << g;
      const std::string darboux = "[[darboux]]\nname = \"G\"\nvalue = \"" + g + "\"\n";
      EXPECT_TRUE(is_claimed(plane("1", p.slope, darboux))) << g;
      EXPECT_FALSE(is_claimed(plane("1", p.other, darboux))) << g;
    }
  }
}

TEST(Multiplicity, OfALevel) {
  for (const char* power : {"", "^2", "^3"}) {
    const std::string on =
        "[[integral]]\nname = \"F\"\nvalue = \"y\"\non = \"x" + std::string(power) + " = 0\"\n";
    EXPECT_FALSE(is_claimed(plane("1", "x", on))) << power;
    EXPECT_TRUE(is_claimed(plane("x*y", "x", on))) << power;
  }
}

TEST(Multiplicity, IsToldWhereTheEquationsAreReadWithoutIt) {
  const System s = plane("x", "1", manifold("x^2"));
  const auto proved = prove_invariant(s.field, s.manifolds.at(0));
  ASSERT_TRUE(std::holds_alternative<InvariantManifold>(proved));
  EXPECT_THAT(std::get<InvariantManifold>(proved).rewritten.front(),
              HasSubstr("'x^2 = 0' is read as x"));
}

// Several equations, none a power, whose ideal is not radical: x = y = 0 with x' = 1.
TEST(Multiplicity, HiddenInSeveralEquations) {
  const System s = plane("1", "x", "[[manifold]]\nequations = [\"y = x^2\", \"y + x^2 = 0\"]\n");
  const auto proved = prove_invariant(s.field, s.manifolds.at(0));
  ASSERT_TRUE(std::holds_alternative<ManifoldFailure>(proved));
}

// Products and components of several dimensions; what the equations say together counts.
TEST(Multiplicity, OfSeveralComponents) {
  const struct {
    const char *x, *y, *z, *equations;
    bool invariant;
  } table[] = {
      {"x", "y*z", "z", "\"x*y = 0\", \"x*z = 0\"", true},           // a plane and a line
      {"x", "y*(1 + z)", "1", "\"x*y = 0\", \"x*z = 0\"", false},    // the line moves
      {"x*y", "x^2", "z*x", "\"x*y = 0\", \"x^2 = 0\"", true},       // an embedded line
      {"x", "y*z", "1", "\"x^2 = 0\", \"x*y = 0\"", true},           //
      {"1", "x", "y*z", "\"y*z = 0\", \"y^2 = 0\"", false},          // the plane y = 0, y' = x
      {"1", "2*x", "x", "\"y = x^2\", \"y = 0\"", false},            // curves that touch
      {"x", "2*y", "1", "\"y^2 = x^4\", \"x*(y - x^2) = 0\"", true}, // y = x^2
      {"x", "y", "1", "\"y^2 = x^4\", \"x*(y - x^2) = 0\"", false},
  };
  for (const auto& t : table) {
    const System s = read_system(parse_document(
        std::string("[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", \"y\", \"z\"]\n") +
            "[system.field]\nx = \"" + t.x + "\"\ny = \"" + t.y + "\"\nz = \"" + t.z +
            "\"\n[[manifold]]\nequations = [" + t.equations + "]\n",
        "test.toml"));
    const auto& equations = s.manifolds.at(0).equations;
    const Ideal ideal = relation_ideal(s.field, set_generators(equations));
    EXPECT_EQ(!invariance_failure(s.field, equations, ideal), t.invariant) << t.x << t.equations;
  }
}

// c = 1 touches the circle: on it s = 0, and c' = -s vanishes there.
TEST(Multiplicity, HiddenInARelation) {
  const std::string text = R"t([system]
kind = "vector-field"
coordinates = ["q"]
relations = ["s^2 + c^2 = 1"]
[system.field]
q = "SPEED"
[[system.function]]
name = "s"
derivative = { q = "c" }
[[system.function]]
name = "c"
derivative = { q = "-s" }
[[darboux]]
name = "G"
value = "c - 1"
[[integral]]
name = "F"
value = "c"
on = "c = 1"
[[manifold]]
equations = ["c = 1"]
)t";
  const auto with = [&](const std::string& speed) {
    std::string t = text;
    return read_system(parse_document(t.replace(t.find("SPEED"), 5, speed), "test.toml"));
  };
  const System moving = with("1");
  for (const SystemClaim& claim : moving.claims)
    EXPECT_FALSE(check_claim(moving.field, claim).proved) << claim.name;
  EXPECT_FALSE(is_invariant(moving));
  const System pendulum = with("s"); // q = 0 is an equilibrium
  EXPECT_TRUE(check_claim(pendulum.field, pendulum.claims.at(0)).proved);
}

} // namespace
} // namespace kov::multiplicity_test
