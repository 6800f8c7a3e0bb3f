// The error that each point of a section carries, against the same orbit in many digits: never less than the truth by
// more than a factor of ten, never more by a factor of a thousand while it says anything.

#include "flow/scene/point_errors.hpp"
#include "flow/scene/system_section.hpp"

#include "symbol/document.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace kov::flow::point_errors_test {
namespace {

SystemScene scene_of(const std::string& text) {
  return read_system_scenes(parse_document(text + "errors = true\n", "test.toml")).front();
}

struct Points {
  std::vector<std::array<double, 2>> at;
  std::vector<double> error;
  std::vector<std::array<float, 2>> size;
};

std::vector<Points> by_orbit(const SystemSection& s) {
  std::vector<Points> all(s.orbits.size());
  for (const DrawnPoint& p : s.points) {
    std::istringstream digits(p.digits);
    std::array<double, 2> at = p.at;
    if (double t = 0; !p.digits.empty()) digits >> t >> at[0] >> at[1];
    all[p.orbit].at.push_back(at);
    all[p.orbit].size.push_back(p.size);
    all[p.orbit].error.push_back(p.error);
  }
  return all;
}

double distance(const SystemScene& s, const std::array<double, 2>& a,
                const std::array<double, 2>& b, std::size_t i) {
  const double d = std::abs(a[i] - b[i]), turn = 2 * M_PI;
  return s.angle[i] ? std::min(d, std::abs(d - turn)) : d;
}

// The largest of each point and the four before.
std::vector<double> true_errors(const SystemScene& s, const Points& mine, const Points& truth) {
  std::vector<double> one, all;
  const std::size_t n = std::min(mine.at.size(), truth.at.size());
  for (std::size_t k = 0; k < n; ++k) {
    double most = 0;
    for (std::size_t i = 0; i < 2; ++i)
      most = std::max(most, distance(s, mine.at[k], truth.at[k], i) /
                                static_cast<double>(mine.size[k][i]));
    one.push_back(most);
    all.push_back(*std::max_element(one.end() - static_cast<long>(std::min<std::size_t>(5, k + 1)),
                                    one.end()));
  }
  return all;
}

// Runs in double and in `digits` digits.  least: errors below are the rounding of the numbers that are compared
void expect_honest(const std::string& text, int digits, double least = 1e-15) {
  SystemScene scene = scene_of(text), precise = scene;
  const auto mine = by_orbit(simulate(scene));
  precise.digits = digits;
  precise.errors = false;
  precise.indicator = Indicator::none;
  precise.tolerance = Quantity(("10^-" + std::to_string(digits - 4)).c_str());
  const auto truth = by_orbit(simulate(precise));
  ASSERT_EQ(mine.size(), truth.size());
  for (std::size_t orbit = 0; orbit < mine.size(); ++orbit) {
    const std::vector<double> error = true_errors(scene, mine[orbit], truth[orbit]);
    double low = 1e300, high = 0;
    for (std::size_t k = 0; k < error.size(); ++k) {
      const double told = mine[orbit].error[k];
      ASSERT_GE(told, 0) << orbit << " " << k;
      if (told < error_lost) low = std::min(low, told / std::max(error[k], least));
      EXPECT_TRUE(error[k] < error_lost || told >= error_lost / 10) << orbit << " " << k;
      if (told > least && told < 1e-3) high = std::max(high, told / std::max(error[k], least));
    }
    EXPECT_GE(low, 0.1) << "orbit " << orbit;
    EXPECT_LE(high, 1000) << "orbit " << orbit;
    EXPECT_GE(error.size(), 10U);
  }
}

std::string henon_heiles(const std::string& scene) {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "hamiltonian = '(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3'\n[scene]\n"
         "section = 'x'\nplot = ['y', 'v']\n" +
         scene;
}

TEST(PointErrors, RegularOrbits) {
  expect_honest(henon_heiles("levels = {H = '1/12'}\nseeds = [['1/10', '1/10'], ['1/5', 0], "
                             "['-1/7', '1/3']]\ncrossings = 300\n"),
                31);
}

TEST(PointErrors, ChaoticOrbits) {
  expect_honest(henon_heiles("levels = {H = '1/6'}\nseeds = [['1/10', '1/10'], ['-1/10', '1/5'], "
                             "['3/10', '-1/10']]\ncrossings = 120\nindicator = 'megno'\n"),
                60);
}

TEST(PointErrors, TruncationAsMuchAsRounding) {
  for (const char* tolerance : {"10^-6", "10^-9", "10^-12"})
    expect_honest(henon_heiles("levels = {H = '1/8'}\nseeds = [['1/10', '1/10'], ['-1/10', "
                               "'1/5']]\ncrossings = 60\ndrift = '1'\ntolerance = '" +
                               std::string(tolerance) + "'\n"),
                  40);
}

// From 10^-13 beside the saddle, and so exactly on the separatrix that rounding decides.
TEST(PointErrors, ASeparatrix) {
  expect_honest("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
                "hamiltonian = '(u^2 + v^2)/2 - x^2/2 + x^4/4 + 9*y^2/2'\n[scene]\nsection = 'y'\n"
                "plot = ['x', 'u']\nstates = [['10^-13', 0, '10^-13', 1], ['10^-13', 0, "
                "'-10^-13+10^-20', 1], ['10^-9', 0, 0, 1], ['sqrt(2)-10^-13', 0, 0, 1]]\n"
                "crossings = 80\ntolerance = '10^-16'\n",
                50);
}

std::string kepler(const std::string& e) {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "hamiltonian = '(u^2 + v^2)/2 - 1/r'\nrelations = ['r^2 = x^2 + y^2']\n"
         "[[system.function]]\nname = 'r'\nmeans = 'sqrt(x^2 + y^2)'\n"
         "derivative = {x = 'x/r', y = 'y/r'}\n[scene]\nplot = ['x', 'v']\ndrift = 1\n"
         "section = 'u'\ndirection = 'both'\nstates = [['2 - " +
         e + "', 0, 0, 'sqrt(" + e + "/(2 - " + e + "))']]\ntime = 70\ntolerance = '10^-16'\n";
}

// The pericentre is at x = -e: what is wrong by 10^-16 of the orbit is wrong by more there.
TEST(PointErrors, KeplerOrbits) {
  expect_honest(kepler("1/10"), 31);
  expect_honest(kepler("1/10^3"), 40);
  expect_honest(kepler("1/10^5"), 50);
}

// The section is nearly touched: what rounding makes of it moves the time of the crossing, in both runs alike.
TEST(PointErrors, BesideATangency) {
  const std::string oscillators =
      "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'u', 'v']\n[system.field]\n"
      "x = 'u'\ny = 'v'\nu = '-x'\nv = '-2*y'\n[scene]\ndirection = 'both'\nplot = ['u', 'y']\n"
      "tolerance = '10^-16'\ncrossings = 16\n";
  for (const char* y : {"1/10000", "1/3000", "1/777"})
    expect_honest(oscillators + "section = 'x + y/1000 - 1'\nstates = [[1, '" + y + "', 0, '" + y +
                      "']]\n",
                  40, 4e-16);
  expect_honest(oscillators + "section = 'sqrt(1 + x^2 + y^2) - 5/4'\nstates = [['3/4', '1/1000', "
                              "'1/10', 0]]\n",
                40, 4e-16);
}

// An orbit beside another that is 10^12 times as large is measured with its own size.
TEST(PointErrors, ATinyOrbitBesideAHugeOne) {
  expect_honest(henon_heiles("states = [[0, '10^-13', '10^-13', 0], [0, '1/10', '1/5', 0], [0, "
                             "'10^-19', '3*10^-19', '10^-19']]\ncrossings = 60\n"),
                60, 4e-16);
}

// No integral says anything of them.
TEST(PointErrors, DissipativeSystems) {
  expect_honest("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', 'z']\n[system.field]\n"
                "x = '10*(y - x)'\ny = 'x*(28 - z) - y'\nz = 'x*y - 8/3*z'\n[scene]\n"
                "section = 'z - 27'\nplot = ['x', 'y']\nstates = [[1, 2, 20], ['1/3', -5, 25]]\n"
                "crossings = 60\n",
                60);
  expect_honest("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'v']\n[system.field]\n"
                "x = 'v'\nv = '(1 - x^2)*v/3 - x'\n[scene]\nsection = 'x'\nplot = ['x + v', 'v']\n"
                "states = [['1/7', 3], [0, '1/10']]\ncrossings = 100\n",
                31);
}

// The constants of the field are rounded as well: 1/10 is none of the machine's numbers.
TEST(PointErrors, ConstantsAreRoundedToo) {
  expect_honest("[system]\nkind = 'hamiltonian'\nparameters = ['k']\ncoordinates = ['x', 'y']\n"
                "momenta = ['u', 'v']\nhamiltonian = '(u^2 + v^2)/2 + x^2/10 + k*y^2/3 + "
                "x^2*y^2/7'\n[scene]\nset = {k = 'sqrt(2)'}\nsection = 'x'\nplot = ['y', 'v']\n"
                "states = [[0, '1/2', '1/4', '1/8'], ['1/10', '1/3', 0, '1/5']]\ncrossings = 300\n",
                31);
}

TEST(PointErrors, AnAngleIsCountedModuloATurn) {
  expect_honest("[system]\nkind = 'hamiltonian'\ncoordinates = ['q', 'y']\nmomenta = ['p', 'v']\n"
                "hamiltonian = 'p^2/2 - c + (v^2 + 2*y^2)/2 + y^2*c/10'\n"
                "relations = ['s^2 + c^2 = 1']\n[[system.function]]\nname = 's'\nmeans = 'sin(q)'\n"
                "derivative = {q = 'c'}\n[[system.function]]\nname = 'c'\nmeans = 'cos(q)'\n"
                "derivative = {q = '-s'}\n[scene]\nsection = 'y'\nplot = ['q', 'p']\n"
                "angles = ['q']\nstates = [[0, 0, 100, 1], [0, 0, 3, 1]]\ncrossings = 300\n",
                31, 1e-14);
}

// ---- what is said of all ----

TEST(PointErrors, TheSectionSaysHowManyReturnsAreRight) {
  const SystemSection chaos = simulate(scene_of(
      henon_heiles("levels = {H = '1/6'}\nseeds = [['1/10', '1/10']]\ncrossings = 400\n")));
  const PointAccuracy a = accuracy_of(chaos);
  EXPECT_TRUE(a.known);
  EXPECT_EQ(a.bound, 1e-6);
  EXPECT_EQ(a.whole, 0U);
  EXPECT_GT(a.returns, 10U);
  EXPECT_LT(a.returns, 100U);
  EXPECT_GT(a.doubtful, 250U);
  for (std::size_t i = 0; i < a.returns; ++i)
    EXPECT_LE(chaos.points[i].error, 1e-6);
  const PointAccuracy regular = accuracy_of(simulate(scene_of(
      henon_heiles("levels = {H = '1/12'}\nseeds = [['1/10', '1/10']]\ncrossings = 100\n"))));
  EXPECT_EQ(regular.whole, 1U);
  EXPECT_EQ(regular.doubtful, 0U);
  EXPECT_LT(regular.bound, 1e-11);
  EXPECT_GT(regular.bound, 0);
}

TEST(PointErrors, NobodyAskedNobodyComputes) {
  SystemScene scene = scene_of(henon_heiles("states = [[0, '1/10', '2/5', 0]]\ncrossings = 10\n"));
  scene.errors = false;
  const SystemSection s = simulate(scene);
  EXPECT_FALSE(accuracy_of(s).known);
  for (const DrawnPoint& p : s.points)
    EXPECT_EQ(p.error, -1);
}

TEST(PointErrors, ThePointsAreThoseOfTheFirstRun) {
  SystemScene scene = scene_of(henon_heiles("states = [[0, '1/10', '2/5', 0]]\ncrossings = 200\n"));
  const SystemSection with = simulate(scene);
  scene.errors = false;
  const SystemSection without = simulate(scene);
  ASSERT_EQ(with.points.size(), without.points.size());
  for (std::size_t i = 0; i < with.points.size(); ++i)
    EXPECT_EQ(with.points[i].at, without.points[i].at);
}

// ---- crossings of two runs ----

using Raw = std::vector<RawPoint<double>>;

Raw circle(double error, int n) {
  Raw all;
  for (int k = 0; k < n; ++k)
    all.push_back({k + error, {std::cos(k) + error, std::sin(k)}});
  return all;
}

TEST(PointErrors, ALostCrossingIsPassed) {
  Raw second = circle(1e-12, 50);
  second.erase(second.begin() + 20);
  const auto d = compared(circle(0, 50), second, {false, false});
  for (std::size_t k = 0; k < 50; ++k)
    EXPECT_NEAR(d[k].at[0], k == 20 ? d[k].at[0] : 1e-12, 1e-15) << k;
  EXPECT_GT(d[20].at[0], 0.1);
}

TEST(PointErrors, TimesMayLagBehindByMoreThanAReturn) { // as on both sides of a separatrix
  Raw second = circle(0, 50);
  for (std::size_t k = 20; k < 50; ++k)
    second[k].t += 3.2;
  const auto d = compared(circle(0, 50), second, {false, false});
  for (std::size_t k = 0; k < 50; ++k)
    EXPECT_EQ(d[k].at[0], 0) << k;
}

TEST(PointErrors, ARunThatEndsEarlyLeavesTheRestUnknown) {
  const auto e = errors_of(compared(circle(0, 50), circle(1e-12, 20), {false, false}), 1e-16);
  EXPECT_LT(e[19], 1e-11);
  for (std::size_t k = 21; k < 50; ++k)
    EXPECT_GE(e[k], error_lost) << k;
}

} // namespace
} // namespace kov::flow::point_errors_test
