#include "linode/double_poles.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::double_poles_test {
namespace {

const Poly z = Poly::z();

// Delta^2 at a root c of den, from the definition.
NfElem from_the_definition(const RationalFunction& r, const NfElem& c) {
  const Poly second = derivative(derivative(r.den()));
  return NfElem(1) + NfElem(8) * evaluate(r.num(), c) / evaluate(second, c);
}

void compare_with_the_definition(const RationalFunction& r) {
  const auto factors = irreducible_factors(r.den());
  const auto values = double_pole_delta_squared(r, factors);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const Poly& q = factors[i].base;
    if (factors[i].exponent != 2 || degree(q) != 1) continue;
    ASSERT_TRUE(values[i]);
    EXPECT_EQ(NfElem(*values[i]), from_the_definition(r, -q.coeff(0)));
  }
}

Rational random_rational(std::mt19937& rng, int digits) {
  const auto number = [&] {
    std::string s = "1";
    for (int i = 1; i < digits; ++i)
      s += static_cast<char>('0' + rng() % 10);
    return Integer::parse(s);
  };
  return {number(), number()};
}

TEST(DoublePoles, ValuesOfAllSizesBesideOtherOrders) {
  std::mt19937 rng(1);
  for (const int digits : {1, 5, 9, 10, 30, 100, 400}) {
    RationalFunction r = RationalFunction(z * z + Poly(1)) + RationalFunction(Poly(3), z * z * z) +
                         RationalFunction(Poly(1), pow(z - Poly(1), 4)) +
                         RationalFunction(Poly(1), z - Poly(2));
    for (int c = 3; c < 10; ++c) {
      const Poly t = z - Poly(Rational(c, 3));
      r = r + RationalFunction(Poly(random_rational(rng, digits)), t * t) +
          RationalFunction(Poly(random_rational(rng, digits)), t);
    }
    compare_with_the_definition(r);
  }
}

// 4a = -8/9 at every pole, those of z^4-2 and of z^3-3 among them.
TEST(DoublePoles, ConjugatePlaces) {
  RationalFunction r;
  for (const Poly& q : {pow(z, 4) - Poly(2), pow(z, 3) - Poly(3), z - Poly(1), z, z + Poly(1)})
    r = r + RationalFunction(scale(derivative(q) * derivative(q), NfElem(Rational(-2, 9))), q * q);
  const auto factors = irreducible_factors(r.den());
  ASSERT_EQ(factors.size(), 5U);
  for (const auto& value : double_pole_delta_squared(r, factors)) {
    // places of degree 3 and 4 need a root modulo the first two primes
    EXPECT_EQ(value.value_or(Rational(1, 9)), Rational(1, 9));
  }
  compare_with_the_definition(r);
}

// Conjugate values that are not rational must stay open, however alike they look modulo a prime.
TEST(DoublePoles, IrrationalValuesStayOpen) {
  RationalFunction r;
  for (long c = 0; c < 4; ++c) {
    const Poly t = z - Poly(c);
    const Poly q = t * t - Poly(2);
    r = r + RationalFunction(t, q * q);
  }
  const auto factors = irreducible_factors(r.den());
  for (const auto& value : double_pole_delta_squared(r, factors))
    EXPECT_FALSE(value);
}

TEST(DoublePoles, OverAQuadraticField) {
  const Field k = make_field({Integer(1), Integer(0), Integer(1)}, "I");
  const NfElem i = NfElem::generator(k);
  RationalFunction r;
  for (long c = 0; c < 5; ++c) {
    const Poly t = z - Poly(NfElem(c));
    r = r + RationalFunction(Poly(c < 4 ? NfElem(Rational(c + 1, 7)) : i), t * t);
  }
  const auto factors = irreducible_factors(r.den());
  const auto values = double_pole_delta_squared(r, factors);
  for (std::size_t j = 0; j < factors.size(); ++j) {
    if (!values[j]) continue;
    EXPECT_EQ(NfElem(*values[j]), from_the_definition(r, -factors[j].base.coeff(0)));
  }
}

} // namespace
} // namespace kov::double_poles_test
