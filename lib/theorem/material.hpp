#pragma once
// The material of a report on a manifold: the curve, the way from the variational equation to r(z), the
// places and groups of y'' = r y.

#include "study/study.hpp"
#include "theorem/theorem.hpp"

namespace kov {

/// Its formulas, tables and pictures, that it is invariant, and its certificates.
void show_curve(NodeResult& n, const System& s, const study::CurveStudy& m);

/// The same of a study that a search has kept, of any order.
void show_study(NodeResult& n, const study::Evidence& found);

} // namespace kov
