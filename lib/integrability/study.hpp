#pragma once
// Data that every stage of the study of a manifold needs, and may hand to the same study elsewhere
// (at one level, on one stratum).

#include "exact/share.hpp"
#include "integrability/report.hpp"

namespace kov {

struct Study {
  const System& system;
  const ManifoldSpec& manifold;
  const std::vector<ClaimReport>& claims; ///< of the file: proved integrals are used
  const CheckOptions& options;
};

} // namespace kov
