#pragma once
// The identity behind y'' + p y' + q y = 0: a covector along the phase curve, and the annihilators
// modulo which its derivatives satisfy the equation.
//
// Source  docs/theory/system_certificates.md, (N1) to (N3)

#include "integrability/curve_rows.hpp"
#include "integrability/study.hpp"

namespace kov {

/// nabla^2 row + p nabla row + q row = sum rest_l annihilators_l, and nabla annihilators = matrices
/// annihilators; vectors are dual to row, nabla row and 0 on the annihilators.
struct NormalIdentity {
  std::vector<CurveRows::Row> annihilators, matrices;
  CurveRows::Row row, rest;
  FunctionField::Element p, q;
  std::vector<CurveRows::Row> vectors;
};

/// Unset: the covectors of the block span no subsystem of which it is a quotient.
/// Requires block.ode
[[nodiscard]] std::optional<NormalIdentity>
normal_identity(const ManifoldReport& report, const BlockReport& block, const CurveRows& rows);

} // namespace kov
