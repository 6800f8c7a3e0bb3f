#pragma once
// From what the blocks of a manifold are to what follows from it, by which theorem.

#include "integrability/report.hpp"

namespace kov {

/// The verdict that follows from the blocks, or from the matrices of the whole.
[[nodiscard]] Verdict verdict_of(const ManifoldReport& report);

/// Fills in the verdict and the theorem used, with the class of first integrals that it excludes.
void conclude(const System& s, const CheckOptions& options, ManifoldReport& report);

/// Verdict::depends, or undecided in part: "except where C = A", outside of which the system is
/// not integrable; empty where that cannot be named.  In the exceptions nothing follows.
[[nodiscard]] std::string exceptions(const ManifoldReport& report, bool possibly = false);

} // namespace kov
