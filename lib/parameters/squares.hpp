#pragma once
// Sums of squares, found by completing squares in one variable after the other: no search.

#include "exact/integer.hpp"
#include "exact/multivariate.hpp"

#include <optional>
#include <vector>

namespace kov {

/// c q^2, c > 0.
struct SquareTerm {
  Rational c;
  MPoly q;
};
/// c1 q1^2 + ... + multiplier f = 0, one q a number other than 0: f has no real zero.
struct NoRealZero {
  std::vector<SquareTerm> terms;
  MPoly multiplier;
};
/// Unset: none is found.
///
/// Given   const Ring line = make_ring({"t"});
/// Given   const MPoly t = MPoly::variable(line, "t"), one(line, Integer(1));
/// Example no_real_zero(t * t - t + one).has_value()  // -> yes
/// Example no_real_zero(t * t - t - one).has_value()  // -> no
[[nodiscard]] std::optional<NoRealZero> no_real_zero(const MPoly& f);

} // namespace kov
