// Both solutions as formulas.  (tests/scripts/basis_test.py puts what is printed into the equation.)

#include "galois/basis.hpp"

#include "galois/hyperexponential_integral.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

const Poly z = Poly::z();

// What is left has simple poles at most where phi has no residue in N; where it is a polynomial, its
// degree is below that of phi.
TEST(HyperexponentialIntegral, LeavesFewPoles) {
  const RationalFunction a(pow(z, 5) + Poly(2), pow(z - Poly(1), 3) * pow(z, 2) * (z + Poly(2)));
  for (const RationalFunction& phi :
       {RationalFunction(), RationalFunction(1), RationalFunction(z),
        RationalFunction(Poly(1), Poly(3) * z),
        RationalFunction(pow(z, 3)) + RationalFunction(Poly(2), Poly(5) * (z - Poly(1)))}) {
    const auto x = reduced_integral(a, phi, {z, z - Poly(1), z + Poly(2)});
    EXPECT_EQ(derivative(x.w) + phi * x.w + x.b, a);
    for (const Poly& q : {z, z - Poly(1), z + Poly(2)})
      EXPECT_LE(remove_factor(x.b.den(), q).first, 1) << to_string(phi);
    EXPECT_LT(degree(x.b.num()),
              degree(x.b.den()) + std::max(1L, degree(phi.num()) - degree(phi.den())))
        << to_string(phi);
  }
}

TEST(HyperexponentialIntegral, Names) {
  const auto text = [](const RationalFunction& a, const RationalFunction& phi) {
    return to_string(reduced_integral(a, phi, {z}));
  };
  EXPECT_EQ(text(RationalFunction(1), Poly(-2) * z), "(1/2)*sqrt(pi)*erf(z)");
  EXPECT_EQ(text(RationalFunction(2), z), "sqrt(pi)/(1/2*sqrt(2))*erfi((1/2*sqrt(2))*z)");
  EXPECT_EQ(text(RationalFunction(Poly(1), z), RationalFunction(3)), "Ei(3*z)");
  EXPECT_EQ(text(RationalFunction(Poly(1), z), RationalFunction()), "log(z)");
}

std::optional<Basis> basis_of(const RationalFunction& r) {
  const Classification c = classify(r);
  return basis(c, r, solutions(c, r));
}

TEST(Basis, OneLine) {
  const auto hermite = basis_of(z * z + Poly(1));
  ASSERT_TRUE(hermite);
  EXPECT_EQ(hermite->first, "exp(z^2/2)");
  EXPECT_EQ(hermite->second, "exp(z^2/2)*(1/2)*sqrt(pi)*erf(z)");
}

// Y'' + Y'/z = 0 and the Legendre equation of degree 1, of which z is a solution.
TEST(Basis, OfTheGivenEquation) {
  const auto given = [](const RationalFunction& p, const RationalFunction& q) {
    const RationalFunction gauge = p * RationalFunction(Rational(-1, 2));
    const RationalFunction r = gauge * gauge - derivative(gauge) - q;
    const Classification c = classify(r);
    return basis(c, r, solutions(c, r), "z", gauge);
  };
  const auto laplace = given(RationalFunction(Poly(1), z), RationalFunction());
  ASSERT_TRUE(laplace);
  EXPECT_EQ(laplace->first, "1");
  EXPECT_EQ(laplace->second, "log(z)");
  const Poly one_minus = Poly(1) - z * z;
  const auto legendre =
      given(RationalFunction(Poly(-2) * z, one_minus), RationalFunction(Poly(2), one_minus));
  ASSERT_TRUE(legendre);
  EXPECT_EQ(legendre->first, "z");
  const auto bessel = given(RationalFunction(Poly(1), z),
                            RationalFunction(Poly(4) * z * z - Poly(1), Poly(4) * z * z));
  ASSERT_TRUE(bessel);
  EXPECT_EQ(bessel->first, "z^(-1/2)*exp(I*z)");
}

TEST(Basis, DihedralGroupsOfEveryGenusHaveOne) {
  const NfElem quarter(Rational(1, 4));
  for (const RationalFunction& r :
       {testing::riemann(quarter, quarter, quarter), // the quaternion group
        testing::riemann(quarter, quarter, NfElem(Rational(1, 25))),
        testing::riemann(quarter, quarter, NfElem(Rational(9, 16))),
        testing::from_square(RationalFunction(pow(z, 3) + Poly(1)), NfElem(1)),
        testing::from_square(RationalFunction(pow(z, 6) + z) * RationalFunction(z * z), NfElem(3))})
    EXPECT_TRUE(basis_of(r)) << to_string(r);
}

// y1/y2 = exp(2 D sqrt(F0)): int 1/(g T) is elementary, whatever the number of branch places.
TEST(Basis, ExponentialsOfAlgebraicFunctions) {
  for (const Poly& F0 : {z, z * z - Poly(2), pow(z, 3) + z})
    for (const Poly& D : {Poly(1), z + Poly(3), z * z + Poly(1)}) {
      // w/sqrt(F) = (D sqrt F0)' = (D' F0 + D F0'/2)/sqrt F0
      const Poly slope = derivative(D) * F0 + scale(D * derivative(F0), NfElem(Rational(1, 2)));
      const auto found =
          basis_of(testing::from_square(RationalFunction(F0, slope * slope), NfElem(1)));
      ASSERT_TRUE(found);
      EXPECT_EQ(found->first.find("int("), std::string::npos) << found->first;
    }
}

TEST(Basis, OtherGroupsHaveNone) {
  for (const RationalFunction& r :
       {RationalFunction(z),
        testing::riemann(NfElem(Rational(1, 4)), NfElem(Rational(1, 9)), NfElem(Rational(1, 16)))})
    EXPECT_FALSE(basis_of(r)) << to_string(r);
}

} // namespace
} // namespace kov
