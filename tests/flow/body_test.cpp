// Sections of bodies: the equations of motion, the panels of the paper, integrals, hard cases.

#include "../../tools/bench/body.hpp"
#include "flow/scene/section_stage.hpp"
#include "support.hpp"

#include "symbol/document.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::flow::body_test {
namespace {

using namespace test;

const char* const panels[] = {
    "asymmetric_classical",   "asymmetric_sliding",   "lever_quarter",       "lever_half",
    "kovalevskaya_classical", "kovalevskaya_sliding", "goryachev_classical", "goryachev_sliding",
    "hess_classical",         "hess_sliding"};

SystemScene scene_from(const std::string& body, const std::string& levels,
                       const std::string& orbits, const std::string& section = {}) {
  return system_of(parse_scene("format = \"scene/1\"\n[body]\n" + body + "\n[levels]\n" + levels +
                                   "\n[section]\n" + section + "\n[orbits]\n" + orbits,
                               "test"));
}

const std::string asymmetric = "inertia = [1, \"2/3\", \"1/2\"]\n",
                  usual = "H = \"3/2\"\nF2 = \"1/20\"";

// ---- the equations of motion ----

// Newton's law for the sliding or the fixed tip, in Omega and Gamma:
//   I Omega' = (K - B) x Omega - m (g + z'') v,  D z'' = v'.Omega + v.I^-1((K - B) x Omega) - g (D - 1)
// with K = I Omega, v = L x Gamma, D = 1 + m v.I^-1 v; z'' = 0 for the fixed tip.
State<double> motion(const Body<double>& b, const State<double>& x) {
  const Mat<double> a = inverse_symmetric(b.inertia);
  const Vec<double> v = cross(b.lever, x.gamma), u = times(a, v), turn = cross(x.gamma, x.omega);
  const Vec<double> y = times(a, cross(minus(times(b.inertia, x.omega), b.gyrostat), x.omega));
  const double d = 1 + b.mass * dot(v, u);
  const double lift =
      b.sliding ? (dot(cross(b.lever, turn), x.omega) + dot(v, y) - b.gravity * (d - 1)) / d : 0;
  return {minus(y, scaled(b.mass * (b.gravity + lift), u)), turn};
}

TEST(Body, ItsSystemMovesAsNewtonSays) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const char* tip : {"sliding", "fixed"})
    for (const char* axis : {"1", "2", "3"}) {
      const SystemScene s = scene_from(
          "inertia = [[1, \"1/10\", 0], [\"1/10\", \"4/5\", \"1/20\"], [0, \"1/20\", \"3/5\"]]\n"
          "gyrostat = [\"1/7\", \"1/5\", -1]\nlever = [\"1/2\", \"sqrt(2)/3\", \"1/3\"]\n"
          "gravity = \"1/4\"\ntip = \"" +
              std::string(tip) + "\"",
          "H = 3\nF2 = \"1/20\"", "grid = [2, 2]\ncrossings = 1", "axis = " + std::string(axis));
      const Body<double> b = body_of(s.body->own);
      const Field f(s.system, s.section.value, s.system.field.components, s.values, false,
                    s.written.get());
      Evaluator<double> rates(f, s.system.field.components);
      std::vector<double> values;
      for (const std::size_t i : f.numbers())
        values.push_back(s.values.at(i).as<double>());
      rates.set(values.data());
      State<double> x;
      for (Vec<double>* v : {&x.omega, &x.gamma})
        for (double& c : *v)
          c = number(random);
      const State<double> d = motion(b, x);
      const double h = 1e-5;
      const auto at = [&](double t) {
        return coordinates_of(
            b, State<double>{plus(x.omega, scaled(t, d.omega)), plus(x.gamma, scaled(t, d.gamma))},
            s.body->own.section.axis);
      };
      const std::vector<double> before = at(-h), after = at(h), now = at(0);
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(rates(now.data())[i], (after[i] - before[i]) / (2 * h), 1e-8) << tip << axis;
    }
}

// ---- the panels of the paper ----

TEST(Body, TheFirstTenCrossingsAgreeWithThirtyDigits) {
  for (const char* name : panels) {
    SystemScene s = body_scene(name);
    s.columns = 4;
    s.rows = 5;
    s.crossings = 10;
    const SystemSection run = simulate(s);
    s.digits = 31;
    s.tolerance = "10^-28";
    const SystemSection reference = simulate(s);
    ASSERT_EQ(run.points.size(), reference.points.size()) << name;
    EXPECT_LE(reference.drift, 1e-26) << name;
    // The chaotic seas multiply an error by more than ten at a turn.
    const std::string n = name;
    const double bound = n == "asymmetric_sliding" ? 1e-12 : n == "hess_sliding" ? 1e-8 : 1e-9;
    double worst = 0;
    for (std::size_t i = 0; i < run.points.size(); ++i)
      worst = std::max(worst, apart(run.points[i], reference.points[i]));
    EXPECT_LE(worst, bound) << name;
  }
}

TEST(Body, TheNumberOfCrossingsIsThatOfThePreciseRunAtEveryAccuracy) {
  SystemScene s = body_scene("bench/asymmetric_sliding_32");
  s.time = "200";
  const auto counts = [&](const char* tolerance, int digits) {
    s.tolerance = tolerance;
    s.digits = digits;
    std::vector<long> all;
    for (const DrawnOrbit& o : simulate(s).orbits)
      all.push_back(o.crossings);
    return all;
  };
  const auto reference = counts("10^-28", 31);
  ASSERT_EQ(reference.size(), 32U);
  for (const char* tolerance : {"10^-4", "10^-5", "10^-7", "10^-10", "10^-14", "10^-16"})
    EXPECT_EQ(counts(tolerance, 0), reference) << tolerance;
  EXPECT_EQ(counts("10^-18", 19), reference);
}

TEST(Body, DriftGoesDownToRounding) {
  const SystemSection s = simulate(body_scene("bench/asymmetric_sliding_32"));
  EXPECT_EQ(s.orbits.size(), 32U);
  EXPECT_LE(s.drift, 1e-13);
}

TEST(Body, DirectionsPartitionTheCrossings) {
  for (const char* angle : {"angle = \"pi/2\"\n", "angle = \"3*pi/2\"\n"}) {
    SystemScene s =
        scene_from(asymmetric + "tip = \"sliding\"\nlever = [\"1/3\", \"1/4\", \"sqrt(11)/12\"]",
                   usual, "grid = [3, 3]\ntime = 50", angle + std::string("direction = \"both\""));
    const std::size_t all = simulate(s).points.size();
    s.falling = false;
    const std::size_t rising = simulate(s).points.size();
    std::swap(s.falling, s.rising);
    EXPECT_GT(all, 0U);
    EXPECT_EQ(all, rising + simulate(s).points.size()) << angle;
  }
}

// With the labels of the axes turned, body and chart together, the section is the same.
TEST(Body, TurningTheLabelsOfTheAxesChangesNothing) {
  const std::string orbits = "grid = [3, 4]\ncrossings = 8", tip = "tip = \"sliding\"\n";
  const SystemSection plain =
      simulate(scene_from(asymmetric + tip + "lever = [\"8/9\", 0, 0]", usual, orbits));
  for (const auto& [body, axis] :
       {std::pair{"inertia = [\"1/2\", 1, \"2/3\"]\nlever = [0, \"8/9\", 0]\n", "axis = 1"},
        std::pair{"inertia = [\"2/3\", \"1/2\", 1]\nlever = [0, 0, \"8/9\"]\n", "axis = 2"}}) {
    const SystemSection turned = simulate(scene_from(body + tip, usual, orbits, axis));
    ASSERT_EQ(turned.points.size(), plain.points.size());
    for (std::size_t i = 0; i < plain.points.size(); ++i)
      EXPECT_LE(apart(turned.points[i], plain.points[i]), 1e-8);
  }
}

// A function of N and Gamma in the place of what is drawn: its values at the crossings.
double spread(SystemScene s, const MFraction& f) {
  s.sphere.reset();
  s.angle = {};
  s.plot[0].value = f;
  s.time = "300";
  s.crossings = -1;
  s.columns = s.rows = 3;
  double worst = 0;
  for (const auto& points : by_orbit(simulate(s)))
    for (const DrawnPoint& p : points)
      worst = std::max(worst, std::abs(p.at[0] - points[0].at[0]) /
                                  std::max(1.0, std::abs(points[0].at[0])));
  return worst;
}

TEST(Body, IntegrableOnesKeepTheirExtraIntegral) {
  const auto variables = [](const SystemScene& s) {
    std::vector<MFraction> all;
    for (const std::size_t i : s.system.field.coordinates)
      all.push_back(MFraction::variable(s.system.ring(), i));
    return all;
  };
  const auto number = [](const SystemScene& s, int n) {
    return MFraction(s.system.ring(), Rational(n));
  };
  const SystemScene euler = body_scene("asymmetric_classical");
  auto x = variables(euler);
  EXPECT_LE(spread(euler, x[0] * x[0] + x[1] * x[1] + x[2] * x[2]), 3e-12);
  // I = (1, 1, 1/2), m g L = 1: |(w1 + i w2)^2 - (2 gamma1 + 2 i gamma2)|^2, w = N there
  const SystemScene kovalevskaya = body_scene("kovalevskaya_classical");
  x = variables(kovalevskaya);
  const MFraction two = number(kovalevskaya, 2), re = x[0] * x[0] - x[1] * x[1] - two * x[3],
                  im = two * x[0] * x[1] - two * x[4];
  EXPECT_LE(spread(kovalevskaya, re * re + im * im), 3e-12);
  const SystemScene goryachev = body_scene("goryachev_classical");
  x = variables(goryachev);
  EXPECT_LE(spread(goryachev, x[2] * (x[0] * x[0] + x[1] * x[1]) - x[0] * x[5]), 3e-12);
  const SystemScene lagrange =
      scene_from("inertia = [2, 2, \"3/2\"]\nlever = [0, 0, \"7/10\"]\ngravity = \"5/4\"\n"
                 "gyrostat = [0, 0, \"1/2\"]\ntip = \"sliding\"",
                 "H = 3\nF2 = \"1/2\"", "grid = [3, 3]\ncrossings = 1");
  EXPECT_LE(spread(lagrange, variables(lagrange)[2]), 1e-12);
}

TEST(Body, StopEndsARunWithWhatIsDone) {
  SystemScene s = body_scene("asymmetric_sliding");
  std::atomic<bool> stop{true};
  SystemSectionOptions o;
  o.stop = &stop;
  EXPECT_THROW((void)simulate(s, o), InputError);
  stop = false;
  o.progress = [&](std::size_t done, std::size_t) { stop = done >= 64; };
  const SystemSection some = simulate(s, o);
  EXPECT_TRUE(some.stopped);
  EXPECT_EQ(some.points.size(), 64U * 600U);
}

// ---- hard cases ----

TEST(HardBodies, NearTheSeparatrix) {
  for (int k = 3; k <= 12; ++k) {
    const std::string d = "10^-" + std::to_string(k);
    const SystemSection r =
        simulate(scene_from(asymmetric + "tip = \"fixed\"", usual,
                            "seeds = [[\"" + d + "\", 0], [0, \"" + d + "\"]]\ntime = 2000"));
    EXPECT_LE(r.drift, 1e-12) << k;
    if (k > 6) continue;
    double lowest = 1;
    for (const DrawnPoint& p : by_orbit(r)[1])
      lowest = std::min(lowest, p.at[1]);
    EXPECT_GT(lowest, 0) << k; // it rotates
  }
}

// |L|/G -> 1, where Andoyer's angles lose their meaning.
TEST(HardBodies, PolesOfTheChart) {
  for (int k = 3; k <= 12; ++k) {
    const std::string y = "1-10^-" + std::to_string(k);
    SystemScene s = scene_from(asymmetric + "lever = [\"8/9\", 0, 0]\ntip = \"sliding\"", usual,
                               "seeds = [[\"3/10\", \"" + y + "\"]]\ntime = 60");
    const SystemSection r = simulate(s);
    EXPECT_LE(r.drift, 1e-12) << k;
    s.digits = 31;
    s.tolerance = "10^-28";
    const SystemSection p = simulate(s);
    ASSERT_EQ(r.points.size(), p.points.size()) << k;
    for (std::size_t i = 0; i < r.points.size(); ++i)
      EXPECT_NEAR(r.points[i].t, p.points[i].t, 1e-7) << k; // the start loses half of the digits
  }
}

TEST(HardBodies, NearlySymmetricAndNearlyFlatOnes) {
  for (const char* e : {"10^-3", "10^-6", "10^-9", "10^-12", "10^-15"})
    for (const std::string inertia : {"[1, \"1+" + std::string(e) + "\", \"1/2\"]",
                                      "[\"3/5\", \"2/5\", \"1-" + std::string(e) + "\"]"})
      EXPECT_LE(
          simulate(scene_from("inertia = " + inertia +
                                  "\nlever = [\"3/10\", 0, \"4/10\"]\ngravity = "
                                  "\"1/4\"\ntip = \"sliding\"",
                              usual,
                              "seeds = [[1, \"-3/5\"], [1, \"1/10\"], [1, \"7/10\"]]\ntime = 500"))
              .drift,
          2e-13)
          << inertia;
}

TEST(HardBodies, LongAndShortLevers) {
  for (int k = -3; k <= 12; ++k)
    for (const char* gravity : {"0", "1"}) {
      const std::string lever = "10^(-" + std::to_string(k) + ")";
      EXPECT_LE(simulate(scene_from(asymmetric + "lever = [\"10^(" + std::to_string(-k) +
                                        ")\", 0, 0]\ngravity = \"" + gravity + "*10^(" +
                                        std::to_string(k) + ")\"\ntip = \"sliding\"",
                                    "H = \"5/2\"\nF2 = \"1/20\"", "grid = [2, 3]\ncrossings = 40"))
                    .drift,
                1e-12)
          << lever << gravity;
    }
}

TEST(HardBodies, ManyTurns) {
  SystemScene s = body_scene("asymmetric_sliding");
  s.columns = 2;
  s.rows = 4;
  s.crossings = 9000;
  const SystemSection r = simulate(s);
  EXPECT_EQ(r.points.size(), 72000U);
  EXPECT_LE(r.drift, 1e-12);
}

// Steady rotations have entire series, for which a high order and whole turns in a step look cheap;
// but e^6 of rounding in each made |Gamma| drift by 6e-15 in a turn.
TEST(HardBodies, SteadyRotationsAndWhatComesAfterThem) {
  SystemScene s = body_scene("asymmetric_classical");
  s.columns = s.rows = 0;
  s.crossings = 3000;
  s.seeds.assign(20, {"pi/2", "0"});
  s.seeds.insert(s.seeds.end(), {{"1/10", "1/1000"}, {"1", "1/2"}, {"3", "-4/5"}});
  EXPECT_LE(simulate(s).drift, 4e-12);
}

// The plane c.M = 0 is invariant: an orbit beside it stays on its side.
TEST(HardBodies, HessAppelrotOrbitsOffThePlaneNeverCrossIt) {
  for (const char* name : {"hess_classical", "hess_sliding"}) {
    SystemScene s = body_scene(name);
    s.sphere.reset();
    s.angle = {};
    s.plot[1].value = *s.sign_of;
    s.crossings = -1;
    s.time = "200";
    for (const auto& points : by_orbit(simulate(s)))
      for (const DrawnPoint& p : points)
        ASSERT_GT(p.at[1] * points[0].at[1], 0) << name;
  }
}

} // namespace
} // namespace kov::flow::body_test
