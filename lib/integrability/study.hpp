#pragma once
// Data that every stage of the study of a manifold needs, and may hand to the same study elsewhere
// (at one level, on one stratum).

#include "exact/share.hpp"
#include "integrability/check.hpp"

namespace kov {

struct Study {
  const System& system;
  const ManifoldSpec& manifold;
  const std::vector<ClaimReport>& claims; ///< of the file: proved integrals are used
  const CheckOptions& options;
};

/// The whole way, elsewhere: nothing is taken over.
[[nodiscard]] inline ManifoldReport whole_study(const Study& study) {
  return check_manifold(study.system, study.manifold, study.claims, study.options);
}

} // namespace kov
