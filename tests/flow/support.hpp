#pragma once
// Scenes of bodies for the tests of lib/flow, and what is measured on their points.

#include "flow/scene/body_system.hpp"
#include "flow/scene/starts.hpp"
#include "flow/scene/system_section.hpp"
#include "support/source_dir.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace kov::flow::test {

inline std::string scene_path(const std::string& name) {
  return kov::test::in_source("/cases/sliding_top/scenes/") + name + ".toml";
}

inline SystemScene body_scene(const std::string& name) {
  return system_of(read_scene(scene_path(name)));
}

/// The states over a place of the picture.
inline std::vector<std::vector<double>> states_over(const SystemScene& s, double u, double v) {
  const Field field = field_of_starts(s);
  return Places(s, field).over({u, v});
}

/// The points of each orbit.
inline std::vector<std::vector<DrawnPoint>> by_orbit(const SystemSection& s) {
  std::vector<std::vector<DrawnPoint>> all(s.orbits.size());
  for (const DrawnPoint& p : s.points)
    all[p.orbit].push_back(p);
  return all;
}

/// In (l, L/G).
inline double apart(const DrawnPoint& a, const DrawnPoint& b) {
  return std::max(std::abs(std::remainder(a.at[0] - b.at[0], 2 * M_PI)),
                  std::abs(a.at[1] - b.at[1]));
}

} // namespace kov::flow::test
