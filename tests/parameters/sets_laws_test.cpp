// Sets that are cut, united and put into words, against their definitions at the points of a grid.

#include "parameters/few_sets.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace kov::sets_laws_test {
namespace {

using test::Random;
using test::random_rounds;
using Point = std::array<long, 3>;

const Ring& ring() {
  static const Ring r = make_ring({"a", "b", "c"});
  return r;
}
Set everything() { return {ring(), {0, 1, 2}}; }
const MayVanish any = [](const MPoly&) { return true; };

MPoly random_polynomial(Random& random) {
  const MPoly a = MPoly::variable(ring(), 0), b = MPoly::variable(ring(), 1),
              c = MPoly::variable(ring(), 2), one(ring(), Integer(1));
  const std::vector<MPoly> all{a,         b,         c,         a - b,         a - one,
                               a + b - c, a * b - c, a * a - b, a * a - b * b, (a - one) * c,
                               b - one,   c + one,   a * b,     b * b - one,   a * a - b * c};
  return random.one_of(all);
}

Set random_set(Random& random) {
  Set set = everything();
  for (long k = random.between(0, 2); k > 0; --k)
    set = set.where_zero(random_polynomial(random));
  for (long k = random.between(0, 2); k > 0; --k)
    set = set.where_nonzero(random_polynomial(random));
  return set;
}

bool vanishes_at(const MPoly& f, const Point& at) {
  Substitution values;
  for (std::size_t i = 0; i < at.size(); ++i)
    values[i] = MFraction(ring(), Rational(at[i]));
  return is_zero(f) || is_zero(substitute(MFraction(f), values));
}

bool contains(const Set& set, const Point& at) {
  return std::ranges::all_of(set.equations(), [&](const MPoly& f) { return vanishes_at(f, at); }) &&
         std::ranges::none_of(set.inequations(),
                              [&](const MPoly& f) { return vanishes_at(f, at); });
}
long how_many_contain(const std::vector<Set>& all, const Point& at) {
  return std::ranges::count_if(all, [&](const Set& set) { return contains(set, at); });
}

std::vector<Point> grid() {
  std::vector<Point> all;
  for (long a = -2; a <= 2; ++a)
    for (long b = -2; b <= 2; ++b)
      for (long c = -2; c <= 2; ++c)
        all.push_back({a, b, c});
  return all;
}

TEST(SetsOfParameters, PartsAreDisjointAndWhatTheySay) {
  random_rounds(40, [](Random& random) {
    const Set set = random_set(random);
    const std::vector<MPoly> zero{random_polynomial(random)};
    const std::vector<MPoly> some{random_polynomial(random), random_polynomial(random)};
    const CutParts parts = split(set, {.zero = zero, .not_all_zero = {some}}, any);
    for (const Point& at : grid()) {
      const bool is_inside =
          vanishes_at(zero[0], at) && !(vanishes_at(some[0], at) && vanishes_at(some[1], at));
      EXPECT_EQ(how_many_contain(parts.inside, at), contains(set, at) && is_inside ? 1 : 0);
      EXPECT_EQ(how_many_contain(parts.outside, at), contains(set, at) && !is_inside ? 1 : 0);
    }
  });
}

TEST(SetsOfParameters, FactorsTellDisjointParts) {
  random_rounds(40, [](Random& random) {
    const Set set = random_set(random);
    const auto parts = by_factors(set, any);
    for (const Point& at : grid())
      EXPECT_EQ(how_many_contain(parts, at), contains(set, at) ? 1 : 0);
  });
}

TEST(SetsOfParameters, SolvedParametersHaveTheirValues) {
  random_rounds(40, [](Random& random) {
    const Set set = random_set(random);
    const SolvedSet solved = solve(set);
    for (const Point& at : grid())
      for (const auto& [i, value] : solved.values) {
        const MPoly x = MPoly::variable(ring(), i);
        const MPoly equation = is_zero(value) ? x : value.den() * x - value.num();
        EXPECT_TRUE(!contains(set, at) || vanishes_at(equation, at));
      }
  });
}

TEST(SetsOfParameters, TheUnionStays) {
  random_rounds(40, [](Random& random) {
    std::vector<Set> sets;
    for (int k = 0; k < 3; ++k)
      sets.push_back(random_set(random));
    const std::vector<Set> told = in_few_words(sets);
    const auto fewer = united(sets);
    EXPECT_LE(fewer.size(), sets.size());
    for (const Point& at : grid()) {
      EXPECT_EQ(how_many_contain(fewer, at) > 0, how_many_contain(sets, at) > 0);
      EXPECT_EQ(how_many_contain(told, at) > 0, how_many_contain(sets, at) > 0);
    }
  });
}

// The points of a set are those of another that satisfy its conditions, as they are written in its ring.
TEST(SetsOfParameters, ConditionsMeanTheSameInAnotherSet) {
  random_rounds(40, [](Random& random) {
    const Set set = random_set(random), other = random_set(random);
    const Set both = set.within(other);
    const CutParts parts = split(other, cut_of(set), any);
    const Cut same = moved(cut_of(set), [](const MFraction& f) { return f; });
    EXPECT_EQ(same.zero, set.equations());
    for (const Point& at : grid()) {
      const bool in_both = contains(set, at) && contains(other, at);
      EXPECT_EQ(contains(both, at), in_both);
      EXPECT_EQ(how_many_contain(parts.inside, at), in_both ? 1 : 0);
      EXPECT_EQ(how_many_contain(parts.outside, at), contains(other, at) && !in_both ? 1 : 0);
    }
  });
}

// Where sqrt(a) is an integer, and where it is not, as far as the statement is decided.
TEST(SetsOfParameters, AStatementCutsASet) {
  const MPoly a = MPoly::variable(ring(), 0);
  const Statement integer{SomeIn{{MFraction(a)}, Classes{all_integers}}};
  const auto number = [](long n) { return MPoly(ring(), Integer(n)); };
  const CutParts parts = split(everything(), {.statements = {integer}}, any);
  ASSERT_EQ(parts.inside.size(), 1U);
  ASSERT_EQ(parts.outside.size(), 1U);
  for (long n = -3; n <= 9; ++n) {
    const bool is_square = n == 0 || n == 1 || n == 4 || n == 9;
    EXPECT_EQ(parts.inside[0].where_zero(a - number(n)).settled().has_value(), is_square) << n;
    EXPECT_EQ(parts.outside[0].where_zero(a - number(n)).settled().has_value(), !is_square) << n;
  }
  // a = 4 says it, and it is said no more; what is said twice is said once
  EXPECT_TRUE(parts.inside[0].where_zero(a - number(4)).settled()->is_algebraic());
  EXPECT_EQ(parts.inside[0].where(integer)->statements().size(), 1U);
  EXPECT_FALSE(parts.inside[0].where(negation(integer)));
  EXPECT_TRUE(split(parts.inside[0], {.statements = {integer}}, any).outside.empty());
}

} // namespace
} // namespace kov::sets_laws_test
