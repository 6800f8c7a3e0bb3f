#pragma once
// The classical equations y'' = r(x) y that have a name.

#include <cstdint>

namespace kov {

/// constant: y'' = c y;  polynomial: r is a polynomial of degree > 2.
enum class Classical : std::uint8_t {
  constant,
  airy,
  weber,
  polynomial,
  euler,
  bessel,
  whittaker,
  riemann,
  lame,
  heun,
};

/// y'' = r(x) y, r a polynomial of this degree.
/// Example to_string(polynomial_family(2))  // -> Weber
[[nodiscard]] constexpr Classical polynomial_family(long degree) noexcept {
  if (degree == 0) return Classical::constant;
  return degree == 1 ? Classical::airy : degree == 2 ? Classical::weber : Classical::polynomial;
}

/// Example to_string(Classical::bessel)  // -> Bessel
[[nodiscard]] constexpr const char* to_string(Classical c) noexcept {
  switch (c) {
  case Classical::constant:
    return "constant";
  case Classical::airy:
    return "Airy";
  case Classical::weber:
    return "Weber";
  case Classical::polynomial:
    return "polynomial";
  case Classical::euler:
    return "Euler";
  case Classical::bessel:
    return "Bessel";
  case Classical::whittaker:
    return "Whittaker";
  case Classical::riemann:
    return "Riemann";
  case Classical::lame:
    return "Lame";
  case Classical::heun:
    return "Heun";
  }
  return "";
}

} // namespace kov
