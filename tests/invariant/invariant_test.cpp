#include "invariant/invariant.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

// The Riemann form with exponent differences l, m, n at 0, 1, infinity (docs/theory/recognition.md, 2).
RationalFunction riemann(const Rational& l, const Rational& m, const Rational& n) {
  const Poly z = Poly::z();
  const Poly one(1);
  const Rational quarter(1, 4);
  return RationalFunction(Poly((l * l - Rational(1)) * quarter), z * z) +
         RationalFunction(Poly((m * m - Rational(1)) * quarter), (z - one) * (z - one)) +
         RationalFunction(Poly((Rational(1) - l * l - m * m + n * n) * quarter), z * (z - one));
}

Rational q(long n, long d = 1) { return {Integer(n), Integer(d)}; }

struct Dimensions {
  const char* name;
  RationalFunction r;
  std::vector<std::size_t> of; // degrees 2, 4, 6, 8, 12
};

class InvariantDimensions : public testing::TestWithParam<Dimensions> {};

TEST_P(InvariantDimensions, AgreeWithMolien) {
  const auto s = singularities(GetParam().r);
  const long degrees[] = {2, 4, 6, 8, 12};
  for (std::size_t i = 0; i < 5; ++i) {
    SCOPED_TRACE(GetParam().name + (" degree " + std::to_string(degrees[i])));
    const auto found = invariants(s, degrees[i]);
    EXPECT_EQ(found.basis.size(), GetParam().of[i]);
    EXPECT_EQ(found.none.has_value(), GetParam().of[i] == 0);
  }
}

const Poly z = Poly::z();

INSTANTIATE_TEST_SUITE_P(
    Groups, InvariantDimensions,
    testing::Values(Dimensions{"SL2, Airy", RationalFunction(z), {0, 0, 0, 0, 0}},
                    Dimensions{"Borel", RationalFunction(z* z + Poly(1)), {0, 0, 0, 0, 0}},
                    Dimensions{"Gm", RationalFunction(Poly(-1)), {1, 1, 1, 1, 1}},
                    Dimensions{
                        "Dinf",
                        RationalFunction(scale(z, NfElem(16)) - Poly(3), scale(z* z, NfElem(16))),
                        {0, 1, 0, 1, 1}},
                    Dimensions{"Q8", riemann(q(1, 2), q(1, 2), q(1, 2)), {0, 2, 1, 3, 4}},
                    Dimensions{"D3", riemann(q(1, 2), q(1, 2), q(1, 3)), {0, 1, 1, 2, 3}},
                    Dimensions{"D5", riemann(q(1, 2), q(1, 2), q(1, 5)), {0, 1, 0, 1, 2}},
                    Dimensions{"A4", riemann(q(1, 2), q(1, 3), q(1, 3)), {0, 0, 1, 1, 2}},
                    Dimensions{"S4", riemann(q(1, 2), q(1, 3), q(1, 4)), {0, 0, 0, 1, 1}},
                    Dimensions{"A5", riemann(q(1, 2), q(1, 3), q(1, 5)), {0, 0, 0, 0, 1}},
                    Dimensions{"T3", riemann(q(5, 3), q(1, 3), q(1, 3)), {0, 0, 1, 0, 1}}));

TEST(Invariant, KernelsThatNeedAnAlgebraicField) { // the A4 equation with z -> I z
  const Field k = make_field({1, 0, 1}, "I");
  const RationalFunction iz(Poly::monomial(NfElem::generator(k), 1));
  const RationalFunction r = -compose(riemann(q(1, 2), q(1, 3), q(1, 3)), iz);
  const auto found = invariants(singularities(r), 6);
  ASSERT_EQ(found.basis.size(), 1U);
  EXPECT_EQ(found.basis[0].p.field(), k);
}

} // namespace
} // namespace kov
