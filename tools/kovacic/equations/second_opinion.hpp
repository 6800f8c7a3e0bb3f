#pragma once
// What --second-opinion prints: what the monodromy matrices prove, beside the answer.

#include "integrability/certificate.hpp"
#include "integrability/monodromy_opinion.hpp"
#include "integrability/report.hpp"

#include <nlohmann/json.hpp>

namespace kov::cli {

using Json = nlohmann::ordered_json;

/// What the matrices say.
struct SecondOpinion {
  Json json;
  /// kovacic-loops/1; `none` says why there is no certificate of what is proved.  Both are empty
  /// where none was asked for, and where nothing is proved.
  NamedCertificate proof;
};

/// Of one equation y'' = r y.
/// Errors  Contradiction: the matrices contradict the answer
[[nodiscard]] SecondOpinion second_opinion(const RationalFunction& r, const Decision& answer,
                                           const Budget& budget, bool with_proof);
/// Of a manifold: the equations of its blocks and its whole variational equation.
/// Errors  Contradiction: the matrices contradict the verdict
[[nodiscard]] std::vector<SecondOpinion> second_opinion(const System& s, const ManifoldReport& m,
                                                        const Budget& budget, bool with_proof);

} // namespace kov::cli
