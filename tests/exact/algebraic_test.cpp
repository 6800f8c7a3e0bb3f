#include "exact/algebraic.hpp"

#include "exact/error.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

TEST(Integer, SquarePart) {
  const struct {
    long d, s, n;
  } table[] = {{1, 1, 1},
               {-1, 1, -1},
               {8, 2, 2},
               {-12, 2, -3},
               {36, 6, 1},
               {-49, 7, -1},
               {2 * 9973, 1, 19946},
               {5 * 10007L * 10007L, 10007, 5},
               {720, 12, 5}};
  for (const auto& [d, s, n] : table)
    EXPECT_EQ(square_part(Integer(d)), std::pair(Integer(s), Integer(n))) << d;
  // a high power at once, not one square after the other
  const auto [s, n] = square_part(pow(Integer(40001), 200001) * Integer(3));
  EXPECT_EQ(n, Integer(3 * 40001L)); // 13 * 17 * 181, each to an odd power
  EXPECT_EQ(s, pow(Integer(40001), 100000));
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
}

TEST(QQbar, TheFieldKnowsWhichRootIsMeant) {
  for (const QQbar& a : roots({-2, 0, 0, 1})) { // x^3 - 2
    const Field k = field_of(a, "a");
    EXPECT_TRUE(equals(NfElem::generator(k), a));
    for (const QQbar& other : roots({-2, 0, 0, 1}))
      EXPECT_EQ(equals(NfElem::generator(k), other), other == a);
    EXPECT_TRUE(equals(pow(NfElem::generator(k), 3), QQbar(2)));
  }
  EXPECT_THROW((void)field_of(principal_root(QQbar(Rational(1, 2)), 3), "a"), InvalidArgument);
}

TEST(NumberField, AReduciblePolynomialIsRefused) {
  for (const std::vector<Integer>& m :
       {std::vector<Integer>{0, 0, 1}, {-1, 0, 1}, {0, 1, 0, 1}, {4, 0, 0, 0, 1}, {1}, {1, 0, 2}})
    EXPECT_THROW(static_cast<void>(make_field(m, "a")), InvalidArgument);
  EXPECT_EQ(make_field({-2, 0, 1}, "a")->degree(), 2);
}

} // namespace
} // namespace kov
