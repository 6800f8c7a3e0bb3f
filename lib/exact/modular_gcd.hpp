#pragma once
// Greatest common divisors over number fields by Chinese remainders: plain Euclid squares the size
// of the coefficients at each division.

#include "exact/poly.hpp"
#include "exact/truth.hpp"

#include <functional>
#include <optional>

namespace kov {

/// The monic gcd of a and b over their common number field K != Q, both not zero; nothing if K has
/// no completely split primes within reach (then Euclid decides).  The result divides a and b
/// exactly and its degree is an upper bound from a good prime, so it is the gcd, not a guess.
///
/// Source  Brown 1971, Langemyr & McCallum 1989
/// Cost    O~(n) residue operations per prime, as many primes as the coefficients of the gcd need
/// Given   const Field k = make_field({-2, 0, 1}, "s");
/// Given   const Poly s(NfElem::generator(k));
/// Example modular_gcd(coerce(z*z - 2, k), (z - s) * (z + 1))  // -> z - s
[[nodiscard]] std::optional<Poly> modular_gcd(const Poly& a, const Poly& b);
/// The same with another proof than two divisions: `proved` is asked about each proposal.
[[nodiscard]] std::optional<Poly> modular_gcd(const Poly& a, const Poly& b,
                                              const std::function<bool(const Poly&)>& proved);

/// a^-1 modulo q over their common number field K != Q, deg a < deg q; nothing if K has no
/// completely split primes within reach, or if a common factor of a and q is likely.  The result s
/// is checked by s a = 1 (mod q).
/// Example modular_inverse(s, (z - s) * (z + 1))  // -> 1/2*s
[[nodiscard]] std::optional<Poly> modular_inverse(const Poly& a, const Poly& q);

/// Is a = q b, and what is q?
struct ModularQuotient {
  Truth divides = Truth::unknown; ///< no: one prime shows it
  Poly quotient = Poly(0);        ///< yes: a = quotient * b has been compared
};
/// Nothing is known for large fields.  Requires b != 0.
/// Cost    that of writing q down, times its logarithm; a division in K[z] goes through coefficients
///         that are far larger
/// Example modular_quotient(z*z - 1, z - 1).quotient  // -> z + 1
[[nodiscard]] ModularQuotient modular_quotient(const Poly& a, const Poly& b);

} // namespace kov
