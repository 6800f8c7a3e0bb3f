#include "riccati/exponential.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov {
namespace {

const Poly z = Poly::z();

RationalFunction riccati(const RationalFunction& w) { return derivative(w) + w * w; }

void expect_found(const RationalFunction& omega) {
  const auto found = exponential_solutions(singularities(riccati(omega)));
  ASSERT_EQ(found.solutions.size(), 1U) << to_string(omega);
  EXPECT_EQ(found.solutions[0].omega(), omega);
}

TEST(Exponential, AiryHasNone) {
  const auto found = exponential_solutions(singularities(RationalFunction(z)));
  ASSERT_TRUE(found.none);
  EXPECT_TRUE(found.none->obstruction.has_value());
}

TEST(Exponential, WeberHasOne) { // x^2 + 1: exp(x^2/2)
  expect_found(RationalFunction(z));
  expect_found(RationalFunction(z * z + Poly(1), z)); // x^2 + 3
}

TEST(Exponential, WeberWithGenericConstantHasNone) {
  const auto found = exponential_solutions(singularities(RationalFunction(z * z + Poly(2))));
  EXPECT_TRUE(found.solutions.empty());
  EXPECT_TRUE(found.none);
}

TEST(Exponential, IrregularInfinityOfHighOrder) { // docs/theory/riccati_one_place.md
  expect_found(RationalFunction(pow(z, 30)) + RationalFunction(Poly(1), scale(z, NfElem(3))));
}

TEST(Exponential, FinitePlacesOfEveryKind) {
  expect_found(RationalFunction(Poly(2), pow(z, 3)) - RationalFunction(Poly(1), z * z) +
               RationalFunction(Poly(3), z) + RationalFunction(scale(z, NfElem(5))));
  expect_found(RationalFunction(Poly(1), z * z) +
               RationalFunction(Poly(Rational(1, 3)), z - Poly(1)));
}

TEST(Exponential, ConjugatePoles) { // pitfall 39: q = x^3 - 2, omega = q'/(3q) is the only one
  const Poly q = pow(z, 3) - Poly(2);
  expect_found(RationalFunction(derivative(q), scale(q, NfElem(3))));
}

TEST(Exponential, ManyRationalPoles) {
  std::mt19937 gen(5);
  RationalFunction w;
  for (long i = 0; i < 24; ++i)
    w += RationalFunction(Poly(Rational(static_cast<long>(gen() % 40) - 20, 7)), z - Poly(i));
  expect_found(w);
}

TEST(Exponential, PolynomialPart) { // Hermite of degree 12 times exp(-x^2/2)
  const auto found = exponential_solutions(singularities(RationalFunction(z * z - Poly(25))));
  ASSERT_EQ(found.solutions.size(), 1U);
  EXPECT_EQ(degree(found.solutions[0].omega().den()), 12);
}

// The primes that are used are those above 2^60; modulo the first one these coefficients vanish.
const Integer first_prime = Integer::parse("1152921504606859327");

TEST(Exponential, TwoLinesModuloAPrimeAreAnAccident) {
  const RationalFunction third(Poly(Rational(1, 3)), z);
  const Poly p{NfElem(Rational(first_prime))};
  for (const RationalFunction& growth : {RationalFunction(p), RationalFunction(p * z)})
    expect_found(third + growth);
}

TEST(Exponential, OneLineModuloAPrimeIsAnAccident) {
  const RationalFunction w = RationalFunction(Poly(Rational(1, 3)), z) +
                             RationalFunction(Poly(Rational(1, 5)), z - Poly(1)) +
                             RationalFunction(Poly(1));
  const RationalFunction r =
      riccati(w) + RationalFunction(Poly(NfElem(Rational(first_prime))), z * (z - Poly(1)));
  EXPECT_TRUE(exponential_solutions(singularities(r)).none.has_value());
}

TEST(Exponential, OverTheGaussianNumbers) {
  const Field k = make_field({1, 0, 1}, "I");
  const Poly i(NfElem::generator(k));
  expect_found(RationalFunction(i, z * z) + RationalFunction(Poly(Rational(1, 3)), z - i));
}

TEST(Exponential, SurdsInResidueFields) { // alpha = sqrt(2) at one place, so no lift by inspection
  const Field k = make_field({-2, 0, 1}, "s");
  const Poly s(NfElem::generator(k));
  expect_found(RationalFunction(s, z) +
               RationalFunction(Poly(1), z - s) * RationalFunction(Rational(1, 5)) +
               RationalFunction(Poly(1)));
}

} // namespace
} // namespace kov
