#include "flow/chaos/periodic_orbit.hpp"

#include "flow/number/enclosure.hpp"
#include "support.hpp"

#include <gtest/gtest.h>

namespace kov::flow::fixed_points_test {
namespace {

using namespace test;

int count(const PeriodicOrbits& f, Stability s) {
  return static_cast<int>(
      std::ranges::count_if(f.orbits, [&](const auto& p) { return p.stability == s; }));
}

// The proof for the point near (l, y), of the largest G there.
PeriodicOrbit proved_at(const SystemScene& s, double l, double y,
                        const std::atomic<bool>* stop = nullptr) {
  const SectionSurface surface(s);
  QuickMap quick(surface);
  const EnclosureScope scope(128);
  EnclosedMap map(surface, stop);
  PeriodicOrbit guess;
  guess.points.push_back({states_over(s, l, y).back(), {l, y}});
  return prove_orbit(map, quick, guess);
}

// The free top: G, the period 2 pi/(b G) and the trace 2 cosh(2 pi sqrt((b-a)(c-b))/b) are known
// exactly. The point at l = pi lies on the cut of the arctangent: its proof failed until the chart
// was turned to the start.
TEST(FixedPoints, ClassicalTopWithoutGravityHasTwoOfEachKind) {
  const SystemScene s = body_scene("asymmetric_classical");
  const PeriodicOrbits f = periodic_orbits(s);
  ASSERT_EQ(f.orbits.size(), 4U);
  EXPECT_EQ(count(f, Stability::elliptic), 2);
  EXPECT_EQ(count(f, Stability::hyperbolic), 2);
  EXPECT_EQ(f.cells->index_sum, 0);
  EXPECT_EQ(f.cells->unexplained, 0);
  const double pi = M_PI, a = 1, b = 1.5, c = 2;
  const double hyperbolic = 2 * std::cosh(2 * pi * std::sqrt((b - a) * (c - b)) / b);
  const double elliptic = 2 * std::cos(2 * pi * std::sqrt((b - a) * (c - a)) / a);
  for (std::size_t i = 0; i < 4; ++i) {
    const PeriodicOrbit& p = f.orbits[i];
    EXPECT_TRUE(p.proved) << to_string(p.why);
    EXPECT_LE(p.error, 1e-15);
    EXPECT_LE(p.trace_error, 1e-14);
    EXPECT_NEAR(p.points[0].drawn[0], static_cast<double>(i) * pi / 2,
                4e-16 * static_cast<double>(i + 1));
    EXPECT_NEAR(p.points[0].drawn[1], 0, 1e-15);
    EXPECT_NEAR(p.trace, i % 2 == 0 ? hyperbolic : elliptic, 1e-13);
    const auto& n = p.points[0].x;
    EXPECT_NEAR(p.time, 2 * pi / ((i % 2 == 0 ? b : a) * std::hypot(n[0], n[1], n[2])), 1e-13);
  }
}

// The paper on its first figure: stable periodic orbits near (0, 0), (pi/2, 0), (pi, 0), (3 pi/2,
// 0) and four unstable ones.  There are four more, stable, close to the poles L/G = +-1.  All are
// proved, with their kind.
TEST(FixedPoints, SlidingTopHasFourUnstableAndEightStable) {
  const SystemScene s = body_scene("asymmetric_sliding");
  PeriodicOptions o;
  o.prove = false;
  o.columns = 24;
  o.rows = 16;
  const PeriodicOrbits f = periodic_orbits(s, o);
  ASSERT_EQ(f.orbits.size(), 12U);
  EXPECT_EQ(f.cells->unexplained, 0);
  std::vector<PeriodicOrbit> equator;
  for (const PeriodicOrbit& p : f.orbits) {
    const double y = p.points[0].drawn[1];
    EXPECT_NEAR(p.determinant, 1, 2e-11); // the map preserves area
    if (std::abs(y) < 0.5) {
      equator.push_back(p);
    } else {
      EXPECT_NEAR(std::abs(y), 0.994970, 1e-6);
      EXPECT_EQ(p.stability, Stability::elliptic);
    }
  }
  for (const std::size_t i : {0, 1, 2}) {
    const auto& at = f.orbits[i].points[0].drawn;
    const PeriodicOrbit p = proved_at(s, at[0], at[1]);
    EXPECT_TRUE(p.proved) << to_string(p.why);
    EXPECT_LE(p.error, 1e-15);
    EXPECT_LE(p.trace_error, 1e-5);
    EXPECT_EQ(p.stability, f.orbits[i].stability);
  }
  ASSERT_EQ(equator.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(equator[i].points[0].drawn[1], 0, 1e-13);
    EXPECT_EQ(equator[i].stability, i % 2 == 0 ? Stability::hyperbolic : Stability::elliptic) << i;
  }
  EXPECT_NEAR(equator[0].points[0].drawn[0], 1.153145467948, 1e-11);
  EXPECT_NEAR(equator[0].trace, 2.2910104609, 1e-9);
  EXPECT_NEAR(equator[1].points[0].drawn[0], M_PI / 2,
              1e-13); // the stable ones: two exactly on the first axis,
  EXPECT_NEAR(equator[3].points[0].drawn[0], M_PI, 0.02); // two only near the second
  EXPECT_NEAR(equator[7].points[0].drawn[0], 2 * M_PI, 0.02);
}

// Strong multipliers, points near the poles, a level with two sheets: what is found makes up the
// index of every cell that has one.  (An index taken from the corners of a cell alone differed.)
TEST(FixedPoints, ThePointsMakeUpTheIndices) {
  PeriodicOptions o;
  o.prove = false;
  o.columns = 32;
  o.rows = 24;
  for (const auto& [name, points] :
       {std::pair{"kovalevskaya_classical", 8}, {"hess_classical", 6}, {"lever_quarter", 6}}) {
    const PeriodicOrbits f = periodic_orbits(body_scene(name), o);
    EXPECT_EQ(f.orbits.size(), static_cast<std::size_t>(points)) << name;
    EXPECT_EQ(f.cells->unexplained, 0) << name;
    EXPECT_LE(f.cells->without, 80) << name;
    EXPECT_GE(f.cells->with_index, 600) << name;
  }
}

// A search that was stopped says so, and names no point without the reason why it is not proved.
TEST(FixedPoints, AStoppedSearchSaysSo) {
  const SystemScene s = body_scene("asymmetric_classical");
  std::atomic<bool> stop{true};
  PeriodicOptions o;
  o.stop = &stop;
  EXPECT_TRUE(periodic_orbits(s, o).stopped);
  stop = false;
  o.columns = 12;
  o.rows = 8;
  o.progress = [&](const PeriodicOrbits&, std::size_t proofs) { stop = proofs >= 1; };
  const PeriodicOrbits f = periodic_orbits(s, o);
  EXPECT_TRUE(f.stopped);
  ASSERT_EQ(f.orbits.size(), 4U);
  EXPECT_TRUE(f.orbits[0].proved);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_FALSE(f.orbits[i].proved);
    EXPECT_TRUE(f.orbits[i].why == NotProved::not_tried || f.orbits[i].why == NotProved::no_time);
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
  const PeriodicOrbit p = proved_at(s, M_PI, 1.0 / 3);
  EXPECT_TRUE(p.proved) << to_string(p.why);
  EXPECT_LE(p.error, 2e-16);
  EXPECT_NEAR(p.points[0].drawn[1], 1.0 / 3, 1e-15);
  EXPECT_LT(std::abs(p.trace) + p.trace_error, 2); // elliptic, proved
}

// What is not a fixed point is not proved to be one.
TEST(FixedPoints, AWrongPlaceIsNotProved) {
  const PeriodicOrbit p = proved_at(body_scene("asymmetric_classical"), 0.9, 0.3);
  EXPECT_FALSE(p.proved);
  EXPECT_NE(p.why, NotProved::not_tried);
}

// What the index finds Newton's method from the nodes alone did not: two points of ten in cells where the map is steep.
TEST(FixedPoints, OnesInSteepCellsAreFound) {
  PeriodicOptions o;
  o.prove = false;
  const PeriodicOrbits f = periodic_orbits(body_scene("goryachev_sliding"), o);
  EXPECT_EQ(count(f, Stability::elliptic), 10);
  EXPECT_EQ(count(f, Stability::hyperbolic), 10);
  EXPECT_EQ(f.cells->unexplained, 0);
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
