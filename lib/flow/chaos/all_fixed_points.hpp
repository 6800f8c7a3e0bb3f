#pragma once
// All fixed points of the n-th return P^n over a rectangle of the picture, on one sheet of the section surface.
//
// The rectangle is divided into boxes until in each of them P^n(z) != z is shown, or a wider box around it has exactly
// one fixed point by Krawczyk's test; the sheets over all boxes are shown to be one (docs/theory/chaos.md 2.1).

#include "flow/chaos/return_map.hpp"

namespace kov::flow {

/// Lowest and highest value of each of the two drawn coordinates.
using DrawnBox = std::array<std::array<double, 2>, 2>;

struct CountedPoint {
  std::vector<double> x; ///< all coordinates
  double error = 0;      ///< of each: proved
  int index = 0;         ///< the sign of det(1 - DP^n), not 0
};

/// The fixed points known over the rectangle about the sheet through one point.
struct FixedPointsOverSheet {
  std::vector<double> through;          ///< approximately; empty: none was found
  std::vector<CountedPoint> points;     ///< inside the rectangle
  std::vector<DrawnBox> undecided = {}; ///< where more may be
  long boxes = 0;                       ///< that were looked at
  /// No sheet has others in the rectangle: each point of the section over it is known to lie on the sheet that was looked
  /// at, or not to be fixed.
  bool all_sheets = false;
  /// `points` are all fixed points on the sheet in the rectangle.  Where the sheet does not go no sheet has any.
  [[nodiscard]] bool complete() const { return undecided.empty(); }
};

struct FixedPointsInRectangle {
  int period = 1; ///< n
  std::vector<FixedPointsOverSheet>
      sheets; ///< those that the search found over the middle, or elsewhere
  bool stopped = false;
};

struct RectangleOptions {
  int period = 1;
  long bits = 64;
  long boxes = 100000; ///< for each sheet; what is left then is undecided
  const std::atomic<bool>* stop = nullptr;
};

/// `rectangle`: from, to for each of the two drawn coordinates.
/// Caveat  another sheet may lie over a part of the rectangle: of it nothing is said
/// Errors  InputError: no section map of a surface (section_surface.hpp); what is drawn is not two coordinates that
///         the section surface can have as a chart; an empty rectangle
/// Example
///   const auto all = fixed_points_in(scene, {{{"-1/10", "1/10"}, {"-1/10", "1/10"}}});
///   all.sheets[0].complete(); // then all.sheets[0].points are all of them
[[nodiscard]] FixedPointsInRectangle
fixed_points_in(const SystemScene& scene, const std::array<std::array<Quantity, 2>, 2>& rectangle,
                const RectangleOptions& options = {});

} // namespace kov::flow
