#pragma once
// Periodic orbits of the section map of a scene, with proven stability.
//
// Search (double): Newton's method for P^N(z) = z from the scene's seeds and states, and over its range from every cell
// of a grid whose index (index_grid.hpp) is not 0 or not known and every node that moves little; from many places of a
// cell whose index the points found in it do not make up.  Proof (balls): Krawczyk's test for the N points together,
// z_(k+1) = P(z_k), each in a chart of its own.

#include "flow/chaos/return_map.hpp"

#include <functional>

namespace kov::flow {

/// tr DP^N above 2, below -2, or between, where the map keeps an area.
enum class Stability : unsigned char { elliptic, hyperbolic, inverse_hyperbolic };
[[nodiscard]] std::string to_string(Stability s);

struct PeriodicPoint {
  std::vector<double> x;         ///< all coordinates
  std::array<double, 2> drawn{}; ///< in the picture
};

struct PeriodicOrbit {
  std::vector<PeriodicPoint> points; ///< N of them
  double time = 0;                   ///< of one turn
  double trace = 0, determinant = 1; ///< of DP^N
  /// The one of larger modulus, or with imaginary part > 0: real, imaginary part.
  [[nodiscard]] std::array<double, 2> multiplier() const;
  /// Proved, and the period N is the least one.  Otherwise `why` says what failed.
  bool proved = false;
  double error = 0; ///< of each coordinate of `points`, and of what is drawn
  double trace_error = 0;
  /// Nothing: |multiplier| = 1 to within the error, or the map is not known to keep an area.
  std::optional<Stability> stability;
  NotProved why = NotProved::not_tried;
};

/// The cells of the grid that lie on the level, of each sheet.
struct CellCount {
  int with_index = 0;
  int without = 0;     ///< index_grid.hpp says why
  int index_sum = 0;   ///< over those that have one
  int unexplained = 0; ///< whose points do not make up their index: some were missed
  bool curves =
      false; ///< Newton's method ran into a curve of fixed points (1 is an eigenvalue of DP)
  bool identity = false; ///< more than half of the grid's points are (nearly) fixed
};

struct PeriodicOrbits {
  int period = 1;
  std::vector<PeriodicOrbit> orbits; ///< by what is drawn first
  std::optional<CellCount> cells;    ///< of a scene with a range
  bool stopped = false;              ///< before everything was searched, and proved
};

struct PeriodicOptions {
  int period = 1;
  int columns = 48, rows = 40; ///< of the grid, if the scene has a range
  bool prove = true;
  long bits = 128;      ///< of the first proof; where it fails, or says little, half as many more
  long most_bits = 288; ///< of the last one
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const PeriodicOrbits& so_far, std::size_t proofs)> progress =
      {}; ///< before one
};

/// Caveat  each orbit with `proved` exists; that there are no others is not proved: a cell of the grid may hide a pair of
///         opposite index
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
/// The same as numbers to show; not proved: as it was, with `why`.
[[nodiscard]] PeriodicOrbit prove_orbit(EnclosedMap& map, QuickMap& quick,
                                        const PeriodicOrbit& found);
/// The orbits of the search, nothing proved.
[[nodiscard]] PeriodicOrbits look_for_orbits(const SystemScene& scene, QuickMap& map,
                                             const PeriodicOptions& options);

} // namespace kov::flow
