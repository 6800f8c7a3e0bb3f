// The engines and the classical algorithm are two proofs of one answer.

#include "decide/words.hpp"

#include "decide/certificate.hpp"

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
    ASSERT_TRUE(d.group) << to_string(w) << ": " << reason(d);
    EXPECT_EQ(*d.kovacic_case, 1) << to_string(w);
    EXPECT_EQ(d.abelian, Truth::yes) << to_string(w); // simple poles, rational residues
    EXPECT_NE(reason(d).find("the judge accepts"), std::string::npos) << to_string(w) << reason(d);
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
    ASSERT_TRUE(d.kovacic_case) << to_string(r) << ": " << reason(d);
    // With two branch points and integral residues "D_1" is the cyclic group of order 4: case 1.
    EXPECT_EQ(*d.kovacic_case, degree(f) == 2 ? kovacic_case(*d.group) : 2) << to_string(r);
    EXPECT_LE(*d.kovacic_case, 2) << to_string(r);
    EXPECT_NE(reason(d).find("the judge accepts"), std::string::npos) << to_string(r) << reason(d);
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
    EXPECT_TRUE(d.group) << to_string(r) << ": " << reason(d);
    EXPECT_NE(reason(d).find("the judge accepts"), std::string::npos) << to_string(r) << reason(d);
  }
}

TEST(Methods, TheTraceNamesTheSteps) {
  Options options;
  options.want_trace = true;
  const Decision d =
      decide({.r = RationalFunction(z * z + Poly(1)), .p = RationalFunction()}, options);
  ASSERT_FALSE(d.trace.empty());
  EXPECT_NE(name(d.trace.front()).find("necessary conditions"), std::string::npos);
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
  EXPECT_NE(reason(d).find("case 4"), std::string::npos) << reason(d);
  EXPECT_NE(reason(d).find("case 1"), std::string::npos) << reason(d);
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

// Why an answer holds is asked by its values; no text is read.
TEST(Why, IsAValue) {
  const auto decided = [](const RationalFunction& r, Method method = Method::automatic) {
    Options options;
    options.method = method;
    return decide({.r = r, .p = RationalFunction()}, options);
  };
  const Decision airy = decided(RationalFunction(z));
  ASSERT_NE(airy.proof(), nullptr);
  EXPECT_EQ(airy.proof()->argument, Argument::torus_no_line);
  EXPECT_EQ(airy.proof()->kind, Trichotomy::irregular_or_irrational);
  EXPECT_FALSE(airy.second_opinion || airy.third_opinion || airy.withdrawn);
  const Decision both = decided(RationalFunction(z), Method::all);
  EXPECT_EQ(both.second_opinion, 4);
  ASSERT_TRUE(both.third_opinion);
  EXPECT_TRUE(both.third_opinion->accepted);
  // exponents beyond every degree limit: the formula, and what had stopped the engines
  const Rational immense(pow(Integer(10), 21) + Integer(1), Integer(2));
  const Decision far =
      decided(RationalFunction(Poly(immense * immense - Rational(1, 4)) + z * z * Poly(-1), z * z));
  const auto* formula = std::get_if<ByFormula>(&far.because);
  ASSERT_NE(formula, nullptr) << reason(far);
  EXPECT_EQ(formula->known.family, Classical::bessel);
  ASSERT_TRUE(formula->engines);
  EXPECT_EQ(formula->engines->why, Unable::Why::budget);
}

TEST(Why, AnAnswerThatWasTakenBackSaysByWhom) {
  Decision d = decide({.r = RationalFunction(z), .p = RationalFunction()});
  const Decision known = d;
  compare(d, {.kovacic_case = 1, .limit = ""});
  ASSERT_TRUE(d.withdrawn);
  const auto* cases = std::get_if<MethodsDisagree>(&*d.withdrawn);
  ASSERT_NE(cases, nullptr);
  EXPECT_EQ(cases->engines, 4);
  EXPECT_EQ(cases->kovacic, 1);
  d = known;
  take(d, {.json = "{}", .refusal = "step 'local': no", .limit = false});
  ASSERT_TRUE(d.withdrawn);
  const auto* refused = std::get_if<CertificateRefused>(&*d.withdrawn);
  ASSERT_NE(refused, nullptr);
  EXPECT_EQ(refused->found, known.group);
}

// y'' = r y is checked on the values; the texts say the same.
TEST(Solutions, AreExactValues) {
  const Poly z2 = z * z;
  for (const RationalFunction& r :
       {RationalFunction(z2 + Poly(3)), RationalFunction(Poly(2), z2), RationalFunction(0),
        RationalFunction(Poly(Rational(3, 16)), z2), RationalFunction(Poly(5)),
        RationalFunction(Poly(Rational(1)), z) - RationalFunction(Poly(Rational(3, 16)), z2)}) {
    const Decision d = decide({.r = r, .p = RationalFunction()});
    ASSERT_FALSE(d.solutions.empty()) << to_string(r);
    const auto printed = printed_solutions(d, 0);
    ASSERT_EQ(printed.size(), d.solutions.size());
    for (std::size_t i = 0; i < printed.size(); ++i) {
      const LiouvillianSolution& s = d.solutions[i];
      EXPECT_EQ(s.exponential.has_value(), s.minimal_polynomial.empty());
      EXPECT_EQ(printed[i].minimal_polynomial.size(), s.minimal_polynomial.size());
      EXPECT_EQ(printed[i].y.empty(), !s.exponential);
      if (!s.exponential) continue;
      const RationalFunction omega = s.exponential->omega();
      EXPECT_EQ(derivative(omega) + omega * omega, coerce(r, omega.field())) << printed[i].y;
    }
    EXPECT_THROW((void)printed_solutions(d, 1), OutOfBudget);
  }
}

TEST(Solutions, ThatAreNotThereSayWhy) {
  Options options;
  options.want_solutions = false;
  const Decision d = decide({.r = RationalFunction(Poly(5)), .p = RationalFunction()}, options);
  ASSERT_TRUE(d.no_solutions);
  EXPECT_EQ(d.no_solutions->why, SolutionsMissing::Why::not_asked_for);
}

// Exponents beyond every search: a formula, or the numbers that Kovacic's first case needs, decide;
// the certificate has no rule for a formula, and the answer says so.
TEST(Methods, ExponentsBeyondEverySearch) {
  const Rational huge = Rational(pow(Integer(10), 60)) - Rational(1, 4);
  const auto answer = [](const RationalFunction& r, bool want_certificate) {
    Options options;
    options.want_certificate = want_certificate;
    return decide({.r = r, .p = RationalFunction()}, options);
  };
  const RationalFunction bessel = RationalFunction(Poly(huge), z * z) - RationalFunction(Poly(1));
  EXPECT_EQ(answer(bessel, false).abelian, Truth::no);
  EXPECT_NE(reason(answer(bessel, false)).find("by the formula for"), std::string::npos);
  const Decision with = answer(bessel, true);
  EXPECT_EQ(with.abelian, Truth::no);
  EXPECT_TRUE(!with.certificate.empty() || !with.no_certificate.empty());
}

} // namespace
} // namespace kov
