#include "flow/number/roots.hpp"

#include "flow/number/big_real.hpp"
#include "flow/orbit/steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace kov::flow::roots_test {
namespace {

// c (x - r1)(x - r2)..., ascending.
std::vector<double> from_roots(const std::vector<double>& roots, double c) {
  std::vector<double> b{c};
  for (const double r : roots) {
    b.push_back(0);
    for (std::size_t k = b.size() - 1; k > 0; --k)
      b[k] = b[k - 1] - r * b[k];
    b[0] *= -r;
  }
  return b;
}

struct Found {
  std::vector<Root<double>> roots;
  int tangencies = 0;
  bool above = false;
};

Found search(std::vector<double> b, bool above, bool falling = true, bool rising = true) {
  Found f;
  f.above = above;
  Root<double> out[32];
  const int n = sign_changes(b.data(), static_cast<int>(b.size()) - 1, 1e-18, f.above, falling,
                             rising, out, 32, f.tangencies);
  f.roots.assign(out, out + n);
  return f;
}

TEST(Roots, AllOfThemInOrderWithTheirDirection) {
  std::mt19937 gen(2718);
  std::uniform_real_distribution<double> inside(0.001, 0.999), outside(1.01, 3);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> in, all;
    const int n = trial % 6;
    for (int i = 0; i < n; ++i)
      in.push_back(0.98 * inside(gen));
    std::sort(in.begin(), in.end());
    for (std::size_t i = 1; i < in.size(); ++i)
      in[i] = std::max(in[i], in[i - 1] + 1e-3);
    all = in;
    for (int i = 0; i < trial % 4; ++i)
      all.push_back(outside(gen) * (i % 2 == 0 ? 1 : -1));
    std::vector<double> b = from_roots(all, 1.5);
    const bool above = b[0] > 0;
    const Found f = search(b, above);
    ASSERT_EQ(f.roots.size(), in.size()) << "trial " << trial;
    for (std::size_t i = 0; i < in.size(); ++i) {
      EXPECT_NEAR(f.roots[i].x, in[i], 1e-8) << "trial " << trial;
      EXPECT_EQ(f.roots[i].falling, above == (i % 2 == 0));
    }
    EXPECT_EQ(f.above, above == (in.size() % 2 == 0));
    EXPECT_EQ(search(b, above, true, false).roots.size() +
                  search(b, above, false, true).roots.size(),
              in.size());
  }
}

TEST(Roots, ATouchIsNoCrossingAndANearTouchIsTwo) {
  const double c = 0.3125;
  const Found touch = search(from_roots({c, c}, 1), true);
  EXPECT_EQ(touch.roots.size(), 0U);
  EXPECT_GE(touch.tangencies, 1);
  EXPECT_TRUE(touch.above);
  for (const double gap : {1e-2, 1e-4, 1e-5, 1e-6}) { // resolved down to 2^-24 of a step
    const Found two = search(from_roots({c - gap / 2, c + gap / 2}, 1), true);
    ASSERT_EQ(two.roots.size(), 2U) << gap;
    EXPECT_NEAR(two.roots[1].x - two.roots[0].x, gap, gap * 1e-3 + 1e-9);
    EXPECT_EQ(search({c * c + gap * gap, -2 * c, 1}, true).roots.size(), 0U); // misses by gap^2
  }
  EXPECT_EQ(search(from_roots({c, c, c}, -1), true).roots.size(), 1U); // odd order: one change
}

TEST(Roots, TheCarriedSignDecidesAtTheEnds) {
  // A step that begins within rounding of the section: the sign of the end before counts.
  EXPECT_EQ(search({-1e-17, -1}, true).roots.size(), 1U);
  EXPECT_EQ(search({-1e-17, -1}, true).roots[0].x, 0.0);
  EXPECT_EQ(search({1e-17, -1}, false).roots.size(), 0U);
  EXPECT_EQ(search({1, -1}, true).roots.size(), 0U); // a zero at the very end is left ...
  EXPECT_EQ(search({0, -1}, true).roots.size(), 1U); // ... to the next step
  EXPECT_EQ(search({0, -1}, false).roots.size(), 0U);
}

TEST(Roots, NoiseIsNoCrossing) {
  std::vector<double> noise;
  for (int i = 0; i < 30; ++i)
    noise.push_back((i % 3 - 1) * 1e-20);
  EXPECT_EQ(search(noise, true).roots.size(), 0U);
  EXPECT_EQ(search(noise, false).roots.size(), 0U);
}

TEST(Roots, ZeroPolynomialAndConstants) {
  EXPECT_EQ(search({0.0}, false).roots.size(), 0U);
  EXPECT_EQ(search({1.0}, true).roots.size(), 0U);
  EXPECT_EQ(search({0.0, 0.0, 0.0}, false).roots.size(), 0U);
}

TEST(Roots, NewtonReachesTheLastBitOfEveryType) {
  const double r = std::sqrt(0.5);
  const double b[] = {-0.5, 0, 1};
  EXPECT_LE(std::abs(monotone_zero(b, 2, false) - r), 2e-16);
  const long double bl[] = {-0.5L, 0, 1};
  EXPECT_LE(std::abs(monotone_zero(bl, 2, false) - std::sqrt(0.5L)), 2e-19L);
  const PrecisionScope scope(300);
  const BigReal bb[] = {BigReal(-0.5), BigReal(0), BigReal(1)};
  const BigReal x = monotone_zero(bb, 2, false), e = x * x - BigReal(0.5);
  EXPECT_LE(std::abs(static_cast<double>(e)), 1e-89);
}

TEST(Roots, LogarithmAndPowerForTheStepAreRoughButEverywhere) {
  for (double x = 1e-300; x < 1e300; x *= 3.7) {
    EXPECT_NEAR(log2_estimate(x), std::log2(x), 0.011);
    EXPECT_NEAR(exp2_estimate(std::log2(x)) / x, 1, 2e-3);
  }
  EXPECT_LT(log2_estimate(0.0), -1000);
}

// ---- series with a tail: bounds decide, and decide rightly ----

std::vector<double> series(std::mt19937& gen, double decay) {
  std::normal_distribution<double> pick;
  std::vector<double> b;
  double size = 1;
  for (int k = 0; k <= 24; ++k, size *= decay)
    b.push_back(size * pick(gen));
  return b;
}

double value(const std::vector<double>& b, double x) {
  double v = 0;
  for (std::size_t k = b.size(); k-- > 0;)
    v = v * x + b[k];
  return v;
}

// The signs at 2000 places; nothing where one of the values is too small to say.
std::vector<bool> signs_along(const std::vector<double>& b) {
  std::vector<bool> all;
  for (int i = 0; i <= 2000; ++i) {
    const double v = value(b, i / 2000.0);
    if (std::abs(v) < 1e-6) return {};
    all.push_back(v > 0);
  }
  return all;
}

int changes(const std::vector<bool>& signs, bool to) {
  int n = 0;
  for (std::size_t i = 1; i < signs.size(); ++i)
    n += signs[i] != signs[i - 1] && signs[i] == to ? 1 : 0;
  return n;
}

TEST(Roots, ASeriesHasTheSignChangesOfItsValues) {
  std::mt19937 gen(31);
  int seen = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const std::vector<double> b = series(gen, 0.3 + 0.2 * (trial % 4));
    const std::vector<bool> signs = signs_along(b);
    if (signs.empty()) continue;
    const Found f = search(b, signs.front());
    const int expected = changes(signs, true) + changes(signs, false);
    EXPECT_EQ(static_cast<int>(f.roots.size()), expected) << "trial " << trial;
    for (const Root<double>& r : f.roots)
      EXPECT_NEAR(value(b, r.x), 0, 1e-12) << "trial " << trial;
    seen += expected;
  }
  EXPECT_GT(seen, 500);
}

// The watch leaves out a step only where nothing is wanted, and few of the others.
TEST(Roots, WhatTheWatchPassesOverHasNoWantedSignChange) {
  std::mt19937 gen(32);
  for (const auto& [falling, rising] : {std::pair{true, false}, {false, true}, {true, true}}) {
    int wanted = 0, looks = 0, steps = 0;
    for (int trial = 0; trial < 3000; ++trial) {
      const double h = 0.5 + 0.1 * (trial % 8);
      std::vector<double> b = series(gen, 0.5), scaled = b;
      double power = 1;
      for (double& c : scaled) {
        c /= power; // b is the series in units of the step
        power *= h;
      }
      const std::vector<bool> signs = signs_along(b);
      if (signs.empty()) continue;
      SectionWatch<double> watch(falling, rising);
      const std::vector<double> before{signs.front() ? 1.0 : -1.0, 0, 0, 0, 0, 0};
      watch.step(before.data(), 5, 1.0, 0.0, [](int, double) {}); // the sign before the step
      bool looked = false;
      watch.step(scaled.data(), 24, h, 0.0, [&](int, double) { looked = true; });
      const int n = (falling ? changes(signs, false) : 0) + (rising ? changes(signs, true) : 0);
      EXPECT_TRUE(looked || n == 0) << "trial " << trial;
      ++steps;
      looks += looked ? 1 : 0;
      wanted += n > 0 ? 1 : 0;
    }
    EXPECT_GT(wanted, 200);
    EXPECT_LT(looks - wanted, steps / 5);
  }
}

} // namespace
} // namespace kov::flow::roots_test
