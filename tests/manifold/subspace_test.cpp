// Straight lines off the origin in invariant subspaces of two degrees of freedom.

#include "manifold/find.hpp"
#include "manifold/lines.hpp"
#include "manifold/subspace.hpp"
#include "system/system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::subspace_test {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

System read(const std::string& coordinates, const std::string& momenta, const std::string& more,
            const std::string& hamiltonian) {
  return read_system(parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = [" +
                                        coordinates + "]\nmomenta = [" + momenta + "]\n" + more +
                                        "\nhamiltonian = '" + hamiltonian + "'\n",
                                    "test.toml"));
}

std::vector<std::string> curves(const FoundManifolds& all) {
  std::vector<std::string> texts;
  for (const FoundManifold& m : all.proved)
    if (m.leaf_dimension() == 1 && !m.equilibria) {
      std::string text;
      for (const Equation& e : m.equations)
        text += (text.empty() ? "" : ", ") + e.text;
      texts.push_back(text);
    }
  return texts;
}

// Two masses on springs of length 1, of strength k and l.
System double_spring(const std::string& k, const std::string& l, const std::string& more = "") {
  return read("'x', 'y', 'X', 'Y'", "'u', 'v', 'U', 'V'", more,
              "(u^2 + v^2 + U^2 + V^2)/2 - y - Y + " + k + "*(sqrt(x^2 + y^2) - 1)^2/2 + " + l +
                  "*(sqrt((X - x)^2 + (Y - y)^2) - 1)^2/2");
}

// 3, 2: the modes have the frequencies 1 and sqrt(6); the equilibrium is 5/3, 19/6.
TEST(Subspaces, ModesOfADoubleSpring) {
  const System s = double_spring("3", "2");
  const FoundManifolds found = find_manifolds(s.field, {*s.field.hamiltonian});
  EXPECT_THAT(curves(found),
              Contains("Y = (12*y - 1)/6, V = 2*v, x = 0, X = 0, u = 0, U = 0, root1 = y, "
                       "root2 = -y + Y"));
  EXPECT_THAT(curves(found), SizeIs(8)); // two modes, two signs of each length
}

TEST(Subspaces, ModesOverASquareRoot) {
  const System without = double_spring("1", "1");
  const FoundManifolds none = find_manifolds(without.field, {*without.field.hamiltonian});
  EXPECT_THAT(curves(none), IsEmpty());
  EXPECT_THAT(none.wanted, Contains(MPoly(without.ring(), Integer(5))));
  const System with = double_spring("1", "1", "constants = ['s']\nrelations = ['s^2 = 5']");
  const auto found = curves(find_manifolds(with.field, {*with.field.hamiltonian}));
  EXPECT_THAT(found, SizeIs(8));
  EXPECT_THAT(found, Contains("Y = (y*s + y - 3*s + 7)/2, V = (v*s + v)/2, x = 0, X = 0, u = 0, "
                              "U = 0, root1 = y, root2 = -y + Y")); // no denominator has s
}

TEST(Subspaces, AreOfTwoDegreesOfFreedom) {
  const System s = read("'x', 'y', 'z'", "'u', 'v', 'w'", "",
                        "(u^2 + v^2 + w^2)/2 + x^2*y + y^3 + (y - 1)^2*x^2 + z^2*x + z^4");
  const MFraction o(s.ring());
  const auto at = [&](std::initializer_list<const char*> names) {
    Substitution solved;
    for (const char* n : names)
      solved[s.ring()->index(n)] = o;
    return fields_on_subspace(s.field, solved);
  };
  EXPECT_THAT(at({"z", "w"}), SizeIs(1));
  EXPECT_THAT(at({"z", "u"}), IsEmpty()); // a coordinate without its momentum
  EXPECT_THAT(at({"z"}), IsEmpty());
}

// sin(z) has no rational value, but at z = 0 where its own equations say so.
TEST(Subspaces, FunctionsHaveTheirValues) {
  const System s =
      read("'x', 'y', 'z'", "'u', 'v', 'w'", "", "(u^2 + v^2 + w^2)/2 + x*sin(z) + y^2 + x^2*y");
  const MFraction o(s.ring());
  const auto index = [&](const char* n) { return s.ring()->index(n); };
  EXPECT_THAT(fields_on_subspace(s.field, {{index("x"), o}, {index("u"), o}}), IsEmpty());
  EXPECT_THAT(fields_on_subspace(s.field, {{index("z"), o}, {index("w"), o}, {index("sin_z"), o}}),
              SizeIs(2)); // cos(z) = 1 and -1
}

} // namespace
} // namespace kov::subspace_test
