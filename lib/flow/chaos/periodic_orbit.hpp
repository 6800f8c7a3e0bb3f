#pragma once
// Periodic orbits of the section map of a system file, with proven stability.
//
// Search (double): Newton's method for P^N(z) = z from the scene's starts and a grid over its range.  Proof (balls):
// Krawczyk's test for the N points together, z_(k+1) = P(z_k), each in a chart of its own.

#include "flow/chaos/return_map.hpp"
#include "flow/section/fixed_points.hpp"

#include <functional>

namespace kov::flow {

struct PeriodicPoint {
  std::vector<double> x;         ///< all coordinates
  std::array<double, 2> drawn{}; ///< in the picture
};

struct PeriodicOrbit {
  std::vector<PeriodicPoint> points;  ///< N of them
  double time = 0;                    ///< of one turn
  double trace = 0, determinant = 1;  ///< of DP^N
  std::array<double, 2> multiplier{}; ///< of larger modulus, or with imaginary part > 0
  /// Proved, and the period N is the least one.  Otherwise `why` says what failed.
  bool proved = false;
  double error = 0; ///< of each coordinate of `points`
  double trace_error = 0;
  /// Nothing: |multiplier| = 1 to within the error, or the map is not known to keep an area.
  std::optional<Stability> stability;
  NotProved why = NotProved::not_tried;
};

struct PeriodicOrbits {
  int period = 1;
  std::vector<PeriodicOrbit> orbits; ///< by what is drawn first
  bool stopped = false;
};

struct PeriodicOptions {
  int period = 1;
  long bits = 128;
  int grid = 20; ///< places in each direction, if the scene has a range
  const std::atomic<bool>* stop = nullptr;
};

/// Caveat  each orbit with `proved` exists; that there are no others is not proved
/// Errors  InputError: the scene has no section map of a surface (section_surface.hpp)
[[nodiscard]] PeriodicOrbits periodic_orbits(const SystemScene& scene,
                                             const PeriodicOptions& options = {});

/// The starts of a scene over one place of the picture: one on each sheet that is found there.
[[nodiscard]] std::vector<std::vector<double>> starts_over(const SystemScene& scene,
                                                           const std::array<Quantity, 2>& place,
                                                           const std::atomic<bool>* stop);

/// An orbit as the proof encloses it.
struct EnclosedOrbit {
  std::vector<Patch> patches; ///< around the points; box: where the point is
  std::vector<std::array<std::array<Enclosure, 2>, 2>> slopes; ///< DP at each
  Enclosure time, trace, determinant;
  std::optional<Stability> stability;
};
/// Throws NotProved.
[[nodiscard]] EnclosedOrbit enclose_orbit(EnclosedMap& map, QuickMap& quick,
                                          const std::vector<std::vector<double>>& points);
/// The same as numbers to show; not proved: `why`.
[[nodiscard]] PeriodicOrbit prove_orbit(EnclosedMap& map, QuickMap& quick,
                                        const std::vector<std::vector<double>>& points);
/// Approximate orbits of least period N; one point of each orbit first.
[[nodiscard]] std::vector<std::vector<std::vector<double>>>
look_for_orbits(const SystemScene& scene, QuickMap& map, const PeriodicOptions& options);

} // namespace kov::flow
