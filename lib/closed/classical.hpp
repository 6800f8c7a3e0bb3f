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

/// The canonical equation, in x.  ramified: Bessel's with a place of odd order at infinity.
/// Example canonical_equation(Classical::airy)  // -> y'' = a x y
[[nodiscard]] constexpr const char* canonical_equation(Classical c,
                                                       bool ramified = false) noexcept {
  switch (c) {
  case Classical::constant:
    return "y'' = c y";
  case Classical::airy:
    return "y'' = a x y";
  case Classical::weber:
    return "y'' = (u x^2 + w) y, a = w/sqrt(u)";
  case Classical::polynomial:
    return "y'' = r(x) y";
  case Classical::euler:
    return "y'' = (l^2-1)/(4*x^2) y";
  case Classical::bessel:
    return ramified ? "y'' = (b/x + (m^2-1)/(4*x^2)) y, Bessel's equation of order m in sqrt(x)"
                    : "y'' = (a + (m^2-1/4)/x^2) y";
  case Classical::whittaker:
    return "y'' = (a + b/x + (m^2-1/4)/x^2) y, k = -b/(2*sqrt(a))";
  case Classical::riemann:
    return "y'' = ((l^2-1)/(4*x^2) + (m^2-1)/(4*(x-1)^2) + (1-l^2-m^2+n^2)/(4*x*(x-1))) y";
  case Classical::lame:
    return "y_tt = (n(n+1) wp(t; g2, g3) + B) y, x = wp(t)";
  case Classical::heun:
    return "four regular places and nothing else";
  }
  return "";
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
