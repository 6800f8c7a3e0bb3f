#pragma once
// From what the blocks of a manifold are to what follows from it, by which theorem.

#include "integrability/check.hpp"

namespace kov {

/// Fills in the verdict, the theorem used with the class of first integrals that it excludes, the
/// statement and the reasons.
void conclude(const System& s, const CheckOptions& options, ManifoldReport& report);

} // namespace kov
