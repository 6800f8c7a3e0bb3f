#pragma once
// For variational equations that the blocks leave open: certified monodromy matrices of the whole,
// or of a block of order three and more.

#include "integrability/study.hpp"

namespace kov {

/// Sets report.matrices if the matrices prove that the identity component is not abelian, for the
/// parameters of the system as they are, and for one level if levels are free (one is enough).
/// Nothing else can follow from them, and a limit leaves the report as it is.
/// Source  docs/theory/monodromy.md 7, 8, 9
void ask_the_matrices(const Study& study, ManifoldReport& report);

/// If the symplectic leaf says nothing: the same of the normal part with the variation of the
/// Casimir function that took away an unknown.  report.matrices then excludes integrals that are
/// independent together with the Casimir functions, although there may be one on the leaf.
/// Source  docs/theory/mechanics.md (9.9)
void ask_with_the_casimir(const Study& study, ManifoldReport& report);

/// "the whole variational equation", or "the variation of M1, M2, S1, S2"
[[nodiscard]] std::string equation_of(const MatrixEvidence& by);

/// "the monodromy matrices of the whole variational equation (size 6, z = p1) prove that ..."
[[nodiscard]] std::string reason(const MatrixEvidence& by);

} // namespace kov
