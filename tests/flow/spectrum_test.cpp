// All Lyapunov exponents, SALI and GALI, winding numbers: against what is known of them.

#include "flow/scene/system_section.hpp"

#include "symbol/document.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kov::flow::spectrum_test {
namespace {

SystemSection drawn(const std::string& text) {
  return simulate(read_system_scenes(parse_document(text, "test.toml")).front());
}

// x_1' = f_1, ...
std::string field_of(const std::vector<std::pair<std::string, std::string>>& f) {
  std::string names, equations;
  for (const auto& [x, rate] : f) {
    names += (names.empty() ? "'" : ", '") + x + "'";
    equations += x + " = '" + rate + "'\n";
  }
  return "[system]\nkind = 'vector-field'\ncoordinates = [" + names + "]\n[system.field]\n" +
         equations + "[scene]\nplot = ['" + f[0].first + "', '" + f[1].first +
         "']\ndirection = 'both'\n";
}

std::string two_oscillators(const std::string& potential, const std::string& scene) {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "hamiltonian = '(u^2 + v^2)/2 + " +
         potential + "'\n[scene]\nsection = 'y'\nplot = ['x', 'u']\n" + scene;
}
const std::string henon_heiles = "(x^2 + y^2)/2 + y^2*x - x^3/3";

double sum_of(const Spectrum& s) {
  double sum = 0;
  for (const auto& e : s.exponents)
    sum += e.rate;
  return sum;
}

// x' = A x: real parts of the eigenvalues, but for what the beginning adds, which falls like 1/t.
TEST(Spectrum, OfLinearSystems) {
  const std::string end =
      "section = 'x - 10^30'\nstates = [['1/3', '1/5', '1/7']]\ntime = 200\nexponents = 'all'\n";
  using Field = std::vector<std::pair<std::string, std::string>>;
  for (const auto& [field, wanted] : std::vector<std::pair<Field, std::vector<double>>>{
           {{{"x", "x/5"}, {"y", "-2*y"}, {"z", "-z/2"}}, {0.2, -0.5, -2}},
           {{{"x", "y"}, {"y", "-x"}, {"z", "-3*z"}}, {0, 0, -3}},
           {{{"x", "-x/10 + 2*y"}, {"y", "-2*x - y/10"}, {"z", "x - z/4"}}, {-0.1, -0.1, -0.25}},
           {{{"x", "x/4 + y"}, {"y", "y/4"}, {"z", "-z"}}, {0.25, 0.25, -1}}}) {
    const SystemSection s = drawn(field_of(field) + end);
    const Spectrum& one = s.orbits[0].spectrum;
    ASSERT_EQ(one.exponents.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(one.exponents[i].rate, wanted[i], 0.04) << field[0].second << " " << i;
      EXPECT_NEAR(one.exponents[i].rate, wanted[i], 2 * one.exponents[i].error)
          << field[0].second << " " << i;
    }
    EXPECT_NEAR(sum_of(one), wanted[0] + wanted[1] + wanted[2], 1e-10) << field[0].second;
  }
}

TEST(Spectrum, OfTheLorenzSystem) {
  const SystemSection s =
      drawn(field_of({{"x", "10*(y - x)"}, {"y", "28*x - y - x*z"}, {"z", "x*y - 8*z/3"}}) +
            "section = 'z - 27'\nstates = [['1', '2', '20']]\ntime = 600\n"
            "tolerance = '10^-12'\nexponents = 'all'\n");
  const auto& e = s.orbits[0].spectrum.exponents;
  ASSERT_EQ(e.size(), 3U);
  EXPECT_NEAR(e[0].rate, 0.9056, 0.03);
  EXPECT_NEAR(e[1].rate, 0, 0.01);
  EXPECT_NEAR(e[2].rate, -14.572, 0.04);
  EXPECT_NEAR(sum_of(s.orbits[0].spectrum), -41.0 / 3, 1e-8); // the divergence
  EXPECT_NEAR(e[0].rate, 0.9056, 2.5 * e[0].error);
  EXPECT_LE(e[0].error, 0.1);
}

TEST(Spectrum, OfHenonAndHeiles) {
  const SystemSection s = drawn(two_oscillators(
      henon_heiles,
      "levels = {H = '1/8'}\nseeds = [['-1/4', 0], ['3/10', 0], ['3/20', '1/5']]\ncrossings = 600\n"
      "indicator = 'megno'\nerrors = false\nexponents = 'all'\n"));
  bool chaotic = false, regular = false;
  for (const DrawnOrbit& o : s.orbits) {
    ASSERT_EQ(o.spectrum.exponents.size(), 4U);
    EXPECT_NEAR(sum_of(o.spectrum), 0, 1e-8);
    const auto& e = o.spectrum.exponents;
    EXPECT_NEAR(e[0].rate + e[3].rate, 0, 2 * (e[0].error + e[3].error));
    EXPECT_NEAR(e[1].rate, 0, 2 * e[1].error);
    if (o.indicators.megno > 5) {
      chaotic = true;
      EXPECT_NEAR(e[0].rate, o.indicators.lyapunov, 2 * (e[0].error + o.indicators.lyapunov_error));
      EXPECT_LE(o.spectrum.log_sali, -12);
      EXPECT_NEAR(o.spectrum.log_gali[0], -(e[0].rate - e[1].rate) * o.time / std::log(10.0),
                  0.2 * std::abs(o.spectrum.log_gali[0]) + 4);
    } else if (o.indicators.megno < 2.2) {
      regular = true;
      EXPECT_GE(o.spectrum.log_sali, -3);
      EXPECT_LE(o.spectrum.log_gali[2], o.spectrum.log_gali[0]);
    }
  }
  EXPECT_TRUE(chaotic && regular);
}

TEST(Spectrum, FewExponentsAreTheFirstOfAll) {
  const std::string scene = "levels = {H = '1/8'}\nseeds = [['-1/4', 0]]\ncrossings = 100\n";
  const Spectrum
      all = drawn(two_oscillators(henon_heiles, scene + "exponents = 'all'\n")).orbits[0].spectrum,
      two = drawn(two_oscillators(henon_heiles, scene + "indicator = 'sali'\n")).orbits[0].spectrum;
  ASSERT_EQ(two.exponents.size(), 2U);
  EXPECT_EQ(two.log_gali.size(), 1U);
  EXPECT_NEAR(two.exponents[0].rate, all.exponents[0].rate, 2 * all.exponents[0].error);
  EXPECT_EQ(drawn(two_oscillators(henon_heiles, scene)).orbits[0].spectrum.exponents.size(), 0U);
}

TEST(Spectrum, OrbitsThatEndEarlyHaveNone) {
  const SystemSection s = drawn(two_oscillators(
      henon_heiles,
      "states = [[0, 0, '1/5', '1/5'], [0, 0, 2, 2]]\ncrossings = 50\nexponents = 2\n"));
  EXPECT_EQ(s.orbits[0].spectrum.exponents.size(), 2U);
  EXPECT_TRUE(s.orbits[1].spectrum.exponents.empty());
}

// ---- winding numbers ----

// x'' = -a^2 x beside y'' = -b^2 y: a/b of a turn between two returns to y = 0, clockwise in (x, u).
TEST(Winding, OfHarmonicOscillators) {
  for (const auto& [square, ratio] : {std::pair{"2", std::sqrt(2.0)},
                                      {"1/3", std::sqrt(1 / 3.0)},
                                      {"7/10", std::sqrt(0.7)},
                                      {"50", std::sqrt(50.0)}}) {
    const SystemSection s =
        drawn(two_oscillators(std::string(square) + "*x^2/2 + y^2/2",
                              "states = [['1/2', 0, '1/5', 1], ['1/1000', 0, 0, 2]]\n"
                              "crossings = 2000\nwinding = true\n"));
    for (const DrawnOrbit& o : s.orbits) {
      EXPECT_GE(o.winding.error, 0);
      EXPECT_LE(o.winding.error, 1e-11) << square;
      EXPECT_NEAR(std::remainder(o.winding.turns + ratio, 1.0), 0, o.winding.error + 1e-13)
          << square;
    }
  }
}

// Kepler's problem with a/r^2 in polar coordinates: L/sqrt(L^2 + 2 a) turns from one pericentre to the next.
TEST(Winding, OfKeplerOrbits) {
  for (const auto& [a, value] :
       {std::pair{"0", 0.0}, {"1/10", 0.1}, {"-1/20", -0.05}, {"3", 3.0}}) {
    const SystemSection s =
        drawn("[system]\nkind = 'hamiltonian'\ncoordinates = ['r', 'f']\nmomenta = ['p', 'L']\n"
              "hamiltonian = 'p^2/2 + L^2/(2*r^2) - 1/r + (" +
              std::string(a) +
              ")/r^2'\n[scene]\nsection = 'p'\nplot = ['f', 'L']\nangles = ['f']\n"
              "states = [[9, 0, '-1/10', 1], [9, 3, '-1/10', '-3/2']]\ncrossings = 500\nwinding = "
              "true\n");
    for (std::size_t i = 0; i < 2; ++i) {
      const double L = i == 0 ? 1 : -1.5, wanted = L / std::sqrt(L * L + 2 * value);
      EXPECT_NEAR(s.orbits[i].winding.turns, wanted, s.orbits[i].winding.error + 1e-12) << a;
      EXPECT_GE(s.orbits[i].winding.error, 0);
      EXPECT_LE(s.orbits[i].winding.error, 1e-10) << a;
    }
  }
}

// The pendulum beside an oscillator: about its centre below the separatrix, with whole turns above it.
TEST(Winding, OfThePendulum) {
  const SystemSection s = drawn(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['q', 'y']\nmomenta = ['p', 'v']\n"
      "hamiltonian = 'p^2/2 - c + (v^2 + 3*y^2)/2'\n[[system.function]]\nname = 's'\nmeans = "
      "'sin(q)'\n"
      "derivative = { q = 'c' }\n[[system.function]]\nname = 'c'\nmeans = 'cos(q)'\n"
      "derivative = { q = '-s' }\n[scene]\nsection = 'y'\nplot = ['q', 'p']\nangles = ['q']\n"
      "states = [[0, 0, 1, 1], [0, 0, 3, 1], [0, 0, '-3', 1]]\ncrossings = 1000\nwinding = true\n");
  // K(k) by the arithmetic-geometric mean: periods 4 K(sin(a/2)), 2 K(1/k)/k of a turn
  const auto quarter = [](double k) {
    double a = 1, b = std::sqrt(1 - k * k);
    for (int i = 0; i < 40; ++i)
      std::tie(a, b) = std::pair((a + b) / 2, std::sqrt(a * b));
    return M_PI / (2 * a);
  };
  const double back = 2 * M_PI / std::sqrt(3.0);
  const double inner = back / (4 * quarter(0.5)), outer = back / (2 * quarter(2.0 / 3) * 2 / 3);
  EXPECT_NEAR(std::remainder(s.orbits[0].winding.turns + inner, 1.0), 0,
              s.orbits[0].winding.error + 1e-12);
  EXPECT_NEAR(s.orbits[1].winding.turns, outer, s.orbits[1].winding.error + 1e-12);
  EXPECT_NEAR(s.orbits[2].winding.turns, -outer, s.orbits[2].winding.error + 1e-12);
  for (const DrawnOrbit& o : s.orbits)
    EXPECT_LE(o.winding.error, 1e-6);
}

TEST(Winding, ChaosHasAWideBarAndNobodyAskedNobodyComputes) {
  const std::string scene = "levels = {H = '1/8'}\nseeds = [['-1/4', 0]]\ncrossings = 800\n";
  EXPECT_LT(drawn(two_oscillators(henon_heiles, scene)).orbits[0].winding.error, 0);
  const Winding w =
      drawn(two_oscillators(henon_heiles, scene + "winding = true\n")).orbits[0].winding;
  EXPECT_TRUE(w.error < 0 || w.error > 1e-4) << w.turns << " " << w.error;
}

TEST(Winding, WhatDoesNotGoRoundHasNone) {
  const std::array<bool, 2> plain{};
  std::vector<std::array<double, 2>> line, few;
  for (int i = 0; i < 100; ++i) {
    line.push_back({std::cos(i * 1.0), 2 * std::cos(i * 1.0)});
  }
  few.assign(line.begin(), line.begin() + 5);
  for (const auto& points : {line, few})
    EXPECT_LT(winding_of(points, plain).error, 0);
}

} // namespace
} // namespace kov::flow::spectrum_test
