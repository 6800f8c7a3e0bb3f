#pragma once
// Fixed points of the section map: periodic orbits that meet the section once, with their
// stability.
//
// Search (double): the displacement P(u) - u of the section map, u = (l, L/G), on a grid; Newton
// from every cell whose index (index_grid.hpp) is not 0 or not known, and from every grid point
// that moves little; from many places of a cell whose index the points found in it do not make up.
//
// The map, its derivative and the proof are those of the general engine (chaos/periodic_orbit.hpp), which the scene is
// written for (body_system.hpp): on the level the map is one from chart to chart of phase space, so that the return to
// the same G is part of the proof, and the box around a point encloses its l and L/G.  For a symplectic map
// det DP = 1: elliptic if |tr DP| < 2, hyperbolic if tr DP > 2, inverse hyperbolic < -2.

#include "flow/scene/system_scene.hpp"
#include "flow/section/not_proved.hpp"

#include <array>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace kov::flow {

enum class Stability : unsigned char { elliptic, hyperbolic, inverse_hyperbolic, parabolic };
[[nodiscard]] std::string to_string(Stability s);

struct FixedPoint {
  double l = 0, y = 0; ///< radian; L/G
  double g_size = 0;   ///< G
  double period = 0;   ///< time
  double trace = 0;    ///< of DP
  double determinant = 1;
  std::array<double, 2>
      multiplier{}; ///< of larger modulus, or with imaginary part > 0: real, imaginary part
  Stability stability = Stability::elliptic; ///< parabolic: |tr| = 2 to within the error
  // Proved bounds; `proved` is false when the test failed and `why` then says where.
  bool proved = false;
  double error = 0;       ///< distance in l and in L/G from the exact fixed point
  double trace_error = 0; ///< of trace
  NotProved why = NotProved::not_tried;
};

struct FixedPoints;

struct FixedPointOptions {
  int columns = 48, rows = 40; ///< of the grid of the search; rows at equal latitudes asin(L/G)
  bool prove = true;
  long bits = 128;      ///< of the first proof; where it fails, or says little, half as many more
  long most_bits = 288; ///< of the last one
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const FixedPoints& so_far, std::size_t proofs)> progress; ///< before a proof
};

/// The fixed points that the search found, sorted by l, then by L/G.
///
/// Requires  the scene is that of a body
/// Errors    InputError: the section is crossed in both directions, which is not one map
/// Caveat    each point with `proved` exists; that there are no others is not proved: a cell of the
///           grid may hide a pair of points of opposite index, and beyond the outermost rows (L/G
///           near +-1) there are no cells.
struct FixedPoints {
  std::vector<FixedPoint> points;
  int cells = 0;               ///< of the grid that have an index
  int cells_without_index = 0; ///< the others that meet the level (index_grid.hpp says why)
  int index_sum = 0;           ///< over those that have one
  int unexplained_cells = 0;   ///< cells whose points do not make up their index: some were missed
  int at_poles = 0; ///< of L/G = +-1, where the chart ends: how many of the two Newton ran into
  int curve_cells =
      0; ///< cells from which Newton ran into a curve of fixed points (1 is an eigenvalue of DP)
  bool stopped = false;    ///< before everything was searched, and proved
  bool degenerate = false; ///< more than half of the grid's points are (nearly) fixed
};
[[nodiscard]] FixedPoints fixed_points(const SystemScene& scene,
                                       const FixedPointOptions& options = {});

/// Proves the fixed point near (l, y), or says why it cannot.
[[nodiscard]] FixedPoint prove_fixed_point(const SystemScene& scene, const FixedPoint& guess,
                                           long bits, const std::atomic<bool>* stop = nullptr);

} // namespace kov::flow
