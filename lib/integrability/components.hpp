#pragma once
// Components of the phase curve that the way to r(z) lost.

#include "integrability/study.hpp"

namespace kov {

/// A clause that names a component which was not studied, or that this was not excluded; empty: the
/// variational equations were studied along every component that is a phase curve.
/// Source  docs/theory/mechanics.md (9.8)
/// Cost    for each function that was divided by, a Gröbner basis of its zeros on the curve
[[nodiscard]] std::string component_left_out(const Study& study, const ManifoldReport& report);

/// The same at special values of free parameters, where curves may fall apart: a clause if it was not
/// excluded; empty: nothing was divided by, or there are no parameters.
[[nodiscard]] std::string components_not_checked(const Study& study, const ManifoldReport& report);

} // namespace kov
