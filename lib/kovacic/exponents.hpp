#pragma once
// Step 1: what a solution can look like at one place.
//
// Two kinds of functions are looked for, and both are products
//
//   P * prod_q q^(e_q) * (exponential part),   P a polynomial.
//
// Case 1.  y itself: at a finite place y = t^alpha (1 + ...) exp(int s [sqrt r]), alpha one of
//   (1 +- Delta)/2 (regular) or (nu +- eps)/2 (irregular, with s = +-1); at infinity the growth
//   exponents (1 +- Delta)/2, 0 or (+-eps - nu)/2.
// Cases 2 and 3.  v, a product of m solutions (m = 2, 4, 6, 12), with v^N in K(z), N = 2, 3, 2, 1:
//   the exponents m/2 + k Delta, |k| <= m/2.  The paper writes e_c = (12/m)(m/2 + k Delta), and
//   for m = 2 e_c = 2(1 + k Delta): here the exponent of v itself is used.
//
// Logarithms sharpen the sets (docs/theory/local_exponents.md 2.1, 3.1): where the local solutions have one, only powers of the
// log-free solution are left.  Exponents that differ by integers belong to *one* class: the least
// (at infinity the greatest) of them stands for all, because P may vanish at the place.
// docs/theory/descent.md (4).

#include "linode/singularities.hpp"

#include <string>
#include <vector>

namespace kov::kovacic {

/// Case 1: one class of local forms of y at a place.
struct LocalForm {
  Poly exponent; ///< in K[c]/q; growth exponent at infinity
  Poly root;     ///< irregular: a = sign * sqrt(leading) in K[c]/q, else 0
};

/// The classes at a place that an exponential solution with y'/y in K(z) can have; empty when
/// there is none (ramified, or Delta or sqrt(leading) is not in the residue field).
/// Source  [Kovacic1986] §3.1 step 1; docs/theory/descent.md (5)
/// Throws  OutOfBudget
/// Example local_forms(singularities(z*z + 3).infinity, {})  // -> {{1, 1}, {-2, -1}}
[[nodiscard]] std::vector<LocalForm> local_forms(const Singularity& place, const Budget& budget);

/// All exponents of v that the place admits, ascending: m/2 + k Delta, or the one log-free value,
/// or m*order/4 where the place is irregular.  No condition of integrality yet.
/// Requires m even, m >= 2
/// Source   [Kovacic1986] §4.1, §5.1 step 1; docs/theory/local_exponents.md 2, 3
/// Example  exponents(singularities(RationalFunction(2, z*z)).finite.front(), 2)
///          // -> {-2, 1, 4}
[[nodiscard]] std::vector<Rational> exponents(const Singularity& place, long m);

/// The members of `exponents` with N * exponent an integer, one for each class modulo Z: the least of the
/// class, at infinity the greatest.
/// Example classes(singularities(RationalFunction(2, z*z)).finite.front(), 2, 2)  // -> {-2}
[[nodiscard]] std::vector<Rational> classes(const Singularity& place, long m, long N);

/// The set as the paper writes it, "{2, 3, 1}": `scale` times those exponents that times N are
/// integers.
[[nodiscard]] std::string exponent_set_text(const Singularity& place, long m, long N, long scale);

} // namespace kov::kovacic
