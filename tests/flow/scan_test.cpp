// Scans: each cell is what its own scene says, whoever computes it.

#include "flow/scene/scan.hpp"
#include "flow/scene/system_section.hpp"

#include "symbol/document.hpp"
#include "symbol/input_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kov::flow::scan_test {
namespace {

SystemScene scan_scene(const std::string& scene) {
  return read_system_scenes(
             parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\n"
                            "momenta = ['u', 'v']\nparameters = ['b']\n"
                            "hamiltonian = '(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - b/3*y^3'\n"
                            "[scene]\nsection = 'x'\nplot = ['y', 'v']\ntolerance = '10^-12'\n" +
                                scene,
                            "test.toml"))
      .front();
}

std::string refused(const std::string& scene) {
  try {
    static_cast<void>(scan_scene(scene));
  } catch (const InputError& e) {
    return e.message();
  }
  return "accepted";
}

const std::string plane =
    "set = {b = 1}\nlevels = {H = '1/8'}\ncrossings = 20\n"
    "scan = {of = 'OF', over = {y = ['-1/2', '7/10', 12], v = ['-1/2', '1/2', 9]}}\n";

std::string of(const std::string& value, std::string text = plane) {
  return text.replace(text.find("OF"), 2, value);
}

// What the points of the cell's own scene say.
double time_of_the_last(const std::string& scene) {
  const SystemSection s = simulate(scan_scene(scene));
  return s.orbits[0].time;
}

TEST(Scan, EveryCellIsItsOwnScene) {
  const SystemScene scene = scan_scene(of("time"));
  const ScanResult r = simulate_scan(scene, {});
  ASSERT_EQ(r.values.size(), 108U);
  EXPECT_EQ(r.early, 0U);
  EXPECT_GT(r.empty, 10U); // outside of the level
  EXPECT_EQ(r.crossings, 20.0 * static_cast<double>(r.orbits));
  EXPECT_LE(r.drift, 1e-10);
  std::size_t compared = 0;
  for (const auto& [i, k] : {std::pair{3U, 4U}, {6U, 4U}, {8U, 3U}, {0U, 0U}, {5U, 6U}}) {
    const double value = r.values[i + 12 * k];
    const std::string seed = "'-1/2 + 6/5*(" + std::to_string(2 * i + 1) + ")/24', '-1/2 + (" +
                             std::to_string(2 * k + 1) + ")/18'";
    const std::string one =
        "set = {b = 1}\nlevels = {H = '1/8'}\ncrossings = 20\nseeds = [[" + seed + "]]\n";
    if (std::isnan(value)) {
      EXPECT_THROW(static_cast<void>(simulate(scan_scene(one))), InputError);
      continue;
    }
    EXPECT_NEAR(value, time_of_the_last(one), 3)
        << i << " " << k; // ends with a step, not a crossing
    ++compared;
  }
  EXPECT_GE(compared, 3U);
}

TEST(Scan, MegnoTellsIslandsFromTheSea) {
  const std::string text = "set = {b = 1}\nlevels = {H = '1/8'}\ncrossings = 150\nscan = {of = "
                           "'megno', over = {y = ['-1/10', '4/10', 3], v = ['-1/8', '1/8', 3]}}\n";
  const ScanResult r = simulate_scan(scan_scene(text), {});
  EXPECT_LT(r.values[2 + 3 * 1], 2.5); // (0.317, 0): the middle of an island
  std::size_t chaotic = 0;
  for (const double x : r.values)
    chaotic += x > 4 ? 1 : 0;
  EXPECT_GE(chaotic, 1U);
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i] && !(std::isnan(a[i]) && std::isnan(b[i]))) return false;
  return a.size() == b.size();
}

TEST(Scan, ThreadsLanesAndAKillChangeNothing) {
  std::string text = of("megno");
  text.replace(text.find(", 12]"), 5, ", 100]");
  text.replace(text.find(", 9]"), 4, ", 90]"); // three blocks
  text.replace(text.find("= 20"), 4, "= 3");
  const SystemScene scene = scan_scene(text);
  std::map<std::size_t, ScanBlock> blocks;
  ScanOptions options;
  options.finished = [&](std::size_t number, const ScanBlock& b) { blocks[number] = b; };
  const ScanResult whole = simulate_scan(scene, options);
  EXPECT_EQ(blocks.size(), 3U);
  ScanOptions other;
  other.threads = 2;
  other.lanes = 4;
  EXPECT_TRUE(same(simulate_scan(scene, other).values, whole.values));
  ScanOptions resumed;
  resumed.kept = {{1, blocks[1]}};
  long computed = 0;
  resumed.finished = [&](std::size_t, const ScanBlock&) { ++computed; };
  const ScanResult rest = simulate_scan(scene, resumed);
  EXPECT_TRUE(same(rest.values, whole.values));
  EXPECT_EQ(computed, 2);
  EXPECT_EQ(rest.crossings, whole.crossings);
  std::atomic<bool> stop{true};
  ScanOptions stopped;
  stopped.stop = &stop;
  EXPECT_TRUE(simulate_scan(scene, stopped).stopped);
}

// Eight lanes with eight values of b, against eight scenes: starts on the level depend on b as well.
TEST(Scan, LanesCarryDifferentParameters) {
  const std::string base = "levels = {H = '1/8'}\ntime = 40\nseeds = [['1/5', '1/10']]\n";
  const ScanResult r =
      simulate_scan(scan_scene(base + "scan = {of = 'crossings', over = {b = [-4, 4, 16]}}\n"), {});
  const ScanResult megno =
      simulate_scan(scan_scene(base + "scan = {of = 'megno', over = {b = [-4, 4, 16]}}\n"), {});
  ASSERT_EQ(r.values.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) {
    const std::string b = std::to_string(static_cast<int>(2 * i + 1) - 16) + "/4";
    const SystemSection one = simulate(
        scan_scene(base + "set = {b = '" + b + "'}\nindicator = 'megno'\nerrors = false\n"));
    EXPECT_EQ(r.values[i], static_cast<double>(one.points.size())) << b;
    const bool early =
        one.orbits[0].ended == Ended::singular || one.orbits[0].ended == Ended::broken;
    EXPECT_EQ(std::isinf(megno.values[i]), early) << b;
    if (!early) { // the tangent vector is measured with the scales of all orbits
      EXPECT_NEAR(megno.values[i], one.orbits[0].indicators.megno, 0.3) << b;
    }
  }
}

// A collision, the section's rounding and the sizes of terms are those of the cell, not of the file.
TEST(Scan, EveryQuestionIsAskedWithTheCellsNumbers) {
  const std::string system =
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "parameters = ['b']\nhamiltonian = '(u^2 + v^2)/2 - 1/sqrt(x^2 + b*y^2)'\n[scene]\n"
      "section = 'y'\nplot = ['x', 'u']\ncrossings = 10\ntolerance = '10^-9'\ndrift = '10^-3'\n";
  const auto scene = [&](const std::string& text) {
    return read_system_scenes(parse_document(system + text, "test.toml")).front();
  };
  const ScanResult r = simulate_scan(
      scene("states = [[1, 0, 0, '1/2']]\nscan = {of = 'megno', over = {b = ['-1/8', '1/4', 4], "
            "v = [-1, 1, 20]}}\n"),
      {});
  EXPECT_LE(r.drift, 1e-3);
  std::size_t early = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 20; ++k) {
      const std::string v = std::to_string(static_cast<int>(2 * k) - 19) + "/20";
      const SystemSection one = simulate(
          scene("set = {b = '" + std::to_string(static_cast<int>(6 * i) - 5) +
                "/64'}\nstates = [[1, 0, 0, '" + v + "']]\nindicator = 'megno'\nerrors = false\n"));
      const bool ends =
          one.orbits[0].ended == Ended::singular || one.orbits[0].ended == Ended::broken;
      EXPECT_EQ(std::isinf(r.values[i + 4 * k]), ends) << i << " " << v;
      early += ends ? 1 : 0;
    }
  }
  EXPECT_GT(early, 0U);
}

TEST(Scan, CoordinatesOfAState) {
  const std::string base = "set = {b = 1}\ncrossings = 5\n";
  const ScanResult r = simulate_scan(
      scan_scene(base +
                 "states = [[0, '1/10', '1/3', 0]]\n"
                 "scan = {of = 'time', over = {u = ['1/10', '4/10', 6], v = [0, '1/10', 2]}}\n"),
      {});
  ASSERT_EQ(r.values.size(), 12U);
  EXPECT_EQ(r.orbits, 12U);
  EXPECT_NEAR(r.values[3], time_of_the_last(base + "states = [[0, '1/10', '11/40', '1/40']]\n"), 3);
}

// Where H lets the orbit escape its steps end in infinity: no number, and counted.
TEST(Scan, WhatEndsEarlyIsCounted) {
  const ScanResult r = simulate_scan(
      scan_scene("set = {b = 1}\ntime = 200\nstates = [[0, 0, 0, 0]]\nscan = {of = 'megno', over = "
                 "{v = ['1/10', 2, 8]}}\n"),
      {});
  EXPECT_GE(r.early, 3U);
  EXPECT_GE(r.orbits, 1U);
  EXPECT_EQ(r.early + r.orbits, 8U);
}

TEST(Scan, BadScansSayWhatIsWrong) {
  const std::string end = "set = {b = 1}\nlevels = {H = '1/8'}\ncrossings = 5\n";
  const auto over = [&](const std::string& axes, const std::string& more = {}) {
    return refused(end + more + "scan = {of = 'megno', over = {" + axes + "}}\n");
  };
  EXPECT_EQ(over("y = [0, 1, 5], v = [0, 1, 5]"), "accepted");
  EXPECT_EQ(over("y = [0, 1, 5], v = [1, 0, 5]"),
            "an axis goes from the smaller number to the larger");
  EXPECT_EQ(over("y = [0, 1], v = [1, 0, 5]"), "an axis is [from, to, how many cells]");
  EXPECT_EQ(over(""), "a scan has one axis or two");
  EXPECT_EQ(over("y = [0, 1, 5], v = [0, 1, 5], x = [0, 1, 5]"), "a scan has one axis or two");
  EXPECT_EQ(over("y = [0, 1, 5], u = [0, 1, 5]"), "'u' cannot be scanned here");
  EXPECT_EQ(over("y = [0, 1, 5], z = [0, 1, 5]"), "'z' cannot be scanned here");
  EXPECT_EQ(over("b = [0, 1, 5]", "seeds = [[0, 0]]\n"), "'b' is set, and scanned");
  EXPECT_EQ(over("y = [0, 1, 5]"), "a scan needs a start for what it does not vary");
  EXPECT_EQ(over("y = [0, 1, 5]", "seeds = [[0, 0], [1, 1]]\n"),
            "a scan has one start that it varies: one seed, or one state");
  EXPECT_EQ(over("y = [0, 1, 5], v = [0, 1, 5]", "digits = 40\n"),
            "a scan is computed in double precision");
  EXPECT_EQ(over("y = [0, 1, 5], v = [0, 1, 5]", "indicator = 'megno'\n"),
            "a scan has no 'indicator'");
  EXPECT_EQ(over("y = [0, 1, 100000], v = [0, 1, 100000]"), "a scan has up to 100000000 cells");
  EXPECT_NE(refused(end + "scan = {of = 'gali', over = {y = [0, 1, 5], v = [0, 1, 5]}}\n"),
            "accepted");
  EXPECT_NE(refused(end + "scan = {over = {y = [0, 1, 5], v = [0, 1, 5]}}\n"), "accepted");
  EXPECT_NE(refused(end + "scan = {of = 'time'}\n"), "accepted");
  EXPECT_NE(refused(end + "scan = 3\n"), "accepted");
}

} // namespace
} // namespace kov::flow::scan_test
