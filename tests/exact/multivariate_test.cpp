#include "exact/multivariate.hpp"

#include "exact/error.hpp"
#include "exact/laws.hpp"
#include "exact/polynomials.hpp"
#include "exact/read_back.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

class MPolyLaws : public Polynomials {
protected:
  // By expansion along the first row.
  [[nodiscard]] MPoly determinant(const std::vector<std::vector<MPoly>>& m) const {
    if (m.empty()) return number_poly(1);
    MPoly sum(ring);
    for (std::size_t c = 0; c < m.size(); ++c) {
      if (is_zero(m[0][c])) continue;
      std::vector<std::vector<MPoly>> minor;
      for (std::size_t r = 1; r < m.size(); ++r) {
        minor.push_back(m[r]);
        minor.back().erase(minor.back().begin() + static_cast<long>(c));
      }
      const MPoly term = m[0][c] * determinant(minor);
      sum = c % 2 == 0 ? sum + term : sum - term;
    }
    return sum;
  }
  // The determinant of Sylvester's matrix.
  [[nodiscard]] MPoly sylvester(const MPoly& f, const MPoly& g, std::size_t i) const {
    const auto n = static_cast<std::size_t>(degree(f, i));
    const auto m = static_cast<std::size_t>(degree(g, i));
    const auto cf = coefficients(f, i);
    const auto cg = coefficients(g, i);
    std::vector rows(n + m, std::vector<MPoly>(n + m, MPoly(ring)));
    for (std::size_t r = 0; r < m; ++r)
      for (std::size_t j = 0; j <= n; ++j)
        rows[r][r + j] = cf[n - j];
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t j = 0; j <= m; ++j)
        rows[m + r][r + j] = cg[m - j];
    return determinant(rows);
  }
};

TEST_F(MPolyLaws, CommutativeRingWithoutZeroDivisors) {
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    const MPoly f = poly();
    const MPoly g = poly();
    const MPoly h = poly();
    ring_laws(f, g, h, MPoly(ring), number_poly(1));
    domain_laws(f, g);
    value_laws(f, g);
    aliasing_laws(f);
    order_laws(f, g, h);
    for (std::size_t v = 0; v < 4; ++v) {
      derivation_laws(f, g, [&](const MPoly& p) { return derivative(p, v); });
      EXPECT_EQ(derivative(derivative(f, v), 1), derivative(derivative(f, 1), v));
      EXPECT_EQ(degree(f * g, v), is_zero(f * g) ? -1 : degree(f, v) + degree(g, v));
      EXPECT_EQ(uses(f, v), !is_zero(derivative(f, v)));
    }
  }
  power_laws(poly(3), number_poly(1));
}

// The zero without variables combines with everything.
TEST_F(MPolyLaws, TheZeroWithoutVariables) {
  const MPoly zero;
  const MPoly f = nonzero();
  EXPECT_EQ(zero + f, f);
  EXPECT_EQ(f + zero, f);
  EXPECT_EQ(zero - f, -f);
  EXPECT_EQ(f - zero, f);
  EXPECT_TRUE(is_zero(zero * f));
  EXPECT_TRUE(is_zero(-zero));
  EXPECT_EQ(zero, MPoly(ring));
  EXPECT_EQ(gcd(zero, -f), gcd(MPoly(ring), -f)); // normalised, too
  EXPECT_EQ(gcd(-f, zero), gcd(f, f));
  EXPECT_TRUE(is_zero(gcd(zero, zero)));
  EXPECT_TRUE(is_zero(derivative(zero, 0)));
  EXPECT_TRUE(is_zero(resultant(zero, f, 0)));
  EXPECT_TRUE(is_zero(discriminant(zero, 0)));
  EXPECT_TRUE(coefficients(zero, 0).empty());
  EXPECT_EQ(degree(zero, 0), -1);
  EXPECT_TRUE(is_constant(zero));
  EXPECT_FALSE(is_one(zero));
  EXPECT_EQ(divides(f, zero), zero);
  EXPECT_EQ(to_string(zero), "0");
}

TEST_F(MPolyLaws, RingsAreNotMixed) {
  const MPoly other = MPoly::variable(make_ring({"x", "y", "z", "a"}), "x");
  EXPECT_THROW(other + x.num(), InvalidArgument);
  EXPECT_THROW(other * x.num(), InvalidArgument);
  EXPECT_THROW((void)gcd(other, x.num()), InvalidArgument);
  EXPECT_THROW((void)make_ring({"x", "y", "x"}), InvalidArgument);
  EXPECT_THROW((void)make_ring({"x", ""}), InvalidArgument);
  EXPECT_THROW((void)ring->index("w"), InvalidArgument);
  EXPECT_EQ(ring->find("w"), std::nullopt);
  for (std::size_t i = 0; i < ring->size(); ++i)
    EXPECT_EQ(ring->index(ring->name(i)), i);
  EXPECT_THROW((void)MPoly::variable(ring, 4), InternalError);
  EXPECT_THROW((void)MPoly::term(ring, Integer(1), {1}), InternalError);
}

TEST_F(MPolyLaws, TermsAddUp) {
  for (int i = 0; i < 10; ++i) {
    const MPoly f = poly(6);
    MPoly sum(ring);
    for (long t = 0; t < f.length(); ++t)
      sum += MPoly::term(ring, f.coefficient(t), f.exponents(t));
    EXPECT_EQ(sum, f);
    for (std::size_t v = 0; v < 4; ++v) {
      MPoly by_powers(ring);
      const auto c = coefficients(f, v);
      for (std::size_t e = 0; e < c.size(); ++e) {
        EXPECT_FALSE(uses(c[e], v));
        by_powers += c[e] * pow(MPoly::variable(ring, v), e);
      }
      EXPECT_EQ(by_powers, f);
      EXPECT_EQ(static_cast<long>(c.size()), degree(f, v) + 1);
    }
  }
}

TEST_F(MPolyLaws, GcdIsPlantedDividesAndIsNormalised) {
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const MPoly common = nonzero(3, 1);
    const MPoly f = common * nonzero(3, 1);
    const MPoly g = common * nonzero(3, 1);
    const MPoly d = gcd(f, g);
    EXPECT_EQ(gcd(g, f), d);
    EXPECT_GT(sign(d.coefficient(0)), 0);
    EXPECT_TRUE(divides(common, d));
    EXPECT_TRUE(is_one(gcd(exact_div(f, d), exact_div(g, d))));
    EXPECT_EQ(gcd(f * f, f * g), gcd(f * d, f * d));
    EXPECT_EQ(gcd(f, MPoly(ring)), gcd(f, f));
  }
}

// In one variable the gcd is that of Q[x], up to a constant.
TEST_F(MPolyLaws, GcdInOneVariableIsEuclids) {
  for (int i = 0; i < 15; ++i) {
    const auto in_x = [&] {
      MPoly f = MPoly::variable(ring, "x") * number_poly(number(1, 5));
      for (int j = 0; j < 3; ++j)
        f += MPoly::term(ring, Integer(number(-4, 4)), {exponent(3), 0, 0, 0});
      return f;
    };
    const MPoly common = in_x();
    const MPoly f = common * in_x();
    const MPoly g = common * in_x();
    if (is_zero(f) || is_zero(g)) continue;
    const auto univariate = [&](const MPoly& p) {
      return to_rational_function(MFraction(p), 0).num();
    };
    EXPECT_EQ(monic(univariate(gcd(f, g))), gcd(univariate(f), univariate(g)));
  }
}

TEST_F(MPolyLaws, DivisionIsExactOrRefused) {
  for (int i = 0; i < 15; ++i) {
    const MPoly f = poly();
    const MPoly g = nonzero();
    EXPECT_EQ(exact_div(f * g, g), f);
    EXPECT_EQ(divides(g, f * g), f);
    if (const auto q = divides(g, f)) {
      EXPECT_EQ(*q * g, f);
    } else {
      EXPECT_THROW((void)exact_div(f, g), InternalError);
    }
  }
  EXPECT_FALSE(divides(MPoly(ring), x.num()));
  EXPECT_FALSE(divides(number_poly(2), x.num())); // over Z, not over Q
}

TEST_F(MPolyLaws, FactorsMultiplyBackAndDoNotSplit) {
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const MPoly f = nonzero(2, 1) * pow(nonzero(3, 1), 2) * number_poly(-12);
    const auto [content, factors] = factor(f);
    MPoly product(ring, content);
    for (const MFactor& factor_of_f : factors) {
      product *= pow(factor_of_f.base, static_cast<unsigned long>(factor_of_f.exponent));
      EXPECT_GT(sign(factor_of_f.base.coefficient(0)), 0);
      const auto [unit, again] = factor(factor_of_f.base);
      ASSERT_EQ(again.size(), 1U);
      EXPECT_EQ(unit, Integer(1));
      EXPECT_EQ(again[0].exponent, 1);
      EXPECT_EQ(again[0].base, factor_of_f.base);
    }
    EXPECT_EQ(product, f);
  }
  EXPECT_THROW((void)factor(MPoly(ring)), InternalError);
  EXPECT_TRUE(factor(number_poly(-5)).second.empty());
  EXPECT_EQ(factor(number_poly(-5)).first, Integer(-5));
}

TEST_F(MPolyLaws, ResultantIsSylvestersDeterminant) {
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const MPoly f = nonzero(4, 2) + pow(x, 2).num() * nonzero(1, 1);
    const MPoly g = nonzero(3, 2) + x.num();
    if (degree(f, 0) < 1 || degree(g, 0) < 1) continue;
    const MPoly r = resultant(f, g, 0);
    EXPECT_EQ(r, sylvester(f, g, 0));
    EXPECT_FALSE(uses(r, 0));
    const MPoly h = x.num() + y.num();
    EXPECT_EQ(resultant(f, g * h, 0), r * resultant(f, h, 0));
    EXPECT_TRUE(is_zero(resultant(f * h, g * h, 0))); // a common factor
    const bool odd = (degree(f, 0) * degree(g, 0)) % 2 != 0;
    EXPECT_EQ(resultant(g, f, 0), odd ? -r : r);
  }
}

// disc f = (-1)^(n(n-1)/2) res(f, f')/lead f
TEST_F(MPolyLaws, DiscriminantFromTheResultant) {
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const MPoly f = nonzero(3, 2) + pow(x, number(2, 4)).num() * nonzero(1, 1);
    const long n = degree(f, 0);
    if (n < 1) continue;
    const MPoly lead = coefficients(f, 0).back();
    const MPoly expected = exact_div(sylvester(f, derivative(f, 0), 0), lead);
    EXPECT_EQ(discriminant(f, 0), n * (n - 1) / 2 % 2 == 0 ? expected : -expected);
    EXPECT_TRUE(is_zero(discriminant(f * (x - y).num() * (x - y).num(), 0)));
  }
  EXPECT_EQ(to_string(discriminant((a * x * x + y * x + one).num(), 0)), "y^2 - 4*a");
  EXPECT_EQ(to_string(resultant((x * x - y).num(), (x - a).num(), 0)), "-y + a^2");
}

TEST_F(MPolyLaws, TextAndBack) {
  ReadBack<MFraction> read(
      {{"x", x}, {"y", y}, {"z", z}, {"a", a}},
      [](const Integer& n, const MFraction& like) { return MFraction(like.ring(), Rational(n)); });
  for (int i = 0; i < 40; ++i) {
    const MPoly f = poly(5);
    EXPECT_EQ(read(to_string(f)), MFraction(f)) << to_string(f);
  }
}

// FLINT stops the program where an exponent is not a machine word: a clear error comes first.
TEST_F(MPolyLaws, HugeExponentsAreRefused) {
  const MPoly large = pow(x.num(), 1UL << 40);
  EXPECT_EQ(degree(large, 0), 1L << 40);
  EXPECT_THROW((void)pow(large, 1UL << 40), DomainError);
  const MPoly limit = pow(large, 1UL << 22); // 2^62
  EXPECT_THROW(limit * limit, DomainError);
  EXPECT_THROW(MFraction(limit) * MFraction(limit), DomainError);
  EXPECT_THROW((one / MFraction(limit)) * (one / MFraction(limit)), DomainError);
  EXPECT_EQ(MFraction(limit) / MFraction(limit), one);
}

// FLINT reads beyond its arrays, or ends the program, where these are asked of it.
TEST_F(MPolyLaws, WhatIsNotThereIsNotAskedFor) {
  const std::size_t none = ring->size();
  for (const MPoly& f : {x.num(), MPoly(ring), number_poly(3), (x * y + a).num()}) {
    EXPECT_THROW((void)uses(f, none), InternalError);
    EXPECT_THROW((void)degree(f, none + 20), InternalError);
    EXPECT_THROW((void)derivative(f, none), InternalError);
    EXPECT_THROW((void)resultant(f, x.num(), none), InternalError);
    EXPECT_THROW((void)discriminant(f, none), InternalError);
    EXPECT_THROW((void)substitute(f, {{none, x}}), InternalError);
    EXPECT_THROW((void)uses(MFraction(f), none), InternalError);
    for (const long i : {-1L, f.length()}) {
      EXPECT_THROW((void)f.coefficient(i), InternalError);
      EXPECT_THROW((void)f.exponents(i), InternalError);
    }
  }
  EXPECT_THROW((void)coefficients(x.num(), none), InternalError);
  EXPECT_THROW((void)MPoly().coefficient(0), InternalError);
  EXPECT_FALSE(uses(MPoly(), none)); // it is 0 in each ring
}

} // namespace
} // namespace kov
