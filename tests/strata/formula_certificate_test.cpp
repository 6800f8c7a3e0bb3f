// Equations that a closed formula decides and no engine: the certificate says the same, and says it
// of no other equation.

#include "strata/formula_certificate.hpp"

#include "certify/strata/check.hpp"
#include "closed/recognize.hpp"
#include "linode/singularities.hpp"

#include <gtest/gtest.h>

namespace kov::strata::formula_certificate_test {
namespace {

const Poly z = Poly::z();

// Exponents so large that no polynomial is searched for.
RationalFunction bessel(const Integer& n, const Poly& f) { // -1 + n(n+1)/x^2 in x = f(z)
  const RationalFunction x(f);
  const RationalFunction slope(derivative(f));
  const RationalFunction u = derivative(slope) / slope;
  const RationalFunction schwarzian = derivative(u) - u * u * RationalFunction(Rational(1, 2));
  const RationalFunction r =
      RationalFunction(-1) + RationalFunction(Rational(n * (n + Integer(1)))) / (x * x);
  return r * slope * slope - schwarzian * RationalFunction(Rational(1, 2));
}

Decision by_formula(const RationalFunction& r) {
  Options options;
  options.want_certificate = true;
  options.want_solutions = false;
  options.budget.max_degree = 1000;
  return decide({r, 0}, options);
}

const Integer immense = pow(Integer(10), 20);

class FormulaCertificate : public ::testing::TestWithParam<RationalFunction> {};

TEST_P(FormulaCertificate, IsAcceptedAndSaysTheSame) {
  const Decision d = by_formula(GetParam());
  ASSERT_TRUE(std::holds_alternative<ByFormula>(d.because));
  ASSERT_TRUE(d.certificate.empty());
  const auto opinion = formula_certificate(d);
  ASSERT_TRUE(opinion);
  EXPECT_EQ(opinion->refusal, "");
  const auto whole = certify::read_strata_certificate(opinion->json);
  EXPECT_EQ(whole.abelian, d.abelian == Truth::yes);
  EXPECT_EQ(to_rational_function(MFraction(whole.r.num, whole.r.den), 0), d.r);
}

INSTANTIATE_TEST_SUITE_P(
    ImmenseBessel, FormulaCertificate,
    ::testing::Values(bessel(immense, z), bessel(immense, z - 3),
                      bessel(Integer(123457), scale(z, NfElem(Rational(2, 7))) + 1),
                      bessel(immense, z* z + 5), bessel(immense, z* z* z - z + 1)));

TEST(FormulaCertificate, TheOtherVerdictIsRefused) {
  Decision d = by_formula(bessel(immense, z));
  d.abelian = Truth::no;
  const auto opinion = formula_certificate(d);
  EXPECT_TRUE(!opinion || !opinion->refusal.empty());
}

TEST(FormulaCertificate, AnotherEquationIsNotRecognised) {
  Decision d = by_formula(bessel(immense, z));
  d.r = d.r + RationalFunction(1, z); // the places are still those of the first one
  const auto opinion = formula_certificate(d);
  EXPECT_TRUE(!opinion || !opinion->refusal.empty());
}

} // namespace
} // namespace kov::strata::formula_certificate_test
