// What is proved is said, whatever becomes of the solutions, the steps and the certificate.

#include "equations/answer.hpp"

#include "decide/words.hpp"
#include "exact/poly.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

namespace kov::cli::proved_first_test {
namespace {

using testing::gauge;
using testing::pull_back;
using testing::riemann;

NfElem over(long n, long d) { return NfElem(Rational(n, d)); }

// Riemann's equation of a finite primitive group after a gauge transformation, which makes about 2k
// apparent singularities, and a shift by a long number, which makes every coefficient long.
RationalFunction with_apparent_singularities(const NfElem& at1, const NfElem& at_infinity,
                                             unsigned long k, unsigned long digits) {
  const RationalFunction a(pow(Poly::z(), k) + Poly(3));
  const RationalFunction r = gauge(riemann(over(1, 4), at1, at_infinity), a);
  const Poly shift(NfElem(Rational(pow(Integer(10), digits) + Integer(1), Integer(3))));
  return compose(r, RationalFunction(Poly::z() + shift));
}

struct Case {
  const char* group;
  NfElem at1, at_infinity;
  unsigned long apparent, digits;
};

std::string equation_of(const Case& c) {
  return to_string(with_apparent_singularities(c.at1, c.at_infinity, c.apparent, c.digits));
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all{{"A5", over(1, 9), over(1, 25), 4, 20},
                                     {"S4", over(1, 9), over(1, 16), 4, 20},
                                     {"A4", over(1, 9), over(1, 9), 4, 20}};
  return all;
}

Answer answer(const std::string& r, const Settings& settings) {
  Solver solver(fixed_question([&] {
                  Question q;
                  q.text.r = parse_expression(r, "-r");
                  return q;
                }),
                settings);
  return solver.answer("");
}

bool decided(const Answer& a) {
  return a.exit == exit_decided && a.result.at("undecided").is_null();
}

// An answer that does not come on a busy machine is asked for again.
Answer patient_answer(const std::string& r, const Settings& settings) {
  Answer a = answer(r, settings);
  for (int again = 0; again < 3 && !decided(a); ++again)
    a = answer(r, settings);
  return a;
}

// The solutions of these equations take three times as long as their verdicts, and more to print.
TEST(ProvedFirst, DecidedInATimeIsDecidedInEveryLongerTime) {
  for (const Case& c : cases()) {
    const std::string r = equation_of(c);
    Settings settings;
    settings.max_print = 0;
    bool before = false;
    for (const double seconds : {0.1, 0.25, 0.5, 1.0, 2.0}) {
      settings.timeout = seconds;
      const Answer a = before ? patient_answer(r, settings) : answer(r, settings);
      EXPECT_TRUE(decided(a) || !before) << c.group << " in " << seconds << " s: " << a.result;
      before = before || decided(a);
      if (!decided(a)) continue;
      EXPECT_EQ(a.result.at("group").at("type"), c.group);
    }
    settings.timeout = 60;
    settings.quiet = true;
    EXPECT_TRUE(decided(answer(r, settings))) << c.group;
  }
}

// Verdict, certificate, solutions: each stays where the next one is cut short.
TEST(ProvedFirst, ADecisionIsAnnouncedBeforeItsSolutions) {
  const RationalFunction r = with_apparent_singularities(over(1, 9), over(1, 25), 4, 0);
  std::vector<Decision> said;
  Options options;
  options.want_certificate = true;
  options.proved = [&](const Decision& d) { said.push_back(d); };
  const Decision d = decide({.r = r, .p = RationalFunction()}, options);
  ASSERT_EQ(said.size(), 2U);
  for (const Decision& early : said) {
    EXPECT_EQ(early.group, d.group);
    EXPECT_TRUE(early.solutions.empty());
  }
  EXPECT_FALSE(said.back().certificate.empty());
  EXPECT_FALSE(d.no_solutions);
  EXPECT_FALSE(d.solutions.empty());
  EXPECT_THROW((void)printed_solutions(d, 1000), OutOfBudget);
  EXPECT_FALSE(d.undecided);
}

} // namespace
} // namespace kov::cli::proved_first_test
