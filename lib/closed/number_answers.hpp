#pragma once
// The classical criteria (criterion.hpp) asked with numbers, which are given by their squares.

#include "closed/closed_answer.hpp"
#include "closed/riemann.hpp"

namespace kov {

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

/// y'' = (1/4 - k/x + (m^2 - 1/4)/x^2) y; Bessel's equation is k = 0.
/// Example whittaker_answer(0, Rational(1, 4)).group->type  // -> Gm
/// Example whittaker_answer(0, Rational(1, 9)).group->type  // -> SL2
[[nodiscard]] ClosedAnswer whittaker_answer(const NfElem& k_squared, const NfElem& m_squared);
/// y'' = (b/x + (m^2-1)/(4x^2)) y, b != 0: Bessel's equation of order m in sqrt(x).
[[nodiscard]] ClosedAnswer ramified_bessel_answer(const NfElem& m_squared);
/// y'' = r y, r a polynomial, not 0.
/// Example polynomial_answer(z * z + 3).group->type  // -> Borel
[[nodiscard]] ClosedAnswer polynomial_answer(const Poly& r);

} // namespace kov
