// Statements in words: one spelling for one statement.

#include "parameters/statement.hpp"

#include <gtest/gtest.h>

namespace kov::statement_words_test {
namespace {

const Ring ring = make_ring({"a", "b", "n"});
MFraction x(const char* name) { return MFraction::variable(ring, name); }
MFraction number(long p, long q = 1) { return {ring, Rational(p, q)}; }
MFraction squared(const MFraction& f) { return f * f; }

const Residues odd{Rational(1), Rational(2)};
const Residues halves{Rational(1, 2), Rational(1)};
const Residues integers{Rational(0), Rational(1)};

TEST(Statements, AreSaidAsAMathematicianWould) {
  const auto said = [](const Assertion& s) {
    return to_string({s, true}) + " | " + to_string({s, false});
  };
  EXPECT_EQ(said(SumIn{{squared(x("a"))}, {halves}}), "a is in 1/2 + Z | a is not in 1/2 + Z");
  EXPECT_EQ(said(SumIn{{squared(number(2) * x("n") + number(1))}, {odd}}),
            "n is an integer | n is not an integer");
  EXPECT_EQ(said(SumIn{{number(4) * x("a") + number(1)}, {odd}}),
            "sqrt(4*a + 1) is an odd integer | sqrt(4*a + 1) is not an odd integer");
  EXPECT_EQ(said(SumIn{{x("a") + number(1, 4)}, {halves}}),
            "sqrt(4*a + 1) is an odd integer | sqrt(4*a + 1) is not an odd integer");
  EXPECT_EQ(said(SumIn{{squared(x("a")), squared(x("b"))}, {halves}}),
            "a + b or a - b is in 1/2 + Z | none of a + b, a - b is in 1/2 + Z");
  EXPECT_EQ(said(SumIn{{x("a"), squared(x("b"))}, {halves}}),
            "some sqrt(a) +- b is in 1/2 + Z | no sqrt(a) +- b is in 1/2 + Z");
  EXPECT_EQ(said(SumIn{{number(0), number(1), number(4) * x("b")}, {odd}}),
            "sqrt(b) is an integer | sqrt(b) is not an integer");
  EXPECT_EQ(said(SumIn{{number(1, 4), number(1, 9), x("b")}, {odd}}),
            "sqrt(b) is in +-1/6 + 2*Z or +-5/6 + 2*Z | "
            "sqrt(b) is not in +-1/6 + 2*Z or +-5/6 + 2*Z");
  EXPECT_EQ(said(SumIn{{squared(x("n"))}, {{Rational(1, 3), Rational(1)}, {Rational(1, 4), 2}}}),
            "n is in +-1/3 + Z or +-1/4 + 2*Z | n is not in +-1/3 + Z or +-1/4 + 2*Z");
  EXPECT_EQ(
      said(AllRational{{squared(x("a")), number(2), squared(number(3) * x("a") + number(1))}}),
      "a and sqrt(2) are rational | one of a, sqrt(2) is irrational");
  EXPECT_EQ(said(AllRational{{squared(number(2) * x("a") + number(1))}}),
            "a is rational | a is irrational");
  EXPECT_EQ(said(SomeIn{{squared(x("a")), squared(x("b"))}, Classes{halves}}),
            "a or b is in 1/2 + Z | none of a, b is in 1/2 + Z");
  EXPECT_EQ(said(SomeIn{{squared(x("a")), squared(x("b"))}, Classes{halves}, false, 2}),
            "a and b are in 1/2 + Z | not both of a and b are in 1/2 + Z");
}

// A function of the parameters has a sign: b + 1/3 is in 1/2 + Z for b in 1/6 + Z, not for b = -1/6.
TEST(Statements, AFunctionIsInOneClass) {
  const MFraction b = x("b");
  EXPECT_EQ(to_string({SumIn{{squared(b + number(1, 3))}, {halves}}, true}), "b is in 1/6 + Z");
  EXPECT_EQ(to_string({SumIn{{squared(number(1, 4) - b)}, {integers}}, false}),
            "b is not in 1/4 + Z");
  EXPECT_EQ(to_string({SumIn{{squared(b), squared(number(1, 3))}, {integers}}, true}),
            "b is in 1/3 + Z or b is in 2/3 + Z");
}

// One to three numbers, rational functions or not, and several classes: none is forgotten.
TEST(Statements, EveryClassIsNamed) {
  const std::vector<Residues> classes{{Rational(1, 6), Rational(2)},
                                      {Rational(5, 6), Rational(2)},
                                      {Rational(1, 5), Rational(2)},
                                      {Rational(2, 7), Rational(2)}};
  const std::vector<MFraction> rational{squared(x("a")), squared(x("b")), squared(x("n"))};
  const std::vector<MFraction> roots{x("a"), squared(x("b")), x("n") + number(1)};
  for (const auto& numbers : {rational, roots})
    for (std::size_t many = 1; many <= 3; ++many)
      for (std::size_t of = 2; of <= classes.size(); ++of)
        for (const bool holds : {true, false}) {
          const SumIn sum{{numbers.begin(), numbers.begin() + static_cast<long>(many)},
                          {classes.begin(), classes.begin() + static_cast<long>(of)}};
          const std::string said = to_string({sum, holds});
          for (std::size_t i = 0; i < classes.size(); ++i)
            EXPECT_EQ(said.find(to_string(classes[i].a)) != std::string::npos, i < of) << said;
        }
  EXPECT_EQ(to_string({SumIn{{x("a"), squared(x("b"))}, {classes[0], classes[1]}}, false}),
            "no sqrt(a) +- b is in +-1/6 + 2*Z or +-5/6 + 2*Z");
}

// Two of three numbers, of which two are equal.
TEST(Statements, EqualNumbersCountTwice) {
  const MFraction a = squared(x("a")), n = squared(x("n"));
  EXPECT_EQ(to_string({SomeIn{{a, a, n}, Classes{halves}, false, 2}, true}), "a is in 1/2 + Z");
  EXPECT_EQ(to_string({SomeIn{{a, a, n}, Classes{halves}, false, 2}, false}),
            "a is not in 1/2 + Z");
  EXPECT_EQ(to_string({SomeIn{{a, a}, Classes{halves}, false, 2}, true}), "a is in 1/2 + Z");
}

// Sentences about one number, whichever statement says it; a root has no rational factor.
// Of l, l, n two are in a class exactly where l is; rows of one table are one sentence.
TEST(Statements, SayNothingTwice) {
  const auto said = [](const Assertion& s) {
    return to_string({s, true}) + " | " + to_string({s, false});
  };
  const MFraction a = squared(x("a")), b = squared(x("b")), third = number(1, 9);
  EXPECT_EQ(said(SomeIn{{a, a, b}, {{halves}}, false, 2}), "a is in 1/2 + Z | a is not in 1/2 + Z");
  EXPECT_EQ(said(SomeIn{{a, b, a}, {{halves}}, false, 2}), "a is in 1/2 + Z | a is not in 1/2 + Z");
  EXPECT_EQ(said(WithoutLogarithm{{third, third, a}}),
            "(one of 1/3, 1/3, a is an integer, and there is no logarithm) | "
            "(none of 1/3, 1/3, a is an integer, or there is a logarithm)");
  const auto row = [&](GroupType g, bool holds) { return Statement{InRow{{a, a, b}, g}, holds}; };
  const auto told = with_contraries({row(GroupType::A4, false), row(GroupType::S4, false),
                                     row(GroupType::A5, false), row(GroupType::A4, true)});
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].text, "a, a, b are in no row for A4, S4 or A5 of the table of Schwarz and "
                          "Kimura");
  EXPECT_EQ(told[0].contrary, "a, a, b are in a row for A4, S4 or A5 of the table of Schwarz and "
                              "Kimura");
}

TEST(Statements, HaveOneSpelling) {
  const MFraction quotient = (number(17) * x("a") - number(1)) / (number(4) * (x("a") - number(1)));
  for (const Residues& c : {odd, halves, integers, Residues{Rational(1, 6), Rational(2)}})
    for (const MFraction& f :
         {x("a"), squared(x("a")), quotient, number(4) * x("a") / squared(x("b"))})
      for (const bool holds : {true, false})
        EXPECT_EQ(to_string({SomeIn{{f}, Classes{c}}, holds}), to_string({SumIn{{f}, {c}}, holds}));
  EXPECT_EQ(to_string({SomeIn{{x("a")}}, false}), to_string({AllRational{{x("a")}}, false}));
  EXPECT_EQ(to_string({SomeIn{{quotient}, Classes{halves}}}),
            "sqrt((17*a - 1)/(a - 1)) is an odd integer");
  EXPECT_EQ(to_string({SomeIn{{number(4) * x("a")}, Classes{integers}}}),
            "2*sqrt(a) is an integer");
  EXPECT_EQ(to_string({SomeIn{{x("a"), squared(x("b"))}, Classes{halves}, true}}),
            "sqrt(a) or b is in 1/2 + Z, or sqrt(a) and b are rational");
  EXPECT_EQ(to_string({SomeIn{{x("a"), number(4) * x("b")}, Classes{halves}}, false}),
            "sqrt(a) is not in 1/2 + Z and sqrt(b) is not in 1/4 + 1/2*Z");
}

} // namespace
} // namespace kov::statement_words_test
