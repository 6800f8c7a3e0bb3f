#pragma once
// Kovacic 1986, §2.1: which of the cases the pole orders of r leave open.
//
//   case 1: every pole has even order or order 1; the order at infinity is even or > 2
//   case 2: some pole has order 2, or odd order > 2
//   case 3: every pole has order <= 2, the order at infinity is >= 2, all Delta are rational
//
// and what a logarithm says (docs/theory/descent.md (3)): an irreducible group with a logarithm in
// its local solutions contains a unipotent element (up to sign), hence is SL(2); so a logarithm
// leaves only the cases 1 and 4.

#include "linode/singularities.hpp"

#include <string>

namespace kov::kovacic {

/// Which cases are possible, and why the others are not.
struct Conditions {
  bool case1 = true; ///< true: the case is still possible
  bool case2 = true;
  bool case3 = true;
  std::string why_not1; ///< a full sentence when the case is excluded
  std::string why_not2;
  std::string why_not3;
};

/// Source  [Kovacic1986] §2.1, theorem; sharpened by logarithms and by the denominators of Delta
/// Example necessary_conditions(singularities(z)).case1  // -> no
/// Example necessary_conditions(singularities(z)).why_not3
///         // -> The place infinity is irregular.
[[nodiscard]] Conditions necessary_conditions(const Singularities& s);

/// Calls f on every finite place, then on infinity.
template <class F> void for_each_place(const Singularities& s, F&& f) {
  for (const Singularity& place : s.finite)
    f(place);
  f(s.infinity);
}

template <class F> [[nodiscard]] bool any_place(const Singularities& s, F&& f) {
  bool found = false;
  for_each_place(s, [&](const Singularity& place) { found = found || f(place); });
  return found;
}

/// Is Delta a rational number whose denominator divides n?  (yes for ordinary and simple places)
[[nodiscard]] bool has_denominator_dividing(const Singularity& place, long n);

} // namespace kov::kovacic
