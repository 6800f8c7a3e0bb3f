#pragma once
// What every stage of the study of a manifold needs, and may hand to the same study elsewhere (at
// one level, on one stratum).

#include "integrability/check.hpp"

namespace kov {

struct Study {
  const System& system;
  const ManifoldSpec& manifold;
  const std::vector<ClaimReport>& claims; ///< of the file: proved integrals are used
  const CheckOptions& options;
};

/// The budget of something that may take this part of the time that is left; its other limits.
[[nodiscard]] Budget part_of_the_time(Budget budget, double part);

[[nodiscard]] inline ManifoldReport check_manifold(const Study& study) {
  return check_manifold(study.system, study.manifold, study.claims, study.options);
}

} // namespace kov
