#pragma once
// The residue field K[c]/q of a place: traces, sums over the roots of q, square roots.
//
// Nothing splits q.  A rational function with principal part b(c)/(z-c)^j at every root c of q is
// written down over K at once:
//
//   sum_{q(c)=0} b(c)/(z-c) = (b q' mod q)/q,      and its derivatives for j > 1.
//
// Source  docs/theory/descent.md (1)

#include "exact/budget.hpp"
#include "exact/rational_function.hpp"

#include <optional>
#include <vector>

namespace kov::kovacic {

/// sum over the roots c of q of b(c), an element of K.  Requires q monic, squarefree.
/// Example trace(z, z*z - z - 1)  // -> 1
[[nodiscard]] NfElem trace(const Poly& b, const Poly& q);

/// The product over the roots c of q of b(c), an element of K.  Requires q monic, squarefree.
/// Example norm(z, z*z - z - 1)  // -> -1
[[nodiscard]] NfElem norm(const Poly& b, const Poly& q);

/// sum over the roots c of q of b(c)/(z-c)^j.  Requires q monic, squarefree; j >= 1.
/// Example sum_over_roots(1, z*z - 2, 1)  // -> 2*z/(z^2 - 2)
[[nodiscard]] RationalFunction sum_over_roots(const Poly& b, const Poly& q, long j);

/// A square root of u in K[c]/q, if there is one.  Requires q monic, irreducible over K.
///
/// Cost    usually one prime: u is a non-residue at a prime of degree one.  A square is found by
///         factoring g(T^2) over K, g the characteristic polynomial of a primitive u s^2.
/// Source  docs/theory/descent.md (2)
/// Throws  OutOfBudget
/// Example square_root(3, z*z - 2, {})  // -> none
[[nodiscard]] std::optional<Poly> square_root(const Poly& u, const Poly& q, const Budget& budget);

/// Candidates for a in K, up to squares of K, where u = a s^2 with s in K[c]/q; 1 where the degree of
/// q is even and above 2.  For q = 1 (infinity) as for a rational place.
/// Source  docs/theory/whittaker_pull_back.md, 2
/// Example square_classes(12, z)  // -> {12}
[[nodiscard]] std::vector<NfElem> square_classes(const Poly& u, const Poly& q);

} // namespace kov::kovacic
