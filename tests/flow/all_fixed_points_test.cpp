// All fixed points of a power of the section map in a rectangle: as many as the search finds, with their indices, and
// undecided where it cannot be known.

#include "flow/chaos/all_fixed_points.hpp"

#include "symbol/document.hpp"
#include "symbol/input_error.hpp"

#include <gtest/gtest.h>

namespace kov::flow::all_fixed_points_test {
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

// However small the rectangle, its point has an index; where there is none, none.
TEST(AllFixedPoints, InTinyRectangles) {
  for (const char* width : {"10^-3", "10^-6", "10^-9"}) {
    const Quantity w(width), y("151333408735/500000000000");
    const auto found = one_sheet({{{y - w, y + w}, {Quantity("0") - w, w * Quantity("3/2")}}});
    EXPECT_TRUE(found.complete()) << width;
    ASSERT_EQ(found.points.size(), 1U) << width;
    EXPECT_EQ(found.points[0].index, 1) << width;
    const auto none =
        one_sheet({{{y + w * Quantity("2"), y + w * Quantity("3")}, {w, w * Quantity("2")}}});
    EXPECT_TRUE(none.complete() && none.points.empty()) << width;
  }
}

// 2 y^2 + v^2 <= 1/4 on the level of the oscillator with frequencies 1 and 2^(1/2), where only 0 is fixed.
TEST(AllFixedPoints, WhereTheSheetEnds) {
  const char* const oscillator = "(u^2 + v^2 + x^2 + 2*y^2)/2";
  for (const Rectangle& r : {Rectangle{{{"-1/10", "1/2"}, {"-1/10", "1/9"}}},
                             Rectangle{{{"-1", "2"}, {"-2/3", "1"}}}, // all of it, and more
                             Rectangle{{{"-1/10", "1/9"}, {"-1/10", "1/9"}}}}) {
    const auto found = one_sheet(r, {}, oscillator);
    EXPECT_TRUE(found.complete() && found.all_sheets) << found.undecided.size();
    EXPECT_EQ(found.points.size(), 1U);
  }
}

TEST(AllFixedPoints, NoneWhereTheLevelHasNoPoint) {
  for (const char* h : {henon_heiles, "(u^2 + v^2 + x^2 + 2*y^2)/2",
                        "u^4 + u^2/3 + v^2 + y^2 + x^2", "u^2/2 - y*u + v^2/2 + y^2 + x^2/2"}) {
    const auto found = one_sheet({{{"3/5", "1"}, {"3/5", "7/10"}}}, {}, h);
    EXPECT_TRUE(found.complete() && found.all_sheets) << h;
    EXPECT_TRUE(found.points.empty() && found.through.empty()) << h;
  }
}

// The middle is outside, a corner inside.
TEST(AllFixedPoints, WhereTheMiddleIsOutside) {
  const auto found =
      one_sheet({{{"-1/20", "1"}, {"-1/20", "1"}}}, {}, "(u^2 + v^2 + x^2 + 2*y^2)/2");
  EXPECT_TRUE(found.complete() && found.all_sheets);
  EXPECT_EQ(found.points.size(), 1U);
}
// On the border of the level the plane x = u = 0 is invariant, and its orbits have return times of their own: where these are 1
// period of the orbit the map to the border has fixed points there, and none beside them.
TEST(AllFixedPoints, BesideTheBorderOfTheLevel) {
  const auto found = one_sheet({{{"41/100", "1/2"}, {"29/100", "7/20"}}});
  EXPECT_TRUE(found.complete() && found.all_sheets);
  EXPECT_TRUE(found.points.empty());
}

// The section is x' = u - y/5 = 0 at the border, where x'' = -2 v/5: most orbits touch the section from one side, those with
// v = 0 cross it with x' = x'' = 0.  Near others the map jumps, where orbits touch it on their way.
TEST(AllFixedPoints, WhereTheSectionIsTouched) {
  const char* const turning = "(u^2 + v^2 + x^2 + 2*y^2)/2 + (x*v - y*u)/5";
  for (const Rectangle& r : {Rectangle{{{"-1/20", "2/5"}, {"-1/20", "1/2"}}},
                             Rectangle{{{"-2/5", "1/20"}, {"-1/2", "1/20"}}}}) {
    const auto found = one_sheet(r, {}, turning);
    EXPECT_TRUE(found.complete() && found.all_sheets) << found.undecided.size();
    EXPECT_EQ(found.points.size(), 1U);
  }
  // twice around: what is shown of orbits that are not closed after one return is not used
  RectangleOptions twice;
  twice.period = 2;
  twice.boxes = 200;
  const auto found = one_sheet({{{"1/5", "3/10"}, {"2/5", "1/2"}}}, twice, turning);
  EXPECT_TRUE(found.points.empty());
}

// Where 2 y^2 = 1/4 + v^2 there are two points over one place, v' = 0 and x' > 0.
TEST(AllFixedPoints, OtherKineticEnergies) {
  const auto saddle =
      one_sheet({{{"-1/10", "1/10"}, {"-1/10", "1/9"}}}, {}, "(u^2 + x^2)/2 - (v^2 + 2*y^2)/2");
  EXPECT_TRUE(saddle.complete() && saddle.all_sheets);
  EXPECT_EQ(saddle.points.size(), 1U);
  const auto quartic = one_sheet({{{"-1/20", "1/5"}, {"-1/20", "1/2"}}}, {},
                                 "u^4/3 + u^2/2 + (x^2 + v^2 + 3*y^2)/2");
  EXPECT_TRUE(quartic.complete() && quartic.all_sheets) << quartic.boxes;
  EXPECT_EQ(quartic.points.size(), 1U);
  // (0, 0) is fixed, on both sheets y > 0 and y < 0 of y^2 = 1/4 - v^2 - u^2
  const auto all = fixed_points_in(scene_of("(u^2 + v^2 + x^2 + 2*y^2)/2", "[\"u\", \"v\"]"),
                                   {{{"1/20", "1/10"}, {"-1/20", "1/19"}}});
  ASSERT_EQ(all.sheets.size(), 2U);
  for (const auto& sheet : all.sheets) {
    EXPECT_TRUE(sheet.complete() && sheet.points.empty());
    EXPECT_FALSE(sheet.all_sheets);
  }
}

// Where a denominator vanishes nothing is known; beside it, all.
TEST(AllFixedPoints, WhereTheHamiltonianHasAPole) {
  const char* const h = "(u^2 + v^2 + x^2)/2 + y^2 + 1/(50*(y + 1/4))";
  RectangleOptions few;
  few.boxes = 500;
  EXPECT_FALSE(one_sheet({{{"-3/10", "1/10"}, {"-1/20", "1/19"}}}, few, h).complete());
  const auto beside = one_sheet({{{"21/250", "23/250"}, {"-1/200", "1/199"}}}, {}, h);
  EXPECT_TRUE(beside.complete() && beside.all_sheets) << beside.undecided.size();
  EXPECT_EQ(beside.points.size(), 1U);
}

TEST(AllFixedPoints, RefusesWhatIsNoRectangleOfCoordinates) {
  EXPECT_THROW((void)fixed_points_in(scene_of(henon_heiles), {{{"1/10", "0"}, {"0", "1/10"}}}),
               InputError);
  EXPECT_THROW((void)fixed_points_in(scene_of(henon_heiles, "[\"y + v\", \"v\"]"),
                                     {{{"0", "1/10"}, {"0", "1/10"}}}),
               InputError);
}

} // namespace
} // namespace kov::flow::all_fixed_points_test
