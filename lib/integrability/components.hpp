#pragma once
// Components of the phase curve that the way to r(z) lost.

#include "integrability/study.hpp"

namespace kov {

/// A component which was not studied, or that this was not excluded; unset: the variational equations
/// were studied along every component that is a phase curve.
/// Source  docs/theory/mechanics.md (9.8)
/// Cost    for each function that was divided by, a Gröbner basis of its zeros on the curve
[[nodiscard]] std::optional<LeftOut> component_left_out(const Study& study,
                                                        const ManifoldReport& report);

/// The same at special values of free parameters, where curves may fall apart: it was not excluded.
/// False: nothing was divided by, or there are no parameters.
[[nodiscard]] bool may_fall_apart(const Study& study, const ManifoldReport& report);

} // namespace kov
