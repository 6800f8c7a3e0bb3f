// The sets of eigenvalues at Darboux points that the judge computes are those that the search finds, by other code.

#include "certify/theorem/computed.hpp"
#include "classify/darboux_points.hpp"

#include <gmock/gmock.h>

namespace kov::certify::darboux_sets_test {
namespace {

TEST(Darboux, TheSetsAreThoseOfTheSearch) {
  for (const long k : {3L, 4L, 5L, 6L, 8L})
    for (long n = 1; n <= 4; ++n)
      for (const Rational& sum : {Rational(-1), Rational(-k, k - 4 == 0 ? 3 : k - 4),
                                  Rational(1, 2), Rational(-k, k - 2), Rational(0)}) {
        const auto ours = eigenvalue_sets(k, n, sum), theirs = eigenvalue_choices(k, n, sum);
        EXPECT_THAT(ours, testing::UnorderedElementsAreArray(theirs)) << k << " " << n;
      }
  EXPECT_EQ(eigenvalue_sets(3, 3, Rational(-1)).size(), 4U);
}

TEST(Darboux, MultipleValuesAskForDerivatives) {
  const Ring ring = make_ring({"L"});
  const auto number = [&](long c) { return MPoly(ring, Integer(c)); };
  Arithmetic a;
  // (2 L - 1)^2 (L + 3) = 4 L^3 + 8 L^2 - 11 L + 3
  const Coefficients chi{number(3), number(-11), number(8), number(4)};
  const auto vanish = [&](const std::vector<Rational>& values) {
    const auto all = equations_for(chi, values, a);
    return std::all_of(all.begin(), all.end(), [](const MPoly& f) { return is_zero(f); });
  };
  EXPECT_TRUE(vanish({Rational(-3), Rational(1, 2), Rational(1, 2)}));
  EXPECT_FALSE(vanish({Rational(-3), Rational(-3), Rational(1, 2)}));
  EXPECT_FALSE(vanish({Rational(1, 2), Rational(1, 2), Rational(1, 2)}));
  EXPECT_FALSE(vanish({Rational(-3), Rational(1, 2), Rational(1, 3)}));
}

} // namespace
} // namespace kov::certify::darboux_sets_test
