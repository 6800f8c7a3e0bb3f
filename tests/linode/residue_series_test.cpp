#include "linode/residue_series.hpp"

#include "exact/error.hpp"
#include "exact/fields.hpp"

#include <gtest/gtest.h>

namespace kov::residue_series_test {
namespace {

using namespace testing;

class ResidueSeriesLaws : public OverFields {
protected:
  // Places of degree one (at 0 and elsewhere), two and three.
  [[nodiscard]] std::vector<Poly> places() {
    return {z(), z() - Poly(nonzero()), z() * z() + constant(43),
            pow(z(), 3) - constant(43) * z() + constant(43)};
  }
  [[nodiscard]] static ResidueSeries product(const ResidueSeries& a, const ResidueSeries& b,
                                             const Poly& q) {
    ResidueSeries c;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
      Poly sum(0);
      for (std::size_t j = 0; j <= i; ++j)
        sum += a[j] * b[i - j];
      c.push_back(sum % q);
    }
    return c;
  }
};

TEST_P(ResidueSeriesLaws, TaylorSeriesAreARingMapAndCommuteWithTheDerivative) {
  for (const Poly& q : places())
    for (const long n : {1L, 6L, 40L}) { // 40: the long way at places of degree one
      if (n == 40 && degree(q) > 1) continue;
      const Poly f = poly(5);
      const Poly g = poly(4);
      const auto fs = taylor_at(f, q, n);
      const auto gs = taylor_at(g, q, n);
      ASSERT_EQ(static_cast<long>(fs.size()), n);
      EXPECT_EQ(taylor_at(f * g, q, n), product(fs, gs, q));
      const auto d = taylor_at(derivative(f), q, n);
      for (std::size_t i = 0; i + 1 < fs.size(); ++i)
        EXPECT_EQ(d[i], scale(fs[i + 1], NfElem(static_cast<long>(i) + 1)));
      EXPECT_EQ(fs[0], f % q); // the value at c
      for (const Poly& c : fs)
        EXPECT_LT(degree(c), degree(q));
    }
}

TEST_P(ResidueSeriesLaws, DivisionUndoesMultiplication) {
  for (const Poly& q : places())
    for (const std::size_t n : {1U, 5U, 36U}) {
      if (n == 36 && degree(q) > 1) continue;
      const auto a = taylor_at(poly(6), q, static_cast<long>(n));
      const auto b = taylor_at(poly(4) * q + constant(number(1, 9)), q, static_cast<long>(n));
      const auto c = divide(a, b, q);
      EXPECT_EQ(c.size(), n);
      EXPECT_EQ(product(c, b, q), product(a, taylor_at(constant(1), q, static_cast<long>(n)), q));
    }
}

TEST_P(ResidueSeriesLaws, SquareRoots) {
  for (const Poly& q : places())
    for (const long n : {1L, 5L, 36L}) {
      if (n == 36 && degree(q) > 1) continue;
      const auto a = taylor_at(constant(1) + q * poly(2), q, n);
      const auto s = square_root(a, q);
      EXPECT_EQ(product(s, s, q), a);
      EXPECT_TRUE(is_one(s[0]));
    }
  EXPECT_THROW((void)square_root({constant(2)}, z()), InternalError);
  EXPECT_THROW((void)square_root({}, z()), InternalError);
}

KOV_OVER_ALL_FIELDS(ResidueSeriesLaws);

} // namespace
} // namespace kov::residue_series_test
