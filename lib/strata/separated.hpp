#pragma once
// Three singular places, all regular, and two exponent differences d1, d2 that are not rational: the
// identity component is abelian exactly where the third one is a natural number n >= 1 with
// +-d1 +- d2 among n - 1, n - 3, ..., 1 - n.  d1 and d2 may belong to a conjugate pair of places: only
// d1^2 + d2^2 and d1^2 d2^2 are asked for.
//
// Source  docs/theory/kimura.md, 6; strata.md, 10.12

#include "strata/leaf.hpp"

namespace kov::strata {

struct ThreePlaces {
  std::vector<PlaceIndex> pair; ///< one place with two roots, or two places: irrational
  PlaceIndex third = 0;
  SeparatedPair numbers;
};
/// Unset: another equation.
/// Given   const MFraction w = z * z + one;
/// Given   const Scheme s = std::get<Scheme>(scheme(z / (w * w), 0, everywhere));
/// Example three_places(s).has_value()  // -> no
[[nodiscard]] std::optional<ThreePlaces> three_places(const Scheme& s);

/// No point of the stratum satisfies the statement: proved, by exact arithmetic.  Needs: which values
/// of the third difference are left.  Unset: it depends on the point, or is not known.
[[nodiscard]] std::variant<std::monostate, SeparatedNowhere, Needs>
separated_nowhere(const ThreePlaces& t, const Scheme& s, const ParametrisedSet& region);

/// The closed answer.  Unset: another equation.
[[nodiscard]] std::optional<std::variant<Leaf, Needs>>
separated_leaf(const Scheme& s, const Evidence& torus, const ParametrisedSet& region);

} // namespace kov::strata
