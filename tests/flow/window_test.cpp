// The window of a scene without a range: what lies over its level, whose extent is known.

#include "flow/scene/system_scene.hpp"

#include "symbol/document.hpp"

#include <gtest/gtest.h>

namespace kov::flow::window_test {
namespace {

std::array<double, 4> window(const std::string& h, const std::string& level) {
  const SystemScene s =
      read_system_scenes(
          parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\n"
                         "momenta = ['u', 'v']\nhamiltonian = '" +
                             h + "'\n[scene]\nsection = 'x'\nplot = ['y', 'v']\nlevels = {H = '" +
                             level + "'}\ngrid = [4, 4]\ncrossings = 3\n",
                         "test.toml"))
          .front();
  const auto at = [&](std::size_t i, std::size_t j) { return (*s.range).at(i).at(j).as<double>(); };
  return {at(0, 0), at(0, 1), at(1, 0), at(1, 1)};
}

// Around the ellipse, and not twice as large.
void expect_around(const std::array<double, 4>& found, double y, double v) {
  for (const auto& [k, size] : {std::pair{0, y}, std::pair{2, v}}) {
    EXPECT_LE(found.at(k), -0.95 * size);
    EXPECT_GE(found.at(k), -1.3 * size);
    EXPECT_GE(found.at(k + 1), 0.95 * size);
    EXPECT_LE(found.at(k + 1), 1.3 * size);
  }
}

TEST(Window, OfOscillators) {
  expect_around(window("(u^2 + v^2)/2 + (x^2 + y^2)/2", "1/2"), 1, 1);
  expect_around(window("(u^2 + v^2)/2 + (x^2 + 100*y^2)/2", "50"), 1, 10);
  expect_around(window("(u^2 + v^2)/2 + (x^2 + y^2)/2", "1/2000"), 0.0316, 0.0316);
  expect_around(window("(u^2 + v^2)/2 + (x^2 + y^2)/2", "200"), 20, 20);
}

// Below the saddle the part around the origin, and not what lies beyond.
TEST(Window, OfABoundedPart) {
  const auto found = window("(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3", "1/8");
  EXPECT_LT(found[1], 1);
  EXPECT_GT(found[1], 0.6);
}

// Where the level does not end, and where it is empty.
TEST(Window, OtherwiseOne) {
  EXPECT_EQ(window("(u^2 + v^2)/2 - x^2 - y^2", "1"), (std::array<double, 4>{-1, 1, -1, 1}));
  EXPECT_EQ(window("(u^2 + v^2)/2 + x^2 + y^2", "-1"), (std::array<double, 4>{-1, 1, -1, 1}));
}

} // namespace
} // namespace kov::flow::window_test
