#include "bench/escape.hpp"
#include "flow/support.hpp"

#include <gtest/gtest.h>

namespace kov::flow::escape_test {
namespace {

// The plane c.M = 0 is unstable: an orbit on it leaves through rounding only, later with more digits (the picture:
// docs/accuracy/escape.png).  Luck in the last bit can only prolong its stay, so the shortest of a few counts.
TEST(Escape, HessAppelrotPlaneIsLeftThroughRoundingOnly) {
  const SystemScene s = test::body_scene("hess_sliding");
  const auto shortest = [&](Arithmetic a, int digits) {
    double least = 1e9;
    for (const char* l : {"4", "5"})
      least = std::min(least, escape_time(s, a, digits, Quantity(l), 40));
    return least;
  };
  const double in_double = shortest(Arithmetic::one_lane, 16),
               in_pairs = shortest(Arithmetic::pairs, 32), in_40 = shortest(Arithmetic::mpfr, 40);
  EXPECT_GT(in_double, 6);
  EXPECT_GT(in_pairs, 1.7 * in_double);
  EXPECT_GT(in_40, 1.15 * in_pairs);
  EXPECT_LT(in_40, 40);
}

} // namespace
} // namespace kov::flow::escape_test
