// The order of classes of first integrals: what excludes what, and what is excluded at once.

#include "literature/integral_class.hpp"

#include "support/random.hpp"

#include <gmock/gmock.h>

namespace kov {
namespace {

using test::Random;
using test::random_rounds;
using testing::ElementsAre;
using Kind = IntegralClass::Kind;
using Near = IntegralClass::Near;

IntegralClass along(std::vector<std::string> curves, Near near = Near::curve) {
  return {.near = near, .curves = std::move(curves)};
}
IntegralClass rational() { return {.kind = Kind::rational, .near = Near::phase_space}; }

TEST(IntegralClass, ASmallerClassIsExcludedWithALargerOne) {
  const IntegralClass near = along({"N"}), closed = along({"N"}, Near::closed_curve);
  EXPECT_EQ(contains(near, closed), Truth::yes);
  EXPECT_EQ(contains(closed, near), Truth::unknown);
  EXPECT_EQ(contains(near, rational()), Truth::yes);
  EXPECT_EQ(contains(closed, rational()), Truth::yes);
  EXPECT_EQ(contains(rational(), closed), Truth::unknown);
  EXPECT_EQ(contains(near, along({"N", "M"})), Truth::yes); // near both is near one
  EXPECT_EQ(contains(along({"N", "M"}), near), Truth::unknown);
  EXPECT_EQ(contains(near, along({"M"})), Truth::unknown);
}

TEST(IntegralClass, RationalInASineIsNotMeromorphicAtInfinity) {
  IntegralClass closed = along({"N"}, Near::closed_curve), in_sine = rational();
  closed.functions = in_sine.functions = {"s"};
  EXPECT_EQ(contains(closed, in_sine), Truth::unknown);
  EXPECT_EQ(at_once({closed, in_sine}).size(), 2U);
  IntegralClass near = along({"N"});
  EXPECT_EQ(contains(near, in_sine), Truth::unknown); // the sine is not a symbol of that class
  near.functions = {"s"};
  EXPECT_EQ(contains(near, in_sine), Truth::yes);
  EXPECT_THAT(at_once({near, in_sine}), ElementsAre(in_sine));
}

TEST(IntegralClass, WhatIsLeftOutMakesItSmaller) {
  IntegralClass all = along({"N"}), without = all, without_two = all;
  without.without = {"q"};
  without_two.without = {"q", "p"};
  EXPECT_EQ(contains(all, without), Truth::yes);
  EXPECT_EQ(contains(without, without_two), Truth::yes);
  EXPECT_EQ(contains(without, all), Truth::unknown);
  IntegralClass through = without; // functions of q are allowed: a larger class than without q
  through.functions = {"s"};
  through.through = {{"q", "s"}};
  IntegralClass strict = without;
  strict.functions = {"s"};
  EXPECT_EQ(contains(through, strict), Truth::yes);
  EXPECT_EQ(contains(strict, through), Truth::unknown);
}

TEST(IntegralClass, TheoremsOnOtherPlacesDoNotCompare) {
  const std::vector<IntegralClass> all = {along({"N"}),
                                          {.near = Near::origin},
                                          {.near = Near::level},
                                          {.kind = Kind::real_analytic, .near = Near::phase_space}};
  for (const IntegralClass& a : all)
    for (const IntegralClass& b : all)
      EXPECT_EQ(contains(a, b), a == b ? Truth::yes : Truth::unknown) << sentence(a) << sentence(b);
  EXPECT_EQ(at_once(all), all);
  IntegralClass leaf = along({"N"}), field = along({"N"});
  leaf.on_leaf = true;
  field.liouville = false;
  EXPECT_EQ(contains(along({"N"}), leaf), Truth::yes);
  EXPECT_EQ(contains(leaf, along({"N"})), Truth::unknown);
  EXPECT_EQ(contains(field, along({"N"})), Truth::unknown);
}

TEST(IntegralClass, TwoCurvesAreOneClass) {
  IntegralClass a = along({"N"}), b = along({"M"}, Near::closed_curve);
  a.without = {"q"};
  a.functions = {"c", "s"};
  b.functions = {"s"};
  IntegralClass both = along({"N", "M"}, Near::closed_curve);
  both.without = {"q"};
  both.functions = {"s"};
  EXPECT_THAT(at_once({a, b}), ElementsAre(both));
}

// x only through its sine, y only through its cosine: both conditions stay.
TEST(IntegralClass, EachCoordinateIsLeftOutByItself) {
  IntegralClass a = along({"N"}), b = along({"M"});
  a.functions = b.functions = {"sin_x", "cos_y"};
  a.without = {"x"};
  a.through = {{"x", "sin_x"}};
  b.without = {"y"};
  b.through = {{"y", "cos_y"}};
  const auto met = at_once({a, b});
  ASSERT_EQ(met.size(), 1U);
  EXPECT_EQ(sentence(met), "meromorphic (in the coordinates and sin_x, cos_y) and do not depend on "
                           "x, y otherwise than through sin_x, cos_y");
  EXPECT_EQ(contains(a, met.front()), Truth::yes);
  EXPECT_EQ(contains(met.front(), a), Truth::unknown);
}

MapFacts map(std::map<std::string, std::vector<std::string>> uses, bool real = true) {
  return {real, std::move(uses)};
}

// A permutation renames what is left out; a rotation in its plane mixes it.
TEST(CarriedClass, NamesWhatIsLeftOutThere) {
  IntegralClass c = along({"N"});
  c.without = {"q"};
  const MapFacts swap = map({{"q", {"x"}}, {"x", {"q"}}, {"p", {"p"}}});
  const MapFacts rotation = map({{"q", {"q", "x"}}, {"x", {"q", "x"}}, {"p", {"p"}}});
  const MapFacts shear = map({{"q", {"q", "x"}}, {"x", {"x"}}, {"p", {"p"}}});
  IntegralClass there = c;
  there.without = {"x"};
  EXPECT_EQ(carried(c, swap), there);
  EXPECT_EQ(carried(there, swap), c);
  EXPECT_EQ(carried(c, rotation), std::nullopt);
  EXPECT_EQ(carried(c, shear), c); // functions of x and p alone, before and behind it
  EXPECT_EQ(carried(there, shear), std::nullopt);
  c.without = {"q", "x"};
  EXPECT_EQ(carried(c, rotation), c);
  c.without = {};
  EXPECT_EQ(carried(c, rotation), c);
}

TEST(CarriedClass, RealFunctionsNeedARealMap) {
  const IntegralClass real = {.kind = Kind::real_analytic, .near = Near::phase_space};
  EXPECT_EQ(carried(real, map({{"q", {"q"}}})), real);
  EXPECT_EQ(carried(real, map({{"q", {"q"}}}, false)), std::nullopt);
  EXPECT_EQ(carried(rational(), map({{"q", {"q"}}}, false)), rational());
}

// The map knows nothing of symbols and of other coordinates.
TEST(CarriedClass, WhatTheMapDoesNotKnowIsNotCarried) {
  for (const auto change : {+[](IntegralClass& c) { c.functions = {"s"}; },
                            +[](IntegralClass& c) { c.frame = "of a.toml"; }}) {
    IntegralClass c = along({"N"});
    change(c);
    EXPECT_EQ(carried(c, map({{"q", {"q"}}})), std::nullopt);
  }
}

TEST(IntegralClass, RationalFunctionsBelongToWhatForbidsNothing) {
  EXPECT_TRUE(has_rational_functions(along({"N"}, Near::closed_curve)));
  EXPECT_TRUE(has_rational_functions({.near = Near::origin, .on_leaf = true}));
  EXPECT_FALSE(has_rational_functions({.kind = Kind::real_analytic, .near = Near::phase_space}));
  IntegralClass c = along({"N"});
  c.without = {"q"};
  EXPECT_FALSE(has_rational_functions(c));
}

IntegralClass any(Random& random) {
  const auto some = [&](const std::vector<std::string>& from) {
    std::vector<std::string> all;
    for (const std::string& one : from)
      if (random.once_in(2)) all.push_back(one);
    return all;
  };
  IntegralClass c;
  c.near = static_cast<Near>(random.between(0, 4));
  c.kind = c.near == Near::phase_space ? Kind::rational : Kind::meromorphic;
  if (c.near == Near::curve || c.near == Near::closed_curve) {
    c.curves = some({"M"});
    c.curves.emplace_back("N");
  }
  c.on_leaf = random.once_in(2);
  c.functions = some({"s", "c"});
  c.without = some({"q", "p"});
  for (const std::string& q : c.without)
    for (const std::string& f : some(c.functions))
      c.through.emplace_back(q, f);
  return c;
}

// An order; and each of several classes contains what is at once in all.
TEST(IntegralClass, RandomClassesAreOrdered) {
  random_rounds(3000, [](Random& random) {
    const IntegralClass a = any(random), b = any(random), c = any(random);
    EXPECT_EQ(contains(a, a), Truth::yes);
    if (contains(a, b) == Truth::yes && contains(b, c) == Truth::yes)
      EXPECT_EQ(contains(a, c), Truth::yes)
          << sentence(a) << "; " << sentence(b) << "; " << sentence(c);
    for (const std::vector<IntegralClass>& all : {std::vector{a, b}, std::vector{a, b, c}}) {
      const auto met = at_once(all);
      for (const IntegralClass& one : all)
        EXPECT_TRUE(std::any_of(met.begin(), met.end(), [&](const IntegralClass& m) {
          return contains(one, m) == Truth::yes;
        })) << sentence(one);
    }
  });
}

} // namespace
} // namespace kov
