#pragma once
// Obstructions of higher order as certificates of the format kovacic-jets/1
// (docs/theory/jet_certificates.md).

#include "jets/obstruction.hpp"
#include "jets/subspace.hpp"

namespace kov::jets {

struct Certified {
  std::string json;     ///< accepted by the judge of lib/certify; empty if there is none, and
  std::string none;     ///< why
  bool refused = false; ///< the judge found something false: the obstruction is not to be believed
};

/// Cost  that of the series once more
[[nodiscard]] Certified certificate(const System& whole, const Subspace& inside,
                                    const HigherObstruction& o);

} // namespace kov::jets
