#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/multivariate.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov {
namespace {

class Multivariate : public testing::Test {
protected:
  MFraction random_fraction(std::mt19937& gen) const {
    std::uniform_int_distribution<int> c(-5, 5);
    std::uniform_int_distribution<unsigned long> e(0, 2);
    const auto poly = [&] {
      MPoly f(ring);
      for (int i = 0; i < 4; ++i)
        f += MPoly::term(ring, Integer(c(gen)), {e(gen), e(gen), e(gen)});
      return f;
    };
    MPoly den = poly();
    while (is_zero(den))
      den = poly();
    return {poly(), den};
  }
  Ring ring = make_ring({"x", "y", "a"});
  MFraction x = MFraction::variable(ring, "x");
  MFraction y = MFraction::variable(ring, "y");
  MFraction a = MFraction::variable(ring, "a");
  MFraction one = MFraction(ring, Rational(1));
};

TEST_F(Multivariate, FieldIdentities) {
  std::mt19937 gen(1);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const MFraction f = random_fraction(gen);
    const MFraction g = random_fraction(gen);
    const MFraction h = random_fraction(gen);
    EXPECT_EQ((f + g) * h, f * h + g * h);
    EXPECT_EQ(f - f, MFraction());
    EXPECT_EQ(derivative(f * g, 0), derivative(f, 0) * g + f * derivative(g, 0));
    if (!is_zero(g)) {
      EXPECT_EQ((f / g) * g, f);
    }
    const Substitution into{{0, g}};
    try {
      EXPECT_EQ(substitute(f + h, into), substitute(f, into) + substitute(h, into));
      EXPECT_EQ(substitute(f * h, into), substitute(f, into) * substitute(h, into));
    } catch (const DomainError&) { // a denominator vanishes at x = g
    }
  }
}

TEST_F(Multivariate, CanonicalFormAndText) {
  EXPECT_EQ((x * x - y * y) / (x - y), x + y);
  EXPECT_EQ(to_string((x * x - y * y) / (Rational(2) * (x - y))), "(x + y)/2");
  EXPECT_EQ(to_string(one / (Rational(-2) * x)), "-1/(2*x)");
  EXPECT_EQ(to_string(x / (x + y)), "x/(x + y)");
  EXPECT_EQ(to_factored_string((x * x - y * y) / (x * x * a)), "(x - y)*(x + y)/(a*x^2)");
  EXPECT_EQ(to_factored_string(one / ((x + y) * (x + y))), "1/(x + y)^2");
  EXPECT_THROW(x / MFraction(ring), DomainError);
  EXPECT_THROW(x + MFraction::variable(make_ring({"x"}), "x"), InvalidArgument);
}

TEST_F(Multivariate, PolynomialTools) {
  const MPoly f = (x * x - y).num();
  EXPECT_EQ(to_string(resultant(f, (x - a).num(), 0)), "-y + a^2");
  EXPECT_EQ(to_string(discriminant((a * x * x + y * x + one).num(), 0)), "y^2 - 4*a");
  const auto [content, factors] = factor((Rational(6) * (x - y) * (x - y) * a).num());
  EXPECT_EQ(content, Integer(6));
  ASSERT_EQ(factors.size(), 2U);
  EXPECT_EQ(factors[1].exponent, 2);
  EXPECT_EQ(coefficients(f, 0).size(), 3U);
}

TEST_F(Multivariate, ToOneVariable) {
  const MFraction f = (x * x - one) / (Rational(3) * x);
  EXPECT_EQ(from_rational_function(to_rational_function(f, 0), ring, 0), f);
  EXPECT_THROW(to_rational_function(f * y, 0), InvalidArgument);
  const Field k = make_field({Integer(-2), 0, 1}, "s");
  const RationalFunction g = to_rational_function(a * a * x, 0, AlgebraicConstant{2, k});
  EXPECT_EQ(to_string(g, "x"), "2*x");
}

TEST_F(Multivariate, Transfer) {
  const Ring other = make_ring({"a", "z", "y", "x"});
  const MFraction f = (x + a) / (y * y - a);
  EXPECT_EQ(transfer(transfer(f, other), ring), f);
  EXPECT_THROW(transfer(f, make_ring({"x", "y"})), InvalidArgument);
}

class Ideals : public Multivariate {};

TEST_F(Ideals, MembershipOverTheParameters) {
  const Ideal circle(ring, {0, 1}, {(x * x + y * y - a).num()});
  EXPECT_EQ(circle.dimension(), 1);
  EXPECT_TRUE(circle.contains(((x * x + y * y - a) * (x + y)).num()));
  EXPECT_FALSE(circle.contains((x * x + y * y).num()));
  const Ideal points(ring, {0, 1}, {(x * x + y * y - a).num(), (x - y).num()});
  EXPECT_EQ(points.dimension(), 0);
  EXPECT_EQ(points.standard_monomials().size(), 2U);
  EXPECT_TRUE(points.contains((Rational(2) * x * x - a).num()));
}

TEST_F(Ideals, SaturationRemovesComponents) {
  const MPoly f = (x * (y - a)).num();
  const Ideal both(ring, {0, 1}, {f});
  EXPECT_FALSE(both.contains((y - a).num()));
  const Ideal one_only(ring, {0, 1}, {f}, {x.num()});
  EXPECT_TRUE(one_only.contains((y - a).num()));
  EXPECT_TRUE(Ideal(ring, {0, 1}, {x.num()}, {x.num()}).is_unit());
}

TEST_F(Ideals, VanishingIsRadicalMembership) {
  const Ideal fat(ring, {0, 1}, {(x * x).num(), (x * y).num()}); // the y axis, fat at the origin
  EXPECT_FALSE(fat.contains(x.num()));
  EXPECT_TRUE(fat.vanishes(x.num()));
  EXPECT_FALSE(fat.vanishes(y.num()));
  const Ideal two(ring, {0, 1}, {(x * y).num(), (x * (x - one)).num()}); // a line and a point
  EXPECT_TRUE(two.vanishes((x * y * a).num()));
  EXPECT_FALSE(two.vanishes(x.num())); // 0 on the line, 1 at the point
}

TEST_F(Ideals, WhatWasInvertedIsRecorded) {
  const Ideal i(ring, {0, 1}, {((a * a - one) * x - y).num(), (x * y - one).num()});
  std::vector<std::string> names;
  for (const auto& f : i.inverted())
    names.push_back(to_string(f));
  EXPECT_EQ(names, (std::vector<std::string>{"a - 1", "a + 1"}));
}

TEST_F(Ideals, FiniteAlgebraIsAField) {
  const FiniteAlgebra k(Ideal(ring, {0}, {(x * x - a).num()}));
  EXPECT_EQ(k.dimension(), 2U);
  const auto root = *k.evaluate(x);
  const auto inverse = *k.invert(root);
  EXPECT_EQ(k.lift(inverse), x / a);
  EXPECT_EQ(*k.in_base_field(k.multiply(root, root)), a);
  EXPECT_FALSE(k.in_base_field(root));
  EXPECT_EQ(k.lift(*k.evaluate(one / (x - one))), (x + one) / (a - one));
  EXPECT_EQ(k.minimal_polynomial(root).size(), 3U);
}

TEST_F(Ideals, ZeroDivisorsAreRefused) {
  const FiniteAlgebra two(Ideal(ring, {0}, {(x * x - one).num()}));
  EXPECT_FALSE(two.invert(*two.evaluate(x - one)));
  EXPECT_FALSE(two.evaluate(one / (x - one)));
  EXPECT_TRUE(two.invert(*two.evaluate(x)));
}

TEST_F(Ideals, LinearSystems) {
  const auto solution = solve_linear({{x, one}, {one, x}}, {a, MFraction(ring)});
  ASSERT_TRUE(solution);
  EXPECT_EQ(x * (*solution)[0] + (*solution)[1], a);
  EXPECT_FALSE(solve_linear({{x, x}, {one, one}}, {one, one}));
  EXPECT_EQ(null_space({{x, x}}, 2).size(), 1U);
}

} // namespace
} // namespace kov
