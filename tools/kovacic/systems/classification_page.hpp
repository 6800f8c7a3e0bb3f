#pragma once
// A classification in the form of a theorem with steps, which has LaTeX and HTML.

#include "study/classification.hpp"
#include "theorem/theorem.hpp"

#include <string>

namespace kov::cli {

/// The first step is the theorem with its tables; each of the others proves exclusions by one
/// equation, or they are those of `proved`.
[[nodiscard]] TheoremResult as_theorem(const System& s, const SystemClassification& c,
                                       const TheoremResult* proved = nullptr);

} // namespace kov::cli
