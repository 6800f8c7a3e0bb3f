#pragma once
// The classical equations y'' = r(x) y that have a name.

#include <algorithm>
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
  mathieu,
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

/// One of them in words; a new family is a row here.
struct ClassicalWords {
  Classical family = Classical::constant;
  const char* name = "";     ///< in JSON and in sentences
  const char* known_as = ""; ///< "" where the canonical equation says more than a name
  const char* equation = ""; ///< canonical, in x
  const char* sl2 = nullptr; ///< set where the group is SL(2, C) for all its numbers: why
};
inline constexpr ClassicalWords classical_words[] = {
    {Classical::constant, "constant", "", "y'' = c y"},
    {Classical::airy, "Airy", "Airy's equation", "y'' = a x y", "Airy's equation"},
    {Classical::weber, "Weber", "Weber's equation", "y'' = (u x^2 + w) y, a = w/sqrt(u)"},
    {Classical::polynomial, "polynomial", "", "y'' = r(x) y"},
    {Classical::euler, "Euler", "Euler's equation", "y'' = (l^2-1)/(4*x^2) y"},
    {Classical::bessel, "Bessel", "Bessel's equation", "y'' = (a + (m^2-1/4)/x^2) y"},
    {Classical::whittaker, "Whittaker", "Whittaker's equation",
     "y'' = (a + b/x + (m^2-1/4)/x^2) y, k = -b/(2*sqrt(a))"},
    {Classical::mathieu, "Mathieu", "Mathieu's equation",
     "y_tt = (2*q*cos(2*t) - a) y, x/cos(2*t) constant",
     "q is not 0, and Mathieu's equation has no Liouvillian solution then"},
    {Classical::riemann, "Riemann", "Riemann's (hypergeometric) equation",
     "y'' = ((l^2-1)/(4*x^2) + (m^2-1)/(4*(x-1)^2) + (1-l^2-m^2+n^2)/(4*x*(x-1))) y"},
    {Classical::lame, "Lame", "Lame's equation", "y_tt = (n(n+1) wp(t; g2, g3) + B) y, x = wp(t)"},
    {Classical::heun, "Heun", "Heun's equation", "four regular places and nothing else"},
};
/// Example std::string(words_of(Classical::lame).known_as)  // -> Lame's equation
[[nodiscard]] constexpr const ClassicalWords& words_of(Classical c) noexcept {
  return *std::ranges::find(classical_words, c, &ClassicalWords::family);
}

/// The canonical equation, in x.  ramified: Bessel's with a place of odd order at infinity.
/// Example canonical_equation(Classical::airy)  // -> y'' = a x y
[[nodiscard]] constexpr const char* canonical_equation(Classical c,
                                                       bool ramified = false) noexcept {
  if (ramified) return "y'' = (b/x + (m^2-1)/(4*x^2)) y, Bessel's equation of order m in sqrt(x)";
  return words_of(c).equation;
}

/// Example to_string(Classical::bessel)  // -> Bessel
[[nodiscard]] constexpr const char* to_string(Classical c) noexcept { return words_of(c).name; }

} // namespace kov
