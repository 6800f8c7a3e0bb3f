#include "flow/section/fixed_points.hpp"

#include "flow/number/enclosure.hpp"
#include "support.hpp"

#include <gtest/gtest.h>

namespace kov::flow::fixed_points_test {
namespace {

using namespace test;

int count(const FixedPoints& f, Stability s) {
  return static_cast<int>(std::count_if(f.points.begin(), f.points.end(),
                                        [&](const auto& p) { return p.stability == s; }));
}

// The free top: G, the period 2 pi/(b G) and the trace 2 cosh(2 pi sqrt((b-a)(c-b))/b) are known
// exactly. The point at l = pi lies on the cut of the arctangent: its proof failed until the chart
// was turned to the start.
TEST(FixedPoints, ClassicalTopWithoutGravityHasTwoOfEachKind) {
  const SystemScene s = body_scene("asymmetric_classical");
  const FixedPoints f = fixed_points(s);
  ASSERT_EQ(f.points.size(), 4U);
  EXPECT_EQ(count(f, Stability::elliptic), 2);
  EXPECT_EQ(count(f, Stability::hyperbolic), 2);
  EXPECT_EQ(f.index_sum, 0);
  EXPECT_EQ(f.unexplained_cells, 0);
  const double pi = M_PI, a = 1, b = 1.5, c = 2;
  const double hyperbolic = 2 * std::cosh(2 * pi * std::sqrt((b - a) * (c - b)) / b);
  const double elliptic = 2 * std::cos(2 * pi * std::sqrt((b - a) * (c - a)) / a);
  for (std::size_t i = 0; i < 4; ++i) {
    const FixedPoint& p = f.points[i];
    EXPECT_TRUE(p.proved) << to_string(p.why);
    EXPECT_LE(p.error, 1e-15);
    EXPECT_LE(p.trace_error, 1e-14);
    EXPECT_NEAR(p.l, static_cast<double>(i) * pi / 2, 4e-16 * static_cast<double>(i + 1));
    EXPECT_NEAR(p.y, 0, 1e-15);
    EXPECT_NEAR(p.trace, i % 2 == 0 ? hyperbolic : elliptic, 1e-13);
    EXPECT_NEAR(p.period, 2 * pi / ((i % 2 == 0 ? b : a) * p.g_size), 1e-13);
  }
}

// The paper on its first figure: stable periodic orbits near (0, 0), (pi/2, 0), (pi, 0), (3 pi/2,
// 0) and four unstable ones.  There are four more, stable, close to the poles L/G = +-1.  All are
// proved, with their kind.
TEST(FixedPoints, SlidingTopHasFourUnstableAndEightStable) {
  const SystemScene s = body_scene("asymmetric_sliding");
  FixedPointOptions o;
  o.prove = false;
  o.columns = 24;
  o.rows = 16;
  const FixedPoints f = fixed_points(s, o);
  ASSERT_EQ(f.points.size(), 12U);
  EXPECT_EQ(f.unexplained_cells, 0);
  std::vector<FixedPoint> equator;
  for (const FixedPoint& p : f.points) {
    EXPECT_NEAR(p.determinant, 1, 1e-11); // the map preserves area
    if (std::abs(p.y) < 0.5) {
      equator.push_back(p);
    } else {
      EXPECT_NEAR(std::abs(p.y), 0.994970, 1e-6);
      EXPECT_EQ(p.stability, Stability::elliptic);
    }
  }
  for (const std::size_t i : {0, 1, 2}) {
    const FixedPoint p = prove_fixed_point(s, f.points[i], 112);
    EXPECT_TRUE(p.proved) << to_string(p.why);
    EXPECT_LE(p.error, 1e-15);
    EXPECT_LE(p.trace_error, 1e-5);
    EXPECT_EQ(p.stability, f.points[i].stability);
  }
  ASSERT_EQ(equator.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(equator[i].y, 0, 1e-13);
    EXPECT_EQ(equator[i].stability, i % 2 == 0 ? Stability::hyperbolic : Stability::elliptic) << i;
  }
  EXPECT_NEAR(equator[0].l, 1.153145467948, 1e-11);
  EXPECT_NEAR(equator[0].trace, 2.2910104609, 1e-9);
  EXPECT_NEAR(equator[1].l, M_PI / 2, 1e-13); // the stable ones: two exactly on the first axis,
  EXPECT_NEAR(equator[3].l, M_PI, 0.02);      // two only near the second
  EXPECT_NEAR(equator[7].l, 2 * M_PI, 0.02);
}

// Strong multipliers, points near the poles, a level with two sheets: what is found makes up the
// index of every cell that has one.  (An index taken from the corners of a cell alone differed.)
TEST(FixedPoints, ThePointsMakeUpTheIndices) {
  FixedPointOptions o;
  o.prove = false;
  o.columns = 32;
  o.rows = 24;
  for (const auto& [name, points] :
       {std::pair{"kovalevskaya_classical", 8}, {"hess_classical", 6}, {"lever_quarter", 6}}) {
    const FixedPoints f = fixed_points(body_scene(name), o);
    EXPECT_EQ(f.points.size(), static_cast<std::size_t>(points)) << name;
    EXPECT_EQ(f.unexplained_cells, 0) << name;
    EXPECT_LE(f.cells_without_index, 80) << name;
    EXPECT_GE(f.cells, 600) << name;
  }
}

// A search that was stopped says so, and names no point without the reason why it is not proved.
TEST(FixedPoints, AStoppedSearchSaysSo) {
  const SystemScene s = body_scene("asymmetric_classical");
  std::atomic<bool> stop{true};
  FixedPointOptions o;
  o.stop = &stop;
  EXPECT_TRUE(fixed_points(s, o).stopped);
  stop = false;
  o.columns = 12;
  o.rows = 8;
  o.progress = [&](const FixedPoints&, std::size_t proofs) { stop = proofs >= 1; };
  const FixedPoints f = fixed_points(s, o);
  EXPECT_TRUE(f.stopped);
  ASSERT_EQ(f.points.size(), 4U);
  EXPECT_TRUE(f.points[0].proved);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_FALSE(f.points[i].proved);
    EXPECT_TRUE(f.points[i].why == NotProved::not_tried || f.points[i].why == NotProved::no_time);
  }
}

// The other code, without derivatives: an orbit from each fixed point comes back to it.
TEST(FixedPoints, AnOrbitFromThereComesBack) {
  SystemScene s = body_scene("asymmetric_sliding");
  s.columns = s.rows = 0;
  s.crossings = 3;
  s.seeds = {{"1646273/10^6", "994970/10^6"}, {"1153145467948/10^12", "0"}, {"pi/2", "0"}};
  for (const DrawnPoint& p : simulate(s).points) {
    EXPECT_NEAR(p.at[0], s.seeds[p.orbit][0].as<double>(), 1e-5);
    EXPECT_NEAR(p.at[1], s.seeds[p.orbit][1].as<double>(), 1e-5);
  }
}

// The turned map has the same proof wherever the section starts: each point of the
// Goryachev-Chaplygin top.
TEST(FixedPoints, PointsOnTheCutOfTheAngleAreProved) {
  const SystemScene s = body_scene("goryachev_classical");
  FixedPoint f;
  f.l = M_PI;
  f.y = 1.0 / 3;
  const auto sizes = momentum_sizes(s.body->scene.body<double>(), s.body->scene.levels<double>(),
                                    s.body->scene.section, f.l, f.y);
  ASSERT_FALSE(sizes.empty());
  f.g_size = sizes.back();
  const FixedPoint p = prove_fixed_point(s, f, 128);
  EXPECT_TRUE(p.proved) << to_string(p.why);
  EXPECT_LE(p.error, 2e-16);
  EXPECT_NEAR(p.y, 1.0 / 3, 1e-15);
  EXPECT_LT(std::abs(p.trace) + p.trace_error, 2); // elliptic, proved
}

// What is not a fixed point is not proved to be one.
TEST(FixedPoints, AWrongPlaceIsNotProved) {
  const SystemScene s = body_scene("asymmetric_classical");
  FixedPoint f;
  f.l = 0.9;
  f.y = 0.3;
  f.g_size = 1.5;
  const FixedPoint p = prove_fixed_point(s, f, 128);
  EXPECT_FALSE(p.proved);
  EXPECT_NE(p.why, NotProved::not_tried);
}

TEST(Enclosure, ComparisonsAreProofs) {
  const Enclosure wide = Enclosure(1.0).widened(Enclosure(0.5)), one(1.0), three(3);
  EXPECT_FALSE(wide < one);
  EXPECT_FALSE(wide > one);
  EXPECT_TRUE(wide < three);
  EXPECT_FALSE(wide == wide);
  EXPECT_TRUE(one.inside(wide));
  EXPECT_FALSE(wide.inside(wide));
}

} // namespace
} // namespace kov::flow::fixed_points_test
