#pragma once
// How wrong the points of a section are: each orbit is computed a second time, with other roundings and less
// truncation, and the two are compared crossing by crossing (docs/theory/point_errors.md).
//
// The second run has steps that are shorter by a fifth, starts that differ by what rounding has done to the starts of
// the first, and constants that differ by their rounding.  So its errors are independent of those of the first run and
// of the same size; both are carried along by the same flow, whatever it does to them.

#include "flow/number/conversions.hpp"
#include "flow/number/lanes.hpp"

#include <array>
#include <vector>

namespace kov::flow {

/// log2 of the length of a step of the second run, in those of the first.
inline constexpr double second_run_steps = -0.32;
/// From this error on two runs have nothing in common any more: later points are no better.
inline constexpr double error_lost = 0.1;

/// A crossing in the arithmetic of its run: the time, what is drawn, and the size of its terms in the step there.
template <class R> struct RawPoint {
  R t{};
  std::array<R, 2> at{};
  std::array<double, 2> size{1, 1};
  /// The part of it that comes from rounding of the section, by the time of the crossing: both runs
  /// may have the same.
  std::array<double, 2> by_section{};
};

/// The difference of two runs at a crossing.
struct PointDifference {
  double t = 0;                 ///< the difference of the times
  std::array<double, 2> at{};   ///< of what is drawn; angles modulo 2 pi
  std::array<double, 2> size{}; ///< of what is drawn, in the first run; of an angle 1
  double rounding =
      1; ///< the largest number that is rounded at the crossing, in units of the size: an angle has turns
  double by_section = 0; ///< as in RawPoint, in units of the size
};

/// The error of each point, in units of its size: the larger of both parts.
/// Ensures  none is below error_lost after one that was not
[[nodiscard]] std::vector<double> errors_of(const std::vector<PointDifference>& differences,
                                            double roundoff);

/// Each crossing of the first run beside the one of the second that belongs to it.  A run that has lost or found a
/// crossing (a section that is only touched) goes on beside the other: the nearest in time is tried as well.
template <class R>
std::vector<PointDifference> compared(const std::vector<RawPoint<R>>& first,
                                      const std::vector<RawPoint<R>>& second,
                                      const std::array<bool, 2>& angle);

} // namespace kov::flow
