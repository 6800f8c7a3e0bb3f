#pragma once
// How large the coefficients of first integrals may have to be.

#include "system/system.hpp"

namespace kov {

/// For integrals of this degree in the momenta of a system p.Gp/2 + V(q) with a rational V that grows like
/// q^m: they contain terms like V^(degree/2).  Unset: V has no denominator, or `degree` itself is enough,
/// or more than `most` would be needed.
[[nodiscard]] std::optional<long> larger_coefficients(const System& s, long degree, long most);

} // namespace kov
