#pragma once
// The symplectic leaves around a phase curve: what is excluded on its own leaf is excluded near the curve
// where they are regular and of dimension four.
//
// Source  docs/theory/mechanics.md (6), lemma T

namespace kov {

struct System;
struct ManifoldReport;

/// Proved for all parameters: dimension - 4 of the Casimir functions that the file claims have independent
/// gradients along the curve, and the bracket has rank four there.  As `certify` sees it (regular_leaf.cpp
/// there); false where the function field of the curve is not known.
[[nodiscard]] bool has_regular_leaves(const System& s, const ManifoldReport& report);

} // namespace kov
