// 10^6 periods: minutes of computing.  Built and run on request only:
//   tools/setup release test_flow_long && ctest --test-dir build/release -C slow -L slow

#include "flow/support.hpp"

#include <gtest/gtest.h>

namespace kov::flow {
namespace {

using namespace test;

// Every orbit crosses the section a million times.  The drift is that of rounding, which grows like
// the root of the number of steps: 10^-12 allows a hundred times what a thousand turns give.
void million_turns(const std::string& name, double bound) {
  const Scene s = read_scene(scene_path(name));
  auto starts = states_of<double>(s);
  std::vector<State<double>> eight;
  for (std::size_t i = 0; i < 8; ++i)
    eight.push_back(starts[i * starts.size() / 8]);
  const auto r = run(s.body<double>(), eight,
                     {.t_end = 1e9, .log2_tolerance = -59, .max_crossings = 1000000}, s.section);
  ASSERT_EQ(r.ends.size(), 8U);
  for (const auto& [orbit, end] : r.ends) {
    EXPECT_EQ(end.crossings, 1000000);
    EXPECT_EQ(end.ended, Ended::crossings);
  }
  EXPECT_LE(largest_drift(r), bound);
  std::printf("%s: drift %.1e\n", name.c_str(), largest_drift(r));
}

TEST(ManyTurns, ClassicalTop) { million_turns("asymmetric_classical", 2e-11); }
TEST(ManyTurns, SlidingTop) { million_turns("asymmetric_sliding", 1e-11); }

} // namespace
} // namespace kov::flow
