#pragma once
// z = M(x) = (a x + b)/(c x + d) in y'' = r y: with y = u sqrt(M') the equation becomes
// u'' = M'^2 r(M) u, again without a first derivative, since the Schwarzian of M is 0.

#include "exact/rational_function.hpp"

#include <string>

namespace kov {

/// x -> (a x + b)/(c x + d).
struct Moebius {
  NfElem a{1}, b{0}, c{0}, d{1};

  [[nodiscard]] bool is_identity() const { return is_zero(b) && is_zero(c) && a == d; }
};

/// (ad - bc)^2/(cx + d)^4 r((ax + b)/(cx + d)).  Throws InvalidArgument for ad = bc.
/// Example pull_back(z, {0, 1, 1, 0})  // -> 1/z^5
/// Example pull_back(z, {1, 1, 1, 1})  // -> throws InvalidArgument
[[nodiscard]] RationalFunction pull_back(const RationalFunction& r, const Moebius& m);
/// (a*x + b)/(c*x + d) as text.
/// Example to_string(Moebius{1, 1, -1, 1}, "x")  // -> (-x - 1)/(x - 1)
[[nodiscard]] std::string to_string(const Moebius& m, const std::string& variable);

} // namespace kov
