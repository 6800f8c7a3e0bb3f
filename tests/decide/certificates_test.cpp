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

} // namespace
} // namespace kov
