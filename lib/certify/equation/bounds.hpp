#pragma once
// Rational upper bounds for real parts of square roots (local_exponents.md, section 4).

#include "exact/poly.hpp"

namespace kov::certify {

/// The least j/k, j >= 0, with (j/k)^2 >= x.
[[nodiscard]] Rational root_above(const Rational& x, const Integer& k);
/// A rational number >= Re sqrt(x): exact if x is a square or x <= 0, else within 2^-32 / den(x).
[[nodiscard]] inline Rational root_above(const Rational& x) {
  return root_above(x, x.den() * pow(Integer(2), 32));
}

/// B >= |T| for every complex root T of chi in Q[T], by Cauchy's criterion |c_n| B^n >= sum |c_i|
/// B^i.
[[nodiscard]] Rational root_bound(const Poly& chi);

} // namespace kov::certify
