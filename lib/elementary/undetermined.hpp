#pragma once
// Undetermined coefficients: one solution of a linear equation with rational coefficients.

#include "elementary/element.hpp"

#include <optional>
#include <vector>

namespace kov::elementary {

/// y with c[0] y + c[1] y' + ... = f, where each monomial of f has exponentials, angles and logarithms with rational
/// derivatives: rational functions of bounded degree times these, and times logarithms of the singular places.
/// Nothing: there is none of this form.  c: rational functions of x.
/// Given   const auto letters = std::make_shared<Letters>("x", std::vector<std::string>{});
/// Given   const MFraction one = letters->number(1), zero = letters->number(0);
/// Given   const Element t(letters, letters->variable_value());
/// Example text(*undetermined({one, zero, one}, exp(t)))  // -> exp(x)/2
[[nodiscard]] std::optional<Element> undetermined(const std::vector<MFraction>& c,
                                                  const Element& f);

/// Have all its functions rational derivatives (no 1/u, no integrals)?
[[nodiscard]] bool has_rational_derivatives(const Monomial& m);

} // namespace kov::elementary
