// Classifications over an eigenvalue of the variations.

#include "classify/classify.hpp"
#include "support/points.hpp"

#include <gtest/gtest.h>

#include <set>

namespace kov::eigenvalue_test {
namespace {

SystemClassification classified(const std::string& form, bool with_constants = true) {
  ClassifyOptions options;
  options.adjoin_constants = with_constants;
  options.degree = 2;
  options.order = 1;
  return classify_system(
      read_system(parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y', 'z']\n"
                                 "momenta = ['u', 'v', 'w']\nparameters = ['a']\n"
                                 "hamiltonian = '(u^2 + v^2 + w^2)/2 + " +
                                     form + "'\n",
                                 "test.toml")),
      options);
}

// 2 lambda^2 - 2 a lambda - 1 has no two roots that are both of the kind that is needed.
TEST(ClassifiedEigenvalue, OfAForm) {
  const auto c = classified("z^4/4 + z^2*(a*x^2 + x*y) + x^3*y");
  EXPECT_EQ(c.constants.size(), 1U);
  for (const Rational& a : {Rational(0), Rational(1), Rational(-3, 2), Rational(7)})
    for (const ClassifiedStratum& s : c.strata)
      if (test::contains(s, {{"a", a}})) {
        EXPECT_EQ(s.status, StratumStatus::excluded);
      }
}

// The relation of lambda gives it as a function of a, of which finitely many values are left.
TEST(ClassifiedEigenvalue, AValueOfTheParameterThatIsNotRational) {
  for (const char* form :
       {"z^4/4 + z^2*((a^2 + 1)*x^2 + x*y)", "z^4/4 + z^2*((a^5 + a + 1)*x^2 + x*y)"})
    EXPECT_NO_THROW(static_cast<void>(classified(form))) << form;
}

// What is decided without the constants is decided so with them, and more may be.
TEST(ClassifiedEigenvalue, WhatIsDecidedBeforeStays) {
  for (const char* form : {"z^4/4 + z^2*(a*x^2 + x*y) + x^3*y", "z^4/4 + z^2*(x^2 + a*x*y)",
                           "(x^2 + y^2 + z^2)^2/4 + a*x^2 + x*y", "z^4/4 + a*z^2*x*y"}) {
    const auto before = classified(form, false);
    const auto after = classified(form);
    EXPECT_TRUE(before.constants.empty()) << form;
    for (const Rational& a : {Rational(0), Rational(1), Rational(-3, 2), Rational(7)}) {
      const std::string was = test::status_at(before, {{"a", a}});
      std::set<std::string> is; // over each root
      for (const ClassifiedStratum& s : after.strata)
        if (test::contains(s, {{"a", a}})) is.insert(to_string(s.status));
      if (was != "open") {
        EXPECT_EQ(is, std::set{was}) << form << ", a = " << to_string(a);
      }
      EXPECT_FALSE(is.empty()) << form << ", a = " << to_string(a);
    }
  }
}

// Garnier's system is integrable with every quadratic form.
TEST(ClassifiedEigenvalue, NoFalseAlarm) {
  const auto c = classified("(x^2 + y^2 + z^2)^2/4 + a*x^2 + x*y");
  for (const ClassifiedStratum& s : c.strata)
    EXPECT_NE(s.status, StratumStatus::excluded);
}

} // namespace
} // namespace kov::eigenvalue_test
