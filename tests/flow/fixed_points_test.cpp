#include "flow/fixed_points.hpp"

#include "flow/enclosure.hpp"
#include "support.hpp"

#include <gtest/gtest.h>

namespace kov::flow {
namespace {

using namespace test;

int count(const FixedPoints& f, Stability s) {
  return static_cast<int>(
      std::count_if(f.points.begin(), f.points.end(), [&](const auto& p) { return p.stability == s; }));
}

// The free top: G, the period 2 pi/(b G) and the trace 2 cosh(2 pi sqrt((b-a)(c-b))/b) are known exactly.
TEST(FixedPoints, ClassicalTopWithoutGravityHasTwoOfEachKind) {
  const Scene s = read_scene(scene_path("asymmetric_classical"));
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
    EXPECT_TRUE(p.proved) << p.why;
    EXPECT_LE(p.error, 1e-15);
    EXPECT_LE(p.trace_error, 1e-14);
    EXPECT_NEAR(p.l, static_cast<double>(i) * pi / 2, 4e-16 * static_cast<double>(i + 1));
    EXPECT_NEAR(p.y, 0, 1e-15);
    EXPECT_NEAR(p.trace, i % 2 == 0 ? hyperbolic : elliptic, 1e-13);
    EXPECT_NEAR(p.period, 2 * pi / ((i % 2 == 0 ? b : a) * p.g_size), 1e-13);
  }
}

// The paper on its first figure: four stable periodic orbits near (0, 0), (pi/2, 0), (pi, 0), (3 pi/2, 0) and four
// unstable ones.  Proofs of all eight: kovacic section --fixed-points.
TEST(FixedPoints, SlidingTopHasFourOfEachKind) {
  const Scene s = read_scene(scene_path("asymmetric_sliding"));
  FixedPointOptions o;
  o.prove = false;
  o.columns = 32;
  o.rows = 24;
  const FixedPoints f = fixed_points(s, o);
  ASSERT_EQ(f.points.size(), 8U);
  EXPECT_EQ(count(f, Stability::elliptic), 4);
  EXPECT_EQ(count(f, Stability::hyperbolic), 4);
  EXPECT_EQ(f.index_sum, 0);
  for (const FixedPoint& p : f.points) {
    EXPECT_NEAR(p.determinant, 1, 1e-12); // the map preserves area
    EXPECT_NEAR(p.y, 0, 1e-12);
  }
  EXPECT_NEAR(f.points[0].l, 1.153145467948, 1e-11);
  EXPECT_NEAR(f.points[0].trace, 2.2910104609, 1e-9);
  const FixedPoint proved = prove_fixed_point(s, f.points[1], 192);
  EXPECT_TRUE(proved.proved) << proved.why;
  EXPECT_LE(proved.error, 1e-15);
  EXPECT_LE(proved.trace_error, 1e-13);
}

// What is no fixed point is not proved to be one.
TEST(FixedPoints, AWrongPlaceIsNotProved) {
  const Scene s = read_scene(scene_path("asymmetric_classical"));
  FixedPoint f;
  f.l = 0.9;
  f.y = 0.3;
  f.g_size = 1.5;
  const FixedPoint p = prove_fixed_point(s, f, 128);
  EXPECT_FALSE(p.proved);
  EXPECT_FALSE(p.why.empty());
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
} // namespace kov::flow
