// The loops are those of the headline: along the segment from the base towards the singularity.

#include "monodromy/loops.hpp"

#include "exact/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

namespace {

using namespace kov;
using namespace kov::monodromy;
using Complex = std::complex<double>;

Complex approximately(const Point& p) {
  return {arf_get_d(arb_midref(p.x.raw()), ARF_RND_NEAR),
          arf_get_d(arb_midref(p.y.raw()), ARF_RND_NEAR)};
}

Point dyadic(long x, long y, long denominator) {
  return {Real(x) / Real(denominator), Real(y) / Real(denominator)};
}

// The angle under which s sees the way from the first point of the loop to the singularity.
double seen_along(const Path& path, Complex end, Complex s) {
  double sum = 0;
  Complex last = approximately(path.vertices.front());
  const auto go = [&](Complex next) {
    sum += std::arg((next - s) / (last - s));
    last = next;
  };
  for (std::size_t k = 0; k < path.joints.size(); ++k) {
    go(approximately(path.joints[k]));
    go(approximately(path.vertices[k + 1]));
  }
  go(end);
  return sum;
}

void expect_straight(const std::vector<Point>& points, const Point& base) {
  std::vector<ComplexBall> singularities;
  for (const Point& p : points)
    singularities.push_back(exact(p));
  const LoopTree tree = loop_tree(singularities, base);
  for (const Loop& l : tree.loops)
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (j == l.singularity) continue;
      const Complex end = approximately(points[l.singularity]), s = approximately(points[j]);
      EXPECT_NEAR(seen_along(l.approach, end, s), std::arg((end - s) / (approximately(base) - s)),
                  1e-6)
          << "loop " << l.singularity << " passes " << j;
    }
}

TEST(Loops, PassOtherSingularitiesOnTheRightSide) {
  // From 3 + 13/256 i the segment to 0 passes 1 + 5/256 i at a distance of 1/100.
  expect_straight({dyadic(0, 0, 1), dyadic(256, 5, 256), dyadic(-4, 0, 1)}, dyadic(768, 13, 256));
  std::mt19937 gen(11);
  const auto any = [&](long n) { return static_cast<long>(gen() % (2 * n + 1)) - n; };
  for (int round = 0; round < 200; ++round) {
    const Point base = dyadic(any(400), any(400), 64);
    const Point far = dyadic(any(400), any(400), 64);
    const long k = 1 + static_cast<long>(gen() % 7); // a point near the segment from base to far
    const Point middle = base + (Real(k) / Real(8)) * (far - base);
    const Point near{middle.x + Real(any(3)) / Real(1L << (4 + gen() % 20)), middle.y};
    try {
      expect_straight({far, near, dyadic(any(400), any(400), 64)}, base);
    } catch (const InvalidArgument&) { // in one direction
    } catch (const OutOfBudget&) {     // too near
    }
  }
}

TEST(Loops, RegularPolygonsHaveABase) {
  for (long n = 3; n <= 16; ++n) {
    std::vector<ComplexBall> roots;
    for (long k = 0; k < n; ++k) {
      ComplexBall w;
      arb_set_si(acb_realref(w.raw()), 2 * k);
      arb_div_si(acb_realref(w.raw()), acb_realref(w.raw()), n, 400);
      acb_exp_pi_i(w.raw(), w.raw(), 400);
      roots.push_back(w);
    }
    EXPECT_EQ(loop_tree(roots, std::nullopt).loops.size(), static_cast<std::size_t>(n));
  }
}

TEST(Loops, TooNearIsALimit) {
  ComplexBall a, b;
  acb_one(a.raw());
  arf_set_d(arb_midref(acb_realref(b.raw())), 1);
  arb_mul_2exp_si(acb_realref(b.raw()), acb_realref(b.raw()), -400);
  acb_add_si(b.raw(), b.raw(), 1, 600);
  EXPECT_THROW(static_cast<void>(loop_tree({a, b}, std::nullopt)), OutOfBudget);
}

} // namespace
