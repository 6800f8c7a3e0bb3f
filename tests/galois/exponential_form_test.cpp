#include "galois/exponential_form.hpp"

#include "exact/fields.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

class ExponentialFormLaws : public OverFields {
protected:
  // R' + sum over the places of sum_c rho(c)/(z - c) = (rho q' mod q)/q
  [[nodiscard]] static RationalFunction put_together(const LogarithmicParts& parts) {
    RationalFunction sum = derivative(parts.rational_part);
    for (const auto& [q, rho] : parts.residues)
      sum += RationalFunction(rho * derivative(q) % q, q);
    return sum;
  }
};

TEST_P(ExponentialFormLaws, HermiteReductionComesBackTogether) {
  for (int i = 0; i < 8; ++i) {
    SCOPED_TRACE(i);
    const RationalFunction omega =
        RationalFunction(poly(6), pow(monic_poly(1), 3) * (z() * z() + constant(43)) *
                                      (z() * z() + constant(43)) * monic_poly(1));
    const LogarithmicParts parts = logarithmic_parts(omega);
    EXPECT_EQ(put_together(parts), omega);
    for (const auto& [q, rho] : parts.residues) {
      EXPECT_FALSE(is_zero(rho));
      EXPECT_LT(degree(rho), degree(q));
    }
  }
}

// A derivative has no residues, and comes back up to a constant.
TEST_P(ExponentialFormLaws, DerivativesHaveNoResidues) {
  for (int i = 0; i < 6; ++i) {
    const RationalFunction f = function(3);
    const LogarithmicParts parts = logarithmic_parts(derivative(f));
    EXPECT_TRUE(parts.residues.empty());
    EXPECT_TRUE(is_zero(derivative(parts.rational_part - f)));
  }
}

// y = prod q^e: the residues are the exponents, and the least m with y^m rational is the least
// common denominator.
TEST_P(ExponentialFormLaws, RadicalOrder) {
  for (int i = 0; i < 6; ++i) {
    const std::vector<Poly> places{z(), z() - constant(2), z() * z() + constant(43)};
    RationalFunction omega;
    Integer expected(1);
    for (const Poly& q : places) {
      const Rational e = rational(6);
      omega += RationalFunction(scale(derivative(q), NfElem(e)), q);
      expected = lcm(expected, e.den());
    }
    const LogarithmicParts parts = logarithmic_parts(coerce(omega, k));
    EXPECT_EQ(radical_order(parts), expected);
    const RationalFunction exponential = coerce(omega, k) + RationalFunction(constant(1));
    EXPECT_FALSE(radical_order(logarithmic_parts(exponential))); // e^z
  }
  if (!k->is_rational()) {
    const RationalFunction irrational(Poly(NfElem::generator(k)), z());
    EXPECT_FALSE(radical_order(logarithmic_parts(irrational)));
  }
}

KOV_OVER_ALL_FIELDS(ExponentialFormLaws);

// y1 y2 = v and Wronskian w: y1/y2 = exp int w/v.
TEST(ExponentialPair, RadicalOrderFromTheExponents) {
  const Poly z = Poly::z();
  for (const long d : {1L, 2L, 3L, 5L})
    for (const long n : {1L, 2L, 4L, 7L}) {
      const Rational w(n, d);
      // y = z^((1 +- w)/2)
      EXPECT_EQ(radical_order(ExponentialPair{RationalFunction(z), NfElem(w * w)}),
                ((Rational(1) + w) / Rational(2)).den());
      // ((z-1)/(z+1))^(w/4) sqrt(z^2 - 1)
      EXPECT_EQ(radical_order(ExponentialPair{RationalFunction(z * z - Poly(1)), NfElem(w * w)}),
                (Rational(1, 2) + w / Rational(4)).den());
      // conjugate zeros: rho = w/(2 * 2 sqrt 2) is not rational, unless w^2 = 2 times a square
      EXPECT_FALSE(
          radical_order(ExponentialPair{RationalFunction(z * z - Poly(2)), NfElem(w * w)}));
      EXPECT_EQ(radical_order(ExponentialPair{RationalFunction(z * z - Poly(2)),
                                              NfElem(Rational(2) * w * w)}),
                (Rational(1, 2) + w / Rational(4)).den());
    }
  const NfElem one(1);
  EXPECT_FALSE(radical_order(ExponentialPair{RationalFunction(1), one}));     // e^z
  EXPECT_FALSE(radical_order(ExponentialPair{RationalFunction(z * z), one})); // e^(1/z)
  EXPECT_FALSE(radical_order(ExponentialPair{RationalFunction(z), NfElem(2)}));
  // a simple pole of v: y1 and y2 have the exponent -1/2 there
  const RationalFunction v(pow(z, 3) - Poly(3) * z, z - Poly(1));
  EXPECT_FALSE(radical_order(ExponentialPair{v, one}));
}

TEST(ExponentialText, Forms) {
  const Poly z = Poly::z();
  const auto text = [](const Poly& p, const RationalFunction& omega) {
    return exponential_text(p, logarithmic_parts(omega));
  };
  EXPECT_EQ(text(Poly(1), RationalFunction(0)), "1");
  EXPECT_EQ(text(Poly(1), RationalFunction(1)), "exp(z)");
  EXPECT_EQ(text(z, RationalFunction(Poly(3), z)), "z*z^3");
  EXPECT_EQ(text(z + Poly(1), RationalFunction(Poly(Rational(-1, 2)), z)), "(z + 1)*z^(-1/2)");
  EXPECT_EQ(text(Poly(1), RationalFunction(Poly(1), z - Poly(2)) + RationalFunction(z)),
            "(z - 2)*exp(z^2/2)");
  // different residues at conjugate places stay under an integral sign
  EXPECT_EQ(text(Poly(1), RationalFunction(Poly(1), z * z - Poly(2))), "exp(int(1/(z^2 - 2), z))");
  EXPECT_EQ(text(Poly(1), RationalFunction(scale(z, NfElem(2)), z * z - Poly(2))), "(z^2 - 2)");
}

} // namespace
} // namespace kov
