// The engines and the classical algorithm are two proofs of one answer.

#include "verdict/decide.hpp"

#include "verdict/certificate.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov {
namespace {

const Poly z = Poly::z();

Decision both(const RationalFunction& r) {
  Options options;
  options.method = Method::all;
  return decide({.r = r, .p = RationalFunction()}, options);
}

RationalFunction random_omega(std::mt19937& gen) {
  RationalFunction w;
  for (long i = 0, n = 1 + static_cast<long>(gen() % 3); i < n; ++i)
    w += RationalFunction(
        Poly(Rational(static_cast<long>(gen() % 21) - 10, 1 + static_cast<long>(gen() % 6))),
        z - Poly(i));
  return w;
}

TEST(Methods, AgreeOnEquationsBuiltFromAnExponential) {
  std::mt19937 gen(20261121);
  for (int i = 0; i < 150; ++i) {
    const RationalFunction w = random_omega(gen);
    const Decision d = both(derivative(w) + w * w);
    ASSERT_TRUE(d.group) << to_string(w) << ": " << d.reason;
    EXPECT_EQ(*d.kovacic_case, 1) << to_string(w);
    EXPECT_EQ(d.abelian, Truth::yes) << to_string(w); // simple poles, rational residues
    EXPECT_NE(d.reason.find("the judge accepts"), std::string::npos) << to_string(w) << d.reason;
  }
}

TEST(Methods, AgreeOnDihedralEquations) { // r = (w^2 + 2 v v'' - v'^2)/(4 v^2), v^2 = F
  std::mt19937 gen(7);
  for (int i = 0; i < 40; ++i) {
    Poly f(1);
    for (long k = 0, n = 2 + static_cast<long>(gen() % 3); k < n; ++k)
      f *= z - Poly(3 * k + static_cast<long>(gen() % 3));
    const RationalFunction F(f);
    const RationalFunction dF = derivative(F);
    const RationalFunction c(Rational(1 + static_cast<long>(gen() % 5)));
    const RationalFunction r =
        (c + derivative(dF) - RationalFunction(Rational(3, 4)) * dF * dF / F) /
        (RationalFunction(4) * F);
    const Decision d = both(r);
    ASSERT_TRUE(d.kovacic_case) << to_string(r) << ": " << d.reason;
    // With two branch points and integral residues "D_1" is the cyclic group of order 4: case 1.
    EXPECT_EQ(*d.kovacic_case, degree(f) == 2 ? kovacic_case(*d.group) : 2) << to_string(r);
    EXPECT_LE(*d.kovacic_case, 2) << to_string(r);
    EXPECT_NE(d.reason.find("the judge accepts"), std::string::npos) << to_string(r) << d.reason;
    EXPECT_EQ(d.abelian, Truth::yes);
  }
}

TEST(Methods, AgreeOnRandomEquations) {
  std::mt19937 gen(99);
  for (int i = 0; i < 150; ++i) {
    RationalFunction r;
    for (long k = 0; k < 3; ++k) {
      const Poly c(Rational(static_cast<long>(gen() % 41) - 20, 16));
      r += RationalFunction(c, pow(z - Poly(k), 1 + gen() % 2));
    }
    const Decision d = both(r);
    EXPECT_TRUE(d.group) << to_string(r) << ": " << d.reason;
    EXPECT_NE(d.reason.find("the judge accepts"), std::string::npos) << to_string(r) << d.reason;
  }
}

TEST(Methods, TheTraceNamesTheSteps) {
  Options options;
  options.want_trace = true;
  const Decision d =
      decide({.r = RationalFunction(z * z + Poly(1)), .p = RationalFunction()}, options);
  ASSERT_FALSE(d.trace.empty());
  EXPECT_NE(d.trace.front().step.find("necessary conditions"), std::string::npos);
}

TEST(Methods, NoAnswerWhenTheyDisagree) {
  Decision d = decide({.r = RationalFunction(z), .p = RationalFunction()});
  ASSERT_EQ(*d.kovacic_case, 4);
  d.certificate = "{}";
  compare(d, {.kovacic_case = 1, .limit = ""});
  ASSERT_TRUE(d.undecided);
  EXPECT_EQ(d.undecided->why, Unable::Why::methods_disagree);
  EXPECT_FALSE(d.group);
  EXPECT_FALSE(d.component);
  EXPECT_EQ(d.abelian, Truth::unknown);
  EXPECT_TRUE(d.certificate.empty());
  EXPECT_NE(d.reason.find("case 4"), std::string::npos) << d.reason;
  EXPECT_NE(d.reason.find("case 1"), std::string::npos) << d.reason;
}

// What the engines proved stays proved; that the other method was asked and did not end is said.
TEST(Methods, AMethodThatWasStoppedLeavesTheQuestionOpen) {
  Decision d = decide({.r = RationalFunction(z), .p = RationalFunction()});
  const auto proved = d.group;
  compare(d, {.kovacic_case = std::nullopt, .limit = "too many families"});
  ASSERT_TRUE(d.undecided);
  EXPECT_EQ(d.undecided->why, Unable::Why::budget);
  EXPECT_EQ(d.group, proved);
}

TEST(Methods, ARefusedCertificateTakesTheAnswerBack) {
  const Decision known = decide({.r = RationalFunction(z), .p = RationalFunction()});
  ASSERT_TRUE(known.group);
  Decision d = known;
  take(d, {.json = "{}", .refusal = "step 'local': no", .limit = false});
  EXPECT_FALSE(d.group || d.component || d.kovacic_case);
  EXPECT_EQ(d.abelian, Truth::unknown);
  EXPECT_EQ(d.undecided->why, Unable::Why::methods_disagree);
  d = known;
  take(d, {.json = "{}", .refusal = "step 'local': too large", .limit = true});
  EXPECT_EQ(d.group, known.group);
  EXPECT_FALSE(d.no_certificate.empty());
  EXPECT_TRUE(d.certificate.empty());
}

TEST(Methods, ALimitOfTheSecondOneTakesNothingBack) {
  const Decision known = decide({.r = RationalFunction(z), .p = RationalFunction()});
  Decision d = known;
  compare(d, {.kovacic_case = std::nullopt, .limit = "time limit"});
  EXPECT_EQ(d.group, known.group);
  EXPECT_EQ(d.undecided->why, Unable::Why::budget);
}

} // namespace
} // namespace kov
