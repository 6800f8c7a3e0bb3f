#include "exact/variables.hpp"

#include "exact/error.hpp"
#include "exact/polynomials.hpp"
#include "exact/to_poly.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;
using Indices = std::vector<std::size_t>;

class Variables : public Polynomials {};

// f is the sum of its coefficients times monomials: where all coefficients are 0 it is, and only there.
TEST_F(Variables, CoefficientsVanishTogetherWithThePolynomial) {
  for (int round = 0; round < 50; ++round) {
    const MPoly f = poly();
    const auto all = nonzero_coefficients(f, {0, 1});
    EXPECT_EQ(all.empty() || (all.size() == 1 && is_zero(all[0])), is_zero(f));
    for (const MPoly& c : all) {
      EXPECT_FALSE(uses_any(c, Indices{0, 1}));
      EXPECT_EQ(is_zero(c), is_zero(f));
    }
    // two points without meaning
    const Substitution at{{2, MFraction(ring, Rational(3))}, {3, MFraction(ring, Rational(-1))}};
    const bool vanish = std::ranges::all_of(
        all, [&](const MPoly& c) { return is_zero(substitute(MFraction(c), at)); });
    EXPECT_EQ(vanish, is_zero(substitute(MFraction(f), at)));
  }
}

TEST_F(Variables, AreAskedOneByOneOrTogether) {
  const std::vector<MFraction> functions{y, x * y, a / x};
  EXPECT_TRUE(uses_any(a / x, Indices{0, 2}));
  EXPECT_FALSE(uses_any(a / x, {1, 2}));
  EXPECT_FALSE(uses_any(a / x, Indices{}));
  EXPECT_TRUE(any_uses(functions, 3));
  EXPECT_FALSE(any_uses(functions, 2));
  EXPECT_TRUE(uses_only(a / x, {0, 3}));
  EXPECT_FALSE(uses_only(a / x, {0}));
  EXPECT_TRUE(uses_only(one, Indices{}));
  EXPECT_EQ(used_by_any(functions), (Indices{1, 0, 3}));
}

TEST_F(Variables, HaveValuesInAField) {
  const Field k = make_field({-2, 0, 1}, "s");
  const NfElem s = NfElem::generator(k);
  const MPoly f = (x * x * a + y * a * a + one).num();
  EXPECT_EQ(to_poly(f, 0, k, {{1, NfElem(3)}, {3, s}}),
            Poly::from_coefficients({NfElem(7), NfElem(0), s}));
  EXPECT_THROW(static_cast<void>(to_poly(f, 0, k, {{3, s}})), InvalidArgument);
}

} // namespace
} // namespace kov
