// Functions that fall into several ones at special values of the parameters.

#include "classify/classify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::special_relations_test {
namespace {

using testing::HasSubstr;

// r^2 = x^2 + 2 a x y^2 + y^4.  At a = 1 and r = x + y^2 the potential is x^4, integrable.
TEST(SpecialRelations, AreNotExcludedByTheGeneralAnswer) {
  const System s = read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "parameters = ['a']\nhamiltonian = '(u^2 + v^2)/2 + 3/2*(x + y^2 - r)*x*y^2 + x^4'\n"
      "relations = ['r^2 = x^2 + 2*a*x*y^2 + y^4']\n"
      "[[system.function]]\nname = 'r'\nmeans = 'sqrt(x^2 + 2*a*x*y^2 + y^4)'\n"
      "derivative = {x = '(x + a*y^2)/r', y = '(2*a*x*y + 2*y^3)/r'}\n",
      "test.toml"));
  const SystemClassification c = classify_system(s);
  for (const ClassifiedStratum& x : c.strata)
    for (const long one : {1L, -1L}) {
      const Ring& ring = x.where.ring();
      const MPoly there = MPoly::variable(ring, "a") - MPoly(ring, Integer(one));
      if (x.status != StratumStatus::open) {
        EXPECT_TRUE(x.where.where_zero(there).is_empty()) << to_string(x.status);
      }
    }
  EXPECT_THAT(statement(c), HasSubstr("then a^2 = 1"));
}

} // namespace
} // namespace kov::special_relations_test
