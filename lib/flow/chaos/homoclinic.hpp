#pragma once
// Chaos proved: a transverse homoclinic point of the section map.
//
// 1. A hyperbolic periodic point p of P (periodic_orbit.hpp); Q = P^N fixes it.
// 2. Cones: on a parallelogram p + A [-r, r]^2 the enclosed derivatives of Q and of its inverse map the cone of slope
//    kappa around the first (second) axis into itself and stretch it.  So the unstable (stable) manifold holds a graph
//    over the whole first (second) axis of the parallelogram, of slope at most kappa.
// 3. A finite orbit from one graph to the other: z_0 on the first, z_(k+1) = Q(z_k), z_n on the second, as one system
//    of 2n equations.  Krawczyk's test proves a solution with a regular derivative, for every pair of graphs that
//    2. allows: the two manifolds cross there, and not tangentially.
// docs/theory/chaos.md has the proofs.  The search is in double and proves nothing.

#include "flow/chaos/periodic_orbit.hpp"

namespace kov::flow {

/// The findings of the proof.  All numbers are exact (dyadic): other code can repeat the proof.
struct HomoclinicProof {
  PeriodicOrbit fixed;                         ///< of Q
  std::array<std::array<double, 2>, 2> axes{}; ///< A, by rows: chart coordinates of p + A (xi, eta)
  Chart chart;                                 ///< at p
  double reach = 0;                            ///< r
  double slope_unstable = 0, slope_stable = 0; ///< kappa
  double stretch_unstable = 0, stretch_stable = 0; ///< lower bounds, > 1
  double xi = 0, eta = 0;           ///< of z_0 and z_n along their axes, approximately
  std::vector<PeriodicPoint> orbit; ///< z_0 ... z_n, approximately
  double error = 0;                 ///< of the chart coordinates of z_1 ... z_(n-1)
  std::size_t middle = 0;           ///< of the orbit: where the angle is taken
  double sine = 0; ///< lower bound of |sin| of the angle between the manifolds there, in its chart
};

struct Homoclinic {
  std::optional<HomoclinicProof> proof;
  std::vector<PeriodicOrbit> hyperbolic; ///< the proved orbits that were tried
  NotProved why = NotProved::no_orbit;   ///< nothing is proved: what failed
  std::string by_checker{};              ///< refused: what it says
  /// For the picture, in double: arcs of the two manifolds of the orbit that was tried last.
  std::vector<std::vector<std::array<double, 2>>> unstable, stable;
  bool stopped = false;
};

struct HomoclinicOptions {
  int period = 1; ///< N
  long bits = 64;
  long most_returns = 60000; ///< of the search for crossings, for each periodic orbit
  int most_candidates = 12;  ///< crossings of the arcs that are tried, of each orbit
  /// The parallelogram is 2^smaller times smaller than it could be: for the checkers, whose enclosures are cruder.
  int smaller = 0;
  const std::atomic<bool>* stop = nullptr;
};

/// Errors  InputError: the scene has no section map of a surface (section_surface.hpp)
[[nodiscard]] Homoclinic homoclinic(const SystemScene& scene,
                                    const HomoclinicOptions& options = {});

} // namespace kov::flow
