#pragma once
// Rational upper bounds for real parts of square roots (local_exponents.md, section 4).

#include "exact/poly.hpp"

namespace kov::certify {

/// A rational number >= Re sqrt(x): exact if x is a square or x <= 0, else within 2^-32 / den(x).
[[nodiscard]] Rational sqrt_above(const Rational& x);

/// B >= |T| for every complex root T of chi in Q[T], by Cauchy's criterion |c_n| B^n >= sum |c_i|
/// B^i.
[[nodiscard]] Rational root_bound(const Poly& chi);

} // namespace kov::certify
