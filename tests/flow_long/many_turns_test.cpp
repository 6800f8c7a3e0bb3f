// 10^6 periods: minutes of computing.  Built and run on request only:
//   tools/setup release test_flow_long && ctest --test-dir build/release -C slow -L slow

#include "flow/scene/system_section.hpp"
#include "flow/support.hpp"
#include "symbol/document.hpp"

#include <gtest/gtest.h>

namespace kov::flow {
namespace {

using namespace test;

// Every orbit crosses the section a million times.  On most orbits the drift is that of random rounding and grows like
// the root of the number of steps (7e-13 here for the sliding top).  On some orbits of the free top rounding repeats
// itself and the drift grows linearly, by 2e-16 for each turn.
void million_turns(const std::string& name, double bound) {
  SystemScene s = body_scene(name);
  s.columns = 2;
  s.rows = 4;
  s.crossings = 1000000;
  const SystemSection r = simulate(s);
  EXPECT_EQ(r.points.size(), 8'000'000U);
  EXPECT_LE(r.drift, bound);
  std::printf("%s: drift %.1e\n", name.c_str(), r.drift);
}

// A regular and a chaotic orbit.
TEST(ManyTurns, HenonHeiles) {
  const SystemSection s = simulate(read_system_scenes(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "hamiltonian = '(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3'\n[scene]\nsection = 'x'\n"
      "plot = ['y', 'v']\nstates = [[0, '1/10', '2/5', 0], [0, '-1/10', '12/25', '1/10']]\n"
      "crossings = 1000000\n",
      "test.toml"))[0]);
  EXPECT_EQ(s.points.size(), 2'000'000U);
  EXPECT_LE(s.drift, 1e-10); // 2e-11: 3e-18 for a step
  std::printf("Henon-Heiles: drift %.1e\n", s.drift);
}

TEST(ManyTurns, ClassicalTop) { million_turns("asymmetric_classical", 5e-10); }
TEST(ManyTurns, SlidingTop) { million_turns("asymmetric_sliding", 5e-12); }

} // namespace
} // namespace kov::flow
