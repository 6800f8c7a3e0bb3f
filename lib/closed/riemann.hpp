#pragma once
// Riemann's equation: three regular singular places with exponent differences l, m, n and nothing
// else,
//
//   r = (l^2-1)/(4 z^2) + (m^2-1)/(4 (z-1)^2) + (1 - l^2 - m^2 + n^2)/(4 z (z-1)),
//
// and its limits with two places (Euler's equation).  The answer depends on l^2, m^2, n^2 only.
//
//   reducible    <=>  one of l +- m +- n is an odd integer
//   dihedral     <=>  irreducible, two of l, m, n in 1/2 + Z
//   A4, S4, A5   <=>  a row of the table (kimura.hpp)
//   SL2          otherwise
//
// Source  [Kimura1969]; docs/theory/kimura.md

#include "exact/poly.hpp"
#include "exact/rational_function.hpp"

#include <array>
#include <vector>

namespace kov {

/// The squares l^2, m^2, n^2, as elements of one field.
using SquaredExponents = std::array<NfElem, 3>;

/// r as above.
[[nodiscard]] RationalFunction riemann_equation(const SquaredExponents& squares);

/// The roots in Q of f, with multiplicity; nothing is factored over the field.
[[nodiscard]] std::vector<Rational> rational_roots(const Poly& f);
/// The odd integers k > 0 with k = +-l +- m +- n for some signs, given e1, e2, e3 of the squares.
[[nodiscard]] std::vector<Integer> odd_relations(const NfElem& e1, const NfElem& e2,
                                                 const NfElem& e3);
/// The integers s >= 0 with s = +-l +- m for some signs, given l^2 + m^2 and l^2 m^2.
/// Example integer_sums(5, 4)  // -> {1, 3}
[[nodiscard]] std::vector<Integer> integer_sums(const NfElem& sum, const NfElem& product);

} // namespace kov
