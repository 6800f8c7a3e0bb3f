// Changes of variables that undo what a user's notation did, and the check that accepts them.

#include "canonical/simplify.hpp"
#include "canonical/systems.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using test::hamiltonian;
using test::lagrangian;
using test::planar;

std::string simple_hamiltonian(const System& s) {
  const auto change = simplified(s);
  if (!change) return "unchanged";
  EXPECT_TRUE(is_canonical(s, *change));
  return to_string(*change->system.field.hamiltonian);
}

TEST(Canonical, CompletesTheSquare) {
  EXPECT_EQ(simple_hamiltonian(planar("((u + x^2*y)^2 + (v + x^3/3)^2)/2 + x^4")),
            "(2*x^4 + u1^2 + v1^2)/2");
  EXPECT_EQ(simple_hamiltonian(planar("(u^2 + v^2)/2 + u*cos(x) + x^4 + cos(x)^2/2")),
            "(2*x^4 + u1^2 + v^2)/2");
  // a magnetic field stays, in its symmetric gauge
  EXPECT_EQ(simple_hamiltonian(planar("((u - y)^2 + v^2)/2 + x^4")),
            simple_hamiltonian(planar("(u^2 + (v + x)^2)/2 + x^4")));
}

TEST(Canonical, MovesTheOrigin) {
  const std::string henon_heiles = "(u^2 + v^2 + x^2 + y^2)/2 + x^2*y - y^3/3";
  EXPECT_EQ(simple_hamiltonian(planar(henon_heiles)), "unchanged");
  EXPECT_EQ(simple_hamiltonian(
                planar("(u^2 + v^2 + (x-2)^2 + (y+1/3)^2)/2 + (x-2)^2*(y+1/3) - (y+1/3)^3/3")),
            "(6*x1^2*y1 + 3*x1^2 - 2*y1^3 + 3*y1^2 + 3*u^2 + 3*v^2)/6");
  EXPECT_EQ(simple_hamiltonian(planar("(u^2 + v^2)/2 + (x - a)^4 + b*(x - a)^2*(y + b)^2")),
            "(2*x1^4 + 2*x1^2*y1^2*b + u^2 + v^2)/2");
  EXPECT_EQ(simple_hamiltonian(planar("(u^2 + v^2)/2 + 1/((x - 1)^2 + (y - 3)^2)")),
            "(x1^2*u^2 + x1^2*v^2 + y1^2*u^2 + y1^2*v^2 + 2)/(2*x1^2 + 2*y1^2)");
}

TEST(Canonical, ExchangesCoordinatesAndMomenta) {
  EXPECT_EQ(simple_hamiltonian(planar("(x^2 + y^2)/2 + u^4 + u^2*v^2")),
            "(2*x1^4 + 2*x1^2*y1^2 + u1^2 + v1^2)/2");
  EXPECT_EQ(simple_hamiltonian(planar("(x^2 + v^2)/2 + u^4 + u^2*y^2")),
            "(2*x1^4 + 2*x1^2*y^2 + u1^2 + v^2)/2");
}

TEST(Canonical, FindsFlatCoordinates) {
  const std::string quartic = "(2*X^4 + 12*X^2*Y^2 + 2*Y^4 + U^2 + V^2)/2";
  const auto potential = [](const std::string& x, const std::string& y) {
    std::string v = "((X)^4 + 6*(X)^2*(Y)^2 + (Y)^4)";
    for (std::size_t i; (i = v.find_first_of("XY")) != std::string::npos;)
      v.replace(i, 1, v[i] == 'X' ? x : y);
    return v;
  };
  EXPECT_EQ(
      simple_hamiltonian(lagrangian("'r', 't'", "'vr', 'vt'",
                                    "(vr^2 + r^2*vt^2)/2 - " + potential("r*sin(t)", "r*cos(t)"))),
      quartic);
  EXPECT_EQ(simple_hamiltonian(
                lagrangian("'r', 't'", "'vr', 'vt'",
                           "(r^2 + t^2)*(vr^2 + vt^2)/2 - " + potential("(r^2 - t^2)/2", "r*t"))),
            quartic);
  EXPECT_EQ(simple_hamiltonian(lagrangian("'m', 'n'", "'vm', 'vn'",
                                          "(cosh(m)^2 - cos(n)^2)*(vm^2 + vn^2)/2 - " +
                                              potential("cosh(m)*cos(n)", "sinh(m)*sin(n)"))),
            quartic);
}

TEST(Canonical, APotentialMayNeedASquareRoot) {
  const System kepler =
      lagrangian("'r', 't'", "'vr', 'vt'", "(vr^2 + r^2*vt^2)/2 + 1/r - a*r*cos(t)");
  const auto change = simplified(kepler);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->system.field.functions.size(), 1U);
  EXPECT_TRUE(is_canonical(kepler, *change));
}

// Each part of the check alone.
TEST(Canonical, AcceptsNoOtherChange) {
  const System s = planar("((u + x^2*y)^2 + (v + x^3/3)^2)/2 + (x - 1)^4");
  const CanonicalChange right = *simplified(s);
  const auto refused = [&](auto spoil) {
    CanonicalChange wrong = right;
    spoil(wrong);
    return !is_canonical(s, wrong);
  };
  EXPECT_FALSE(refused([](CanonicalChange&) {}));
  EXPECT_TRUE(refused([&](CanonicalChange& c) { c.variables[0] += MFraction(s.ring(), 1); }));
  EXPECT_TRUE(refused([&](CanonicalChange& c) { std::swap(c.variables[0], c.variables[2]); }));
  EXPECT_TRUE(refused([&](CanonicalChange& c) { c.variables[1] = -c.variables[1]; }));
  EXPECT_TRUE(refused(
      [&](CanonicalChange& c) { *c.system.field.hamiltonian += MFraction(c.system.ring(), 1); }));
  EXPECT_TRUE(refused(
      [&](CanonicalChange& c) { c.system.field.components[0] += MFraction(c.system.ring(), 1); }));
}

} // namespace
} // namespace kov
