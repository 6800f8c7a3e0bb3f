#include "classify/bounded.hpp"

#include "exact/error.hpp"
#include "support/statements.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::bounded_test {
namespace {

using test::Kind;
using test::numbers;
using test::some;
using testing::ElementsAre;

System with(const std::string& assumed) {
  return read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['q']\nmomenta = ['p']\nparameters = ['s', "
      "'t']\nhamiltonian = 'p^2/2 + s*q + t*q^2'\n[assume]\n" +
          assumed,
      "test.toml"));
}

struct Plane {
  System system;
  MFraction s = MFraction::variable(system.ring(), "s"),
            t = MFraction::variable(system.ring(), "t");
  Set all{system.ring(), system.field.parameters};
  [[nodiscard]] MFraction number(long n) const { return {system.ring(), Rational(n)}; }
};
Statement integer(const MFraction& x) { return some(Kind::integer, {x * x}); }

TEST(Bounded, OneDifferenceBetweenBounds) {
  const Plane p{with("s = 'real'\nconditions = ['s > 0', 's < 3']")};
  const auto b = bounded_values(p.system, *p.all.where(std::vector<Statement>{integer(p.s)}));
  ASSERT_TRUE(b);
  EXPECT_THAT(b->values.values,
              ElementsAre(0, 1, 4, 9)); // 0 and 3 are not points: that is seen later
  EXPECT_TRUE(b->trusted.empty());      // 0 < s < 3 and s^2 > 9: the judge sees it
}

TEST(Bounded, NotOfComplexParametersOrWithoutBounds) {
  const Plane p{with("t = 'real'\n")};
  EXPECT_FALSE(bounded_values(p.system, *p.all.where(std::vector<Statement>{integer(p.s)})));
  EXPECT_FALSE(bounded_values(p.system, *p.all.where(std::vector<Statement>{integer(p.t)})));
  EXPECT_FALSE(bounded_values(p.system, *p.all.where(std::vector<Statement>{})));
  const Plane q{with("s = 'real'\nconditions = ['s > 0', 's < 3']")};
  Statement rational = integer(q.s), negated = integer(q.s);
  numbers(rational).classes.reset();
  negated.holds = false;
  EXPECT_FALSE(bounded_values(q.system, *q.all.where(std::vector<Statement>{rational})));
  EXPECT_FALSE(bounded_values(q.system, *q.all.where(std::vector<Statement>{negated})));
}

// 2s and 2s/(s^2 + t^2): the second is not an integer for large s, unless it may be 0.
TEST(Bounded, ByTheDistanceOfAnother) {
  const Plane p{with("s = 'real'\nt = 'positive'\n")};
  const MFraction m = Rational(2) * p.s, n = m / (p.s * p.s + p.t * p.t);
  EXPECT_FALSE(
      bounded_values(p.system, *p.all.where(std::vector<Statement>{integer(m), integer(n)})));
  const auto b = bounded_values(p.system, *p.all.where_nonzero(p.s.num()).where(
                                              std::vector<Statement>{integer(m), integer(n)}));
  ASSERT_TRUE(b);
  EXPECT_EQ(b->condition, 0U);
  EXPECT_THAT(b->values.values, ElementsAre(0, 1, 4, 9, 16));
  Statement halves = integer(n); // |n| >= 1/2 only
  numbers(halves).classes = Kind::half_integer;
  const auto wider = bounded_values(
      p.system, *p.all.where_nonzero(p.s.num()).where(std::vector<Statement>{integer(m), halves}));
  ASSERT_TRUE(wider);
  EXPECT_EQ(wider->values.values.back(), Rational(64));
}

} // namespace
} // namespace kov::bounded_test
