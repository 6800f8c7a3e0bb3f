#pragma once
// Is there a logarithm at a regular singular place whose exponent difference is a natural number N?
//
// With r = B(t)/(t^2 A(t)) the ansatz y = t^((1-N)/2) sum u_k t^k gives, for k >= 1,
//
//   A_0 k (k - N) u_k = sum_{j>=1} (B_j - A_j ((2(k-j) - N)^2 - 1)/4) u_{k-j},
//
// and there is no logarithm exactly when the right side vanishes at k = N (N >= 1); for N = 0 there
// always is one.  docs/theory/local_exponents.md

#include "exact/budget.hpp"
#include "exact/truth.hpp"
#include "linode/residue_series.hpp"

namespace kov {

/// Shape   num, den: r = num/den in lowest terms near the place q (monic irreducible), den having
///         order exactly 2 there; N >= 0 the exponent difference
/// Unknown when one prime finds no logarithm and N is too large to ask exactly (N deg q > 4000), or
///         when N is above the degree limit of the budget
/// Cost    O(N deg r) operations modulo q, first modulo one prime: a nonzero value there proves a
///         logarithm at once.
/// Example has_logarithm(2, z*z, z, 3)  // -> Truth::no
/// Example has_logarithm(2 + z, z*z, z, 3)  // -> Truth::yes
[[nodiscard]] Truth has_logarithm(const Poly& num, const Poly& den, const Poly& q, long N,
                                  const Budget& budget = {});

} // namespace kov
