// What is written down of a tree of strata: no step is trusted where the rules cover the verdict.
// That the judges accept it is tested in tests/cli and tests/certify.

#include "strata/certificate.hpp"

#include "strata/known_facts.hpp"
#include "strata/words.hpp"

#include <gtest/gtest.h>

namespace kov::strata::certificate_test {
namespace {

const Ring ring = make_ring({"A", "C", "h", "z"});
MFraction x(const char* name) { return MFraction::variable(ring, name); }
MFraction number(long n, long d = 1) { return {ring, Rational(n, d)}; }
MPoly poly(const MFraction& f) { return f.num(); }

Assumptions positive_bodies() {
  Assumptions a;
  a.require(x("A"), Sign::positive);
  a.require(x("C"), Sign::positive);
  return a;
}

// p times = the sum of the terms, with the conditions of `facts`.
void expect_identity(const Lemma& lemma, const KnownFacts& facts) {
  MFraction sum(ring);
  for (const auto& t : *lemma.terms) {
    MFraction product = MFraction(ring, t.c);
    for (const auto& [q, e] : t.squares)
      product *= pow(MFraction(q), static_cast<long>(2 * e));
    for (const auto& [i, e] : t.powers)
      product *= pow(MFraction(facts.conditions().at(i).p), static_cast<long>(e));
    sum += product;
  }
  const MFraction left = MFraction(lemma.p) * (lemma.times ? MFraction(*lemma.times) : number(1));
  EXPECT_TRUE(left == sum) << to_string(lemma.p);
}

TEST(KnownFacts, SignsAreProvedByIdentities) {
  Assumptions a = positive_bodies();
  a.require(x("A") - x("C") - number(1, 2), Sign::nonnegative);
  a.real.push_back(ring->index("h"));
  KnownFacts facts(ring, a, {});
  std::vector<Lemma> lemmas;
  for (const MFraction& f : {x("A") + x("C"), -x("A") * x("C") - x("h") * x("h"),
                             number(2) * x("A") - number(2) * x("C") - number(1, 2),
                             (x("A") + number(1)) * (x("A") + x("h") * x("h"))}) {
    EXPECT_TRUE(facts.ensure_nonzero(poly(f), lemmas)) << to_string(f);
    const MPoly rest = facts.without_known_factors(poly(f));
    EXPECT_TRUE(is_constant(rest)) << to_string(rest);
  }
  EXPECT_GE(lemmas.size(), 4U);
  for (const auto& lemma : lemmas)
    expect_identity(lemma, facts);
  EXPECT_FALSE(facts.ensure_nonzero(poly(x("h") - number(1)), lemmas));
  EXPECT_FALSE(facts.ensure_positive(poly(-x("A")), lemmas));
}

TEST(KnownFacts, AFactorOfAKnownPolynomialIsKnown) {
  KnownFacts facts(ring, {}, {});
  facts.assume_nonzero(poly(x("C") * x("h") * x("h")));
  std::vector<Lemma> lemmas;
  EXPECT_TRUE(facts.ensure_nonzero(poly(x("h")), lemmas));
  ASSERT_EQ(lemmas.size(), 1U);
  EXPECT_FALSE(lemmas[0].terms);
}

TEST(KnownFacts, AnInequalityIsLostOverAComplexDenominator) {
  KnownFacts facts(ring, positive_bodies(), {});
  facts.assume_nonzero(poly(x("h")));
  facts.solve(poly(x("h") * x("A") - number(1)), ring->index("A")); // A = 1/h, h complex
  EXPECT_EQ(facts.conditions().at(0).sign, Sign::dropped);
  EXPECT_EQ(facts.conditions().at(1).sign, Sign::positive);
}

TEST(KnownFacts, AContradictionIsASumThatVanishes) {
  KnownFacts facts(ring, positive_bodies(), {});
  facts.solve(poly(x("A") + x("C") + number(1)), ring->index("C"));
  const auto terms = facts.contradiction();
  ASSERT_TRUE(terms);
  expect_identity({.p = MPoly(ring), .terms = *terms}, facts);
}

StrataCertificate written(const MFraction& r, const Assumptions& a = positive_bodies()) {
  StrataLimits limits;
  limits.decide.want_certificate = true;
  return certificate(decide_strata({r, ring->index("z"), a, {}}, limits));
}

TEST(StrataCertificate, NothingIsTrustedWhereTheRulesCoverTheVerdict) {
  const MFraction z = x("z");
  for (const MFraction& r :
       {x("A") * z,                                                                 // irregular
        x("A") / (z * z) + x("C") / ((z - number(1)) * (z - number(1))),            // open
        -x("A") / (z * z) - number(2, 9) / ((z - number(1)) * (z - number(1))) + z, // negative
        number(3, 4) * x("A") / (x("A") * z * z) + x("C") / (z - number(1)) +
            x("A") / (z - number(2)),
        (x("h") * x("h") - number(2)) / (z * z * z)}) { // a root of h^2 - 2
    const StrataCertificate c = written(r);
    EXPECT_TRUE(c.trusted.empty()) << to_string(r) << ": " << sentence(c.trusted.front().told);
    EXPECT_NE(c.json.find("kovacic-strata/1"), std::string::npos);
  }
}

// Bessel's equation with nu not in 1/2 + Z, by the rule of closed answers.
TEST(StrataCertificate, AMembershipSettlesAClosedAnswer) {
  Assumptions a;
  a.memberships.push_back({x("h") + number(1, 2), false});
  const StrataCertificate c = written(
      (number(4) * x("h") * x("h") - number(1)) / (number(4) * x("z") * x("z")) - number(1), a);
  EXPECT_TRUE(c.trusted.empty());
  EXPECT_NE(c.json.find("memberships"), std::string::npos) << c.json;
}

// What the checker believes is said beside every answer that it was asked about, kept or not.
TEST(StrataCertificate, AnAnswerCountsWhatItsCertificateTrusts) {
  const MFraction z = x("z"), m = x("h");
  StrataLimits limits;
  limits.decide.ask_the_judge = true;
  for (const MFraction& r : {x("A") * z, x("A") / (z * z), x("A") * z * z + x("C"),
                             (number(4) * m * m - number(1)) / (number(4) * z * z) - number(1)}) {
    Assumptions a;
    a.memberships.push_back({m + number(1, 2), false});
    const StrataAnswer answer = decide_strata({r, ring->index("z"), a, {}}, limits);
    ASSERT_TRUE(answer.certificate) << to_string(r);
    std::vector<Trusted> told;
    for (const auto* list : {&answer.certificate->trusted, &answer.certificate->left_out})
      for (const Uncertified& u : *list)
        told.push_back(u.told);
    EXPECT_EQ(answer.trusted, told) << to_string(r);
  }
}

// The proof of another equation's group in the place of this one's.
TEST(StrataCertificate, AVerdictIsWithdrawnWhereOurCheckerRefusesIt) {
  StrataLimits limits;
  limits.decide.want_certificate = true;
  const auto decided = [&](const MFraction& r) {
    return decide_strata({r, ring->index("z"), positive_bodies(), {}}, limits);
  };
  StrataAnswer a = decided(x("z"));
  ASSERT_EQ(a.abelian(), Truth::no);
  EXPECT_TRUE(a.refusal.empty());
  ASSERT_TRUE(a.certificate);
  ProofTree tampered = *a.tree;
  const StrataAnswer other = decided(x("z") * x("z") + x("z"));
  tampered.leaf->because.front() = *evidence<Number>(other.strata.front().leaf);
  a.tree = std::make_shared<ProofTree>(tampered);
  a.certificate.reset();
  certify(a);
  EXPECT_NE(a.refusal.find("about another equation"), std::string::npos) << a.refusal;
  EXPECT_EQ(a.abelian(), Truth::unknown);
  EXPECT_FALSE(a.strata.front().leaf.group);
  EXPECT_NE(reason(a.strata.front().leaf).find("our own checker refuses"), std::string::npos);
}

} // namespace
} // namespace kov::strata::certificate_test
