#include "exact/factor.hpp"
#include "exact/modular.hpp"
#include "exact/rational_function.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov {
namespace {

Field sqrt_field(long n, const char* name) { return make_field({Integer(-n), 0, 1}, name); }

Poly random_poly(std::mt19937& gen, const Field& k, int max_degree) {
  std::uniform_int_distribution<int> coefficient(-9, 9);
  std::uniform_int_distribution<int> deg(0, max_degree);
  std::vector<NfElem> c;
  for (int i = deg(gen); i >= 0; --i) {
    NfElem e(k);
    for (long j = 0; j < k->degree(); ++j)
      e += pow(NfElem::generator(k), static_cast<unsigned long>(j)) *
           NfElem(Rational(coefficient(gen), 1 + std::abs(coefficient(gen))));
    c.push_back(k->degree() == 1 ? NfElem(Rational(coefficient(gen), 3)) : e);
  }
  return Poly::from_coefficients(c);
}

class PolyOver : public testing::TestWithParam<int> {
protected:
  Field field() const {
    switch (GetParam()) {
    case 0:
      return rationals();
    case 1:
      return sqrt_field(-1, "I");
    case 2:
      return sqrt_field(2, "s");
    case 3:
      return make_field({1, 1, 0, 1}, "a"); // group S_3: one prime in six splits
    default:
      return make_field({1, 0, 0, 0, 1}, "a"); // Q(i, sqrt 2)
    }
  }
};

TEST_P(PolyOver, RingAndDivisionIdentities) {
  const Field k = field();
  std::mt19937 gen(12345);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const Poly a = random_poly(gen, k, 8);
    const Poly b = random_poly(gen, k, 5);
    const Poly c = random_poly(gen, k, 5);
    EXPECT_EQ((a + b) * c, a * c + b * c);
    EXPECT_EQ(derivative(a * b), derivative(a) * b + a * derivative(b));
    if (is_zero(b)) continue;
    const auto [q, r] = divrem(a, b);
    EXPECT_EQ(q * b + r, a);
    EXPECT_LT(degree(r), std::max(degree(b), 1L));
    if (is_zero(a) || is_zero(c)) continue;
    EXPECT_TRUE(divides(monic(c), gcd(a * c, b * c)));
    EXPECT_EQ(degree(gcd(a * c, b * c)), degree(c) + degree(gcd(a, b)));
    if (degree(b) > 0 && degree(gcd(a, b)) == 0) {
      EXPECT_TRUE(is_one((inverse_mod(a, b) * a) % b));
    }
  }
}

TEST_P(PolyOver, FactorsMultiplyBack) {
  const Field k = field();
  std::mt19937 gen(777);
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const Poly a = random_poly(gen, k, 3);
    const Poly b = random_poly(gen, k, 2);
    if (degree(a) < 1 || degree(b) < 1) continue;
    const Poly f = a * a * b;
    Poly product(1);
    for (const Factor& factor : irreducible_factors(f))
      product *= pow(factor.base, static_cast<unsigned long>(factor.exponent));
    EXPECT_EQ(product, monic(f));
  }
}

INSTANTIATE_TEST_SUITE_P(Fields, PolyOver, testing::Values(0, 1, 2, 3, 4));

TEST(Factor, SplitsOverTheGaussianNumbers) {
  const Field k = sqrt_field(-1, "I");
  const Poly z = Poly::z();
  EXPECT_EQ(irreducible_factors(coerce(z * z + Poly(1), k)).size(), 2U);
  EXPECT_EQ(irreducible_factors(coerce(z * z - Poly(2), k)).size(), 1U);
  EXPECT_EQ(irreducible_factors(coerce(pow(z, 4) + Poly(1), k)).size(), 2U);
  EXPECT_EQ(irreducible_factors(z * z + Poly(1)).size(), 1U);
}

TEST(Factor, ManyRationalRoots) {
  Poly f(1);
  for (long i = 1; i <= 60; ++i)
    f *= Poly::z() - Poly(Rational(i, 7));
  EXPECT_EQ(irreducible_factors(f * (Poly::z() * Poly::z() + Poly(1))).size(), 61U);
}

TEST(NfElem, SquareRoots) {
  const Field k = sqrt_field(2, "s");
  const NfElem s = NfElem::generator(k);
  const NfElem a = NfElem(3) + NfElem(2) * s; // (1+s)^2
  const auto root = exact_sqrt(a);
  ASSERT_TRUE(root);
  EXPECT_EQ(*root * *root, a);
  EXPECT_FALSE(exact_sqrt(NfElem(3) + s));
  EXPECT_TRUE(exact_sqrt(coerce(NfElem(2), k)));
}

TEST(RationalFunction, CanonicalFormAndText) {
  const Poly z = Poly::z();
  const RationalFunction f(z * z - Poly(1), Poly(2) * (z - Poly(1)));
  EXPECT_EQ(f, RationalFunction(z + Poly(1), Poly(2)));
  EXPECT_EQ(to_string(f), "(z + 1)/2");
  EXPECT_EQ(to_string(RationalFunction(Poly(-3), Poly(16) * z * z)), "-3/(16*z^2)");
  EXPECT_EQ(to_string(RationalFunction(z)), "z");
  EXPECT_EQ(order_at_infinity(RationalFunction(z)), -1);
}

TEST(Modular, AssignmentTakesTheModulusAlong) {
  NmodPoly a(3);
  NmodPoly b(13);
  b.set_coeff(1, 12);
  a = b;
  EXPECT_EQ(a.modulus(), 13U);
  EXPECT_EQ((a * a).coeff(2), 1U);
}

TEST(Modular, ReductionIsARingMap) {
  const Field k = sqrt_field(-1, "I");
  PrimeIdeals primes = PrimeIdeals::large(k);
  const PrimeIdeal prime = primes.next();
  std::mt19937 gen(3);
  for (int i = 0; i < 20; ++i) {
    const Poly a = random_poly(gen, k, 6);
    const Poly b = random_poly(gen, k, 6);
    EXPECT_EQ(*prime.reduce(a) * *prime.reduce(b), *prime.reduce(a * b));
  }
}

TEST(NumberFields, TextsShowTheLetterAndNotTheGenerator) {
  const Field k = make_field({-6, 0, 1}, "a", 0, Integer(2)); // a with 2 a^2 = 3
  const NfElem a = NfElem::generator(k) / NfElem(2);
  EXPECT_EQ(to_string(a), "a");
  EXPECT_EQ(k->name(), "(2*a)");
  const Poly z = Poly::z();
  EXPECT_EQ(to_string(RationalFunction(Poly(a), z * z), "z"), "a/z^2");
  EXPECT_EQ(to_string(RationalFunction(Poly(a) + z, scale(z * z, NfElem(3))), "z"),
            "(z + a)/(3*z^2)");
  EXPECT_EQ(to_string(Poly(a * NfElem(Rational(1, 2)) + NfElem(1)), "z"), "1/2*a + 1");
}

} // namespace
} // namespace kov
