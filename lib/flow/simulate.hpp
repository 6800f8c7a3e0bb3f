#pragma once
// From a scene to the points of its section.

#include "flow/kernels.hpp"
#include "flow/scene.hpp"

#include <functional>

namespace kov::flow {

/// A step's local error is kept below tolerance / 2^6: then the integrals drift by about the tolerance in a
/// thousand turns (measured in docs/accuracy.md), and the number of crossings is right from 10^-4 on.
inline constexpr int safety_bits = 6;

struct SectionPoint {
  std::size_t orbit = 0;
  double t = 0; ///< time of the crossing, from the start of the orbit
  double l = 0; ///< radian, in [0, 2 pi)
  double y = 0; ///< L/G
  double g_size = 0; ///< G
};

struct OrbitReport {
  double l = 0, y = 0, g_size = 0; ///< where it started on the section
  int sign = 0;                    ///< of the form `sign_of` there; 0 without one
  long crossings = 0, steps = 0;
  int tangencies = 0; ///< times the orbit touched the section without crossing, to 2^-24 of a step
  double time = 0;
  std::array<double, 3> drift{}; ///< |H-H0|/max(1,|H0|), |F1-F1_0|/F1_0, |F2-F2_0|/max(1,|F2_0|)
  Ended ended = Ended::time;
};

struct Section {
  std::vector<SectionPoint> points; ///< by orbit, then by time
  std::vector<OrbitReport> orbits;
  int order = 0;          ///< of the Taylor steps
  std::string arithmetic; ///< "double, AVX-512, 8 lanes"
  double drift = 0;       ///< the largest of all orbits
  std::size_t skipped = 0; ///< grid points where the level has no point
  bool stopped = false;
};

struct SimulateOptions {
  int threads = 1;
  int lanes = 8;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::size_t done, std::size_t all)> progress; ///< called from the threads, one at a time
};

/// Integrates the orbits of the scene.
///
/// Errors  InputError: no seed lies on the level; InvalidArgument never
/// Cost    proportional to orbits * time; the answer does not depend on threads or lanes
[[nodiscard]] Section simulate(const Scene& scene, const SimulateOptions& options = {});

/// The starting points of a scene, in the order seeds, then grid (rows within columns).
struct Start {
  double l, y, g_size;
  State<double> x;
};
[[nodiscard]] std::vector<Start> starts_of(const Scene& scene, std::size_t* skipped = nullptr);

} // namespace kov::flow
