#pragma once
// Factorisation in K[z]: squarefree parts, and irreducible factors by norms (Trager 1976) over
// Q(a).

#include "exact/budget.hpp"
#include "exact/poly.hpp"

#include <vector>

namespace kov {

/// base^exponent.
struct Factor {
  Poly base; ///< monic
  long exponent = 1;
};

/// Yun's algorithm: f = lead(f) * prod base^exponent, bases squarefree and pairwise coprime,
/// exponents increasing.  Requires f != 0.
/// Example squarefree_factors(pow(z, 3) - z*z)  // -> {{z - 1, 1}, {z, 2}}
[[nodiscard]] std::vector<Factor> squarefree_factors(const Poly& f);

/// Irreducible factors over the field of f, sorted by (exponent, degree, coefficients).
/// Cost  rational roots are split off first (linear in their number), then FLINT's van Hoeij; over
///       Q(a) one factorisation over Q of degree [K:Q] deg f.
/// Throws OutOfBudget; requires f != 0
/// Example irreducible_factors(pow(z, 4) - 1)  // -> {{z - 1, 1}, {z + 1, 1}, {z^2 + 1, 1}}
/// Given   const Field gauss = make_field({1, 0, 1}, "I");
/// Example irreducible_factors(coerce(z*z + 1, gauss))  // -> {{z - I, 1}, {z + I, 1}}
[[nodiscard]] std::vector<Factor> irreducible_factors(const Poly& f, const Budget& budget = {});

/// The product of a list, by a balanced tree: far cheaper than one factor after the other.
[[nodiscard]] Poly product(std::vector<Poly> factors);

/// No factor of positive degree occurs twice; yes for constants.  Cost: first one prime.
[[nodiscard]] bool is_squarefree(const Poly& f);

} // namespace kov
