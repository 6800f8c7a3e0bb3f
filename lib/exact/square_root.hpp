#pragma once
// Square roots of rational functions of several variables.

#include "exact/multivariate.hpp"

#include <optional>

namespace kov {

/// +-sqrt(f), if it is a rational function.
/// Given   const MFraction nu = MFraction::variable(make_ring({"nu"}), 0);
/// Example square_root(nu * nu)  // -> nu
/// Example square_root(nu)  // -> none
[[nodiscard]] std::optional<MFraction> square_root(const MFraction& f);

} // namespace kov
