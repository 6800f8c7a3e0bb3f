#include "exact/factor.hpp"

#include "exact/error.hpp"
#include "exact/fields.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

class FactorLaws : public OverFields {
protected:
  [[nodiscard]] static Poly multiplied_back(const std::vector<Factor>& factors) {
    Poly f(1);
    for (const Factor& factor : factors)
      f *= pow(factor.base, static_cast<unsigned long>(factor.exponent));
    return f;
  }
};

TEST_P(FactorLaws, SquarefreePartsMultiplyBack) {
  for (int i = 0; i < 5; ++i) {
    SCOPED_TRACE(i);
    const Poly f = scale(monic_poly(2) * pow(monic_poly(1), 2) * pow(monic_poly(1), 5), nonzero());
    const auto parts = squarefree_factors(f);
    EXPECT_EQ(multiplied_back(parts), monic(f));
    for (std::size_t j = 0; j < parts.size(); ++j) {
      EXPECT_TRUE(is_squarefree(parts[j].base));
      EXPECT_TRUE(is_one(lead(parts[j].base)));
      EXPECT_GT(degree(parts[j].base), 0);
      for (std::size_t l = 0; l < j; ++l) {
        EXPECT_LT(parts[l].exponent, parts[j].exponent);
        EXPECT_EQ(degree(gcd(parts[l].base, parts[j].base)), 0);
      }
    }
  }
  EXPECT_TRUE(squarefree_factors(constant(7)).empty());
}

TEST_P(FactorLaws, SquarefreeMeansCoprimeToTheDerivative) {
  for (int i = 0; i < 10; ++i) {
    const Poly f = monic_poly(number(0, 4));
    const Poly g = monic_poly(number(1, 2));
    EXPECT_EQ(is_squarefree(f), degree(gcd(f, derivative(f))) <= 0);
    EXPECT_FALSE(is_squarefree(f * g * g));
  }
}

TEST_P(FactorLaws, IrreducibleFactorsMultiplyBackAndDoNotSplit) {
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    const Poly f =
        scale(monic_poly(2) * pow(monic_poly(1), 2) * (z() * z() + constant(1)), nonzero());
    const auto factors = irreducible_factors(f);
    EXPECT_EQ(multiplied_back(factors), monic(f));
    for (const Factor& factor : factors) {
      EXPECT_TRUE(is_one(lead(factor.base)));
      const auto again = irreducible_factors(factor.base);
      ASSERT_EQ(again.size(), 1U);
      EXPECT_EQ(again[0].base, factor.base);
      EXPECT_EQ(again[0].exponent, 1);
      // quadratic factors have no root: their discriminant is not a square
      if (degree(factor.base) == 2) {
        const NfElem b = factor.base.coeff(1);
        EXPECT_FALSE(exact_sqrt(b * b - NfElem(4) * factor.base.coeff(0)));
      }
    }
    const bool sorted =
        std::is_sorted(factors.begin(), factors.end(), [](const Factor& a, const Factor& b) {
          return a.exponent != b.exponent ? a.exponent < b.exponent : compare(a.base, b.base) < 0;
        });
    EXPECT_TRUE(sorted);
  }
}

// The norm of a factor is a power of an irreducible polynomial over Q.
TEST_P(FactorLaws, ConjugateFactorsLieOverOnePrime) {
  for (const auto& factor : irreducible_factors(monic_poly(2) * monic_poly(1)))
    EXPECT_EQ(irreducible_factors(norm(factor.base)).size(), 1U) << to_string(factor.base);
}

// The minimal polynomial of the generator has the generator as a root, and its factor belongs to
// it.
TEST_P(FactorLaws, TheMinimalPolynomialLosesItsRoot) {
  std::vector<NfElem> c;
  for (const Integer& n : k->minpoly_coefficients())
    c.emplace_back(Rational(n));
  const auto factors = irreducible_factors(coerce(Poly::from_coefficients(c), k));
  const Poly line = z() - Poly(NfElem::generator(k));
  EXPECT_TRUE(
      std::any_of(factors.begin(), factors.end(), [&](const Factor& f) { return f.base == line; }));
  EXPECT_EQ(multiplied_back(factors), coerce(Poly::from_coefficients(c), k));
}

TEST_P(FactorLaws, ManyLinearFactorsWithMultiplicities) {
  Poly f = constant(1);
  std::vector<std::pair<NfElem, long>> planted;
  for (long i = 1; i <= 4; ++i) {
    const NfElem root = NfElem(i) + NfElem::generator(k) * NfElem(Rational(1, i));
    planted.emplace_back(root, i);
    f *= pow(z() - Poly(root), static_cast<unsigned long>(i));
  }
  const auto factors = irreducible_factors(f);
  ASSERT_EQ(factors.size(), planted.size());
  for (std::size_t i = 0; i < planted.size(); ++i) { // sorted by exponent
    EXPECT_EQ(factors[i].base, z() - Poly(planted[i].first));
    EXPECT_EQ(factors[i].exponent, planted[i].second);
  }
}

KOV_OVER_ALL_FIELDS(FactorLaws);

TEST(Factor, ProductOfAList) {
  std::vector<Poly> lines;
  Poly one_by_one(1);
  for (long i = 0; i < 9; ++i) {
    EXPECT_EQ(product(lines), one_by_one);
    lines.push_back(Poly::z() - Poly(i));
    one_by_one *= lines.back();
  }
}

// Cyclotomic polynomials are irreducible over Q, and z^n - 1 is their product over d | n.
TEST(Factor, Cyclotomic) {
  for (const unsigned n : {1U, 6U, 12U, 15U, 16U, 30U}) {
    const auto factors = irreducible_factors(pow(Poly::z(), n) - Poly(1));
    std::size_t divisors = 0;
    std::vector<long> degrees;
    for (unsigned d = 1; d <= n; ++d)
      if (n % d == 0) {
        ++divisors;
        degrees.push_back(static_cast<long>(n_euler_phi(d)));
      }
    std::sort(degrees.begin(), degrees.end());
    ASSERT_EQ(factors.size(), divisors) << n;
    for (std::size_t i = 0; i < divisors; ++i)
      EXPECT_EQ(degree(factors[i].base), degrees[i]);
  }
}

// Reducible modulo every prime, irreducible over Q (Swinnerton-Dyer).
TEST(Factor, SwinnertonDyer) {
  const Poly z = Poly::z();
  const Poly f = pow(z, 8) - Poly(40) * pow(z, 6) + Poly(352) * pow(z, 4) - Poly(960) * z * z +
                 Poly(576); // roots +-sqrt 2 +- sqrt 3 +- sqrt 5
  EXPECT_EQ(irreducible_factors(f).size(), 1U);
  EXPECT_EQ(irreducible_factors(coerce(f, make_field({-2, 0, 1}, "s"))).size(), 2U);
}

TEST(Factor, SplitsWhereTheFieldAllowsIt) {
  const struct {
    std::vector<Integer> field;
    Poly f;
    std::size_t factors;
  } table[] = {
      {{1, 0, 1}, pow(Poly::z(), 2) + Poly(1), 2},
      {{1, 0, 1}, pow(Poly::z(), 2) - Poly(2), 1},
      {{1, 0, 1}, pow(Poly::z(), 4) + Poly(1), 2},
      {{1, 0, 0, 0, 1}, pow(Poly::z(), 4) + Poly(1), 4},
      {{1, 0, 0, 0, 1}, pow(Poly::z(), 2) - Poly(2), 2},
      {{-1, -2, 1, 1}, pow(Poly::z(), 3) + pow(Poly::z(), 2) - Poly(2) * Poly::z() - Poly(1), 3},
      {{-2, 0, 0, 1}, pow(Poly::z(), 3) - Poly(2), 2},
      {{0, 1}, pow(Poly::z(), 2) + Poly(1), 1}};
  for (const auto& [field, f, count] : table) {
    const Field k = field.size() == 2 ? rationals() : make_field(field, "a");
    EXPECT_EQ(irreducible_factors(coerce(f, k)).size(), count) << to_string(f);
  }
}

TEST(Factor, ManyRationalRoots) {
  Poly f(1);
  for (long i = 1; i <= 60; ++i)
    f *= Poly::z() - Poly(Rational(i, 7));
  EXPECT_EQ(irreducible_factors(f * (Poly::z() * Poly::z() + Poly(1))).size(), 61U);
}

// Roots that agree modulo the primes of the quick look, and roots too long for it.
TEST(Factor, RationalRootsOfAllSizes) {
  const Poly z = Poly::z();
  const Integer p(1073741827L); // beside 2^30
  const Integer long_number = pow(Integer(10), 60) + Integer(7);
  const std::vector<Rational> roots{Rational(1),           Rational(p + Integer(1)),
                                    Rational(long_number), Rational(Integer(1), long_number),
                                    Rational(0),           -Rational(long_number, p)};
  Poly f(1);
  for (std::size_t i = 0; i < roots.size(); ++i)
    f *= pow(z - Poly(roots[i]), i % 3 + 1);
  const auto factors = irreducible_factors(f);
  ASSERT_EQ(factors.size(), roots.size());
  for (const Factor& factor : factors) {
    const auto at = std::find(roots.begin(), roots.end(), to_rational(-factor.base.coeff(0)));
    ASSERT_NE(at, roots.end());
    EXPECT_EQ(factor.exponent, (at - roots.begin()) % 3 + 1);
  }
}

TEST(Factor, BudgetAndZero) {
  Budget small;
  small.max_degree = 3;
  EXPECT_THROW((void)irreducible_factors(pow(Poly::z(), 5) + Poly::z() + Poly(3), small),
               OutOfBudget);
  EXPECT_THROW((void)irreducible_factors(Poly(0)), InternalError);
  EXPECT_THROW((void)squarefree_factors(Poly(0)), InternalError);
  EXPECT_TRUE(irreducible_factors(Poly(5)).empty());
}

TEST(Factor, SquareRootsInAField) {
  const Field k = make_field({-2, 0, 1}, "s");
  const NfElem s = NfElem::generator(k);
  const NfElem a = NfElem(3) + NfElem(2) * s; // (1+s)^2
  const auto root = exact_sqrt(a);
  ASSERT_TRUE(root);
  EXPECT_EQ(*root * *root, a);
  EXPECT_FALSE(exact_sqrt(NfElem(3) + s));
  EXPECT_TRUE(exact_sqrt(coerce(NfElem(2), k)));
}

} // namespace
} // namespace kov
