// Where nothing moves any more: exponents of linear fields, sinks, saddles, equilibria and limit cycles, which are known;
// crossings of orbits that decay, whose times are known; orbits that lie in their section.

#include "flow/scene/system_section.hpp"
#include "support.hpp"

#include "symbol/document.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kov::flow::rest_test {
namespace {

SystemScene scene_of(const std::string& text) {
  return read_system_scenes(parse_document(text, "test.toml")).front();
}

// x' = f, y' = g
std::string plane_field(const std::string& f, const std::string& g, const std::string& scene) {
  return "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y']\n[system.field]\nx = '" + f +
         "'\ny = '" + g + "'\n[scene]\nplot = ['x', 'y']\ndirection = 'both'\n" + scene;
}

constexpr const char* henon_heiles =
    "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
    "hamiltonian = '(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3'\n[scene]\nplot = ['y', 'v']\n";

struct Known {
  std::string f, g, state;
  double exponent;
};

// The exponent is known; where an orbit rests or is attracted to rest it is said so, and it is not chaotic.
void compare(const Known& k, const char* digits) {
  const SystemScene scene =
      scene_of(plane_field(k.f, k.g,
                           "section = 'x - 77'\nindicator = 'megno'\ntime = 300\nstates = [[" +
                               k.state + "]]\n" + digits));
  const DrawnOrbit o = simulate(scene).orbits[0];
  const std::string what = k.f + ", " + k.g + " from " + k.state + " " + digits;
  EXPECT_NEAR(o.indicators.lyapunov, k.exponent, o.indicators.lyapunov_error) << what;
  EXPECT_LE(o.indicators.lyapunov_error, 0.07) << what;
  if (k.exponent <= 0) {
    EXPECT_LE(o.indicators.megno, 3) << what;
  }
}

TEST(Rest, ExponentsThatAreKnown) {
  const std::vector<Known> all{
      {"-x", "-y", "'1/2', '1/2'", -1},
      {"-x", "-1000*y", "'1/2', '1/2'", -1}, // stiff
      {"-x", "-y/10^3", "'1/2', '1/2'", -1e-3},
      {"-x + y", "-y", "'1/2', '1/2'", -1}, // one eigenvector
      {"-x + 5*y", "-5*x - y", "1, 2", -1},
      {"-x/10 - y", "x - y/10", "'10^-9', '10^9'", -0.1},
      {"y", "-x - y/5", "1, 0", -0.1},
      {"2*x", "-y", "0, 0", 2}, // a saddle
      {"2*x", "-y", "0, 1", 2},
      {"x - 5*y", "5*x + y", "0, 0", 1},
      {"y", "-x", "0, 0", 0},
      {"y", "-4*x", "1, 1", 0},
      {"0", "0", "1, 1", 0},
      {"1", "-y", "0, 1", 0},
      // shifted: the equilibrium is (2/3, -1/7), not a number of the machine
      {"-(x - 2/3) + (y + 1/7)", "-(x - 2/3) - (y + 1/7)", "1, 1", -1},
      {"-(x - 2/3)", "-3*(y + 1/7)", "1, 1", -1},
      {"1 - x^2", "-3*y", "0, 1", -2}, // sinks of fields that are not linear
      {"x - x^3", "-y", "'1/2', '1/3'", -1},
      {"x - x^3", "-y", "1, 0", -1},
      {"x - x^3", "-y", "0, 1", 1}, // the invariant line of the saddle
      {"y", "-x - y/5 + x^3/10", "1, 0", -0.1},
      // limit cycles: 0 along the cycle
      {"x - y - x*(x^2 + y^2)", "x + y - y*(x^2 + y^2)", "'1/10', 0", 0},
      {"y", "(1 - x^2)*y - x", "'1/10', 0", 0}};
  for (const Known& k : all)
    compare(k, "");
  for (std::size_t i = 0; i < all.size(); i += 3)
    for (const char* digits : {"digits = 18\n", "digits = 30\n"})
      compare(all[i], digits);
  compare(all[0], "digits = 40\ntolerance = '10^-30'\n");
  compare(all[17], "digits = 40\ntolerance = '10^-30'\n");
}

TEST(Rest, ExponentsOfEquilibriaOfHenonAndHeiles) {
  for (const auto& [state, exponent] : {std::pair{"0, 0, 0, 0", 0.0}, {"0, 1, 0, 0", 1.0}}) {
    const SystemSection s = simulate(scene_of(
        henon_heiles + ("section = 'x - 1/3'\nindicator = 'megno'\ntime = 500\nstates = [[" +
                        std::string(state) + "], [0, '1/10', '2/5', 0]]\n")));
    EXPECT_NEAR(s.orbits[0].indicators.lyapunov, exponent, s.orbits[0].indicators.lyapunov_error);
    EXPECT_EQ(s.orbits[0].rest_from, 0) << state;
    EXPECT_LT(s.orbits[1].rest_from, 0) << state;
  }
}

TEST(Rest, IsToldWithItsTime) {
  const auto orbit = [](const std::string& f, const std::string& g, const std::string& state,
                        const std::string& more) {
    return simulate(scene_of(plane_field(
                        f, g, "section = 'x - 77'\nstates = [[" + state + "]]\n" + more)))
        .orbits[0];
  };
  for (const char* more :
       {"time = 400\n", "crossings = 3\n", "crossings = 3\nindicator = 'lyapunov'\n",
        "time = 400\ndigits = 18\n", "time = 400\ndigits = 30\n"}) {
    for (const char* still : {"0, 0", "1, 0", "-1, 0"})
      EXPECT_EQ(orbit("x - x^3", "-y", still, more).rest_from, 0) << still << more;
    const double from = orbit("x - x^3", "-y", "'1/2', '1/3'", more).rest_from;
    EXPECT_GT(from, 25) << more;
    EXPECT_LT(from, 90) << more;
    EXPECT_LT(orbit("y", "-x", "0, 1", "time = 400\n").rest_from, 0) << more;
    EXPECT_LT(orbit("1/10^6", "-y", "1, 0", "time = 400\n").rest_from, 0) << more; // slow
  }
  // and with no time nothing waits for a crossing that does not come
  const DrawnOrbit o = orbit("x - x^3", "-y", "'1/2', '1/3'", "crossings = 10\n");
  EXPECT_EQ(o.ended, Ended::idle);
  EXPECT_LE(o.steps, 10000);
}

// x'' = -x - 2 d x': x = 0 at the times (k pi + atan(d/w) - phase)/w, however small x has become.
TEST(Rest, CrossingsOfADecayingOrbitGoOn) {
  for (const char* more : {"", "digits = 18\n", "digits = 30\n"})
    for (const auto& [friction, time] :
         {std::pair{"1/5", 500}, {"1/5", 1500}, {"1", 200}, {"1/50", 2500}}) {
      const SystemSection s = simulate(scene_of(
          plane_field("y", "-x - " + std::string(friction) + "*y",
                      "section = 'x'\nstates = [[1, 0], ['10^-9', 0], ['-10^9', 0]]\ntime = " +
                          std::to_string(time) + "\n" + more)));
      const double d = Quantity(friction).as<double>() / 2, w = std::sqrt(1 - d * d);
      const double first = (M_PI / 2 + std::atan(d / w)) / w;
      const auto wanted = static_cast<long>(std::floor((time - first) * w / M_PI)) + 1;
      std::array<long, 3> seen{};
      for (const DrawnPoint& p : s.points) {
        const double t = first + static_cast<double>(seen[p.orbit]++) * M_PI / w;
        EXPECT_NEAR(p.t / t, 1, 1e-11) << friction << " " << p.orbit << " " << more;
      }
      for (const long n : seen)
        EXPECT_EQ(n, wanted) << friction << " " << time << " " << more;
      for (const DrawnOrbit& o : s.orbits)
        EXPECT_LT(o.inside_from, 0);
    }
}

// The same beside what does not decay: a clock, another oscillator.
TEST(Rest, ADecayingPartGoesOnBesideTheRest) {
  const SystemSection s = simulate(scene_of(
      "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'q', 'p', 't']\n[system.field]\n"
      "x = 'y'\ny = '-x - y/5'\nq = 'p'\np = '-2*q'\nt = '1'\n[scene]\nsection = 'x'\n"
      "direction = 'both'\nplot = ['x', 'q']\nstates = [[1, 0, 1, 0, 0]]\ntime = 1000\n"));
  EXPECT_EQ(s.points.size(), 317U);
  EXPECT_LT(s.orbits[0].rest_from, 0);
  EXPECT_LT(s.orbits[0].inside_from, 0);
}

// Round a place that is not 0 rounding hides the orbit in the end: the time is told, nothing false is counted.
TEST(Rest, WhatRoundingHidesIsTold) {
  const double w = std::sqrt(1 - 0.01);
  for (const char* section : {"x - 2/3", "y", "x - 2/3 + y", "(x - 2/3)*(x^2 + 1)"}) {
    const SystemSection s = simulate(scene_of(
        plane_field("y", "-(x - 2/3) - y/5",
                    "section = '" + std::string(section) + "'\nstates = [[2, 0]]\ntime = 600\n")));
    const DrawnOrbit& o = s.orbits[0];
    EXPECT_GT(o.inside_from, 200) << section;
    EXPECT_LT(o.inside_from, 400) << section;
    EXPECT_GT(o.rest_from, 200) << section;
    ASSERT_FALSE(s.points.empty());
    EXPECT_LE(s.points.back().t, o.inside_from) << section;
    EXPECT_NEAR(static_cast<double>(o.crossings), o.inside_from * w / M_PI, 12) << section;
  }
  // a saddle-focus cycle of Lotka and Volterra: x and y come near 0 and back, and V is kept
  const SystemSection cycle = simulate(scene_of(plane_field(
      "x*(1 - y)", "y*(x - 1)", "section = 'x - 1'\nstates = [[1, 60]]\ntime = 500\n")));
  ASSERT_GE(cycle.points.size(), 8U);
  for (const DrawnPoint& p : cycle.points)
    EXPECT_NEAR(p.at[1] - std::log(p.at[1]), 60 - std::log(60), 1e-8);
}

TEST(Rest, AnOrbitThatLiesInTheSectionIsToldSo) {
  for (const char* more : {"crossings = 20\n", "time = 50\n", "crossings = 20\ndigits = 30\n"})
    for (const char* x : {"0", "'1/10^17'"}) {
      const SystemSection s = simulate(scene_of(
          henon_heiles + ("section = 'x'\ndirection = 'both'\nstates = [[" + std::string(x) +
                          ", '1/2', 0, '1/10'], [0, '1/10', '2/5', 0]]\n" + more)));
      if (std::string(x) != "0" && std::string(more).find("digits") != std::string::npos)
        continue; // there 10^-17 is not a rounding
      EXPECT_EQ(s.orbits[0].inside_from, 0) << x << more;
      EXPECT_EQ(s.orbits[0].crossings, 0) << x << more;
      EXPECT_LT(s.orbits[1].inside_from, 0) << x << more;
      EXPECT_GT(s.orbits[1].crossings, 0) << x << more;
      EXPECT_LT(s.orbits[0].steps, 10000);
    }
  for (const char* section : {"x - y", "(x - y)*(x^2 + 1)", "x^2 - y^2"}) {
    const SystemSection s = simulate(
        scene_of(plane_field("-y + x/3", "-x + y/3",
                             "section = '" + std::string(section) +
                                 "'\nstates = [['1/3', '1/3'], [1, '1/3']]\ntime = 20\n")));
    EXPECT_EQ(s.orbits[0].inside_from, 0) << section;
    EXPECT_EQ(s.orbits[0].crossings, 0) << section;
    EXPECT_LT(s.orbits[1].inside_from, 0) << section;
  }
}

// From 10^-12 to the limit cycle, through x = 0 all the time: the steps grow with the orbit.
TEST(Rest, AnOrbitMayGrowOutOfItsStart) {
  const SystemSection s = simulate(scene_of(
      plane_field("x/2 - y - x*(x^2 + y^2)/2", "x + y/2 - y*(x^2 + y^2)/2",
                  "section = 'x'\nstates = [['10^-12', 0], ['10^-50', 0]]\ntime = 1000\n")));
  EXPECT_EQ(s.points.size(), 2 * 318U);
  for (const DrawnOrbit& o : s.orbits)
    EXPECT_LE(o.steps, 5000);
}

TEST(Rest, AllKernelsAgree) {
  for (const Known& k : std::vector<Known>{{"x - x^3", "-y", "['1/2', '1/3'], [1, 0], [0, 1]", 0},
                                           {"y", "-x - y/5", "[1, 0], [0, 0], ['10^-9', 1]", 0}}) {
    const SystemScene scene = scene_of(plane_field(
        k.f, k.g, "section = 'x'\nindicator = 'megno'\ntime = 400\nstates = [" + k.state + "]\n"));
    SystemSectionOptions options;
    options.lanes = 1;
    const SystemSection one = simulate(scene, options);
    for (const int lanes : {4, 8}) {
      options.lanes = lanes;
      const SystemSection other = simulate(scene, options);
      ASSERT_EQ(one.points.size(), other.points.size());
      for (std::size_t i = 0; i < one.points.size(); ++i)
        EXPECT_EQ(one.points[i].t, other.points[i].t);
      for (std::size_t i = 0; i < one.orbits.size(); ++i) {
        EXPECT_EQ(one.orbits[i].indicators.lyapunov, other.orbits[i].indicators.lyapunov);
        EXPECT_EQ(one.orbits[i].rest_from, other.orbits[i].rest_from);
        EXPECT_EQ(one.orbits[i].inside_from, other.orbits[i].inside_from);
      }
    }
  }
}

// Functions that only the scene writes.
TEST(Rest, ASceneMayUseFunctionsThatTheSystemHasNot) {
  const std::string system =
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['q', 't']\nmomenta = ['p', 'E']\n"
      "hamiltonian = 'p^2/2 - cos(q) - cos(q - t) + E'\n[scene]\nplot = ['q', 'p']\nstates = "
      "[[0, 0, '1/2', 0], [1, 0, '1/2', 0]]\ncrossings = 30\n";
  const SystemSection s =
      simulate(scene_of(system + "section = 'sin(t)'\nwhere = 'cos(t)'\nangles = ['q']\n"));
  ASSERT_EQ(s.points.size(), 60U);
  for (std::size_t i = 0; i < s.points.size(); ++i)
    EXPECT_NEAR(s.points[i].t, 2 * M_PI * static_cast<double>(i % 30 + 1), 1e-11);
}

// Transient chaos, then a focus: its eigenvalue is known.
TEST(Rest, TheLorenzSystemComesToAFocus) {
  const SystemSection s = simulate(scene_of(
      "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z']\n[system.field]\n"
      "x = '1071/100*(y - x)'\ny = 'x*(119 - z) - y'\nz = 'x*y - 893/100*z'\n[scene]\n"
      "section = 'z - 118'\ndirection = 'downward'\nstates = [[19, 20, 50]]\nplot = ['x', 'y']\n"
      "skip = 50\ncrossings = 3000\nindicator = 'lyapunov'\n"));
  const DrawnOrbit& o = s.orbits[0];
  EXPECT_NEAR(o.indicators.lyapunov, -0.43125, o.indicators.lyapunov_error);
  EXPECT_EQ(o.ended, Ended::idle);
  EXPECT_GT(o.rest_from, 0);
}

} // namespace
} // namespace kov::flow::rest_test
