// A system at special values of its parameters.

#include "integrability/specialise.hpp"

#include "exact/error.hpp"
#include "system/read_system.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

// r^2 = x^2 + a y^2: at a = 0 it is r = x or r = -x, which are two systems.
TEST(SpecialValues, WhereRelationsFallApart) {
  const System s = read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], "
      "parameters = ['a'], hamiltonian = '(u^2+v^2)/2 - 1/r', relations = ['r^2 = x^2 + a*y^2'], "
      "function = [{name = 'r', means = 'sqrt(x^2 + a*y^2)', "
      "derivative = {x = 'x/r', y = 'a*y/r'}}]}",
      "file.toml"));
  const auto at = [&](long a) {
    return at_values(s, {{s.ring()->index("a"), MFraction(s.ring(), Rational(a))}});
  };
  EXPECT_TRUE(at(4).field.parameters.empty());
  EXPECT_THROW(static_cast<void>(at(0)), DomainError);
}

} // namespace
} // namespace kov
