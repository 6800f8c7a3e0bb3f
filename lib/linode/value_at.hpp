#pragma once
// Values of a rational function at places.

#include "exact/rational_function.hpp"

#include <optional>

namespace kov {

/// The value of f at the roots of q, where it is one number.
/// Example value_at(RationalFunction(z*z + 1, z), z*z - 4)  // -> none
/// Example value_at(RationalFunction(z*z + 1), z*z - 4)  // -> 5
[[nodiscard]] inline std::optional<NfElem> value_at(const RationalFunction& f, const Poly& q) {
  if (degree(gcd(f.den(), q)) > 0) return std::nullopt;
  const Poly value = f.num() * inverse_mod(f.den() % q, q) % q;
  return degree(value) > 0 ? std::nullopt : std::optional(value.coeff(0));
}

/// Example value_at_infinity(RationalFunction(z, 2*z + 1))  // -> 1/2
[[nodiscard]] inline std::optional<NfElem> value_at_infinity(const RationalFunction& f) {
  const long grows = degree(f.num()) - degree(f.den());
  if (grows > 0) return std::nullopt;
  return grows < 0 ? NfElem(0) : lead(f.num()) / lead(f.den());
}

} // namespace kov
