#pragma once
// Greatest common divisors over number fields by Chinese remainders: plain Euclid squares the size
// of the coefficients at each division.

#include "exact/poly.hpp"

#include <optional>

namespace kov {

/// The monic gcd of a and b over their common number field K != Q, both not zero; nothing if K has
/// no completely split primes within reach (then Euclid decides). Source  Brown 1971, Langemyr &
/// McCallum 1989; the result divides a and b exactly and its degree is
///         an upper bound from a good prime, so it is the gcd, not a guess.
/// Cost    O~(n) residue operations per prime, as many primes as the coefficients of the gcd need.
[[nodiscard]] std::optional<Poly> modular_gcd(const Poly& a, const Poly& b);

/// a^-1 modulo q over their common number field K != Q, deg a < deg q; nothing if K has no
/// completely split primes within reach, or if a common factor of a and q is likely.  The result s
/// is checked by s a = 1 (mod q).
[[nodiscard]] std::optional<Poly> modular_inverse(const Poly& a, const Poly& q);

} // namespace kov
