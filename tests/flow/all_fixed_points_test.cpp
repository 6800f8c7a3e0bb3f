// All fixed points of a power of the section map in a rectangle: as many as the search finds, with their indices, and
// undecided where it cannot be known.

#include "flow/chaos/all_fixed_points.hpp"

#include "symbol/document.hpp"
#include "symbol/input_error.hpp"

#include <gtest/gtest.h>

namespace kov::flow {
namespace {

using Rectangle = std::array<std::array<Quantity, 2>, 2>;

SystemScene scene_of(const std::string& hamiltonian, const std::string& plot = "[\"y\", \"v\"]") {
  return read_system_scenes(
             parse_document(
                 "format = \"equation/1\"\n[system]\nkind = \"hamiltonian\"\n"
                 "coordinates = [\"x\", \"y\"]\nmomenta = [\"u\", \"v\"]\nhamiltonian = \"" +
                     hamiltonian +
                     "\"\n[[scene]]\nsection = \"x\"\nlevels = { H = \"1/8\" }\nplot = " + plot +
                     "\nseeds = [[0, 0]]\ncrossings = 1\n",
                 "test.toml"))
      .front();
}

const char* const henon_heiles = "(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3";

FixedPointsOverSheet one_sheet(const Rectangle& r, RectangleOptions o = {},
                               const char* hamiltonian = henon_heiles) {
  const auto all = fixed_points_in(scene_of(hamiltonian), r, o);
  EXPECT_EQ(all.sheets.size(), 1U);
  return all.sheets.at(0);
}

TEST(AllFixedPoints, AsManyAsThereAreAndTheirIndices) {
  const auto elliptic = one_sheet({{{"29/100", "31/100"}, {"-1/100", "1/100"}}});
  ASSERT_TRUE(elliptic.complete());
  ASSERT_EQ(elliptic.points.size(), 1U);
  EXPECT_EQ(elliptic.points[0].index, 1);
  EXPECT_NEAR(elliptic.points[0].x[1], 0.3026668174698, 1e-11);
  EXPECT_LT(elliptic.points[0].error, 1e-9);
  const auto hyperbolic = one_sheet({{{"-19/100", "-9/50"}, {"-1/200", "1/200"}}});
  ASSERT_TRUE(hyperbolic.complete());
  ASSERT_EQ(hyperbolic.points.size(), 1U);
  EXPECT_EQ(hyperbolic.points[0].index, -1);
  const auto none = one_sheet({{{"1/10", "3/25"}, {"-1/100", "1/100"}}});
  EXPECT_TRUE(none.complete());
  EXPECT_TRUE(none.points.empty());
}

// One elliptic, one hyperbolic; the index is known wherever a point is.
TEST(AllFixedPoints, TwoInOneRectangle) {
  const auto both = one_sheet({{{"29/100", "31/100"}, {"-61/200", "1/100"}}});
  ASSERT_TRUE(both.complete());
  ASSERT_EQ(both.points.size(), 2U);
  EXPECT_EQ(both.points[0].index + both.points[1].index, 0);
  for (const CountedPoint& p : both.points)
    EXPECT_LT(p.error, 1e-9);
}

// Few orbits come back, or none does: nothing is claimed.
TEST(AllFixedPoints, WhereOrbitsDoNotComeBackIsUndecided) {
  RectangleOptions few;
  few.boxes = 30;
  const auto found =
      one_sheet({{{"-1/10", "1/10"}, {"-1/10", "1/10"}}}, few, "(u^2 + v^2 + y^2 - x^2)/2");
  EXPECT_FALSE(found.complete());
  EXPECT_TRUE(found.points.empty());
}

// A whole circle of fixed points, where the frequencies are 1 and 1 + y^2 + v^2 - 1/25: none is isolated.
TEST(AllFixedPoints, NothingIsClaimedOfACurveOfThem) {
  RectangleOptions few;
  few.boxes = 400;
  const auto found = one_sheet({{{"9/50", "11/50"}, {"-1/50", "1/50"}}}, few,
                               "(u^2 + x^2)/2 + (24/25)*(y^2 + v^2)/2 + (y^2 + v^2)^2/4");
  EXPECT_FALSE(found.complete());
  EXPECT_TRUE(found.points.empty());
}

TEST(AllFixedPoints, OfTheSecondReturn) {
  RectangleOptions twice;
  twice.period = 2;
  const auto found = one_sheet({{{"151/500", "303/1000"}, {"-1/2000", "1/2000"}}}, twice);
  ASSERT_TRUE(found.complete());
  ASSERT_EQ(found.points.size(), 1U); // the fixed point of the first
  EXPECT_NEAR(found.points[0].x[1], 0.3026668174698, 1e-10);
}

// It is fixed, and v = 0 by symmetry: neither inside nor outside.
TEST(AllFixedPoints, OnTheBorderIsUndecided) {
  RectangleOptions few;
  few.boxes = 300;
  const auto found = one_sheet({{{"151/500", "303/1000"}, {"0", "1/1000"}}}, few);
  EXPECT_FALSE(found.complete());
  EXPECT_TRUE(found.points.empty());
}

// All orbits close after one return: a multiplier is 1 everywhere.
TEST(AllFixedPoints, NothingIsClaimedOfTheIdentity) {
  RectangleOptions few;
  few.boxes = 40;
  const auto found =
      one_sheet({{{"1/10", "1/8"}, {"0", "1/50"}}}, few, "(u^2 + v^2 + x^2 + y^2)/2");
  EXPECT_FALSE(found.complete());
  EXPECT_TRUE(found.points.empty());
}

// 2 y^2 + v^2 <= 1/4 on the level of the oscillator with frequencies 1 and 2^(1/2), where only 0 is fixed.
TEST(AllFixedPoints, WhereTheSheetEndsIsUndecided) {
  const char* const oscillator = "(u^2 + v^2 + x^2 + 2*y^2)/2";
  RectangleOptions few;
  few.boxes = 200;
  EXPECT_FALSE(one_sheet({{{"0", "1/2"}, {"-1/10", "1/10"}}}, few, oscillator).complete());
  const auto inside = one_sheet({{{"-1/10", "1/9"}, {"-1/10", "1/9"}}}, {}, oscillator);
  EXPECT_TRUE(inside.complete());
  EXPECT_EQ(inside.points.size(), 1U);
}

TEST(AllFixedPoints, RefusesWhatIsNoRectangleOfCoordinates) {
  EXPECT_THROW((void)fixed_points_in(scene_of(henon_heiles), {{{"1/10", "0"}, {"0", "1/10"}}}),
               InputError);
  EXPECT_THROW((void)fixed_points_in(scene_of(henon_heiles, "[\"y + v\", \"v\"]"),
                                     {{{"0", "1/10"}, {"0", "1/10"}}}),
               InputError);
}

} // namespace
} // namespace kov::flow
