#pragma once
// Random polynomials and fractions in x, y, z over the parameter a, for the multivariate suites.

#include "exact/fields.hpp"
#include "exact/multivariate.hpp"

namespace kov {

inline void PrintTo(const MPoly& f, std::ostream* out) { *out << to_string(f); }
inline void PrintTo(const MFraction& f, std::ostream* out) { *out << to_string(f); }

} // namespace kov

namespace kov::testing {

class Polynomials : public ::testing::Test {
protected:
  Ring ring = make_ring({"x", "y", "z", "a"});
  test::Random random = choices(50);
  MFraction x = MFraction::variable(ring, "x");
  MFraction y = MFraction::variable(ring, "y");
  MFraction z = MFraction::variable(ring, "z");
  MFraction a = MFraction::variable(ring, "a");
  MFraction one = MFraction(ring, Rational(1));

  [[nodiscard]] long number(long low, long high) { return random.between(low, high); }
  [[nodiscard]] unsigned long exponent(unsigned long high) {
    return static_cast<unsigned long>(number(0, static_cast<long>(high)));
  }
  /// Up to `terms` terms, exponents at most e.
  [[nodiscard]] MPoly poly(int terms = 4, unsigned long e = 2) {
    MPoly f(ring);
    for (int i = 0; i < terms; ++i)
      f += MPoly::term(ring, Integer(number(-6, 6)),
                       {exponent(e), exponent(e), exponent(e), exponent(1)});
    return f;
  }
  [[nodiscard]] MPoly nonzero(int terms = 4, unsigned long e = 2) {
    while (true)
      if (MPoly f = poly(terms, e); !is_zero(f)) return f;
  }
  [[nodiscard]] MFraction fraction() { return {poly(3, 1), nonzero(3, 1)}; }
  [[nodiscard]] MPoly number_poly(long n) const { return MPoly(ring, Integer(n)); }
};

} // namespace kov::testing
