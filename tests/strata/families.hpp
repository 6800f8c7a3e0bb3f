#pragma once
// Equations with parameters of many types: each classical family, and what belongs to none.

#include "exact/multivariate.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace kov::test {

inline const Ring family_ring = make_ring({"z", "a", "b", "n"});

struct Family {
  const char* name;
  MFraction r;
};
inline void PrintTo(const Family& f, std::ostream* out) { *out << f.name; }

inline std::vector<Family> families() {
  const auto variable = [](const char* name) { return MFraction::variable(family_ring, name); };
  const auto number = [](long p, long q = 1) { return MFraction(family_ring, Rational(p, q)); };
  // the term (d^2 - 1)/4 with exponent difference d at a pole
  const auto of_difference = [&](const MFraction& d) { return (d * d - number(1)) / number(4); };
  const MFraction z = variable("z"), a = variable("a"), b = variable("b"), n = variable("n");
  const MFraction one = number(1);
  const MFraction riemann =
      of_difference(a) / (z * z) + of_difference(b) / ((z - one) * (z - one)) +
      (of_difference(n) - of_difference(a) - of_difference(b)) / (z * (z - one));
  const MFraction cubic = number(4) * z * z * z - a * z - b;
  const MFraction slope = number(12) * z * z - a;
  return {
      {"Bessel", -one + (n * n - number(1, 4)) / (z * z)},
      {"Whittaker", number(1, 4) - a / z + (b * b - number(1, 4)) / (z * z)},
      {"Weber", z * z + a},
      {"Airy", a * z + b},
      {"Constant", a},
      {"Euler", of_difference(n) / (z * z)},
      {"Riemann", riemann},
      {"Quartic", z * z * z * z + a * z + b},
      {"QuarticWithOddLength", z * z * z + a * z},
      {"Lame", (n * (n + one) * z + b) / cubic - number(3, 16) * slope * slope / (cubic * cubic) +
                   number(12) * z / (number(2) * cubic)},
      {"IrrationalDifference", a / ((z * z + one) * (z * z + one)) + b / (z * z)},
      {"ManyPoles", a / (z * z) + b / ((z - one) * (z - one)) + n / ((z + one) * (z + one))},
      {"PoleOfOrderFour", a / (z * z * z * z) + b / (z * z) + n},
      {"Logarithm", of_difference(number(2)) / (z * z) + a / z + b},
      {"PulledBack", number(4) * z * z * (-one + (n * n - number(1, 4)) / (z * z * z * z)) +
                         number(3, 4) / (z * z)},
      {"TwoIrregularPlaces", a / (z * z * z) + b / z + one},
      {"Reducible", a * a + a / z},
      {"Dihedral",
       -number(3, 16) / (z * z) - number(3, 16) / ((z - one) * (z - one)) + a / (z * (z - one))},
  };
}

} // namespace kov::test
