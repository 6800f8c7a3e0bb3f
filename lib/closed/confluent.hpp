#pragma once
// Equations with one irregular place and at most one regular one:
//
//   Whittaker   y'' = (1/4 - k/x + (m^2 - 1/4)/x^2) y       Bessel is k = 0: order m
//   Bessel      y'' = (b/x + (m^2 - 1)/(4 x^2)) y, b != 0   order m in the variable sqrt(x)
//   Weber       y'' = (x^2 + a) y                           Airy  y'' = x y
//
// The identity component contains a torus, so that it is abelian only for Gm and Dinf.
//
// Source  [MartinetRamis1989] 3.3 (Whittaker); docs/theory/confluent.md

#include "closed/closed_answer.hpp"
#include "exact/number_field.hpp"

namespace kov {

/// Reducible <=> some +-k +- m is in 1/2 + N; diagonal <=> of k + m - 1/2 and k - m - 1/2 one is
/// in {0, 1, 2, ...} and the other in {-1, -2, ...}.  Given k^2 and m^2.
/// Example whittaker_answer(0, Rational(1, 4)).group->type  // -> Gm
/// Example whittaker_answer(0, Rational(1, 9)).group->type  // -> SL2
[[nodiscard]] ClosedAnswer whittaker_answer(const NfElem& k_squared, const NfElem& m_squared);
/// y'' = (b/x + (m^2-1)/(4x^2)) y, b != 0: Dinf <=> m in 1/2 + Z, else SL2.  Given m^2.
[[nodiscard]] ClosedAnswer ramified_bessel_answer(const NfElem& m_squared);
/// Borel <=> a is an odd integer, else SL2.  Given a^2.
/// Example weber_answer(9).group->type  // -> Borel
[[nodiscard]] ClosedAnswer weber_answer(const NfElem& a_squared);
/// y'' = r y with r a polynomial of this degree >= 3: not abelian.  Odd degree: SL2.
[[nodiscard]] ClosedAnswer polynomial_answer(long degree);
/// y'' = c y with c != 0.
[[nodiscard]] ClosedAnswer constant_answer();
/// y'' = x y.
[[nodiscard]] ClosedAnswer airy_answer();

} // namespace kov
