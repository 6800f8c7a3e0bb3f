#pragma once
// A scan: one number of each orbit of a line or a plane of starts or parameters, without keeping points.
//
//   [scene.scan]
//   of   = "megno"                                          | "lyapunov" | "fli" | "crossings" | "time"
//   over = { y = ["-2/5", "3/5", 1000], v = [...] }         one or two: what is drawn, coordinates of a state, parameters
//
// The cells of the matrix are numbered along the first axis; blocks of them are computed one after the other, and each
// is the same whatever else was computed: by whom, with how many threads, before or after a kill.

#include "flow/scene/system_scene.hpp"

namespace kov::flow {

inline constexpr std::size_t scan_block = 4096; ///< cells

/// The numbers of one block, and what is known of its orbits.
struct ScanBlock {
  std::vector<double>
      values; ///< NaN: no orbit starts there; infinity: it ends early, in a singularity
  double drift = 0;
  double crossings = 0;
};

struct ScanResult {
  std::vector<double> values; ///< of the first axis side by side
  double drift = 0, crossings = 0;
  std::string integrals; ///< what drifts; empty: nothing is known that should not
  int order = 0;
  std::string arithmetic;
  std::size_t orbits = 0, empty = 0,
              early = 0; ///< cells with a number, without a start, ended early
  bool stopped = false;
};

struct ScanOptions {
  int threads = 1, lanes = 0;
  std::size_t part = 0, parts = 1; ///< only the blocks whose numbers have this remainder
  const std::atomic<bool>* stop = nullptr;
  std::map<std::size_t, ScanBlock> kept;                           ///< blocks that are known
  std::function<void(std::size_t done, std::size_t all)> progress; ///< in cells; one call at a time
  std::function<void(std::size_t number, const ScanBlock&)> finished; ///< the same
};

/// The middle of cell i of an axis.
[[nodiscard]] double scanned_value(const ScanAxis& axis, std::size_t i);
[[nodiscard]] std::size_t cells_of(const Scan& scan);

/// If several orbits start at one place (sheets of the level), the largest number counts.
///
/// Errors  InputError: no start at all, too large a system, more digits than double
/// Cost    proportional to cells * crossings; memory to cells
[[nodiscard]] ScanResult simulate_scan(const SystemScene& scene, const ScanOptions& options);

} // namespace kov::flow
