#pragma once
// Is v a solution of the m-th symmetric power of y'' = r y?  Decided without ever forming that
// operator: L_0 = 1, L_1 = D, L_(i+1) = D L_i - i(m-i+1) r L_(i-1), Sym^m = L_(m+1)  (Bronstein,
// Mulders, Weil 1997).

#include "invariant/invariant.hpp"

namespace kov {

/// Cost  m+1 derivations of polynomials of degree <= deg P + (m+1) deg prod q^(order/2)
/// Example solves_symmetric_power({2, 1, {}}, singularities(1))  // -> yes
/// Example solves_symmetric_power({2, z, {}}, singularities(1))  // -> no
[[nodiscard]] bool solves_symmetric_power(const Invariant& v, const Singularities& s);

} // namespace kov
