// The second exponential solution, by equations that are made from their lines.

#include "riccati/second_line.hpp"

#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using testing::from_omega;

const Poly z = Poly::z();

RationalFunction pole(const Rational& a, long c) { return {Poly(a), z - Poly(c)}; }

std::optional<RationalFunction> second(const RationalFunction& omega) {
  return product_with_second_line({omega, Poly(1)}, singularities(from_omega(omega)));
}

// With v = y1 y2 and Wronskian 1 the two lines are omega = (v' +- 1)/(2v).
TEST(SecondLine, TheProductIsFoundFromEitherLine) {
  const RationalFunction products[] = {
      RationalFunction(z * z - Poly(2)), // over Q(sqrt 2) its exponents are irrational
      RationalFunction(scale(z * (z - Poly(1)), NfElem(3))),
      RationalFunction(scale(z * (z - Poly(1)), NfElem(Rational(5, 7)))),
      RationalFunction(Poly(1), z),
      RationalFunction(z * z * z + z + Poly(1), (z - Poly(1)) * (z - Poly(1))),
      RationalFunction(pow(z, 5), (z - Poly(2)) * (z * z + Poly(1)))};
  for (const RationalFunction& v : products)
    for (const long sign : {1, -1}) {
      SCOPED_TRACE(to_string(v) + ", sign " + std::to_string(sign));
      const RationalFunction omega =
          (derivative(v) + RationalFunction(sign)) / (RationalFunction(2) * v);
      const auto found = second(omega);
      ASSERT_TRUE(found);
      EXPECT_EQ(*found, RationalFunction(-sign) * v);
    }
}

TEST(SecondLine, ARadicalOfManyPolesIsAlone) {
  for (const long k : {1L, 1000L, 1000000000L}) {
    const Rational large(3 * k + 1, 3);
    EXPECT_FALSE(second(pole(large, 0) + pole(large, 1) + pole(Rational(1, 5), 2))) << k;
    EXPECT_FALSE(second(pole(large, 0) + pole(Rational(1, 2) - large, 1) + RationalFunction(z)))
        << k;
  }
}

// z^(a+1) e^z and its like: the solutions of v' = 2 omega v + 1 have no pole and no zero to spare.
TEST(SecondLine, AnIrregularPlaceMayLeaveOneLineOrTwo) {
  EXPECT_TRUE(second(RationalFunction(1)));                                // e^z, e^-z
  EXPECT_TRUE(second(RationalFunction(1) - RationalFunction(Poly(1), z))); // e^z/z has a partner
  EXPECT_FALSE(second(RationalFunction(z)));
  EXPECT_FALSE(second(RationalFunction(1) + pole(Rational(1, 3), 0)));
}

TEST(SecondLine, ALogarithmExcludesIt) {
  EXPECT_FALSE(second(pole(Rational(1, 2), 0) + pole(Rational(1, 3), 1)));
}

} // namespace
} // namespace kov
