// Sets that are cut, united and put into words, against their definitions at the points of a grid.

#include "study/parameter_split.hpp"
#include "study/places.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace kov {
namespace {

using test::Random;
using test::random_rounds;
using Point = std::array<long, 3>;

const Ring& ring() {
  static const Ring r = make_ring({"a", "b", "c"});
  return r;
}
ParameterSet everything() { return {ring(), {0, 1, 2}}; }
const MayVanish any = [](const MPoly&) { return true; };

MPoly random_polynomial(Random& random) {
  const MPoly a = MPoly::variable(ring(), 0), b = MPoly::variable(ring(), 1),
              c = MPoly::variable(ring(), 2), one(ring(), Integer(1));
  const std::vector<MPoly> all{a,         b,         c,         a - b,         a - one,
                               a + b - c, a * b - c, a * a - b, a * a - b * b, (a - one) * c,
                               b - one,   c + one,   a * b,     b * b - one,   a * a - b * c};
  return random.one_of(all);
}

ParameterSet random_set(Random& random) {
  ParameterSet set = everything();
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

bool contains(const ParameterSet& set, const Point& at) {
  return std::ranges::all_of(set.equations(), [&](const MPoly& f) { return vanishes_at(f, at); }) &&
         std::ranges::none_of(set.inequations(),
                              [&](const MPoly& f) { return vanishes_at(f, at); });
}
long how_many_contain(const std::vector<ParameterSet>& all, const Point& at) {
  return std::ranges::count_if(all, [&](const ParameterSet& set) { return contains(set, at); });
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
    const ParameterSet set = random_set(random);
    const std::vector<MPoly> zero{random_polynomial(random)};
    const std::vector<MPoly> some{random_polynomial(random), random_polynomial(random)};
    const SetParts parts = split_set(set, zero, {some}, any);
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
    const ParameterSet set = random_set(random);
    const auto parts = by_factors(set, any);
    for (const Point& at : grid())
      EXPECT_EQ(how_many_contain(parts, at), contains(set, at) ? 1 : 0);
  });
}

TEST(SetsOfParameters, SolvedParametersHaveTheirValues) {
  random_rounds(40, [](Random& random) {
    const ParameterSet set = random_set(random);
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
    std::vector<ParameterSet> sets;
    std::vector<ParameterPlace> places;
    for (int k = 0; k < 3; ++k) {
      sets.push_back(random_set(random));
      places.push_back({sets.back(), {}});
    }
    std::vector<ParameterSet> told;
    for (const ParameterPlace& place : in_few_words(places))
      told.push_back(place.where);
    const auto fewer = united(sets);
    EXPECT_LE(fewer.size(), sets.size());
    for (const Point& at : grid()) {
      EXPECT_EQ(how_many_contain(fewer, at) > 0, how_many_contain(sets, at) > 0);
      EXPECT_EQ(how_many_contain(told, at) > 0, how_many_contain(sets, at) > 0);
    }
  });
}

} // namespace
} // namespace kov
