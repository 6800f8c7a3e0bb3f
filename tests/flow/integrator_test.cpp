#include "support.hpp"

#include <gtest/gtest.h>

namespace kov::flow {
namespace {

using namespace test;

Scene scene_of(const std::string& name) { return read_scene(scene_path(name)); }

const char* const panels[] = {
    "asymmetric_classical",   "asymmetric_sliding",   "lever_quarter",       "lever_half",
    "kovalevskaya_classical", "kovalevskaya_sliding", "goryachev_classical", "goryachev_sliding",
    "hess_classical",         "hess_sliding"};

template <class R>
double distance(const Body<double>& b, const Crossing<double>& c, const Crossing<R>& r) {
  const auto a = andoyer_of(b, rounded(c.x), 2), e = andoyer_of(b, rounded(r.x), 2);
  return std::max(std::abs(std::remainder(a.l - e.l, 2 * M_PI)), std::abs(a.y - e.y));
}

// Pairs of doubles are the reference of the other tests: here they face 120 bits of MPFR.
TEST(Integrator, PairsOfDoublesAgreeWithMpfr) {
  const PrecisionScope scope(120);
  Scene s = scene_of("lever_half");
  s.columns = 1;
  s.rows = 1;
  const Goal goal{.t_end = 1e4, .log2_tolerance = -102, .max_crossings = 4};
  const auto twins = run(s.body<Twin1>(), states_of<Twin1>(s), goal, s.section);
  const auto big = run(s.body<BigReal>(), states_of<BigReal>(s), goal, s.section);
  ASSERT_EQ(twins.crossings.at(0).size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    for (int k = 0; k < 6; ++k) {
      const Twin1 t = twins.crossings.at(0)[i].x[k];
      const BigReal e = BigReal(t.hi) + BigReal(t.lo) - big.crossings.at(0)[i].x[k];
      EXPECT_LE(std::abs(static_cast<double>(e)), 2e-29) << i << " " << k;
    }
  EXPECT_LE(largest_drift(twins), 1e-29);
}

// Issue 7: the first ten section points within 1e-12 of a reference, for every panel of the paper.
TEST(Integrator, TheFirstTenCrossingsAgreeWithThirtyDigits) {
  for (const char* name : panels) {
    const Scene s = scene_of(name);
    const Goal goal{.t_end = 1e4, .log2_tolerance = -59, .max_crossings = 10};
    Goal fine = goal;
    fine.log2_tolerance = -98;
    const Body<double> b = s.body<double>();
    const auto record = run(b, states_of<double>(s), goal, s.section);
    const auto reference = run(s.body<Twin1>(), states_of<Twin1>(s), fine, s.section);
    ASSERT_EQ(reference.crossings.size(), 72U);
    // The chaotic seas multiply an error by more than ten at a turn; the scene is the second panel.
    const std::string n = name;
    const double bound = n == "asymmetric_sliding" ? 1e-12 : n == "hess_sliding" ? 1e-8 : 1e-9;
    double worst = 0;
    for (const auto& [orbit, points] : reference.crossings) {
      ASSERT_EQ(points.size(), 10U) << name;
      ASSERT_EQ(record.crossings.at(orbit).size(), 10U) << name;
      for (std::size_t i = 0; i < 10; ++i)
        worst = std::max(worst, distance(b, record.crossings.at(orbit)[i], points[i]));
    }
    EXPECT_LE(worst, bound) << name;
    EXPECT_LE(largest_drift(reference), 1e-27) << name;
  }
}

TEST(Integrator, TheNumberOfCrossingsIsThatOfThePreciseRunAtEveryAccuracy) {
  const Scene s = read_scene(scene_path("bench/asymmetric_sliding_32"));
  Goal goal{.t_end = 200, .log2_tolerance = -98};
  const auto reference = run(s.body<Twin1>(), states_of<Twin1>(s), goal, s.section);
  ASSERT_EQ(reference.crossings.size(), 32U);
  const auto compare = [&](const auto& record) {
    for (const auto& [orbit, points] : reference.crossings)
      EXPECT_EQ(record.crossings.at(orbit).size(), points.size())
          << "orbit " << orbit << ", tolerance 2^" << goal.log2_tolerance;
  };
  for (const double accuracy : {-20.0, -24.0, -30.0, -40.0, -53.0, -59.0}) {
    goal.log2_tolerance = accuracy;
    compare(run(s.body<double>(), states_of<double>(s), goal, s.section));
  }
  goal.log2_tolerance = -66;
  compare(run(s.body<long double>(), states_of<long double>(s), goal, s.section));
}

TEST(Integrator, DriftGoesDownToRounding) {
  const Scene s = read_scene(scene_path("bench/asymmetric_sliding_32"));
  const auto record = run(s.body<double>(), states_of<double>(s), {.t_end = 1000}, s.section);
  EXPECT_EQ(record.ends.size(), 32U);
  EXPECT_LE(largest_drift(record), 3e-14);
}

TEST(Integrator, LanesAndThreadsDoNotChangeAnything) {
  for (const char* name : {"asymmetric_sliding", "lever_half", "kovalevskaya_classical"}) {
    const Scene s = scene_of(name);
    const auto starts = states_of<double>(s);
    for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512}) {
      if (isa > best_isa()) continue;
      std::vector<Record<double>> records;
      for (const int lanes : {1, 4, 8}) {
        Goal goal{.t_end = 25, .lanes = lanes};
        goal.isa = isa;
        records.push_back(run(s.body<double>(), starts, goal, s.section));
      }
      for (std::size_t i = 1; i < records.size(); ++i)
        for (const auto& [orbit, end] : records[0].ends) {
          const auto& other = records[i].ends.at(orbit);
          for (int k = 0; k < 6; ++k)
            EXPECT_EQ(end.x[k], other.x[k])
                << name << ", " << to_string(isa) << ", orbit " << orbit;
          for (int k = 0; k < 3; ++k)
            EXPECT_EQ(end.drift[k], other.drift[k]);
          ASSERT_EQ(records[0].crossings[orbit].size(), records[i].crossings[orbit].size());
          for (std::size_t c = 0; c < records[0].crossings[orbit].size(); ++c)
            EXPECT_EQ(records[0].crossings[orbit][c].t, records[i].crossings[orbit][c].t);
        }
    }
  }
  const Scene s = scene_of("lever_quarter");
  SimulateOptions one, four;
  four.threads = 3;
  four.lanes = 4;
  const Section a = simulate(s, one), b = simulate(s, four);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    EXPECT_EQ(a.points[i].orbit, b.points[i].orbit);
    EXPECT_EQ(a.points[i].l, b.points[i].l);
    EXPECT_EQ(a.points[i].y, b.points[i].y);
  }
}

// The section points really lie on the section, with the wanted direction, and no other sign change of S
// happens between two of them (looked for on a fine mesh of an independent run).
TEST(Integrator, NoCrossingIsMissedOrCountedTwice) {
  for (const char* name : panels) {
    Scene s = scene_of(name);
    s.columns = 3;
    s.rows = 3;
    const Body<double> b = s.body<double>();
    const auto starts = states_of<double>(s);
    const double t_end = 30;
    const auto record = run(b, starts, {.t_end = t_end}, s.section);
    const auto section = [&](const State<double>& x, double& side) {
      const Vec<double> n = minus(momentum(b, x), b.gyrostat);
      side = n[1] * x.gamma[0] - n[0] * x.gamma[1];
      return dot(n, x.gamma) * n[2] - dot(n, n) * x.gamma[2];
    };
    for (std::size_t i = 0; i < starts.size(); ++i) {
      double side = 0;
      for (const auto& c : record.crossings.at(i)) {
        const double size = dot(momentum(b, state_of(c.x)), momentum(b, state_of(c.x)));
        EXPECT_LE(std::abs(section(state_of(c.x), side)), 1e-13 * (1 + size)) << name;
        EXPECT_GT(side, 0);
        EXPECT_TRUE(moves_upward(b, state_of(c.x), s.section));
      }
      // the mesh: short runs of length 0.01 one after another
      std::size_t counted = 0;
      State<double> x = starts[i];
      bool above = false;
      const int cells = 1500;
      for (int k = 0; k < cells; ++k) {
        const auto piece = run(
            b, {x}, {.t_end = t_end / cells, .log2_tolerance = -60, .section = false, .lanes = 1});
        x = state_of(piece.ends.at(0).x);
        const double now = section(x, side);
        if (above && now <= 0 && side > 0) ++counted;
        above = now > 0;
      }
      EXPECT_EQ(record.crossings.at(i).size(), counted) << name << ", orbit " << i;
    }
  }
}

// Omega -> -Omega, B -> -B reverses time.
TEST(Integrator, TimeReversalReturnsToTheStart) {
  for (const char* name : {"asymmetric_sliding", "hess_sliding", "kovalevskaya_sliding"}) {
    const Scene s = scene_of(name);
    const Body<double> b = s.body<double>();
    const auto starts = states_of<double>(s);
    auto there = run(b, starts, {.t_end = 8, .log2_tolerance = -58, .section = false});
    std::vector<State<double>> turned;
    for (auto& [orbit, end] : there.ends) {
      State<double> x = state_of(end.x);
      x.omega = scaled(-1.0, x.omega);
      turned.push_back(x);
    }
    const auto back = run(b, turned, {.t_end = 8, .log2_tolerance = -58, .section = false});
    for (std::size_t i = 0; i < starts.size(); ++i)
      for (int k = 0; k < 3; ++k) { // at most e^(lambda t) of rounding, lambda below 1 here
        EXPECT_NEAR(-back.ends.at(i).x[k], starts[i].omega[k], 1e-9) << name << " " << i;
        EXPECT_NEAR(back.ends.at(i).x[3 + k], starts[i].gamma[k], 1e-9) << name << " " << i;
      }
  }
}

TEST(Integrator, DirectionsAndSidesPartitionTheCrossings) {
  const Scene s = scene_of("lever_half");
  const auto starts = states_of<double>(s);
  const auto count = [&](bool falling, bool rising, int side) {
    SectionRule rule = s.section;
    rule.falling = falling;
    rule.rising = rising;
    rule.side = side;
    std::size_t n = 0;
    for (const auto& [orbit, c] : run(s.body<double>(), starts, {.t_end = 50}, rule).crossings)
      n += c.size();
    return n;
  };
  EXPECT_EQ(count(true, true, 1), count(true, false, 1) + count(false, true, 1));
  EXPECT_EQ(count(true, true, -1), count(true, false, -1) + count(false, true, -1));
  EXPECT_GT(count(false, true, -1), 0U); // dg/dt > 0 at g = 3pi/2
}

// With the labels of the axes turned, body and chart together, the section is the same.
TEST(Integrator, TurningTheLabelsOfTheAxesChangesNothing) {
  const Scene s = scene_of("asymmetric_sliding");
  const Body<double> b = s.body<double>();
  const auto starts = states_of<double>(s);
  const auto plain = run(b, starts, {.t_end = 20}, s.section);
  for (int shift = 1; shift < 3; ++shift) {
    Body<double> t = b;
    std::vector<State<double>> moved(starts.size());
    for (int i = 0; i < 3; ++i) {
      const int to = (i + shift) % 3;
      t.inertia[to][to] = b.inertia[i][i];
      t.lever[to] = b.lever[i];
      for (std::size_t k = 0; k < starts.size(); ++k) {
        moved[k].omega[to] = starts[k].omega[i];
        moved[k].gamma[to] = starts[k].gamma[i];
      }
    }
    SectionRule rule = s.section;
    rule.axis = (2 + shift) % 3;
    const auto turned = run(t, moved, {.t_end = 20}, rule);
    for (const auto& [orbit, points] : plain.crossings)
      for (std::size_t i = 0; i < points.size(); ++i)
        for (int k = 0; k < 3; ++k)
          EXPECT_EQ(points[i].x[k], turned.crossings.at(orbit).at(i).x[(k + shift) % 3]);
  }
}

TEST(Integrator, IntegrableBodiesConserveTheirExtraIntegral) {
  const auto spread = [](const std::string& name, const auto& extra, bool casimir_zero = false) {
    Scene s = scene_of(name);
    if (casimir_zero) s.casimir = Quantity("0");
    const Body<double> b = s.body<double>();
    const auto record = run(b, states_of<double>(s), {.t_end = 300}, s.section);
    double worst = 0;
    for (const auto& [orbit, points] : record.crossings)
      for (const auto& c : points) {
        const double first = extra(b, state_of(points[0].x)), now = extra(b, state_of(c.x));
        worst = std::max(worst, std::abs(now - first) / std::max(1.0, std::abs(first)));
      }
    return worst;
  };
  EXPECT_LE(
      spread("asymmetric_classical", // Euler
             [](const auto& b, const auto& x) { return dot(momentum(b, x), momentum(b, x)); }),
      3e-12);
  EXPECT_LE(
      spread("kovalevskaya_classical",
             [](const auto&,
                const auto& x) { // |(w1 + i w2)^2 - 2 (gamma1 + i gamma2)/2|^2, I1 = I2 = 2 I3
               const double re = x.omega[0] * x.omega[0] - x.omega[1] * x.omega[1] - 2 * x.gamma[0],
                            im = 2 * x.omega[0] * x.omega[1] - 2 * x.gamma[1];
               return re * re + im * im;
             }),
      3e-12);
  EXPECT_LE(spread("goryachev_classical",
                   [](const auto& b, const auto& x) {
                     const auto m = momentum(b, x);
                     return m[2] * (m[0] * m[0] + m[1] * m[1]) - m[0] * x.gamma[2] * 1.0;
                   }),
            3e-12);
}

TEST(Integrator, LagrangeAndZhukovskiiConserveTheirExtraIntegral) {
  Body<double> lagrange;
  lagrange.inertia = {{{2, 0, 0}, {0, 2, 0}, {0, 0, 1.5}}};
  lagrange.lever = {0, 0, 0.7};
  lagrange.gravity = 1.25;
  lagrange.gyrostat = {0, 0, 0.5};
  lagrange.sliding = true;
  const State<double> x{{0.3, -0.2, 1.1}, {0.48, 0.6, 0.64}};
  const auto a = run(lagrange, std::vector<State<double>>{x}, {.t_end = 500, .section = false});
  EXPECT_NEAR(momentum(lagrange, state_of(a.ends.at(0).x))[2], momentum(lagrange, x)[2], 1e-12);
  EXPECT_LE(largest_drift(a), 1e-12);

  Body<double> zhukovskii;
  zhukovskii.inertia = {{{1, 0.1, 0}, {0.1, 0.8, 0.05}, {0, 0.05, 0.6}}};
  zhukovskii.gyrostat = {0.1, 0.2, -0.3};
  const auto extra = [&](const State<double>& s) {
    const Vec<double> m = momentum(zhukovskii, s);
    return dot(m, m) - 2 * dot(zhukovskii.gyrostat, m);
  };
  const auto c = run(zhukovskii, std::vector<State<double>>{x}, {.t_end = 500, .section = false});
  EXPECT_NEAR(extra(state_of(c.ends.at(0).x)), extra(x), 1e-12);
}

TEST(Integrator, StopAndLimitsEndARunWithWhatIsDone) {
  const Scene s = scene_of("asymmetric_sliding");
  std::atomic<bool> stop{true};
  SimulateOptions o;
  o.stop = &stop;
  const Section none = simulate(s, o);
  EXPECT_TRUE(none.stopped);
  EXPECT_EQ(none.points.size(), 0U);
  stop = false;
  o.progress = [&](std::size_t done, std::size_t) { stop = done >= 32; };
  const Section some = simulate(s, o);
  EXPECT_TRUE(some.stopped);
  EXPECT_EQ(some.points.size(), 32U * 600U);
}

} // namespace
} // namespace kov::flow
