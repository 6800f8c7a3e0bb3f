#pragma once
// A rational function in a letter r with r^2 = s.

#include "exact/multivariate.hpp"

#include <utility>

namespace kov::elementary {

/// f = first + second r.  Throws DomainError where the denominator has the norm 0.
/// Given   const Ring ring = make_ring({"r", "a"});
/// Given   const MFraction r = MFraction::variable(ring, 0), a = MFraction::variable(ring, 1);
/// Example split_root(a / (a + r), 0, a).second  // -> -1/(a - 1)
[[nodiscard]] inline std::pair<MFraction, MFraction> split_root(const MFraction& f, std::size_t r,
                                                                const MFraction& square) {
  const MFraction zero(f.ring(), Rational(0));
  if (!uses(f, r)) return {f, zero};
  const auto split = [&](const MPoly& p) {
    std::pair<MFraction, MFraction> parts{zero, zero};
    const auto c = coefficients(p, r);
    for (std::size_t k = 0; k < c.size(); ++k)
      (k % 2 == 0 ? parts.first : parts.second) +=
          MFraction(c[k]) * pow(square, static_cast<long>(k / 2));
    return parts;
  };
  const auto [a, b] = split(f.num());
  const auto [c, d] = split(f.den());
  const MFraction norm = c * c - d * d * square;
  return {(a * c - b * d * square) / norm, (b * c - a * d) / norm};
}

} // namespace kov::elementary
