#pragma once
// Linear programming over Q, exactly: one question that proofs of signs ask.

#include "exact/integer.hpp"

#include <optional>
#include <vector>

namespace kov {

/// x >= 0 with a x = 0 and sum of x_j over the strict j = 1, or nothing if there is none.
/// Shape   a: rows of equal length; strict: one entry for each column
/// Cost    the simplex method with Bland's rule
/// Example nonnegative_combination({{Rational(1), Rational(-1)}}, {true, false})  // -> {1, 1}
[[nodiscard]] std::optional<std::vector<Rational>>
nonnegative_combination(const std::vector<std::vector<Rational>>& a,
                        const std::vector<bool>& strict);

} // namespace kov
