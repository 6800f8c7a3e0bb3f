// Blocks of the normal part that fall apart after a constant change of the unknowns.

#include "integrability/decoupling.hpp"
#include "support/checked.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::decoupling_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

ManifoldReport run(const std::string& text) { return test::checked(text); }

// Along the third axis of p^2/2 + z^4/4 + z^2 (a quadratic form) + ...
std::string axis(const std::string& form, const std::string& more = "",
                 const std::string& kinetic = "u^2 + v^2") {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\nmomenta = ['u', 'v', "
         "'w']\n"
         "hamiltonian = '(" +
         kinetic + " + w^2)/2 + z^4/4 + z^2*(" + form + ")" + more +
         "'\n[[manifold]]\nname = 'axis'\nequations = ['x = 0', 'y = 0', 'u = 0', 'v = 0']\n"
         "level = ['H = 1']\n";
}

std::vector<std::string> equations(const ManifoldReport& m) {
  std::vector<std::string> all;
  for (const BlockReport& b : m.blocks)
    all.push_back(b.ode ? to_string(b.ode->r) : note(b.missing));
  return all;
}

std::string all_reasons(const ManifoldReport& m) {
  std::string text;
  for (const auto& r : reasons(m))
    text += r + "\n";
  for (const BlockReport& b : m.blocks)
    text += note(b.missing) + "\n";
  return text;
}

// Rotations do not change what is said: the eigenvalues 10 and 4 of the form, in other coordinates.
TEST(Decoupling, TheSameEquationsAfterARotation) {
  const auto straight = run(axis("5*x^2 + 2*y^2"));
  const auto turned = run(axis("7/2*x^2 + 3*x*y + 7/2*y^2"));
  const auto by_3_4_5 = run(axis("5*(3*x + 4*y)^2/25 + 2*(4*x - 3*y)^2/25"));
  const auto expected = equations(straight);
  ASSERT_EQ(expected.size(), 2U);
  EXPECT_THAT(equations(turned), testing::UnorderedElementsAreArray(expected));
  EXPECT_THAT(equations(by_3_4_5), testing::UnorderedElementsAreArray(expected));
  EXPECT_EQ(turned.verdict, straight.verdict);
  EXPECT_EQ(by_3_4_5.verdict, straight.verdict);
}
TEST(Decoupling, TwoConstantMatricesThatCommute) {
  const auto apart = run(axis("7/2*x^2 + 3*x*y + 7/2*y^2", " + x^2 + y^2 + x*y"));
  EXPECT_EQ(apart.blocks.size(), 2U);
  const auto not_apart = run(axis("7/2*x^2 + 3*x*y + 7/2*y^2", " + 3*x^2 + y^2"));
  EXPECT_THAT(all_reasons(not_apart), HasSubstr("a normal block of order 4"));
}
TEST(Decoupling, OtherKineticEnergies) {
  const auto m = run(axis("x^2 + 2*y^2", "", "u^2 + 3*v^2")); // eigenvalues 2 and 12
  ASSERT_EQ(m.blocks.size(), 2U);
  const auto same = run(axis("(x + y)^2/2 + 6*(x - y)^2/2"));
  EXPECT_THAT(equations(same), testing::UnorderedElementsAreArray(equations(m)));
}
// A Jordan block is triangular, and coupled.
TEST(Decoupling, JordanBlocks) {
  const auto m = run(axis("2*x^2 + 2*y^2", " + z^2*(x^2 - y^2)/5", "u^2 + v^2"));
  EXPECT_EQ(m.blocks.size(), 2U);
  // x^2 + 2 (x + i y)^2 over Q(i) needs i; with the kinetic energy 2 u v it does not
  const auto nilpotent = run(axis("2*x*y + x^2", "", "2*u*v"));
  ASSERT_EQ(nilpotent.blocks.size(), 2U);
  EXPECT_EQ(to_string(nilpotent.blocks[0].ode->r), to_string(nilpotent.blocks[1].ode->r));
  EXPECT_THAT(to_string(nilpotent.verdict), Not(HasSubstr("no obstruction")));
}
// sqrt(2): nothing is said, and that is told; where it is adjoined (eigenvalue.hpp) the block falls apart.
TEST(Decoupling, IrrationalEigenvaluesStayTogether) {
  const std::string text = axis("x^2 + 2*x*y - y^2");
  EXPECT_EQ(run(text).blocks.size(), 2U);
  const auto m = test::checked(study::FileStudy(read_system(parse_document(text, "test.toml"))));
  EXPECT_THAT(all_reasons(m), HasSubstr("a normal block of order 4"));
}
TEST(Decoupling, ParametersInTheEigenvectors) {
  const auto m = run("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\n"
                     "momenta = ['u', 'v', 'w']\nparameters = ['a', 'k']\n"
                     "hamiltonian = '(u^2 + v^2 + w^2)/2 + z^4/4 + z^2*(k*(x + a*y)^2 + "
                     "(y - a*x)^2)'\n[[manifold]]\nname = 'axis'\n"
                     "equations = ['x = 0', 'y = 0', 'u = 0', 'v = 0']\nlevel = ['H = 1']\n");
  EXPECT_EQ(m.blocks.size(), 2U);
  for (const BlockReport& b : m.blocks)
    EXPECT_TRUE(b.ode) << note(b.missing);
}

// What a search writes: there is no such equation at a = 0.
TEST(Decoupling, PolesOfTheEquationsAreDividedBy) {
  const System s = read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\nmomenta = ['u', 'v', 'w']\n"
      "parameters = ['a']\nhamiltonian = '(u^2 + v^2 + w^2)/2 + x^4/4 + x^2*(y^2 + z^2)/2'\n",
      "test.toml"));
  const MFraction a = formula(s, "a");
  ManifoldSpec m;
  m.name = "axis";
  for (const auto& f : {formula(s, "y") + formula(s, "z") / a, formula(s, "z"),
                        formula(s, "v") + formula(s, "w") / a, formula(s, "w")})
    m.equations.push_back({f, to_string(f) + " = 0"});
  m.levels = {{formula(s, "H - 1"), "H = 1"}};
  const auto proved = std::get<InvariantManifold>(prove_invariant(s.field, m));
  EXPECT_THAT(normal_system(s.field, proved, {}).divisors, testing::Contains(a.num()));
}

} // namespace
} // namespace kov::decoupling_test
