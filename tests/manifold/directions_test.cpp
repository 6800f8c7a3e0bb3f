// Straight lines through the origin, with roots in the potential and with algebraic coefficients.

#include "manifold/directions.hpp"

#include "manifold/find.hpp"
#include "system/system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::directions_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

System read(const std::string& coordinates, const std::string& momenta, const std::string& more,
            const std::string& hamiltonian) {
  return read_system(parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = [" +
                                        coordinates + "]\nmomenta = [" + momenta + "]\n" + more +
                                        "\nhamiltonian = '" + hamiltonian + "'\n",
                                    "test.toml"));
}

std::string text(const std::vector<Equation>& equations) {
  std::string all;
  for (const Equation& e : equations)
    all += (all.empty() ? "" : ", ") + e.text;
  return all;
}

std::vector<std::string> lines(const System& s, const std::vector<MFraction>& integrals = {}) {
  std::vector<std::string> all;
  for (const auto& equations : find_directions(s.field, integrals).lines)
    all.push_back(text(equations));
  return all;
}

// In the heliocentric coordinates of three bodies with the masses 1, m, n in a plane.
System three_bodies(const std::string& more, const std::string& m, const std::string& n) {
  return read("'a', 'b', 'c', 'd'", "'u', 'v', 'w', 'x'", more,
              "(u^2 + v^2)*(1 + 1/" + m + ")/2 + (w^2 + x^2)*(1 + 1/" + n + ")/2 + u*w + v*x - " +
                  m + "/sqrt(a^2 + b^2) - " + n + "/sqrt(c^2 + d^2) - " + m + "*" + n +
                  "/sqrt((a - c)^2 + (b - d)^2)");
}

TEST(Directions, LagrangesTriangle) {
  for (const auto& [m, n] : {std::pair("m", "n"), std::pair("1", "1"), std::pair("1", "3"),
                             std::pair("2", "3"), std::pair("m", "1")}) {
    const System without = three_bodies("parameters = ['m', 'n']", m, n);
    const MFraction momentum = formula(without, "a*v - b*u + c*x - d*w");
    EXPECT_THAT(find_directions(without.field, {momentum}).wanted,
                Contains(MPoly(without.ring(), Integer(3))))
        << m << " " << n;
    const System with =
        three_bodies("parameters = ['m', 'n']\nconstants = ['s']\nrelations = ['s^2 = 3']", m, n);
    EXPECT_THAT(lines(with, {formula(with, "a*v - b*u + c*x - d*w")}),
                Contains("b = 0, c = a/2, d = a*s/2, b' = 0, c' = (1/2)*a', d' = (s/2)*a', root1 = "
                         "a, root2 = a, root3 = a"))
        << m << " " << n;
  }
}

TEST(Directions, EachIsInvariant) {
  const System s =
      three_bodies("parameters = ['m', 'n']\nconstants = ['s']\nrelations = ['s^2 = 3']", "m", "n");
  const MFraction momentum = formula(s, "a*v - b*u + c*x - d*w");
  const auto found = find_manifolds(s.field, {*s.field.hamiltonian, momentum});
  EXPECT_GE(
      std::count_if(found.proved.begin(), found.proved.end(),
                    [](const FoundManifold& m) { return m.kind == "line through the origin"; }),
      2);
}

// x y z: the axes, which are equilibria, and (1, 1, 1) with its mirror images.
TEST(Directions, OfAPolynomial) {
  const System s = read("'x', 'y', 'z'", "'u', 'v', 'w'", "", "(u^2 + v^2 + w^2)/2 + x*y*z");
  EXPECT_THAT(lines(s), Contains("y = x, z = x, y' = x', z' = x'"));
  EXPECT_THAT(lines(s), Contains("y = -x, z = -x, y' = (-1)*x', z' = (-1)*x'"));
  const System masses = read("'x', 'y', 'z'", "'u', 'v', 'w'", "", "(u^2 + 2*v^2 + w^2)/2 + x*y*z");
  EXPECT_THAT(find_directions(masses.field, {}).wanted,
              ElementsAre(MPoly(masses.ring(), Integer(2))));
}

// Parts of several degrees have to agree.
TEST(Directions, OfSeveralParts) {
  const auto both = [](const std::string& form) {
    return lines(
        read("'x', 'y', 'z'", "'u', 'v', 'w'", "", "(u^2 + v^2 + w^2)/2 + x*y*z + " + form));
  };
  EXPECT_THAT(both("x^2 + y^2 + z^2"), Contains("y = x, z = x, y' = x', z' = x'"));
  EXPECT_THAT(both("x^2 + y^2 + 2*z^2"), testing::Not(Contains(HasSubstr("z = x"))));
}

TEST(Directions, WhereThereIsNoSecondOrder) {
  EXPECT_THAT(lines(read("'x', 'y'", "'u', 'v'", "", "(u^2 + v^2)/2 + x*v - y*u")), IsEmpty());
  EXPECT_THAT(lines(read("'x', 'y'", "'u', 'v'", "", "(u^2 + x*v^2)/2 + x*y")), IsEmpty());
  EXPECT_THAT(lines(read("'x', 'y'", "'u', 'v'", "", "(u^2 + v^2)/2 + cos(x)*cos(y)")), IsEmpty());
}

} // namespace
} // namespace kov::directions_test
