// Linear equations of second order with parameters, in every form in which they are written.

#include "support/source_dir.hpp"
#include "symbol/input_error.hpp"
#include "system/in_ring.hpp"
#include "system/linear_formula.hpp"
#include "system/read_system.hpp"

#include <gtest/gtest.h>

namespace kov::linear_formula_test {
namespace {

class LinearFormula : public testing::Test {
protected:
  [[nodiscard]] std::string read(const std::string& text) const {
    const Expression ode = parse_expression(text, "ode", true);
    const auto found = parametric_second_order(ode, "y", scope.ring()->index("z"), scope);
    return to_string(found.c2) + ", " + to_string(found.c1) + ", " + to_string(found.c0);
  }

  const Entry file = parse_document("system = {kind = 'vector-field', coordinates = ['z'], "
                                    "parameters = ['n', 'a'], field = {z = '1'}}",
                                    "f.toml");
  const SystemScope scope{file, {}};
};

TEST_F(LinearFormula, CoefficientsOfBessel) {
  EXPECT_EQ(read("z^2*y'' + z*y' + (z^2 - n^2)*y = 0"), "z^2, z, z^2 - n^2");
  EXPECT_EQ(read("y'' = -y'/z - (1 - n^2/z^2)*y"), read("y'' + y'/z + y - n^2*y/z^2 = 0"));
}

// c (b y')' = c b y'' + c b' y', for b with parameters and denominators.
TEST_F(LinearFormula, DerivativesOfProductsAreExpanded) {
  EXPECT_EQ(read("(z*y')' = n*y"), "z, 1, -n");
  EXPECT_EQ(read("((z^2 + a)*y')' + n*y = 0"), "z^2 + a, 2*z, n");
  EXPECT_EQ(read("(y/z)'' = 0"), read("y''/z - 2*y'/z^2 + 2*y/z^3 = 0"));
  EXPECT_EQ(read("2*((z*y)')' = 0"), read("2*(z*y'' + 2*y') = 0"));
  EXPECT_EQ(read("-(-y'') - a*y = 0"), "1, 0, -a");
}

TEST_F(LinearFormula, DerivativesOfOtherPrograms) {
  EXPECT_EQ(read("diff(y, z, 2) + a*z*y = 0"), "1, 0, z*a");
  EXPECT_EQ(read("diff(z*diff(y(z), z), z) = n*y(z)"), "z, 1, -n");
  EXPECT_EQ(read("diff(a*diff(y, z), z, 1) = diff(y, z, 0)"), "a, 0, -1");
}

TEST_F(LinearFormula, OtherEquationsAreRefused) {
  for (const char* other : {"y' = n*y",              // order one
                            "y''' = n*y",            // order three
                            "y'' = n",               // not homogeneous
                            "y*y'' = n*y",           // not linear
                            "y''^2 = n*y",           //
                            "y'' = 1/y",             //
                            "n*y'' - n*y'' + y = 0", // y'' cancels
                            "y'' = n*y(2*z)",        // another function
                            "diff(y, n, 2) = y", "y'' = unknown*y"})
    EXPECT_THROW(static_cast<void>(read(other)), InputError) << other;
}

// What in_ring leaves: every formula is the same, in the larger ring.
TEST(InRing, EveryPartOfASystemIsMoved) {
  const System s = read_system(test::in_source("/cases/classics/spring_pendulum.toml"));
  auto names = s.ring()->names();
  names.push_back("E");
  const System moved = in_ring(s, make_ring(names));
  ASSERT_EQ(moved.field.dimension(), s.field.dimension());
  for (std::size_t i = 0; i < s.field.dimension(); ++i)
    EXPECT_EQ(to_string(moved.field.components[i]), to_string(s.field.components[i]));
  EXPECT_EQ(moved.ring()->size(), s.ring()->size() + 1);
  EXPECT_EQ(moved.manifolds.size(), s.manifolds.size());
  EXPECT_EQ(to_string(*moved.field.hamiltonian), to_string(*s.field.hamiltonian));
}

} // namespace
} // namespace kov::linear_formula_test
