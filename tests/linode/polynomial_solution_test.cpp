#include "linode/polynomial_solution.hpp"

#include "exact/fields.hpp"

#include <gtest/gtest.h>

namespace kov::polynomial_solution_test {
namespace {

using namespace testing;

class PolynomialSolutionLaws : public OverFields {
protected:
  [[nodiscard]] static Poly residual(const Poly& c2, const Poly& c1, const Poly& c0,
                                     const Poly& f) {
    return c2 * derivative(derivative(f)) + c1 * derivative(f) + c0 * f;
  }
  // Is z^d a combination of L(1), ..., L(z^(d-1)) after application of L?  Gauss over K.
  [[nodiscard]] bool exists(const Poly& c2, const Poly& c1, const Poly& c0, long d) const {
    std::vector<Poly> images;
    for (long i = 0; i < d; ++i)
      images.push_back(residual(c2, c1, c0, pow(z(), static_cast<unsigned long>(i))));
    Poly target = residual(c2, c1, c0, pow(z(), static_cast<unsigned long>(d)));
    for (std::size_t i = 0; i < images.size(); ++i) {
      if (is_zero(images[i])) continue;
      const long top = degree(images[i]);
      const auto clear = [&](Poly& f) {
        f -= scale(images[i], f.coeff(top) / images[i].coeff(top));
      };
      for (std::size_t j = i + 1; j < images.size(); ++j)
        clear(images[j]);
      clear(target);
    }
    return is_zero(target);
  }
};

TEST_P(PolynomialSolutionLaws, PlantedSolutionsAreFound) {
  for (int i = 0; i < 8; ++i) {
    const Poly p = monic_poly(number(0, 5));
    const Poly a = monic_poly(number(0, 2));
    const Poly b = poly(2);
    const Poly c0 = -(a * derivative(derivative(p)) + b * derivative(p));
    const auto found = polynomial_solution(a * p, b * p, c0, degree(p));
    ASSERT_TRUE(found) << to_string(p);
    EXPECT_EQ(degree(*found), degree(p));
    EXPECT_TRUE(is_one(lead(*found)));
    EXPECT_TRUE(is_zero(residual(a * p, b * p, c0, *found)));
  }
}

TEST_P(PolynomialSolutionLaws, FoundExactlyWhereLinearAlgebraFindsOne) {
  int none = 0;
  int some = 0;
  for (int i = 0; i < 40; ++i) {
    const Poly c2 = constant(number(-1, 1)) * z() * z() + constant(number(-1, 1));
    const Poly c1 = constant(number(-2, 2)) * z() + constant(number(-1, 1));
    const Poly c0 = constant(number(-6, 6));
    if (is_zero(c2) && is_zero(c1) && is_zero(c0)) continue;
    for (long d = 0; d <= 4; ++d) {
      const auto found = polynomial_solution(c2, c1, c0, d);
      EXPECT_EQ(found.has_value(), exists(c2, c1, c0, d))
          << to_string(c2) << ", " << to_string(c1) << ", " << to_string(c0) << ": " << d;
      if (found) {
        EXPECT_TRUE(is_zero(residual(c2, c1, c0, *found)));
      }
      ++(found ? some : none);
    }
  }
  EXPECT_GT(none, 20);
  EXPECT_GT(some, 0);
}

KOV_OVER_ALL_FIELDS(PolynomialSolutionLaws);

// The classical polynomials, by their three-term recurrences.
TEST(PolynomialSolution, ClassicalPolynomials) {
  const Poly z = Poly::z();
  const auto number = [](long n) { return Poly(n); };
  Poly hermite[2] = {Poly(1), number(2) * z};
  Poly legendre[2] = {Poly(1), z};
  Poly chebyshev[2] = {Poly(1), z};
  Poly laguerre[2] = {Poly(1), Poly(1) - z};
  for (long n = 1; n <= 12; ++n) {
    EXPECT_EQ(polynomial_solution(Poly(1), number(-2) * z, number(2 * n), n), monic(hermite[1]));
    EXPECT_EQ(polynomial_solution(Poly(1) - z * z, number(-2) * z, number(n * (n + 1)), n),
              monic(legendre[1]));
    EXPECT_EQ(polynomial_solution(Poly(1) - z * z, -z, number(n * n), n), monic(chebyshev[1]));
    EXPECT_EQ(polynomial_solution(z, Poly(1) - z, number(n), n), monic(laguerre[1]));
    EXPECT_FALSE(polynomial_solution(Poly(1), number(-2) * z, number(2 * n + 1), n));
    EXPECT_FALSE(polynomial_solution(Poly(1), number(-2) * z, number(2 * n), n + 1));
    const auto step = [&](Poly* f, const Poly& next) { f[0] = std::exchange(f[1], next); };
    step(hermite, number(2) * z * hermite[1] - number(2 * n) * hermite[0]);
    step(legendre, scale(number(2 * n + 1) * z * legendre[1] - number(n) * legendre[0],
                         NfElem(Rational(1, n + 1))));
    step(chebyshev, number(2) * z * chebyshev[1] - chebyshev[0]);
    step(laguerre, scale((number(2 * n + 1) - z) * laguerre[1] - number(n) * laguerre[0],
                         NfElem(Rational(1, n + 1))));
  }
}

// Two exponents at infinity that differ by a natural number: one coefficient is free, and it may be
// needed to make the lower ones fit.
TEST(PolynomialSolution, AFreeCoefficientIsUsed) {
  const Poly z = Poly::z();
  // solutions z^3 + z and z: exponents 3 and 1 at infinity
  const Poly f = pow(z, 3) + z;
  const Poly w = f - z * derivative(f); // the Wronskian of f and z, up to sign
  // y'' w - y' w' + ... with both as solutions: determinant of rows (y, f, z)
  const Poly c2 = w;
  const Poly c1 = z * derivative(derivative(f));
  const Poly c0 = -derivative(derivative(f));
  const auto found = polynomial_solution(c2, c1, c0, 3);
  ASSERT_TRUE(found);
  EXPECT_EQ(degree(*found), 3);
  EXPECT_TRUE(is_zero(c2 * derivative(derivative(*found)) + c1 * derivative(*found) + c0 * *found));
  EXPECT_EQ(polynomial_solution(c2, c1, c0, 1), z);
  EXPECT_FALSE(polynomial_solution(c2, c1, c0, 2));
}

TEST(PolynomialSolution, Limits) {
  Budget small;
  small.max_degree = 5;
  EXPECT_THROW((void)polynomial_solution(Poly(1), Poly(0), Poly(0), 6, small), OutOfBudget);
  EXPECT_THROW((void)polynomial_solution(Poly(1), Poly(0), Poly(0), -1), InternalError);
}

// Of large degree absence is told by one prime; what there is is found all the same.
TEST(PolynomialSolution, OfLargeDegree) {
  const Poly z = Poly::z();
  for (const long n : {63L, 64L, 65L, 200L, 1000L}) {
    const Poly last(n * (n + 1));
    const auto legendre = polynomial_solution(Poly(1) - z * z, Poly(-2) * z, last, n);
    ASSERT_TRUE(legendre) << n;
    EXPECT_EQ(degree(*legendre), n);
    EXPECT_FALSE(polynomial_solution(z - z * z * z, Poly(-2) * z * z, last * z + Poly(5), n)) << n;
  }
}

// f'' (p q' - p' q) - f' (p q'' - p'' q) + f (p' q'' - p'' q') = 0 for f = p and f = q: the
// coefficient of z^(deg q) is free.
TEST(PolynomialSolution, WithAFreeCoefficientOfLargeDegree) {
  const Poly z = Poly::z();
  for (const unsigned long m : {2UL, 31UL, 69UL}) {
    const Poly p = pow(z, 70) + z;
    const Poly q = pow(z, m) + Poly(1);
    const Poly dp = derivative(p), dq = derivative(q), ddp = derivative(dp), ddq = derivative(dq);
    const Poly c2 = p * dq - dp * q, c1 = ddp * q - p * ddq, c0 = dp * ddq - ddp * dq;
    const auto found = polynomial_solution(c2, c1, c0, 70);
    ASSERT_TRUE(found) << m;
    EXPECT_TRUE(
        is_zero(c2 * derivative(derivative(*found)) + c1 * derivative(*found) + c0 * *found));
    EXPECT_FALSE(polynomial_solution(c2, c1, c0 + Poly(1), 70)) << m;
  }
}

} // namespace
} // namespace kov::polynomial_solution_test
