#pragma once
// The cost of accuracy: runs of one scene in every arithmetic, measured against a precise run.

#include "flow/number/big_real.hpp"
#include "flow/scene/system_scene.hpp"

#include <array>
#include <string>
#include <vector>

namespace kov::flow {

/// The result that a run must reproduce: for each orbit the number of its crossings until the
/// scene's time, and (l, L/G) of the first ten.
struct Reference {
  std::vector<long> crossings;
  std::vector<std::vector<std::array<BigReal, 2>>> points;
};

/// Crossings counted in pairs of doubles, points in `digits` digits.
/// Requires a scene with a time.
[[nodiscard]] Reference reference_of(const SystemScene& scene, int digits);

enum class Arithmetic : unsigned char { packs, one_lane, extended, pairs, mpfr };
[[nodiscard]] std::string to_string(Arithmetic a);
/// `digits` of a scene that runs in it.
[[nodiscard]] int digits_of(Arithmetic a, int mpfr);

struct Effort {
  double tolerance = 0; ///< asked for
  int order = 0;        ///< of the Taylor steps
  double seconds =
      0; ///< of the processor: the best of three, or of one that took longer than a second
  long crossings = 0;
  long wrong = 0;   ///< orbits whose number of crossings is not that of the reference
  double drift = 0; ///< largest drift of an integral
  double error = 0; ///< largest distance of the first ten points from the reference, in l and L/G
};

/// A run to the scene's time with the tolerance 10^-digits.
///
/// Cost  the integration alone is timed, not the starts
[[nodiscard]] Effort measure(const SystemScene& scene, Arithmetic arithmetic, int digits,
                             const Reference& reference);

} // namespace kov::flow
