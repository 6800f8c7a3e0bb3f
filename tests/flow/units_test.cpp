// The same scene in other units; and nothing is left out without a word.

#include "flow/chaos/periodic_orbit.hpp"
#include "support.hpp"

#include <gtest/gtest.h>

#include <ctime>
#include <random>

namespace kov::flow::units_test {
namespace {

using namespace test;

struct Powers { // of ten
  long mass, length, time, vertical;
};

Quantity times(const Quantity& q, long p) {
  return q * Quantity(("10^(" + std::to_string(p) + ")").c_str());
}

void scale(std::array<Quantity, 3>& v, long p) {
  for (Quantity& q : v)
    q = times(q, p);
}

Scene rescaled(Scene s, const Powers& p) {
  const long inertia = p.mass + 2 * p.length;
  for (auto& row : s.inertia)
    scale(row, inertia);
  scale(s.lever, p.length - p.vertical);
  scale(s.gyrostat, inertia - p.time);
  s.mass = times(s.mass, p.mass);
  s.gravity = times(s.gravity, p.length - 2 * p.time);
  s.energy = times(s.energy, inertia - 2 * p.time);
  s.length = times(s.length, 2 * p.vertical);
  s.casimir = times(s.casimir, inertia - p.time + p.vertical);
  if (s.time) s.time = times(*s.time, p.time);
  return s;
}

Scene gyrostat() {
  return parse_scene(
      "format = \"scene/1\"\n[body]\n"
      "inertia = [[1, \"1/10\", 0], [\"1/10\", \"4/5\", \"1/20\"], [0, \"1/20\", \"3/5\"]]\n"
      "gyrostat = [0, \"1/5\", -1]\ntip = \"fixed\"\nlever = [\"1/2\", 0, \"1/3\"]\n"
      "gravity = \"1/4\"\n[levels]\nH = \"3/4\"\nF2 = \"1/20\"\n"
      "[section]\ndirection = \"both\"\n[orbits]\ngrid = [5, 5]\ncrossings = 12\n",
      "gyrostat");
}

std::vector<Scene> scenes() {
  std::vector<Scene> all{gyrostat()};
  for (const char* name :
       {"asymmetric_sliding", "kovalevskaya_sliding", "hess_classical", "asymmetric_classical"}) {
    all.push_back(read_scene(scene_path(name)));
    all.back().columns = 4;
    all.back().rows = 3;
    all.back().crossings = 12;
  }
  return all;
}

// The same orbits, crossings and verdicts; and the same times but for the units.
void expect_same(const SystemSection& a, const SystemSection& b, const Powers& p) {
  ASSERT_EQ(a.orbits.size(), b.orbits.size());
  EXPECT_EQ(a.skipped, b.skipped);
  EXPECT_EQ(a.cut_short(), b.cut_short());
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_LE(b.drift, 1e-13);
  const double time = std::pow(10.0, p.time);
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const DrawnPoint &u = a.points[i], &v = b.points[i];
    EXPECT_EQ(u.orbit, v.orbit);
    EXPECT_LE(apart(u, v), 1e-6);
    EXPECT_NEAR(v.t / time / u.t, 1, 1e-6);
  }
}

TEST(Units, TheUnitsOfASceneDoNotMatter) {
  std::mt19937_64 random(15);
  const auto power = [&](long most) { return static_cast<long>(random() % (2 * most + 1)) - most; };
  for (const Scene& s : scenes()) {
    const SystemSection plain = simulate(system_of(s));
    EXPECT_GT(plain.points.size(), 0U);
    for (int i = 0; i < 6; ++i) {
      const Powers p{power(30), power(30), power(30), power(20)};
      SCOPED_TRACE(s.file + " 10^" + std::to_string(p.mass) + " " + std::to_string(p.length) + " " +
                   std::to_string(p.time) + " " + std::to_string(p.vertical));
      expect_same(plain, simulate(system_of(rescaled(s, p))), p);
    }
  }
}

TEST(Units, NorForFixedPoints) {
  PeriodicOptions o;
  o.columns = 16;
  o.rows = 10;
  const Scene s = read_scene(scene_path("asymmetric_classical"));
  const Powers p{-27, -10, -13, 3}; // a molecule
  const PeriodicOrbits a = periodic_orbits(system_of(s), o),
                       b = periodic_orbits(system_of(rescaled(s, p)), o);
  ASSERT_EQ(a.orbits.size(), b.orbits.size());
  EXPECT_EQ(a.cells->index_sum, b.cells->index_sum);
  for (std::size_t i = 0; i < a.orbits.size(); ++i) {
    EXPECT_NEAR(a.orbits[i].points[0].drawn[0], b.orbits[i].points[0].drawn[0], 1e-11);
    EXPECT_NEAR(a.orbits[i].trace, b.orbits[i].trace, 1e-9);
    EXPECT_NEAR(b.orbits[i].time / a.orbits[i].time * 1e13, 1, 1e-9);
    EXPECT_TRUE(b.orbits[i].proved) << to_string(b.orbits[i].why);
  }
}

TEST(Units, BeyondTheRangeOfDoublesAreRefused) {
  Scene s = read_scene(scene_path("asymmetric_classical"));
  s.energy = Quantity(std::string(6000, '7').c_str());
  EXPECT_THROW((void)simulate(system_of(s)), InputError);
  s = read_scene(scene_path("asymmetric_sliding"));
  s.lever[0] = "10^200";
  EXPECT_THROW((void)simulate(system_of(s)), InputError);
}

// Starts on every sheet of the level, not on the largest G alone.
TEST(Starts, AreOnEverySheet) {
  const SystemScene s = system_of(gyrostat());
  std::size_t sheets = 0, several = 0;
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 5; ++k) {
      const auto states =
          states_over(s, 2 * M_PI * (i + 0.3819660112501051) / 5, -1 + 2 * (k + 0.5) / 5);
      several += states.size() > 1 ? 1 : 0;
      sheets += states.size();
    }
  EXPECT_GT(several, 0U);
  EXPECT_EQ(simulate(s).orbits.size(), sheets);
}

// On a pole of the chart nothing ever crosses: the orbit ends, and the result says why.
TEST(Nothing, IsLeftOutInSilence) {
  Scene s = read_scene(scene_path("asymmetric_classical"));
  s.columns = s.rows = 0;
  s.crossings = 3;
  s.section.falling = s.section.rising = true;
  s.seeds = {{"0", "1"}, {"1", "0"}};
  const SystemSection r = simulate(system_of(s));
  EXPECT_EQ(r.orbits[0].ended, Ended::idle);
  EXPECT_EQ(r.orbits[0].inside_from, 0);
  EXPECT_EQ(r.points.size(), 3U);
  s.crossings = 1000000000;
  EXPECT_THROW((void)simulate(system_of(s)), InputError);
}

TEST(Nothing, IsSearchedAfterAStop) {
  const std::atomic<bool> stop{true};
  PeriodicOptions o;
  o.stop = &stop;
  const PeriodicOrbits f = periodic_orbits(body_scene("asymmetric_sliding"), o);
  EXPECT_TRUE(f.stopped);
  EXPECT_TRUE(f.orbits.empty());
}

// More digits of a number type are kept in the points.
TEST(Digits, ArePrintedAsFarAsTheyAreKnown) {
  SystemScene s = body_scene("asymmetric_sliding");
  EXPECT_EQ(digits_shown(s.tolerance, s.digits), 17);
  s.tolerance = "10^-8";
  EXPECT_EQ(digits_shown(s.tolerance, s.digits), 9);
  s.columns = s.rows = 1;
  s.crossings = 2;
  s.tolerance = "10^-38";
  s.digits = 40;
  const std::string coarse = simulate(s).points.at(1).digits;
  s.tolerance = "10^-48";
  s.digits = 50;
  const std::string fine = simulate(s).points.at(1).digits;
  const std::size_t second = coarse.find(' ') + 1, other = fine.find(' ') + 1;
  EXPECT_EQ(coarse.substr(second, 36), fine.substr(other, 36)); // l
}

// The default number of lanes is a good one (AVX2 once ran packs of eight in memory, 30 times slower).
TEST(Lanes, TheDefaultIsNotSlow) {
  SystemScene s = body_scene("lever_half");
  s.columns = s.rows = 3;
  s.crossings = 10;
  const auto seconds = [&](int lanes) { // the best of three: other work disturbs some of them
    SystemSectionOptions o;
    o.lanes = lanes;
    return std::min({simulate(s, o).seconds, simulate(s, o).seconds, simulate(s, o).seconds});
  };
  EXPECT_LE(seconds(0), 3 * std::min(seconds(1), seconds(4)) + 0.01);
}

} // namespace
} // namespace kov::flow::units_test
