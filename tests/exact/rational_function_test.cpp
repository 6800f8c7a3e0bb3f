#include "exact/rational_function.hpp"

#include "exact/error.hpp"
#include "exact/fields.hpp"
#include "exact/laws.hpp"
#include "exact/read_back.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

class RationalFunctionLaws : public OverFields {
protected:
  // num and den without a common factor, den monic, over one field
  static void expect_canonical(const RationalFunction& f) {
    EXPECT_TRUE(is_one(lead(f.den())));
    EXPECT_EQ(degree(gcd(f.num(), f.den())), is_zero(f) ? degree(f.den()) : 0);
    if (is_zero(f)) {
      EXPECT_TRUE(is_one(f.den()));
    }
    EXPECT_EQ(f.num().field(), f.den().field());
  }
};

TEST_P(RationalFunctionLaws, Field) {
  const RationalFunction zero{Poly(k)};
  const RationalFunction one(constant(1));
  for (int i = 0; i < 6; ++i) {
    SCOPED_TRACE(i);
    const RationalFunction a = function(3);
    const RationalFunction b = function(2) + RationalFunction(pow(z(), 5));
    const RationalFunction c = one / (function(2) + RationalFunction(pow(z(), 7)));
    ring_laws(a, b, c, zero, one);
    field_laws(a, b, c, one);
    domain_laws(a, b);
    value_laws(a, b);
    aliasing_laws(a);
    for (const RationalFunction& f : {a + b, a - a, a * c, a / b, -a, b - c})
      expect_canonical(f);
  }
  EXPECT_THROW(one / zero, DomainError);
  EXPECT_THROW(RationalFunction(constant(1), Poly(k)), DomainError);
}

TEST_P(RationalFunctionLaws, CanonicalFormForgetsWhatCancels) {
  for (int i = 0; i < 8; ++i) {
    const Poly n = poly(3);
    const Poly d = monic_poly(2);
    const Poly common = scale(monic_poly(number(0, 2)), nonzero());
    const RationalFunction f(n * common, d * common);
    EXPECT_EQ(f, RationalFunction(n, d));
    EXPECT_EQ(f.num() * d, n * f.den());
    expect_canonical(f);
    const RationalFunction again =
        RationalFunction::from_coprime(scale(f.num(), NfElem(-3)), scale(f.den(), NfElem(-3)));
    EXPECT_EQ(again, f);
  }
}

TEST_P(RationalFunctionLaws, Derivation) {
  for (int i = 0; i < 5; ++i) {
    const RationalFunction a = function(2);
    const RationalFunction b = function(2);
    derivation_laws(a, b, [](const RationalFunction& f) { return derivative(f); });
    if (!is_zero(b)) {
      EXPECT_EQ(derivative(a / b), (derivative(a) * b - a * derivative(b)) / (b * b));
      EXPECT_EQ(derivative(pow(b, -2)), RationalFunction(-2) * derivative(b) * pow(b, -3));
    }
    expect_canonical(derivative(a));
  }
}

TEST_P(RationalFunctionLaws, Powers) {
  const RationalFunction f = function(2) + RationalFunction(pow(z(), 3));
  RationalFunction product(constant(1));
  for (long e = 0; e < 5; ++e, product = product * f) {
    EXPECT_EQ(pow(f, e), product);
    EXPECT_EQ(pow(f, -e) * product, RationalFunction(1));
    expect_canonical(pow(f, -e));
  }
  EXPECT_THROW((void)pow(RationalFunction{Poly(k)}, -1), DomainError);
}

TEST_P(RationalFunctionLaws, SubstitutionIsAHomomorphism) {
  for (int i = 0; i < 3; ++i) {
    const RationalFunction f = function(2);
    const RationalFunction g = function(2);
    const RationalFunction h = RationalFunction(pow(z(), 2)) + RationalFunction(constant(1), z());
    EXPECT_EQ(compose(f + g, h), compose(f, h) + compose(g, h));
    EXPECT_EQ(compose(f * g, h), compose(f, h) * compose(g, h));
    EXPECT_EQ(compose(f, RationalFunction(z())), f);
    EXPECT_EQ(derivative(compose(f, h)), compose(derivative(f), h) * derivative(h));
    const RationalFunction moebius(z() + constant(2), z() + constant(1));
    const RationalFunction back(constant(2) - z(), z() - constant(1));
    EXPECT_EQ(compose(moebius, back), RationalFunction(z()));
    EXPECT_EQ(compose(compose(f, moebius), back), f);
  }
  const RationalFunction pole(constant(1), z() - constant(1));
  EXPECT_THROW((void)compose(pole, RationalFunction(constant(1))), DomainError);
}

TEST_P(RationalFunctionLaws, OrderAtInfinityIsAValuation) {
  for (int i = 0; i < 10; ++i) {
    const RationalFunction a = function(3);
    const RationalFunction b = function(3);
    if (is_zero(a) || is_zero(b)) continue;
    EXPECT_EQ(order_at_infinity(a * b), order_at_infinity(a) + order_at_infinity(b));
    if (!is_zero(a + b)) {
      EXPECT_GE(order_at_infinity(a + b), std::min(order_at_infinity(a), order_at_infinity(b)));
    }
  }
  EXPECT_THROW((void)order_at_infinity(RationalFunction{Poly(k)}), InternalError);
}

TEST_P(RationalFunctionLaws, TextAndBack) {
  std::map<std::string, RationalFunction> names{{"z", RationalFunction(z())}};
  if (!k->is_rational())
    names.emplace(k->letter(),
                  RationalFunction(Poly(NfElem::generator(k) / NfElem(Rational(k->scale())))));
  ReadBack<RationalFunction> read(names, [](const Integer& n, const RationalFunction&) {
    return RationalFunction(Rational(n));
  });
  for (int i = 0; i < 15; ++i) {
    const RationalFunction f = function(3);
    EXPECT_EQ(read(to_string(f)), f) << to_string(f);
    const RationalFunction g = RationalFunction(Poly(element())) / RationalFunction(pow(z(), 2));
    EXPECT_EQ(read(to_string(g)), g) << to_string(g);
  }
}

TEST_P(RationalFunctionLaws, FunctionsOverQAreASubfield) {
  const RationalFunction f(Poly::z() * Poly::z() - Poly(2), Poly::z() + Poly(Rational(1, 3)));
  EXPECT_EQ(coerce(f, k), f);
  EXPECT_EQ(coerce(f, k).field(), k);
  const RationalFunction c{Poly(element())};
  EXPECT_EQ(f * c, coerce(f, k) * c);
  EXPECT_EQ(f + c, coerce(f, k) + c);
}

KOV_OVER_ALL_FIELDS(RationalFunctionLaws);

TEST(RationalFunction, Texts) {
  const Poly z = Poly::z();
  const RationalFunction f(z * z - Poly(1), Poly(2) * (z - Poly(1)));
  EXPECT_EQ(f, RationalFunction(z + Poly(1), Poly(2)));
  EXPECT_EQ(to_string(f), "(z + 1)/2");
  EXPECT_EQ(to_string(RationalFunction(Poly(-3), Poly(16) * z * z)), "-3/(16*z^2)");
  EXPECT_EQ(to_string(RationalFunction(z)), "z");
  EXPECT_EQ(to_string(RationalFunction(0)), "0");
  EXPECT_EQ(to_string(RationalFunction(Poly(1), z), "x"), "1/x");
  EXPECT_EQ(order_at_infinity(RationalFunction(z)), -1);
}

} // namespace
} // namespace kov
