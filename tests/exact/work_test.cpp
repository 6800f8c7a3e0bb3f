// A search among polynomials stops at the same place on every machine, and says so.

#include "exact/work.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/polynomials.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace kov {
namespace {

using ::testing::HasSubstr;

class Limits : public testing::Polynomials {
protected:
  [[nodiscard]] Ideal ideal(const std::vector<MFraction>& generators, double most) const {
    std::vector<MPoly> g;
    for (const MFraction& f : generators)
      g.push_back(f.num());
    Budget budget;
    budget.max_work = most;
    return Ideal(ring, {0, 1, 2}, g, {}, budget);
  }
  static std::string limit(const std::function<void()>& search) {
    try {
      search();
    } catch (const OutOfBudget& e) {
      return e.what();
    }
    return {};
  }
};

TEST_F(Limits, TheSizeOfAValueCountsTermsAndLongNumbers) {
  const MPoly f = (x + y + one).num();
  EXPECT_EQ(size_of(MPoly()), 1);
  EXPECT_LT(size_of(f), size_of(pow(f, 5)));
  EXPECT_GT(size_of(MPoly(ring, pow(Integer(10), 1000))), 50);
  EXPECT_GE(size_of(MFraction(f, (a * x + one).num())), size_of(f));
}

TEST_F(Limits, OfAGroebnerBasisAreCounted) {
  const std::vector<MFraction> hard{pow(x, 4) * y + z * z + a * x + one,
                                    pow(y, 4) * z + x * x + a * y + x,
                                    pow(z, 4) * x + y * y + z + a * y};
  for (int round = 0; round < 2; ++round)
    EXPECT_THAT(limit([&] { (void)ideal(hard, 100); }),
                HasSubstr("work limit: a Gröbner basis would need more than 100 products"));
  const std::vector<MFraction> easy{x * x - a, y - x, z};
  double least = 1; // the same limit is enough every time
  while (!limit([&] { (void)ideal(easy, least); }).empty())
    least *= 2;
  for (int round = 0; round < 5; ++round) {
    EXPECT_EQ(limit([&] { (void)ideal(easy, least); }), "");
    EXPECT_NE(limit([&] { (void)ideal(easy, least / 2); }), "");
  }
}

TEST_F(Limits, AreKeptByWhateverIsDoneWithAnIdeal) {
  const std::vector<MFraction> curve{x * x - a * y - one, z - x * y};
  double enough = 16;
  while (!limit([&] { (void)ideal(curve, enough); }).empty())
    enough *= 2;
  const Ideal i = ideal(curve, enough);
  const MPoly long_one = pow((x + y + z + a * one).num(), 12);
  EXPECT_THAT(limit([&] { (void)i.reduce(MFraction(long_one)); }), HasSubstr("work limit"));
  EXPECT_THAT(limit([&] { (void)i.vanishes(long_one); }), HasSubstr("work limit"));
  EXPECT_EQ(i.budget().max_work, enough);
}

TEST_F(Limits, OfLinearEquationsAreCounted) {
  std::vector<std::vector<MFraction>> m(6);
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) // of rank 5: the last row is the sum of the others
      m[static_cast<std::size_t>(r)].push_back(r < 5 ? pow(x + Rational(r) * y, c) + Rational(c) * a
                                                     : MFraction(ring));
  for (int r = 0; r < 5; ++r)
    for (std::size_t c = 0; c < 6; ++c)
      m[5][c] += m[static_cast<std::size_t>(r)][c];
  Budget little;
  little.max_work = 100;
  EXPECT_THAT(limit([&] { (void)null_space(m, 6, ring, little); }),
              HasSubstr("a system of linear equations"));
  EXPECT_EQ(null_space(m, 6, ring).size(), 1U);
  m[5][5] += one; // of full rank: seen at one point, without elimination
  EXPECT_EQ(limit([&] { EXPECT_TRUE(null_space(m, 6, ring, little).empty()); }), "");
}

TEST_F(Limits, OfADegreeAreNoError) {
  const FiniteAlgebra r(ideal({pow(x, 3) - a, y - x, z}, 1e8));
  const auto e = *r.evaluate(x + one);
  EXPECT_FALSE(r.minimal_polynomial(e, 2));
  ASSERT_TRUE(r.minimal_polynomial(e, 3));
  EXPECT_EQ(r.minimal_polynomial(e, 3)->size(), 4U);
  EXPECT_EQ(r.minimal_polynomial(e).size(), 4U);
}

} // namespace
} // namespace kov
