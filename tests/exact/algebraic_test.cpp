#include "exact/algebraic.hpp"

#include "exact/error.hpp"
#include "exact/laws.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using testing::value_laws;

std::vector<QQbar> numbers() {
  std::vector<QQbar> all{QQbar(0), QQbar(1), QQbar(Rational(-3, 7)), QQbar::i()};
  all.push_back(principal_root(QQbar(2), 2));
  all.push_back(principal_root(QQbar(-5), 3));
  all.push_back(roots({-1, -1, 0, 1})[1]);
  return all;
}

// The value of a polynomial with integer coefficients by Horner's rule.
QQbar horner(const std::vector<Integer>& f, const QQbar& x) {
  QQbar value;
  for (std::size_t i = f.size(); i-- > 0;)
    value = value * x + QQbar(Rational(f[i]));
  return value;
}

bool overlap(const ComplexBall& a, const ComplexBall& b) {
  return acb_overlaps(a.raw(), b.raw()) != 0;
}

TEST(QQbarLaws, Ring) {
  const auto all = numbers();
  for (const QQbar& a : all)
    for (const QQbar& b : all) {
      EXPECT_EQ(a + b, b + a);
      EXPECT_EQ(a * b, b * a);
      EXPECT_EQ(a + QQbar(0), a);
      EXPECT_EQ(a * QQbar(1), a);
      EXPECT_EQ(Integer(-3) * a, QQbar(-3) * a);
      EXPECT_EQ(a + Integer(-1) * a, QQbar(0));
      value_laws(a, b);
    }
  for (std::size_t i = 3; i + 2 < all.size(); ++i) { // towers of three: degrees multiply
    const QQbar &a = all[i], &b = all[i + 1], &c = all[i + 2];
    EXPECT_EQ((a + b) + c, a + (b + c));
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ(a * (b + c), a * b + a * c);
  }
}

TEST(QQbarLaws, MinimalPolynomialsVanishAndAreCanonical) {
  for (const QQbar& a : numbers()) {
    const auto m = minimal_polynomial(a);
    EXPECT_EQ(static_cast<long>(m.size()), degree(a) + 1);
    EXPECT_EQ(sign(m.back()), 1);
    Integer content;
    for (const Integer& c : m)
      content = gcd(content, c);
    EXPECT_EQ(content, Integer(1));
    EXPECT_EQ(horner(m, a), QQbar(0));
    // a number is one of the roots of its minimal polynomial, exactly once
    const auto conjugates = roots(m);
    EXPECT_EQ(std::count(conjugates.begin(), conjugates.end(), a), 1);
  }
  EXPECT_EQ(degree(principal_root(QQbar(2), 2) + principal_root(QQbar(3), 2)), 4);
}

TEST(QQbarLaws, EnclosuresHoldTheNumber) {
  const auto all = numbers();
  for (const QQbar& a : all)
    for (const QQbar& b : all) {
      ComplexBall sum;
      ComplexBall product;
      acb_add(sum.raw(), enclosure(a, 90).raw(), enclosure(b, 90).raw(), 90);
      acb_mul(product.raw(), enclosure(a, 90).raw(), enclosure(b, 90).raw(), 90);
      EXPECT_TRUE(overlap(sum, enclosure(a + b, 90)));
      EXPECT_TRUE(overlap(product, enclosure(a * b, 90)));
      EXPECT_EQ(overlap(enclosure(a, 200), enclosure(b, 200)), a == b);
    }
}

// Vieta: the elementary symmetric functions of the roots are the coefficients.
TEST(QQbarLaws, RootsMultiplyBack) {
  const std::vector<std::vector<Integer>> table{{-2, 0, 1},     {6, -5, 1},      {1, 0, 1},
                                                {4, -4, 1},     {-1, -1, 0, 1},  {0, 0, 3},
                                                {-1, 3, -3, 1}, {1, 0, 0, 0, 1}, {-6, 1, 2}};
  for (const auto& f : table) {
    const auto all = roots(f);
    ASSERT_EQ(all.size(), f.size() - 1);
    std::vector<QQbar> product{QQbar(Rational(f.back()))}; // ascending
    for (const QQbar& r : all) {
      std::vector<QQbar> next(product.size() + 1);
      for (std::size_t i = 0; i < product.size(); ++i) {
        next[i + 1] = next[i + 1] + product[i];
        next[i] = next[i] + Integer(-1) * (r * product[i]);
      }
      product = std::move(next);
    }
    for (std::size_t i = 0; i < f.size(); ++i)
      EXPECT_EQ(product[i], QQbar(Rational(f[i])));
  }
  EXPECT_TRUE(roots({7}).empty());
}

TEST(QQbarLaws, RealRootsComeFirstFromTheLargestDown) {
  const auto all = roots({-6, 5, 5, -5, 1}); // (x^2 - 1)(x - 2)(x - 3)
  ASSERT_EQ(all.size(), 4U);
  for (const auto& [i, n] : {std::pair(0, 3), {1, 2}, {2, 1}, {3, -1}})
    EXPECT_EQ(all[static_cast<std::size_t>(i)], QQbar(n));
  EXPECT_EQ(roots({-2, 0, 0, 1})[0], principal_root(QQbar(2), 3)); // the real one
}

TEST(QQbarLaws, PrincipalRoots) {
  for (const QQbar& a : numbers())
    for (const unsigned long n : {1UL, 2UL, 3UL}) {
      const QQbar r = principal_root(a, n);
      QQbar power(1);
      for (unsigned long i = 0; i < n; ++i)
        power = power * r;
      EXPECT_EQ(power, a);
      if (a == QQbar(0)) continue;
      Ball argument; // in (-pi/n, pi/n]
      Ball limit;
      acb_arg(argument.raw(), enclosure(r, 128).raw(), 128);
      arb_const_pi(limit.raw(), 128);
      arb_div_ui(limit.raw(), limit.raw(), n, 128);
      EXPECT_LE(lower_bound(argument), upper_bound(limit));
      EXPECT_GT(upper_bound(argument), -lower_bound(limit));
    }
}

TEST(QQbarLaws, EvaluationIsHornersRule) {
  fmpq_poly_t f;
  fmpq_poly_init(f);
  fmpq_poly_set_str(f, "4  1/2 -3 0 2/5");
  for (const QQbar& a : numbers())
    EXPECT_EQ(Integer(10) * evaluate(f, a), horner({5, -30, 0, 4}, a));
  fmpq_poly_clear(f);
}

TEST(QQbar, QuadraticParts) {
  // (Calcium 0.4.1's own qqbar_get_quadratic gives 1 as the radicand of I)
  for (const long n : {-1L, 2L, -3L, 5L, -163L})
    for (const long v : {1L, -1L, 3L, -7L}) {
      const QQbar root = principal_root(QQbar(Rational(n)), 2);
      const QQbar a = QQbar(Rational(1, 6)) * (Integer(v) * root + QQbar(5));
      const Quadratic q = quadratic_parts(a);
      EXPECT_EQ(q.n, Integer(n));
      EXPECT_EQ(Rational(q.v, q.w), Rational(v, 6));
      EXPECT_EQ(Rational(q.u, q.w), Rational(5, 6));
    }
  EXPECT_THROW((void)quadratic_parts(QQbar(3)), InternalError);
}

TEST(QQbar, TheFieldKnowsWhichRootIsMeant) {
  const std::vector<std::vector<Integer>> table{
      {-2, 0, 0, 1}, {1, 0, 1}, {-1, -2, 1, 1}, {-1, -1, 0, 0, 0, 1}, {1, 0, 0, 0, 1}};
  for (const auto& f : table)
    for (const QQbar& a : roots(f)) {
      const Field k = field_of(a, "a");
      const NfElem x = NfElem::generator(k);
      EXPECT_TRUE(equals(x, a));
      for (const QQbar& other : roots(f))
        EXPECT_EQ(equals(x, other), other == a);
      // the embedding carries sums and products over
      EXPECT_TRUE(equals(x * x + NfElem(Rational(1, 3)), a * a + QQbar(Rational(1, 3))));
      EXPECT_TRUE(equals(pow(x, 5), a * a * a * a * a));
      EXPECT_FALSE(equals(x + NfElem(1), a));
    }
  EXPECT_THROW((void)field_of(principal_root(QQbar(Rational(1, 2)), 3), "a"), InvalidArgument);
  EXPECT_TRUE(field_of(QQbar(5), "a")->is_rational());
  EXPECT_TRUE(equals(NfElem(Rational(2, 3)), QQbar(Rational(2, 3))));
}

TEST(NumberField, AReduciblePolynomialIsRefused) {
  for (const std::vector<Integer>& m :
       {std::vector<Integer>{0, 0, 1}, {-1, 0, 1}, {0, 1, 0, 1}, {4, 0, 0, 0, 1}, {1}, {1, 0, 2}})
    EXPECT_THROW(static_cast<void>(make_field(m, "a")), InvalidArgument);
  EXPECT_EQ(make_field({-2, 0, 1}, "a")->degree(), 2);
}

} // namespace
} // namespace kov
