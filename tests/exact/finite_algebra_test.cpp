#include "exact/finite_algebra.hpp"

#include "exact/error.hpp"
#include "exact/polynomials.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;
using Element = FiniteAlgebra::Element;

class FiniteAlgebraLaws : public Polynomials {
protected:
  [[nodiscard]] FiniteAlgebra algebra(const std::vector<MFraction>& generators) const {
    std::vector<MPoly> g;
    for (const MFraction& f : generators)
      g.push_back(f.num());
    return FiniteAlgebra(Ideal(ring, {0, 1}, g));
  }
  // Two fields, a product of fields, and a ring with nilpotent elements; all over Q(a).
  [[nodiscard]] std::vector<std::vector<MFraction>> examples() const {
    return {{x * x - a, y},
            {x * x - Rational(2) * one, y * y - Rational(3) * one},
            {x * x - one, y - x},
            {x * x, x * y, y * y - a},
            {x * x + y * y - a, x * y - one}};
  }
  [[nodiscard]] Element element(const FiniteAlgebra& r) {
    Element e = r.zero();
    for (auto& entry : e)
      entry =
          MFraction(ring, Rational(number(-4, 4), 3)) + MFraction(ring, Rational(number(0, 1))) * a;
    return e;
  }
  [[nodiscard]] std::vector<MFraction> apply(const std::vector<std::vector<MFraction>>& m,
                                             const std::vector<MFraction>& v) const {
    std::vector<MFraction> result;
    for (const auto& row : m) {
      MFraction sum(ring);
      for (std::size_t j = 0; j < v.size(); ++j)
        sum += row[j] * v[j];
      result.push_back(sum);
    }
    return result;
  }
};

TEST_F(FiniteAlgebraLaws, CommutativeAlgebra) {
  for (const auto& generators : examples()) {
    const FiniteAlgebra r = algebra(generators);
    const Element unit = r.constant(one);
    for (int i = 0; i < 4; ++i) {
      const Element u = element(r);
      const Element v = element(r);
      const Element w = element(r);
      EXPECT_EQ(r.multiply(u, v), r.multiply(v, u));
      EXPECT_EQ(r.multiply(r.multiply(u, v), w), r.multiply(u, r.multiply(v, w)));
      EXPECT_EQ(r.multiply(u, v + w), r.multiply(u, v) + r.multiply(u, w));
      EXPECT_EQ(r.multiply(u, unit), u);
      EXPECT_EQ(u - v, u + scale(v, -one));
      EXPECT_EQ(scale(u, a), r.multiply(u, r.constant(a)));
      EXPECT_TRUE(is_zero(u - u));
      EXPECT_TRUE(is_zero(r.zero()));
    }
    EXPECT_EQ(r.basis().size(), r.dimension());
  }
}

TEST_F(FiniteAlgebraLaws, EvaluationIsAHomomorphismAndLiftItsInverse) {
  for (const auto& generators : examples()) {
    const FiniteAlgebra r = algebra(generators);
    for (const MFraction& g : generators)
      EXPECT_TRUE(is_zero(*r.evaluate(g)));
    for (int i = 0; i < 4; ++i) {
      const MFraction f = x * x * MFraction(ring, Rational(number(-3, 3))) + y - a;
      const MFraction g = x * y + MFraction(ring, Rational(number(-3, 3))) * x;
      EXPECT_EQ(*r.evaluate(f + g), *r.evaluate(f) + *r.evaluate(g));
      EXPECT_EQ(*r.evaluate(f * g), r.multiply(*r.evaluate(f), *r.evaluate(g)));
      const Element u = element(r);
      EXPECT_EQ(*r.evaluate(r.lift(u)), u);
      if (const auto quotient = r.evaluate(f / g)) {
        EXPECT_EQ(r.multiply(*quotient, *r.evaluate(g)), *r.evaluate(f));
      }
    }
  }
}

TEST_F(FiniteAlgebraLaws, UnitsHaveInversesAndZeroDivisorsAreRefused) {
  for (const auto& generators : examples()) {
    const FiniteAlgebra r = algebra(generators);
    for (int i = 0; i < 5; ++i) {
      const Element u = element(r);
      const auto m = r.minimal_polynomial(u);
      const auto inverse = r.invert(u);
      // a unit is what has a minimal polynomial that does not vanish at 0
      EXPECT_EQ(inverse.has_value(), !is_zero(m.front()));
      if (inverse) {
        EXPECT_EQ(r.multiply(u, *inverse), r.constant(one));
      }
    }
    EXPECT_FALSE(r.invert(r.zero()));
  }
  const FiniteAlgebra two = algebra({x * x - one, y - x});
  EXPECT_FALSE(two.invert(*two.evaluate(x - one)));
  EXPECT_FALSE(two.evaluate(one / (x - one)));
  EXPECT_FALSE(two.evaluate(one / (x - y)));
  const FiniteAlgebra fat = algebra({x * x, y});
  EXPECT_EQ(fat.lift(*fat.invert(*fat.evaluate(one + x))), one - x);
}

TEST_F(FiniteAlgebraLaws, MinimalPolynomialsAnnihilateAndAreShortest) {
  for (const auto& generators : examples()) {
    const FiniteAlgebra r = algebra(generators);
    for (int i = 0; i < 3; ++i) {
      const Element u = element(r);
      const auto m = r.minimal_polynomial(u);
      EXPECT_TRUE(is_one(m.back()));
      EXPECT_LE(m.size(), r.dimension() + 1);
      Element value = r.zero();
      std::vector<Element> powers{r.constant(one)};
      for (const MFraction& c : m) {
        value = value + scale(powers.back(), c);
        powers.push_back(r.multiply(powers.back(), u));
      }
      EXPECT_TRUE(is_zero(value));
      EXPECT_FALSE(r.minimal_polynomial(u, m.size() - 2));
      EXPECT_EQ(r.minimal_polynomial(u, m.size() - 1), m);
      // 1, u, ..., u^(deg-1) are independent
      std::vector<std::vector<MFraction>> rows(r.dimension());
      for (std::size_t j = 0; j < r.dimension(); ++j)
        for (std::size_t e = 0; e + 1 < m.size(); ++e)
          rows[j].push_back(powers[e][j]);
      EXPECT_TRUE(null_space(rows, m.size() - 1, ring).empty());
    }
    EXPECT_EQ(r.minimal_polynomial(r.constant(a)), (std::vector<MFraction>{-a, one}));
  }
  const FiniteAlgebra k = algebra({x * x - Rational(2) * one, y * y - Rational(3) * one});
  const auto m = k.minimal_polynomial(*k.evaluate(x + y)); // t^4 - 10 t^2 + 1
  const std::vector<MFraction> expected{one, MFraction(ring), Rational(-10) * one, MFraction(ring),
                                        one};
  EXPECT_EQ(m, expected);
}

TEST_F(FiniteAlgebraLaws, ConstantsAreRecognised) {
  const FiniteAlgebra k = algebra({x * x - a, y - x});
  EXPECT_EQ(k.dimension(), 2U);
  EXPECT_EQ(*k.in_base_field(*k.evaluate(x * y)), a);
  EXPECT_FALSE(k.in_base_field(*k.evaluate(x)));
  EXPECT_EQ(*k.invert(*k.evaluate(x)), *k.evaluate(y / a)); // x = y = sqrt a
  EXPECT_EQ(*k.evaluate(one / (x - one)), *k.evaluate((y + one) / (a - one)));
}

TEST_F(FiniteAlgebraLaws, OtherIdealsAreRefused) {
  EXPECT_THROW((void)algebra({x * y}), InvalidArgument);
  EXPECT_THROW((void)algebra({one}), InvalidArgument);
  EXPECT_THROW(FiniteAlgebra(Ideal(ring, {0}, {(pow(x, 9) - a).num()}), 8), OutOfBudget);
}

// ---- linear algebra over the fractions

TEST_F(FiniteAlgebraLaws, SolutionsSolveAndTheNullSpaceIsComplete) {
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const auto rows = static_cast<std::size_t>(number(1, 4));
    const auto columns = static_cast<std::size_t>(number(1, 4));
    std::vector m(rows, std::vector<MFraction>(columns, MFraction(ring)));
    for (auto& row : m)
      for (auto& entry : row)
        if (number(0, 2) != 0) entry = MFraction(poly(2, 1));
    if (rows > 1) m[rows - 1] = m[0]; // a rank that is not full
    std::vector<MFraction> planted;
    for (std::size_t j = 0; j < columns; ++j)
      planted.push_back(MFraction(ring, Rational(number(-3, 3))) + a);
    const auto b = apply(m, planted);
    const auto solution = solve_linear(m, b);
    ASSERT_TRUE(solution);
    EXPECT_EQ(apply(m, *solution), b);
    const auto kernel = null_space(m, columns, ring);
    for (const auto& v : kernel)
      EXPECT_EQ(apply(m, v), std::vector<MFraction>(rows, MFraction(ring)));
    // rank and nullity: the transpose has the same rank, and rows - rank relations
    std::vector transpose(columns, std::vector<MFraction>(rows, MFraction(ring)));
    for (std::size_t r = 0; r < rows; ++r)
      for (std::size_t c = 0; c < columns; ++c)
        transpose[c][r] = m[r][c];
    EXPECT_EQ(columns - kernel.size(), rows - null_space(transpose, rows, ring).size());
    if (rows > 1) { // equal rows, different right sides
      auto wrong = b;
      wrong.back() += one;
      EXPECT_FALSE(solve_linear(m, wrong));
    }
  }
}

TEST_F(FiniteAlgebraLaws, AMatrixWithoutRowsHasEveryVectorInItsNullSpace) {
  const auto all = null_space({}, 3, ring);
  ASSERT_EQ(all.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_EQ(all[i][j], i == j ? one : MFraction(ring));
  const auto zeros = null_space({{MFraction(), MFraction()}}, 2, ring); // zeros without variables
  ASSERT_EQ(zeros.size(), 2U);
  EXPECT_EQ(zeros[1][1], one);
  EXPECT_TRUE(solve_linear({}, {})->empty());
}

} // namespace
} // namespace kov
