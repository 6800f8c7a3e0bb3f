#pragma once
// What --second-opinion prints: what the monodromy matrices prove, beside the answer.

#include "integrability/check.hpp"
#include "integrability/monodromy_opinion.hpp"

#include <nlohmann/json.hpp>

namespace kov::cli {

using Json = nlohmann::ordered_json;

/// Of one equation y'' = r y.
/// Errors  InternalError: the matrices contradict the answer
[[nodiscard]] Json second_opinion(const RationalFunction& r, const Decision& answer,
                                  const Budget& budget);
/// Of a manifold: the equations of its blocks and its whole variational equation.
/// Errors  InternalError: the matrices contradict the verdict
[[nodiscard]] Json second_opinion(const System& s, const ManifoldReport& m, const Budget& budget);

} // namespace kov::cli
