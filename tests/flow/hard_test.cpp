// The hard cases, each with the bound that it must keep.

#include "flow/scene/escape.hpp"
#include "support.hpp"

#include <gtest/gtest.h>

namespace kov::flow {
namespace {

using namespace test;

Body<double> asymmetric(double lever, bool sliding = true) {
  Body<double> b;
  b.inertia = {{{1, 0, 0}, {0, 2.0 / 3, 0}, {0, 0, 0.5}}};
  b.lever = {lever, 0, 0};
  b.sliding = sliding;
  return b;
}

State<double> point(const Body<double>& b, const Levels<double>& f, double l, double y) {
  const auto sizes = momentum_sizes(b, f, {}, l, y);
  EXPECT_FALSE(sizes.empty());
  return section_point(b, f, {}, l, y, sizes.back());
}

const Levels<double> usual{1.5, 1, 0.05};

// Starts 1e-3 ... 1e-12 from the unstable point (0, 0) of the classical top: the orbit stays near
// it for a time that grows with log(1/delta); it keeps its integrals, and its side of the
// separatrix as long as the side is more than rounding (the energy differs from that of the
// separatrix by delta^2).
TEST(HardCases, NearTheSeparatrix) {
  const Body<double> b = asymmetric(0, false);
  std::vector<State<double>> starts;
  std::vector<double> deltas;
  for (int k = 3; k <= 12; ++k)
    for (const bool rotates : {false, true}) {
      const double d = std::pow(10.0, -k);
      deltas.push_back(rotates ? -d : d);
      starts.push_back(rotates ? point(b, usual, 0, d) : point(b, usual, d, 0));
    }
  const auto r = run(b, starts, {.t_end = 2000, .log2_tolerance = -59});
  EXPECT_LE(largest_drift(r), 1e-12);
  double before[2] = {0, 0}; // time until the orbit is far away, librating and rotating
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const bool rotates = deltas[i] < 0;
    double away = 0, lowest = 1;
    for (const auto& c : r.crossings.at(i)) {
      const double y = andoyer_of(b, state_of(c.x), 2).y;
      if (away == 0 && std::abs(y) > 0.3) away = c.t;
      lowest = std::min(lowest, y);
    }
    EXPECT_GE(away, before[rotates ? 1 : 0]) << i;
    before[rotates ? 1 : 0] = away;
    const Vec<double> m0 = momentum(b, starts[i]), m1 = momentum(b, state_of(r.ends.at(i).x));
    EXPECT_NEAR(dot(m1, m1), dot(m0, m0), 1e-12);
    if (std::abs(deltas[i]) >= 1e-6) {
      EXPECT_EQ(lowest > 0, rotates) << deltas[i];
    }
  }
}

Twin1 twin(double x) { return {x}; }

Body<Twin1> twin_of(const Body<double>& b) {
  Body<Twin1> t;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      t.inertia[i][k] = twin(b.inertia[i][k]);
    t.lever[i] = twin(b.lever[i]);
  }
  t.sliding = b.sliding;
  return t;
}

// |L|/G -> 1 and |F2|/G -> 1, where Andoyer's angles lose their meaning: same crossings as in 100
// bits.
TEST(HardCases, PolesOfTheChart) {
  const Body<double> b = asymmetric(8.0 / 9);
  std::vector<State<double>> starts;
  for (int k = 3; k <= 12; ++k) {
    starts.push_back(point(b, usual, 0.3, 1 - std::pow(10.0, -k)));
    starts.push_back(point(b, usual, 2.0, -1 + std::pow(10.0, -k)));
    // F2/G = 1 - 10^-k: M and Gamma nearly parallel
    const double y = 0.4, l = 0.7, size = 1.7, c = size * (1 - std::pow(10.0, -k));
    starts.push_back(section_point(b, {0, 1, c}, {}, l, y, size));
  }
  std::vector<State<Twin1>> precise;
  for (const auto& x : starts)
    precise.push_back({{twin(x.omega[0]), twin(x.omega[1]), twin(x.omega[2])},
                       {twin(x.gamma[0]), twin(x.gamma[1]), twin(x.gamma[2])}});
  const auto r = run(b, starts, {.t_end = 60, .log2_tolerance = -59});
  const auto p = run(twin_of(b), precise, {.t_end = 60, .log2_tolerance = -98});
  EXPECT_LE(largest_drift(r), 1e-13);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    // a start that is rounded may lie just before the section: with more digits that is seen
    const auto& all = p.crossings.at(i);
    const std::size_t first = static_cast<double>(all.front().t) < 1e-13 ? 1 : 0;
    ASSERT_EQ(r.crossings.at(i).size() + first, all.size()) << i;
    for (std::size_t k = 0; k < r.crossings.at(i).size(); ++k)
      EXPECT_NEAR(r.crossings.at(i)[k].t, static_cast<double>(all[k + first].t), 1e-9) << i;
  }
}

// On a pole itself the section function vanishes identically: no crossing, no endless search.
TEST(HardCases, PermanentRotationOnAPole) {
  const Body<double> b = asymmetric(0, false);
  const State<double> x{{0, 0, 2.0}, {std::sqrt(0.75), 0, 0.5}};
  const auto r = run(b, std::vector<State<double>>{x}, {.t_end = 100});
  EXPECT_EQ(r.crossings.count(0), 0U);
  EXPECT_EQ(r.ends.at(0).ended, Ended::time);
}

TEST(HardCases, NearlySymmetricAndNearlyFlatBodies) {
  for (const double e : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    Body<double> symmetric = asymmetric(0.5), flat = asymmetric(0.5);
    symmetric.inertia[1][1] = 1 + e;
    flat.inertia = {{{0.6, 0, 0}, {0, 0.4, 0}, {0, 0, 1 - e}}};
    for (Body<double> b : {symmetric, flat}) {
      b.gravity = 0.25;
      b.lever = {0.3, 0.0, 0.4};
      std::vector<State<double>> starts;
      for (const double y : {-0.6, 0.1, 0.7})
        starts.push_back(point(b, usual, 1.0, y));
      const auto r = run(b, starts, {.t_end = 500, .log2_tolerance = -59});
      EXPECT_LE(largest_drift(r), 5e-14) << e;
    }
  }
}

// L -> 0: the sliding top tends to the free top like L^2 (g = 0), and nothing cancels on the way,
// also not with the weight m g L held at 1.
TEST(HardCases, ShortLever) {
  const std::vector<State<double>> start{{{0.5, 1.1, 1.3}, {0.6, 0.0, 0.8}}};
  const auto end = [&](double lever, double gravity, bool sliding) {
    Body<double> b = asymmetric(lever, sliding);
    b.gravity = gravity;
    const auto r = run(b, start, {.t_end = 5, .log2_tolerance = -59, .section = false});
    const double scale = 1;
    EXPECT_LE(largest_drift(r), 1e-13 * scale) << lever;
    return r.ends.at(0);
  };
  const auto free = end(0, 0, false), heavy = end(1, 1, false);
  for (int k = 1; k <= 12; ++k) {
    const double lever = std::pow(10.0, -k);
    const auto slides = end(lever, 0, true), weighs = end(lever, 1 / lever, true);
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(slides.x[i], free.x[i], 40 * lever * lever + 1e-13) << lever;
      // z'' m L against m g L = 1: the difference is of the order L^2 z''/L
      EXPECT_NEAR(weighs.x[i], heavy.x[i], 100 * lever * lever + 1e-12) << lever;
    }
  }
}

TEST(HardCases, LongLever) {
  for (const double lever : {10.0, 1e2, 1e3}) {
    const Body<double> b = asymmetric(lever);
    const std::vector<State<double>> start{{{0.5, 1.1 / lever, 1.3 / lever}, {0.6, 0.0, 0.8}}};
    const auto r = run(b, start, {.t_end = 100, .log2_tolerance = -59});
    EXPECT_EQ(r.ends.at(0).ended, Ended::time);
    EXPECT_LE(largest_drift(r), 1e-12) << lever;
  }
}

TEST(HardCases, FastSpin) {
  for (const double spin : {1e1, 1e2, 1e3, 1e4}) {
    Body<double> b = asymmetric(0.4);
    b.gravity = 1;
    const std::vector<State<double>> start{{{0.02 * spin, -0.1 * spin, spin}, {0.6, 0.0, 0.8}}};
    const auto r = run(b, start, {.t_end = 2000 / spin, .log2_tolerance = -59});
    const double energy = integrals(b, start[0]).energy, casimir = integrals(b, start[0]).casimir;
    EXPECT_LE(r.ends.at(0).drift[0] / energy, 2e-13) << spin;
    EXPECT_LE(r.ends.at(0).drift[1], 1e-13) << spin;
    EXPECT_LE(r.ends.at(0).drift[2] / std::abs(casimir), 2e-13) << spin;
  }
}

// 1e5 turns of the sliding top (10^6 turns of each: tests/flow_long).
TEST(HardCases, ManyTurns) {
  const Body<double> b = asymmetric(8.0 / 9);
  std::vector<State<double>> starts;
  for (int i = 0; i < 8; ++i)
    starts.push_back(point(b, usual, 0.4 + 0.7 * i, -0.7 + 0.2 * i));
  const auto r = run(b, starts, {.t_end = 4e4, .log2_tolerance = -59});
  std::size_t turns = 0;
  for (const auto& [orbit, c] : r.crossings)
    turns += c.size();
  EXPECT_GT(turns, 70000U);
  EXPECT_LE(largest_drift(r), 3e-13);
}

// Steady rotations have entire series, for which a high order and whole turns in a step look cheap;
// but e^6 of rounding in each made |Gamma| drift by 6e-15 in a turn, also for the orbits after
// them, which had to use their order.
TEST(HardCases, SteadyRotationsAndWhatComesAfterThem) {
  Scene s = read_scene(scene_path("asymmetric_classical"));
  s.columns = s.rows = 0;
  s.crossings = 3000;
  s.seeds.assign(20, Seed{"pi/2", "0"});
  s.seeds.insert(s.seeds.end(), {{"1/10", "1/1000"}, {"1", "1/2"}, {"3", "-4/5"}});
  EXPECT_LE(simulate(s).drift, 2e-12); // 2e-11 before
  s.seeds = {{"pi/2", "0"}};
  EXPECT_LE(simulate(s).drift, 1e-12);
}

// The order that a run uses is that of all its orbits, in whatever place they stand.
TEST(HardCases, TheOrderDoesNotDependOnTheOrbitsPlaces) {
  const Scene s = read_scene(scene_path("asymmetric_sliding"));
  const Effects effects = s.effects();
  const Model<double> model = model_of(s.body<double>(), effects);
  std::vector<State<double>> starts = states_of<double>(s);
  const auto order = [&] {
    const std::vector<double> x = numbers(starts);
    return choose_order(effects, model, x.data(), starts.size(), -59);
  };
  const int forwards = order();
  std::reverse(starts.begin(), starts.end());
  EXPECT_EQ(order(), forwards);
}

// Hess-Appelrot, paper eq. (HAdarbus): F = 3 M1 + 4 M3 up to a factor.
template <class R> R darboux(const Body<R>& b, const State<R>& x) {
  const Vec<R> m = momentum(b, x);
  return R(3) * m[0] + R(4) * m[2];
}

TEST(HardCases, HessAppelrotOrbitsOffThePlaneNeverCrossIt) {
  for (const char* name : {"hess_classical", "hess_sliding"}) {
    const Scene s = read_scene(scene_path(name));
    const Body<double> b = s.body<double>();
    auto starts = states_of<double>(s);
    for (const double d :
         {1e-2, 1e-4, 1e-6, 1e-8}) // beside the curve 4 y + 3 sqrt(1-y^2) sin l = 0
      for (const double side : {-1.0, 1.0})
        for (const double l : {0.5, 4.0}) {
          const double sl = std::sin(l), y = -3 * sl / std::sqrt(16 + 9 * sl * sl) + side * d;
          starts.push_back(point(b, s.levels<double>(), l, y));
        }
    const auto r = run(b, starts, {.t_end = 200, .log2_tolerance = -59}, s.section);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const double first = darboux(b, starts[i]);
      for (const auto& c : r.crossings.at(i))
        ASSERT_GT(darboux(b, state_of(c.x)) * first, 0)
            << name << ", orbit " << i << ", t = " << c.t;
    }
  }
}

// The plane is invariant but unstable: an orbit on it leaves through rounding only, later with more
// digits (the picture: docs/accuracy/escape.png).  Luck in the last bit can only prolong its stay,
// so the shortest of a few counts.
TEST(HardCases, HessAppelrotPlaneIsLeftThroughRoundingOnly) {
  const Scene s = read_scene(scene_path("hess_sliding"));
  const auto shortest = [&](Arithmetic a, int digits) {
    double least = 1e9;
    for (const char* l : {"4", "5"})
      least = std::min(least, escape_time(s, a, digits, Quantity(l), 40));
    return least;
  };
  const double in_double = shortest(Arithmetic::one_lane, 16),
               in_pairs = shortest(Arithmetic::pairs, 32), in_40 = shortest(Arithmetic::mpfr, 40);
  EXPECT_GT(in_double, 6);
  EXPECT_GT(in_pairs, 1.7 * in_double);
  EXPECT_GT(in_40, 1.15 * in_pairs);
  EXPECT_LT(in_40, 40);
}

} // namespace
} // namespace kov::flow
