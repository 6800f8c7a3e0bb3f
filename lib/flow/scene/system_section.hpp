#pragma once
// From a scene of any system to the points of its section.

#include "flow/field/field_kernels.hpp"
#include "flow/scene/spectrum.hpp"
#include "flow/scene/winding.hpp"

namespace kov::flow {

struct DrawnPoint {
  std::size_t orbit = 0;
  double t = 0;
  std::array<double, 2> at{}; ///< what is drawn; angles in [-pi, pi)
  std::string digits;         ///< "t x y" of a run in more digits than double
  /// In units of `size`, which is that of the terms of what is drawn (point_errors.hpp); -1: not known.
  double error = -1;
  std::array<float, 2> size{};
  std::array<float, 2> turns{}; ///< whole turns that were taken away from an angle
};

/// How many digits of a point the tolerance justifies; digits: of a scene, 0 for double.
[[nodiscard]] int digits_shown(const Quantity& tolerance, int digits);
/// Digits that the turns have taken.
[[nodiscard]] int digits_lost(const DrawnPoint& p, std::size_t part);

struct DrawnOrbit {
  std::array<double, 2> start{}; ///< in the picture
  int sign = 0;                  ///< of the scene's `sign_of` there; 0 without one
  long crossings = 0, steps = 0;
  int tangencies = 0; ///< the section was touched, but for rounding
  long hidden = 0;    ///< steps in which it was within rounding all the time, though not at the end
  double time = 0;
  double drift = 0; ///< the largest of its integrals and function symbols, relative to their sizes
  Indicators indicators = {};
  Spectrum spectrum = {}; ///< where exponents are asked for
  Winding winding = {};   ///< where it is
  Ended ended = Ended::stopped;
  double rest_from = -1; ///< from then to the end it rests, but for rounding; -1: it does not
  double inside_from =
      -1; ///< from then to the end it lies in the section, but for rounding; -1: it does not
};

struct SystemSection {
  std::vector<DrawnPoint> points; ///< by orbit, then by time
  std::vector<DrawnOrbit> orbits;
  std::vector<std::string>
      integrals; ///< their texts; the last is the functions' own check, if there are functions
  std::vector<double>
      drifts; ///< of each, the largest over the orbits, relative to the size of its terms there
  std::vector<double>
      beyond;       ///< the same with what is not drawn since an orbit has left the scene's bound
  double drift = 0; ///< the largest of `drifts`; of `beyond` where no orbit stays within the bound
  double seconds = 0; ///< of the processor, for the integration alone
  int order = 0;
  double products = 0; ///< of series in each order
  std::string arithmetic;
  std::size_t again = 0; ///< orbits that ran again with more digits: rounding hid their section
  int digits_again = 0;
  std::size_t skipped = 0; ///< places of the grid where the level has no point
  bool stopped = false, has_time = false;
  [[nodiscard]] std::size_t count(Ended how) const;
  /// Orbits with fewer crossings than asked for: they reached the limit of steps, or (with a time) of points.
  [[nodiscard]] std::size_t cut_short() const;
};

/// How far the points of a section can be trusted.
struct PointAccuracy {
  bool known = false;
  double bound =
      1e-6; ///< 10^-6, or less if all points are right to less; 10^-3 if none is right to 10^-6
  std::size_t returns = 0;  ///< so many first points of every orbit have errors below it
  std::size_t whole = 0;    ///< orbits of which all have
  std::size_t doubtful = 0; ///< points with errors above `visible_error`
};
inline constexpr double visible_error = 1e-3; ///< a pixel of a picture
[[nodiscard]] PointAccuracy accuracy_of(const SystemSection& s);

struct SystemSectionOptions {
  int threads = 1, lanes = 0;
  bool native =
      true; ///< with code of the processor (field/machine_code.hpp); the answer is the same without
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::size_t done, std::size_t all)> progress;
  std::function<void(const SystemSection& so_far)> finished_some; ///< points are not sorted yet
};

/// Integrates the orbits of the scene; of a diagram, for each value of its parameter, which is what is drawn first.
///
/// Units   a step's error and the drifts are relative to the scales of the coordinates, which a few orbits show:
///         the units of the system do not matter
/// Errors  InputError: no start, a function without a value, too many points, too large a system
/// Cost    proportional to orbits * time; the answer does not depend on threads or lanes
[[nodiscard]] SystemSection simulate(const SystemScene& scene,
                                     const SystemSectionOptions& options = {});

} // namespace kov::flow
