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

#include "closed/closed_answer.hpp"
#include "exact/poly.hpp"
#include "exact/rational_function.hpp"

#include <array>
#include <vector>

namespace kov {

/// The squares l^2, m^2, n^2, as elements of one field.
using SquaredExponents = std::array<NfElem, 3>;

/// r as above.
[[nodiscard]] RationalFunction riemann_equation(const SquaredExponents& squares);

/// The Galois group of Riemann's equation; always determined.
/// Cost  a few operations in the field and factorisations of degree 3 and 4 over Q
/// Given   const Rational half(1, 2), third(1, 3), fifth(1, 5);
/// Example riemann_answer({half*half, third*third, fifth*fifth}).group->type  // -> A5
/// Example riemann_answer({half*half, third*third, 2}).group->type  // -> SL2
[[nodiscard]] ClosedAnswer riemann_answer(const SquaredExponents& squares);

/// The same where the squares are the values of one element at the roots of an irreducible cubic,
/// or of a quadratic and a rational place: given by (T - l^2)(T - m^2)(T - n^2) over the field.
/// A square that is not in Q belongs to an irrational exponent difference.
[[nodiscard]] ClosedAnswer riemann_answer(const Poly& squares);

/// Two regular places with exponent difference l and nothing else: y'' = (l^2-1)/(4 z^2) y.
/// Example describe(*euler_answer(Rational(1, 4)).group)  // -> cyclic of order 4 (diagonal)
[[nodiscard]] ClosedAnswer euler_answer(const NfElem& square);

/// The odd integers k > 0 with k = +-l +- m +- n for some signs, given e1, e2, e3 of the squares.
[[nodiscard]] std::vector<Integer> odd_relations(const NfElem& e1, const NfElem& e2,
                                                 const NfElem& e3);
/// The integers s >= 0 with s = +-l +- m for some signs, given l^2 + m^2 and l^2 m^2.
[[nodiscard]] std::vector<Integer> integer_sums(const NfElem& sum, const NfElem& product);

} // namespace kov
