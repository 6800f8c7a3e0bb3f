// Solutions from the evidence: planted ones come back, over every field, and Riccati polynomials
// are the products of the lines that they were made from.

#include "galois/solutions.hpp"

#include "exact/fields.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

using Polynomial = std::vector<RationalFunction>; ///< in w, ascending

Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      c[i + j] += a[i] * b[j];
  return c;
}

RationalFunction number(const NfElem& c) { return RationalFunction(Poly(c)); }

class SolutionLaws : public OverFields {
protected:
  // Two exponentials with product v and Wronskian w: omega = (v' +- w)/(2v).
  struct Pair {
    RationalFunction v;
    NfElem w;
    RationalFunction r, omega, other;
  };
  [[nodiscard]] Pair pair() {
    while (true) {
      const RationalFunction v(scale(monic_poly(number_of_zeros()), nonzero()), monic_poly(1));
      const NfElem w = nonzero();
      const RationalFunction half = RationalFunction(Rational(1, 2)) / v;
      Pair p{v, w, from_square(v * v, w * w), (derivative(v) + kov::number(w)) * half,
             (derivative(v) - kov::number(w)) * half};
      if (!is_zero(p.r)) return p;
    }
  }
  [[nodiscard]] long number_of_zeros() { return OverFields::number(1, 2); }
};

TEST_P(SolutionLaws, TheEquationOfAPairHasBoth) {
  for (int i = 0; i < 4; ++i) {
    const Pair p = pair();
    EXPECT_EQ(from_omega(p.omega), p.r);
    EXPECT_EQ(from_omega(p.other), p.r);
    const auto found = solutions(classify(p.r), p.r);
    ASSERT_EQ(found.size(), 2U) << to_string(p.r);
    std::vector<RationalFunction> omegas;
    for (const LiouvillianSolution& y : found) {
      ASSERT_TRUE(y.exponential);
      omegas.push_back(y.exponential->omega());
      EXPECT_EQ(from_omega(omegas.back()), p.r);
    }
    EXPECT_FALSE(omegas[0] == omegas[1]);
    // with more than two lines (a trivial group) others may be found
    if (classify(p.r).pair) {
      EXPECT_EQ(omegas[0] + omegas[1], p.omega + p.other);
      EXPECT_TRUE(omegas[0] == p.omega || omegas[1] == p.omega);
    }
  }
}

// y1^a y2^b has the polynomial (w - omega1)^a (w - omega2)^b.
TEST_P(SolutionLaws, RiccatiPolynomialsAreProductsOfLines) {
  for (int i = 0; i < 3; ++i) {
    const Pair p = pair();
    for (long a = 0; a <= 3; ++a)
      for (long b = a == 0 ? 1 : 0; a + b <= 4; ++b) {
        Polynomial expected{RationalFunction(1)};
        for (long j = 0; j < a; ++j)
          expected = times(expected, {-p.omega, RationalFunction(1)});
        for (long j = 0; j < b; ++j)
          expected = times(expected, {-p.other, RationalFunction(1)});
        const RationalFunction u = RationalFunction(a) * p.omega + RationalFunction(b) * p.other;
        EXPECT_EQ(riccati_polynomial(a + b, u, p.r), expected) << a << ", " << b;
      }
    // what is not a product of m solutions is refused, not returned
    EXPECT_THROW(static_cast<void>(riccati_polynomial(
                     2, p.omega + p.other + RationalFunction(Poly(1), z() - constant(91)), p.r)),
                 InternalError);
  }
}

// (y1 y2)^2 = f: the quadratic of a dihedral group is w^2 - phi w + phi'/2 + phi^2/2 - r.
TEST_P(SolutionLaws, TheQuadraticOfADihedralGroup) {
  const RationalFunction half(Rational(1, 2));
  for (int i = 0; i < 3; ++i) {
    const Poly f = z() * (z() * z() + constant(43)) * monic_poly(1);
    const RationalFunction r = from_square(RationalFunction(f), nonzero());
    const RationalFunction phi = derivative(RationalFunction(f)) * half / RationalFunction(f);
    const Polynomial quadratic{derivative(phi) * half + phi * phi * half - r, -phi,
                               RationalFunction(1)};
    EXPECT_EQ(riccati_polynomial(2, phi, r), quadratic);
    EXPECT_EQ(riccati_polynomial(4, phi + phi, r), times(quadratic, quadratic));
  }
}

KOV_OVER_ALL_FIELDS(SolutionLaws);

// w^2 in Q without root there: two conjugate solutions over Q(w).
TEST(Solutions, ConjugateExponentials) {
  const Poly z = Poly::z();
  for (const long n : {-1L, 2L, -3L, 5L, 12L})
    for (const Poly& v : {z, z * z + Poly(1), z * (z - Poly(2))}) {
      const RationalFunction r = from_square(RationalFunction(v * v), NfElem(n));
      const auto found = solutions(classify(r), r);
      ASSERT_EQ(found.size(), 2U) << to_string(r);
      const RationalFunction a = found[0].exponential->omega();
      const RationalFunction b = found[1].exponential->omega();
      EXPECT_EQ(a.field()->degree(), 2);
      EXPECT_EQ(from_omega(a), coerce(r, a.field()));
      EXPECT_EQ(a + b, coerce(RationalFunction(derivative(v), v), a.field()));
      const RationalFunction w = (a - b) * coerce(RationalFunction(v), a.field());
      EXPECT_EQ(w * w, coerce(RationalFunction(n), a.field()));
    }
}

// Groups {1} and {+-1}: every solution is the square root of a rational function, two are shown.
// Spherical Bessel functions of order n behind a map, a square or not a square: n zeros (2n behind it)
// are P, and theta has the places only.
TEST(Solutions, ManyZeros) {
  const Poly x = Poly::z();
  for (const long n : {20L, 40L, 80L})
    for (const long a : {-1L, 4L, 3L})
      for (const RationalFunction& f :
           {RationalFunction(x), RationalFunction(x * x - Poly(2), x + Poly(1))}) {
        const RationalFunction bessel(Poly(n * (n + 1)) + scale(x * x, NfElem(a)), x * x);
        const RationalFunction r = pull_back(bessel, f);
        const Classification c = classify(r);
        ASSERT_TRUE(c.group && c.group->type == GroupType::Gm) << n;
        const auto found = solutions(c, r);
        ASSERT_EQ(found.size(), 2U);
        RationalFunction omegas;
        for (const LiouvillianSolution& y : found) {
          const auto& [theta, P] = *y.exponential;
          const RationalFunction omega = y.exponential->omega();
          EXPECT_EQ(derivative(omega) + omega * omega, r);
          omegas += omega;
          if (n * degree(f.num()) < 60) continue;
          EXPECT_EQ(degree(P), n * degree(f.num()));
          EXPECT_LE(degree(theta.den()), 6);
        }
        EXPECT_EQ(omegas, derivative(c.pair->v) / c.pair->v);
      }
}

TEST(Solutions, SquareRootsOfRationalFunctions) {
  const Poly z = Poly::z();
  const RationalFunction free(0);
  const RationalFunction cases[] = {
      RationalFunction(Poly(2), z * z), RationalFunction(Poly(6), pow(z - Poly(1), 2)),
      RationalFunction(Poly(3), Poly(4) * z * z), // exponents 3/2, -1/2
      pull_back(free, RationalFunction(z * z * z - z)),
      pull_back(free, RationalFunction(z * z, z - Poly(1)))};
  for (const RationalFunction& r : cases) {
    const Classification c = classify(r);
    ASSERT_TRUE(c.group) << to_string(r);
    EXPECT_EQ(c.group->type, GroupType::cyclic);
    const auto found = solutions(c, r);
    ASSERT_EQ(found.size(), 2U);
    const RationalFunction a = found[0].exponential->omega();
    const RationalFunction b = found[1].exponential->omega();
    EXPECT_EQ(from_omega(a), r);
    EXPECT_EQ(from_omega(b), r);
    // independent: y1 y2 (a - b) is the Wronskian, so that (a - b)'/(a - b) = -a - b
    ASSERT_FALSE(is_zero(a - b));
    EXPECT_EQ(derivative(a - b), -(a - b) * (a + b));
  }
  EXPECT_EQ(solutions(classify(free), free).size(), 2U);
}

} // namespace
} // namespace kov
