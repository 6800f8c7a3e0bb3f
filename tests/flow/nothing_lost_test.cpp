// What once was lost in silence: sections whose terms cancel, first crossings, touches, near collisions, escapes, whole
// turns, digits.

#include "flow/scene/system_section.hpp"

#include "symbol/document.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kov::flow::nothing_lost_test {
namespace {

SystemScene scene_from(const std::string& text) {
  return read_system_scenes(parse_document(text, "test.toml")).front();
}
SystemSection drawn(const std::string& text) { return simulate(scene_from(text)); }

std::string oscillator(const std::string& scene, const std::string& direction = "both") {
  return "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'u']\n[system.field]\nx = 'u'\nu = "
         "'-x'\n"
         "[scene]\nplot = ['x', 'u']\ndirection = '" +
         direction + "'\n" + scene;
}

// Chebyshev's polynomial, multiplied out: T_n(cos a) = cos(n a).
std::string chebyshev(int n) {
  std::vector<Integer> a{Integer(1)}, b{Integer(0), Integer(1)};
  for (int k = 1; k < n; ++k) {
    std::vector<Integer> c(b.size() + 1);
    for (std::size_t i = 0; i < b.size(); ++i)
      c[i + 1] = Integer(2) * b[i];
    for (std::size_t i = 0; i < a.size(); ++i)
      c[i] = c[i] - a[i];
    a = std::move(b);
    b = std::move(c);
  }
  std::string text = "0";
  for (std::size_t i = 0; i < b.size(); ++i)
    if (!(b[i] == Integer(0))) text += " + (" + to_string(b[i]) + ")*x^" + std::to_string(i);
  return text;
}

TEST(NothingLost, SectionsWhoseTermsCancel) {
  for (const int n : {12, 24, 40, 41, 60}) {
    const SystemSection s = drawn(oscillator("section = '" + chebyshev(n) +
                                             "'\nstates = [['3/5', '4/5'], ['-4/5', '3/5']]\n"
                                             "time = 100\n"));
    for (std::size_t orbit = 0; orbit < 2; ++orbit) {
      const double phase = orbit == 0 ? std::atan2(-0.8, 0.6) : std::atan2(-0.6, -0.8);
      const auto before = [&](double t) { return std::floor(n * (t + phase) / M_PI - 0.5); };
      EXPECT_EQ(static_cast<double>(s.orbits[orbit].crossings), before(100) - before(0)) << n;
      EXPECT_EQ(s.orbits[orbit].hidden, 0) << n;
    }
    for (const DrawnPoint& p : s.points)
      EXPECT_NEAR(std::cos(n * std::acos(std::min(1.0, std::max(-1.0, p.at[0])))), 0, 1e-4) << n;
  }
}

TEST(NothingLost, WhatNoDigitsShowIsSaid) {
  const SystemSection s = drawn(oscillator("section = '" + chebyshev(40) +
                                           "'\nstates = [['3/5', '4/5']]\ntime = 100\ndigits = 18\n"
                                           "tolerance = '10^-15'\n"));
  EXPECT_TRUE(s.orbits[0].crossings == 1273 || s.orbits[0].hidden > 0);
  const SystemSection far = drawn(
      oscillator("section = '" + chebyshev(200) + "'\nstates = [['3/5', '4/5']]\ntime = 5\n"));
  EXPECT_TRUE(far.orbits[0].hidden > 0 || far.orbits[0].inside_from >= 0);
}

TEST(NothingLost, AFirstCrossingSoonAfterTheStart) {
  for (const char* before : {"10^-9", "10^-11", "10^-13", "10^-14"})
    for (const char* section : {"x", "x + x^3", "x*(2 - u)", "-3*x"}) {
      const SystemSection s =
          drawn(oscillator("section = '" + std::string(section) + "'\nstates = [['-" + before +
                           "', 1], ['" + before + "', 1], [0, 1]]\ntime = 10\n"));
      const double first = Quantity(before).as<double>();
      ASSERT_EQ(s.orbits[0].crossings, 4) << before << section; // at once, then pi, 2 pi, 3 pi
      EXPECT_NEAR(s.points[0].t / first, 1, 0.05) << before << section;
      EXPECT_EQ(s.orbits[1].crossings, 3) << before << section;
      EXPECT_EQ(s.orbits[2].crossings, 3) << before << section;
    }
}

TEST(NothingLost, ATouchIsNoCrossing) {
  const std::string states =
      "'\nstates = [['3/5', '4/5'], ['-3/5', '4/5'], ['5/13', '-12/13'], [0, 1]]\n";
  for (const char* section : {"x - 1", "u + 1", "1 - x^2", "(x - 1)*(x^2 + 1)", "u/2 - 1/2"})
    for (const char* direction : {"both", "upward", "downward"}) {
      const SystemSection s = drawn(
          oscillator("section = '" + std::string(section) + states + "time = 1000\n", direction));
      EXPECT_EQ(s.points.size(), 0U) << section;
      int touched = 0;
      for (const DrawnOrbit& o : s.orbits)
        touched += o.tangencies;
      EXPECT_GE(touched, 100) << section << direction;
    }
  // a little further in it is crossed twice
  EXPECT_EQ(drawn(oscillator("section = 'x - 1 + 10^-12" + states + "time = 1000\n")).points.size(),
            4U * 2 * 159 + 2);
}

// ---- near collisions ----

std::string kepler(const std::string& scene) {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "hamiltonian = '(u^2 + v^2)/2 - 1/r'\nrelations = ['r^2 = x^2 + "
         "y^2']\n[[system.function]]\nname = 'r'\n"
         "means = 'sqrt(x^2 + y^2)'\nderivative = {x = 'x/r', y = 'y/r'}\n[scene]\nplot = ['r', "
         "'u']\n"
         "drift = 1\ntolerance = '10^-16'\n" +
         scene;
}

// Semi-axis 1 from the apocentre 1 + e: apsides at the multiples of pi.
TEST(NothingLost, NearCollisionsAreNone) {
  for (int k = 1; k <= 11; ++k) {
    const std::string e = "10^-" + std::to_string(k), v = "sqrt(" + e + "/(2 - " + e + "))";
    const std::string x = "2 - " + e;
    for (const std::string& state :
         {"['" + x + "', 0, 0, '" + v + "']", "[0, '" + x + "', '-" + v + "', 0]",
          "['3/5*(" + x + ")', '4/5*(" + x + ")', '-4/5*" + v + "', '3/5*" + v + "']"}) {
      const SystemSection s = drawn(kepler("section = 'x*u + y*v'\ndirection = 'both'\nstates = [" +
                                           state + "]\ntime = 70\n"));
      EXPECT_EQ(s.orbits[0].ended, Ended::time) << state;
      ASSERT_EQ(s.points.size(), 22U) << state;
      const double small = std::pow(10.0, -k), lost = std::max(1e-13, 1e-15 / small);
      EXPECT_NEAR(s.points[0].t, M_PI, std::max(1e-13, small * 1e-2)) << state;
      EXPECT_NEAR(s.points[0].at[0] / small, 1, 100 * lost) << state;
      EXPECT_NEAR(s.points[1].t / (2 * M_PI), 1, 100 * lost) << state;
      // the drift tells what was lost
      EXPECT_GE(s.drift, std::abs(s.points[1].t / (2 * M_PI) - 1) / 50) << state;
    }
  }
}

TEST(NothingLost, ACollisionHasItsTime) {
  for (const char* state :
       {"[1, 0, 0, 0]", "['3/5', '4/5', 0, 0]", "['-5/13', '12/13', 0, 0]", "[0, -1, 0, 0]"}) {
    const SystemSection s =
        drawn(kepler("section = 'u - 10^6'\nstates = [" + std::string(state) + "]\ntime = 9\n"));
    EXPECT_EQ(s.orbits[0].ended, Ended::singular) << state;
    EXPECT_NEAR(s.orbits[0].time, M_PI / std::sqrt(8.0), 1e-12) << state;
  }
}

TEST(NothingLost, TheDriftIsRelativeToWhatIsThere) {
  const SystemSection s =
      drawn(kepler("section = 'u'\ndirection = 'both'\ntime = 70\n"
                   "states = [['2 - 10^-4', 0, 0, 'sqrt(10^-4/(2-10^-4))']]\n"));
  ASSERT_EQ(s.points.size(), 22U);
  EXPECT_GE(s.drift, std::abs(s.points[21].t / (22 * M_PI) - 1) / 10);
}

// ---- escapes, angles, digits ----

TEST(NothingLost, AnEscapeIsNoSingularity) {
  for (const char* force : {"0", "1/(1 + x^2)", "x/(1 + x^2)^2"}) {
    const SystemSection s =
        drawn("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'u']\n[system.field]\nx = "
              "'u'\nu = '" +
              std::string(force) +
              "'\n[scene]\nplot = ['x', 'u']\nsection = 'x'\nstates = [['-1', 1], [1, 1], [2, 3]]\n"
              "crossings = 40\n");
    for (const DrawnOrbit& o : s.orbits)
      EXPECT_EQ(o.ended, Ended::escaped) << force;
  }
  EXPECT_EQ(
      drawn(kepler("section = 'y'\nstates = [[1, 0, 0, 2]]\ncrossings = 40\n")).orbits[0].ended,
      Ended::escaped);
  EXPECT_EQ(drawn(kepler("section = 'y'\nstates = [[1, 0, 0, 2]]\ntime = 1000\n")).orbits[0].ended,
            Ended::time);
  const SystemSection blown =
      drawn("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'u']\n[system.field]\n"
            "x = 'x^2'\nu = '-u'\n[scene]\nplot = ['x', 'u']\nsection = 'x - 2'\n"
            "states = [[1, 1]]\ncrossings = 9\n");
  EXPECT_EQ(blown.orbits[0].ended, Ended::singular);
  EXPECT_NEAR(blown.orbits[0].time, 1, 1e-12);
}

std::string rotor(const std::string& scene, const std::string& angles = "['q']") {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['q', 'y']\nmomenta = ['p', 'v']\n"
         "hamiltonian = 'p^2/2 - c + (v^2 + 2*y^2)/2 + y^2*c/10'\nrelations = ['s^2 + c^2 = 1']\n"
         "[[system.function]]\nname = 's'\nmeans = 'sin(q)'\nderivative = { q = 'c' }\n"
         "[[system.function]]\nname = 'c'\nmeans = 'cos(q)'\nderivative = { q = '-s' }\n"
         "[scene]\nsection = 'y'\nplot = ['q', 'p']\nangles = " +
         angles + "\n" + scene;
}

TEST(NothingLost, WholeTurnsCostNoDigits) {
  const std::string orbit = "states = [[0, 0, 100, 1], ['10^6', 0, 50, 1]]\ncrossings = 200\n";
  const SystemSection quick = drawn(rotor(orbit + "tolerance = '10^-16'\n")),
                      fine = drawn(rotor(orbit + "digits = 31\ntolerance = '10^-28'\n"));
  ASSERT_EQ(quick.points.size(), 400U);
  for (std::size_t i = 0; i < quick.points.size(); ++i) {
    EXPECT_NEAR(std::remainder(quick.points[i].at[0] - fine.points[i].at[0], 2 * M_PI), 0,
                3e-13 * static_cast<double>(i % 200 + 4) +
                    (i < 200 ? 0 : 2e-10)) // the start 10^6 itself is exact
        << i;
    EXPECT_LE(digits_lost(quick.points[i], 0), 1);
  }
  EXPECT_LE(quick.drift, 1e-10);
  EXPECT_LE(fine.drift, 1e-25);
  // an angle that is asked for with its turns has them, and an angle that must keep them loses their digits
  EXPECT_GT(std::abs(drawn(rotor(orbit, "[]")).points[150].at[0]), 1000);
}

TEST(NothingLost, FunctionsAreCheckedInTheDigitsOfTheRun) {
  const std::string more = "states = [['1/2', 0, 1, 1]]\ncrossings = 5\n";
  for (const auto& [digits, tolerance, most] : {std::tuple{"18", "10^-17", 1e-15},
                                                {"31", "10^-28", 1e-25},
                                                {"40", "10^-36", 1e-33},
                                                {"70", "10^-66", 1e-60}})
    EXPECT_LE(
        drawn(rotor(more + "digits = " + digits + "\ntolerance = '" + tolerance + "'\n")).drift,
        most);
  for (const char* function : {"exp", "sinh", "atan", "sqrt", "log"}) {
    const std::string f = function, argument = f == "sqrt" || f == "log" ? "(2 + x)" : "x";
    const std::string slope = f == "exp"    ? "g"
                              : f == "atan" ? "1/(1 + x^2)"
                              : f == "sqrt" ? "1/(2*g)"
                              : f == "log"  ? "1/(2 + x)"
                                            : "k";
    std::string text =
        "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'u']\n[system.field]\nx = 'u'\n"
        "u = '-x + g/100'\n[[system.function]]\nname = 'g'\nmeans = '" +
        f + "(" + argument.substr(argument[0] == '(' ? 1 : 0, argument[0] == '(' ? 5 : 1) +
        ")'\nderivative = {x = '" + slope + "'}\n";
    if (f == "sinh")
      text += "[[system.function]]\nname = 'k'\nmeans = 'cosh(x)'\nderivative = {x = 'g'}\n";
    text += "[scene]\nsection = 'u'\nplot = ['x', 'g']\nstates = [['1/3', '1/2']]\ncrossings = "
            "4\ndigits = 40\n"
            "tolerance = '10^-36'\n";
    EXPECT_LE(drawn(text).drift, 1e-33) << f;
  }
}

} // namespace
} // namespace kov::flow::nothing_lost_test
