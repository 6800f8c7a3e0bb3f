#pragma once
// The material of a report on a manifold: the curve, the way from the variational equation to r(z), the
// places and groups of y'' = r y.

#include "study/study.hpp"
#include "theorem/theorem.hpp"

namespace kov {

/// Its formulas, tables and pictures, that it is invariant, and its certificates; of any order.
void show_curve(NodeResult& n, const System& s, const study::CurveStudy& m,
                const std::vector<NamedCertificate>& certificates);

} // namespace kov
