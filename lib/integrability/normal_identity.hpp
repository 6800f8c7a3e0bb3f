#pragma once
// The identity behind y'' + p y' + q y = 0, or behind a system: covectors along the phase curve, and the
// annihilators modulo which their derivatives satisfy it.
//
// Source  docs/theory/system_certificates.md, (N1) to (N5)

#include "algebraize/rational_system.hpp"
#include "integrability/curve_rows.hpp"
#include "integrability/study.hpp"

namespace kov {

/// nabla^2 row + p nabla row + q row = sum rest_l annihilators_l, or nabla row_i = sum a_ij row_j + likewise, and
/// nabla annihilators = matrices annihilators; vectors are dual to row, nabla row, or to the rows, and 0 on the
/// annihilators.
struct NormalIdentity {
  std::vector<CurveRows::Row> annihilators, matrices;
  std::vector<CurveRows::Row> rows, rests;
  FunctionField::Element p, q; ///< of one row
  std::vector<CurveRows::Row> vectors;
};

/// Unset: the covectors of the block span no subsystem of which it is a quotient.
/// Requires block.ode
[[nodiscard]] std::optional<NormalIdentity>
normal_identity(const ManifoldReport& report, const BlockReport& block, const CurveRows& rows);

/// sum c df of pairs (c, f)
using Differential = std::vector<std::pair<MFraction, MFraction>>;
/// The unknowns of a system over K(z), as differentials divided by elements of the basis, where some others
/// are 0.
struct UnknownsOfSystem {
  std::vector<Differential> unknowns, eliminated;
  bool whole = false; ///< on the whole Poisson manifold
};
/// The same of Y' = A Y.   Unset: they span no subsystem, or an unknown occurs twice
[[nodiscard]] std::optional<NormalIdentity> normal_identity(const RationalSystem& system,
                                                            const UnknownsOfSystem& unknowns,
                                                            const CurveRows& rows);

} // namespace kov
