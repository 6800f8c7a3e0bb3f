// Every verdict on the corpora writes a certificate, the judge accepts it, and what it certifies is
// what the corpus expects.

#include "corpus.hpp"

#include "certify/equation/check.hpp"

namespace kov {
namespace {

class Certificates : public testing::TestWithParam<Json> {};

TEST_P(Certificates, AreWrittenAndAccepted) {
  Options options;
  options.want_certificate = true;
  options.want_solutions = false;
  const Decision d = decide(equation_of(GetParam()), options);
  ASSERT_FALSE(d.certificate.empty()) << d.no_certificate;
  const certify::Certificate c = certify::read_certificate(d.certificate);
  const auto verdict = certify::check(c);
  const auto* accepted = std::get_if<certify::Accepted>(&verdict);
  ASSERT_NE(accepted, nullptr) << std::get<certify::Rejected>(verdict).why;
  EXPECT_EQ(accepted->trusted_steps, 0U);
  EXPECT_EQ(d.r, RationalFunction(c.num, c.den));

  const Json& expected = GetParam().at("expected");
  ASSERT_TRUE(c.claim.group && c.claim.component && c.claim.abelian);
  EXPECT_EQ(*c.claim.group, to_string(d.group->type));
  EXPECT_EQ(c.claim.n, d.group->n);
  EXPECT_EQ(*c.claim.component, to_string(*d.component));
  EXPECT_EQ(corpus_name(*d.group), expected.at("group").get<std::string>());
  EXPECT_EQ(*c.claim.abelian, expected.at("identity_component_abelian").get<bool>());
}

INSTANTIATE_TEST_SUITE_P(Public, Certificates, testing::ValuesIn(corpus("public.jsonl")), name_of);
INSTANTIATE_TEST_SUITE_P(Pitfalls, Certificates, testing::ValuesIn(corpus("pitfalls.jsonl")),
                         name_of);

// sum a_i/(z - i)^2 with a_i of 100 digits: the exponents allow polynomials of degree 10^51, but
// one prime proves SL(2).
TEST(LongCoefficients, OnePrimeIsEnough) {
  RationalFunction r;
  Integer a = pow(Integer(7), 118);
  for (long i = 1; i <= 12; ++i) {
    r += RationalFunction(Poly(Rational(a)), pow(Poly::z() - Poly(i), 2));
    a += pow(Integer(11), 95) + Integer(i);
  }
  Options options;
  options.want_certificate = true;
  const Decision d = decide({.r = r, .p = RationalFunction()}, options);
  ASSERT_TRUE(d.group) << reason(d);
  EXPECT_EQ(d.group->type, GroupType::SL2);
  EXPECT_FALSE(d.certificate.empty()) << d.no_certificate;
}

// Euler's equation c/(z - a)^2 and its images under z -> (z + 2)/(3z - 1), whatever the exponent
// difference: all have certificates.
TEST(Euler, EveryEquationHasACertificate) {
  const Poly z = Poly::z();
  const Integer large = pow(Integer(10), 20);
  for (const Rational& delta :
       {Rational(1), Rational(3), Rational(1, 2), Rational(7, 3), Rational(large),
        Rational(large + Integer(39)), Rational(large, Integer(7))}) {
    const Rational c = (delta * delta - Rational(1)) * Rational(1, 4);
    const Poly there = (z - Poly(5)) * (z - Poly(5));
    const Poly moved =
        (z + Poly(2)) * (z + Poly(2)) * (Poly(3) * z - Poly(1)) * (Poly(3) * z - Poly(1));
    for (const RationalFunction& r :
         {RationalFunction(Poly(c), there), RationalFunction(Poly(c * Rational(49)), moved)}) {
      Options options;
      options.want_certificate = true;
      const Decision d = decide({.r = r, .p = RationalFunction()}, options);
      ASSERT_TRUE(d.group) << reason(d);
      EXPECT_EQ(d.group->type, GroupType::cyclic) << to_string(r);
      EXPECT_EQ(d.group->n, ((Rational(1) + delta) * Rational(1, 2)).den());
      EXPECT_FALSE(d.certificate.empty()) << to_string(r) << ": " << d.no_certificate;
    }
  }
}

} // namespace
} // namespace kov
