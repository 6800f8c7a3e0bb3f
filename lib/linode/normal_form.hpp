#pragma once
// Second-order linear equations over K(z) and their normal form.
//
//   y'' + p y' + q y = 0,   y = u exp(-1/2 int p)   =>   u'' = r u,   r = p^2/4 + p'/2 - q.
//
// The factor removed multiplies the Galois group by scalars only, so that the identity component is
// abelian for the one equation exactly when it is for the other (docs/theory/normal_form.md, 1.5).

#include "exact/rational_function.hpp"

namespace kov {

/// y'' = r y, with the p of the equation that it came from (0 if it was given in this form).
struct NormalForm {
  RationalFunction r;
  RationalFunction p; ///< the factor removed is exp(-1/2 int p)
};

/// Source  [Kovacic1986] §1.1; docs/theory/normal_form.md, 1.5
/// Example normal_form(RationalFunction(1, z), 1 - RationalFunction(1, 4*z*z)).r  // -> -1
[[nodiscard]] NormalForm normal_form(const RationalFunction& p, const RationalFunction& q);

} // namespace kov
