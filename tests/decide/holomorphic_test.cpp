// Infinite dihedral groups that a differential without poles proves infinite.

#include "certify/equation/check.hpp"
#include "corpus.hpp"
#include "support/equations.hpp"

namespace kov {
namespace {

bool accepted(const std::string& certificate) {
  return std::holds_alternative<certify::Accepted>(
      certify::check(certify::read_certificate(certificate)));
}

std::string certificate_of(const RationalFunction& r) {
  Options options;
  options.want_certificate = true;
  return decide({.r = r, .p = RationalFunction()}, options).certificate;
}

// Many branch points: w dz/v has no poles, and no arithmetic modulo primes is needed.
TEST(HolomorphicQuotient, ProvesThatADihedralGroupIsInfinite) {
  RationalFunction f(1);
  for (long i = 0; i < 30; ++i)
    f *= RationalFunction(Poly::z() - Poly(i * i));
  const std::string certificate = certificate_of(testing::from_square(f, NfElem(2)));
  EXPECT_NE(certificate.find("dihedral-holomorphic"), std::string::npos);
  EXPECT_LT(certificate.size(), 60000U);
  EXPECT_TRUE(accepted(certificate));
}

TEST(HolomorphicQuotient, IsRefusedWhereThereArePoles) {
  // Lame n = 1, B = 2: v = (z - 2)/sqrt(...) has a zero; finite dihedral groups; one pole at
  // infinity
  for (const RationalFunction& r : {testing::lame(NfElem(2), NfElem(2), NfElem(4), NfElem(1)),
                                    testing::lame(NfElem(2), NfElem(0), NfElem(0), NfElem(4)),
                                    testing::riemann(NfElem(Rational(1, 4)), NfElem(Rational(1, 4)),
                                                     NfElem(Rational(1, 25)))}) {
    Json certificate = Json::parse(certificate_of(r));
    Json& last = certificate.at("steps").back();
    ASSERT_EQ(last.at("rule"), "conclude");
    last["data"]["theorem"] = "dihedral-holomorphic";
    certificate["claim"] = {
        {"group", "Dinf"}, {"n", nullptr}, {"component", "Gm"}, {"abelian", true}};
    EXPECT_FALSE(accepted(certificate.dump()));
  }
}

} // namespace
} // namespace kov
