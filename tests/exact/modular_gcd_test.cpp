#include "exact/modular_gcd.hpp"

#include "exact/fields.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

class ModularGcdLaws : public OverFields {};

TEST_P(ModularGcdLaws, TheGcdOfCoprimeMultiplesIsWhatWasPlanted) {
  if (k->is_rational()) return;
  for (int i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    const Poly g = monic_poly(number(0, 3));
    const Poly a = z() * z() + constant(43); // coprime to every z - c
    const Poly b = z() * scale(monic_poly(1), nonzero());
    const auto found = modular_gcd(a * g, b * g);
    ASSERT_TRUE(found); // completely split primes are within reach
    EXPECT_EQ(*found, g);
  }
}

// Coefficients that need several primes, and factors that make some of them unlucky.
TEST_P(ModularGcdLaws, LongCoefficients) {
  if (k->is_rational()) return;
  const NfElem large = NfElem(Rational(pow(Integer(10), 45) + Integer(9), pow(Integer(7), 30)));
  const Poly g = z() * z() + scale(z(), large * nonzero()) + Poly(large + element());
  const auto found = modular_gcd(g * (z() + constant(3)), g * (z() - constant(5)));
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, g);
}

TEST_P(ModularGcdLaws, InverseModulo) {
  if (k->is_rational()) return;
  for (int i = 0; i < 4; ++i) {
    const Poly q = monic_poly(3);
    const Poly a = scale(monic_poly(2), nonzero());
    const auto s = modular_inverse(a, q);
    EXPECT_EQ(s.has_value(), degree(gcd(a, q)) == 0);
    if (s) {
      EXPECT_TRUE(is_one((*s * a) % q));
      EXPECT_LT(degree(*s), degree(q));
    }
  }
  const Poly common = z() - Poly(nonzero());
  EXPECT_FALSE(modular_inverse(common * (z() + constant(2)), common * (z() * z() + constant(43))));
}

// Either argument may have rational coefficients and say so: the answer is over the larger field.
TEST_P(ModularGcdLaws, OneArgumentOverTheRationals) {
  if (k->is_rational()) return;
  const Poly rational = (Poly::z() - Poly(2)) * (Poly::z() * Poly::z() + Poly(43));
  const Poly common = z() - constant(2);
  const Poly other = common * (z() - Poly(NfElem::generator(k)) - constant(5));
  EXPECT_EQ(modular_gcd(rational, other), common);
  EXPECT_EQ(modular_gcd(other, rational), common);
  const Poly unit = z() - Poly(NfElem::generator(k)) - constant(5);
  const Poly square = Poly::z() * Poly::z() - Poly(6) * Poly::z() + Poly(9);
  const auto s = modular_inverse(unit, square);
  ASSERT_TRUE(s);
  EXPECT_TRUE(is_one((*s * unit) % square));
  const auto t = modular_inverse(Poly::z() - Poly(3), unit * unit);
  ASSERT_TRUE(t);
  EXPECT_TRUE(is_one((*t * (Poly::z() - Poly(3))) % (unit * unit)));
}

TEST_P(ModularGcdLaws, TheQuotientIsWhatWasPlanted) {
  if (k->is_rational()) return;
  for (int i = 0; i < 4; ++i) {
    const Poly b = scale(monic_poly(3), nonzero());
    const Poly q = monic_poly(number(0, 4));
    const ModularQuotient found = modular_quotient(q * b, b);
    EXPECT_EQ(found.divides, Truth::yes);
    EXPECT_EQ(found.quotient, q);
    EXPECT_EQ(modular_quotient(q * b + Poly(nonzero()), b).divides, Truth::no);
  }
  // long ones, as exact_div and divides ask for them
  const Poly b = pow(monic_poly(2), 12), q = pow(monic_poly(2), 11);
  EXPECT_EQ(exact_div(q * b, b), q);
  EXPECT_TRUE(divides(b, q * b));
  EXPECT_FALSE(divides(b, q * b + z()));
}

KOV_OVER_ALL_FIELDS(ModularGcdLaws);

TEST(ModularGcd, RefusesFieldsWithoutSplitPrimesInReach) {
  std::vector<Integer> m(8); // x^7 - 2: one prime in 42 splits, but not asked for
  m[0] = -2;
  m[7] = 1;
  const Field k = make_field(m, "a");
  const Poly line = Poly::z() - Poly(NfElem::generator(k));
  const Poly f = line * (Poly::z() + Poly(1));
  EXPECT_FALSE(modular_gcd(f, line * Poly::z()));
  EXPECT_EQ(gcd(f * (Poly::z() - Poly(3)), line * Poly::z() * (Poly::z() - Poly(4))), line);
  EXPECT_TRUE(is_one((inverse_mod(line, pow(Poly::z(), 3)) * line) % pow(Poly::z(), 3)));
}

} // namespace
} // namespace kov
