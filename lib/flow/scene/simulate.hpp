#pragma once
// From a scene to the points of its section.

#include "flow/orbit/kernels.hpp"
#include "flow/scene/scene.hpp"

#include <functional>

namespace kov::flow {

/// A step's local error is kept below tolerance / 2^6: then the integrals drift by about the tolerance in a
/// thousand turns (measured in docs/accuracy.md), and the number of crossings is right from 10^-4 on.
inline constexpr int safety_bits = 6;

struct SectionPoint {
  std::size_t orbit = 0;
  double t = 0;       ///< time of the crossing, from the start of the orbit
  double l = 0;       ///< radian, in [0, 2 pi)
  double y = 0;       ///< L/G
  double g_size = 0;  ///< G
  std::string digits; ///< "t l L/G G" of a run in more digits than double, to as many as it has
};

struct OrbitReport {
  double l = 0, y = 0, g_size = 0; ///< where it started on the section
  int sign = 0;                    ///< of the form `sign_of` there; 0 without one
  long crossings = 0, steps = 0;
  int tangencies = 0; ///< times the orbit touched the section without crossing, to 2^-24 of a step
  double time = 0;
  std::array<double, 3> drift{}; ///< of H, F1, F2, relative to sizes_on_level (andoyer.hpp)
  Ended ended = Ended::time;
};

/// How many digits of a point the tolerance justifies; digits: of a scene, 0 for double.
[[nodiscard]] int digits_shown(const Quantity& tolerance, int digits);

struct Section {
  std::vector<SectionPoint> points; ///< by orbit, then by time
  std::vector<OrbitReport> orbits;
  int least_order = 0, order = 0; ///< of the Taylor steps, over all orbits
  std::string arithmetic;         ///< "double, AVX-512, 8 lanes"
  double drift = 0;               ///< the largest of all orbits
  std::size_t skipped = 0;        ///< grid points where the level has no point
  bool stopped = false;
  bool has_time = false; ///< the time alone ends an orbit
  /// Orbits that have fewer crossings than asked for, although nobody stopped them: they reached
  /// the limit of steps, or (a scene with a time) of points.
  [[nodiscard]] std::size_t cut_short() const;
};

/// Scenes without a time: an orbit ends after `least_steps` + `steps_for_crossing` for each
/// crossing.
inline constexpr long least_steps = 20000, steps_for_crossing = 2000;
/// Scenes with a time: at most so many points, for the memory.
inline constexpr long most_points = 50'000'000;

struct SimulateOptions {
  int threads = 1;
  int lanes = 0; ///< 0: best_lanes
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::size_t done, std::size_t all)>
      progress; ///< called from the threads, one at a time
  std::function<void(const Section& so_far)> finished_some; ///< the same; points are not sorted yet
};

/// Integrates the orbits of the scene.
///
/// Units   limits and steps are meant in the scene's own units (own_units.hpp): the unit of a scene
///         does not matter
/// Errors  InputError: no seed lies on the level, or more than most_points crossings are asked for
/// Cost    proportional to orbits * time; the answer does not depend on threads or lanes
[[nodiscard]] Section simulate(const Scene& scene, const SimulateOptions& options = {});

/// The starting points of a scene, in the order seeds, then grid (rows within columns); a place
/// where the level has several sheets (values of G) gives one orbit for each, from the smallest G
/// to the largest.
struct Start {
  double l, y, g_size;
  State<double> x;
  std::optional<std::size_t> seed; ///< its number
};
[[nodiscard]] std::vector<Start> starts_of(const Scene& scene, std::size_t* skipped = nullptr);

} // namespace kov::flow
