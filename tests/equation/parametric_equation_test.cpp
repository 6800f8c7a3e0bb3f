// Equations with parameters as text, and what is decided for all of them at once.

#include "equation/assumptions.hpp"
#include "equation/parametric_equation.hpp"
#include "equation/sentence.hpp"
#include "strata/words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using ::testing::HasSubstr;

ParametricEquation family(const std::string& r, const std::string& assume) {
  EquationText text;
  text.r = parse_expression(r, "r");
  text.variable = "z";
  text.assume.push_back({assume, nullptr, ""});
  for (const auto& name : names_in_assumption({assume, nullptr, ""}))
    text.parameters.push_back(name);
  return read_parametric_equation(text);
}

strata::StrataAnswer answer(const std::string& r, const std::string& assume) {
  return strata::decide_strata(family(r, assume).question);
}

TEST(Sentences, AreUnderstood) {
  EXPECT_EQ(sentences({"A > 0, B >= C; n not an integer and nu not in 1/2+Z", nullptr, ""}).size(),
            4U);
  EXPECT_EQ(sentences({"2*nu odd integer", nullptr, ""}).at(0).modulus, Rational(2));
  EXPECT_FALSE(sentences({"n is not an integer", nullptr, ""}).at(0).holds);
  EXPECT_EQ(sentences({"c arbitrary complex", nullptr, ""}).at(0).kind,
            Sentence::Kind::declaration);
  EXPECT_THROW(sentences({"c is blue", nullptr, ""}), InputError);
  EXPECT_THROW(sentences({"A >", nullptr, ""}), InputError);
}

// k Z is not k + Z.
TEST(Sentences, MultiplesOfTheIntegers) {
  const auto sentence = [](const char* text) { return sentences({text, nullptr, ""}).at(0); };
  EXPECT_EQ(sentence("nu in 1/2Z").modulus, Rational(1, 2));
  EXPECT_EQ(sentence("nu in (1/2)Z").modulus, Rational(1, 2));
  EXPECT_EQ(sentence("nu in 1/2 + Z").modulus, Rational(1));
  EXPECT_EQ(sentence("nu not in 1/2+2*Z").modulus, Rational(2));
  EXPECT_EQ(sentence("nu not in Z").modulus, Rational(1));
  EXPECT_THROW((void)sentence("nu in aZ"), InputError);
  EXPECT_THROW((void)sentence("nu in -2Z"), InputError);
  EXPECT_THROW((void)sentence("nu in 1/2-Z"), InputError);
  // Bessel: nu = 1 is SL(2), nu = 1/2 is not
  EXPECT_EQ(answer("-1 + (nu^2 - 1/4)/z^2", "nu in 1/2Z").abelian(), Truth::unknown);
  EXPECT_EQ(answer("-1 + (nu^2 - 1/4)/z^2", "nu not in 1/2+2Z").abelian(), Truth::unknown);
  EXPECT_EQ(answer("-1 + (nu^2 - 1/4)/z^2", "nu in 1/2+Z").abelian(), Truth::yes);
  EXPECT_EQ(answer("-1 + (nu^2 - 1/4)/z^2", "nu not in 1/2+Z").abelian(), Truth::no);
}

TEST(Families, AnInequalityIsAboutRealParameters) {
  EXPECT_THROW((void)answer("(-c^2 - 1)/(4*z^2) - 1", "c != 0, b - c > 0, c complex"), InputError);
  EXPECT_THROW((void)answer("I*z + a/z^2", "I*a > 0"), InputError);
  EXPECT_EQ(answer("(b/a)/(z - I)", "a arbitrary complex, b arbitrary complex").abelian(),
            Truth::unknown); // a = 0: r has no value
}

TEST(Families, AssumptionsAreAboutParameters) {
  EXPECT_THROW(static_cast<void>(family("a*z", "a = z")), InputError);
  EXPECT_THROW(static_cast<void>(family("a*z", "z > 0")), InputError);
}

// n/m means something only where m is not 0.
TEST(Families, AnAssumedIntegerHasADenominator) {
  const auto a = answer("m*z + n/z^2", "n/m integer");
  ASSERT_EQ(a.strata.size(), 1U); // no stratum m = 0
  EXPECT_TRUE(a.strata.front().solved.empty());
}

TEST(Families, WholeEquations) {
  EquationText text;
  text.ode = parse_expression("(z - b)*y'' = a*(z - b)*z*y + (1/(z - b))*y", "ode", true);
  text.parameters = {"a", "b"};
  EquationText r = text;
  r.ode.reset();
  r.r = parse_expression("a*z + 1/(z - b)^2", "r");
  EXPECT_EQ(to_string(read_parametric_equation(text).question.r),
            to_string(read_parametric_equation(r).question.r));
  text.ode = parse_expression("z*w'' + w' - n*w = 0", "ode", true); // w = y/sqrt(z)
  text.parameters = {"n"};
  r.r = parse_expression("n/z - 1/(4*z^2)", "r");
  r.parameters = {"n"};
  EXPECT_EQ(to_string(read_parametric_equation(text).question.r),
            to_string(read_parametric_equation(r).question.r));
  for (const char* wrong : {"w''' = n*w", "w'' = n*w^2", "w'' = n*w + 1"}) {
    text.ode = parse_expression(wrong, "ode", true);
    EXPECT_THROW(static_cast<void>(read_parametric_equation(text)), InputError) << wrong;
  }
}

// What is wrong with a sentence for the equation a*z, a = value; "" for nothing.
std::string complaint(const std::string& sentence, const std::string& value) {
  EquationText text;
  text.r = parse_expression("a*z", "r");
  text.variable = "z";
  text.parameters = {"a"};
  if (!value.empty()) text.set.emplace_back("a", parse_expression(value, "value"));
  text.assume.push_back({sentence, nullptr, ""});
  try {
    check_assumptions(text);
    return "";
  } catch (const InputError& e) {
    return e.message();
  }
}

TEST(Assumptions, AreCheckedAgainstTheValues) {
  for (const auto& [sentence, value] :
       std::vector<std::pair<std::string, std::string>>{{"a > 0", "2-sqrt(3)"},
                                                        {"a > sqrt(2)", "3/2"},
                                                        {"a in 1/2+Z", "-3/2"},
                                                        {"a real", "root(x^3-2, 1.26)"},
                                                        {"a != I", "1"},
                                                        {"a not an integer", "sqrt(2)"},
                                                        {"a >= 0", "sqrt(2)*sqrt(3)-sqrt(6)"}})
    EXPECT_EQ(complaint(sentence, value), "") << sentence;
  for (const auto& [sentence, value] :
       std::vector<std::pair<std::string, std::string>>{{"a > 0", "sqrt(3)-2"},
                                                        {"a > 0", "I"},
                                                        {"a > 0", "sqrt(2)*sqrt(3)-sqrt(6)"},
                                                        {"a != 0", "sqrt(2)*sqrt(3)-sqrt(6)"},
                                                        {"a rational", "sqrt(2)"},
                                                        {"a real", "1+I"},
                                                        {"a odd integer", "4"},
                                                        {"a not an integer", "4"},
                                                        {"a in Z", "1/2"}})
    EXPECT_THAT(complaint(sentence, value), HasSubstr("is violated by the values given"))
        << sentence;
}

TEST(Assumptions, SayOfWhatTheyAre) {
  EXPECT_THAT(complaint("b > 0", ""), HasSubstr("'b' is not a parameter"));
  EXPECT_THAT(complaint("a > z", "1"), HasSubstr("'z' is the variable"));
  EXPECT_THAT(complaint("a", ""), HasSubstr("not understood"));
  EXPECT_THAT(complaint(" ", ""), HasSubstr("says nothing"));
  EXPECT_THAT(complaint("1/(a-a) > 0", ""), HasSubstr("division by zero"));
  EXPECT_THAT(complaint("1/a > 0", "0"), HasSubstr("division by zero"));
  EXPECT_TRUE(is_prose("as in the paper", {"a"}));
  EXPECT_FALSE(is_prose("2*a", {"a"}));
}

TEST(Families, AiryIsNeverAbelian) {
  const auto a = answer("z + c", "c arbitrary complex");
  ASSERT_EQ(a.strata.size(), 1U);
  EXPECT_EQ(a.abelian(), Truth::no);
  EXPECT_EQ(a.strata[0].leaf.group->type, GroupType::SL2);
}

TEST(Families, BesselWithAndWithoutAHalfInteger) {
  const std::string r = "(4*nu^2-1)/(4*z^2)-1";
  const auto odd = answer(r, "2*nu odd integer");
  ASSERT_EQ(odd.strata.size(), 1U);
  EXPECT_EQ(odd.abelian(), Truth::yes);
  EXPECT_EQ(odd.strata[0].leaf.group->type, GroupType::Gm);
  const auto generic = answer(r, "nu not in 1/2+Z");
  ASSERT_EQ(generic.strata.size(), 1U);
  EXPECT_EQ(generic.abelian(), Truth::no);
  EXPECT_EQ(generic.strata[0].leaf.group->type, GroupType::SL2);
  const auto open = answer(r, "nu complex");
  EXPECT_EQ(open.abelian(), Truth::unknown); // not the same on its two parts
  EXPECT_TRUE(open.decided());
  EXPECT_THAT(open_condition(open.strata[0].leaf), HasSubstr("nu is in 1/2 + Z"));
}

TEST(Families, WeberIsNeverAbelian) {
  const std::string r = "z^2/4-1/2-n";
  EXPECT_EQ(answer(r, "n not an integer").strata[0].leaf.group->type, GroupType::SL2);
  EXPECT_EQ(answer(r, "n integer").strata[0].leaf.group->type, GroupType::Borel);
  const auto any = answer(r, "n complex");
  EXPECT_EQ(any.abelian(), Truth::no);
  EXPECT_FALSE(any.strata[0].leaf.group.has_value());
}

// A = C D > 0 says nothing about the sign of C/D: at C = I, D = -I it is -1, and the group is
// abelian.
TEST(ParametricEquation, NaturalNumbers) {
  const std::string r = "n*(n + 1)/z^2 + 1/4 - k/z";
  const auto group = [&](const std::string& assumed) {
    const auto a = answer(r, assumed);
    return a.strata[0].leaf.group ? a.strata[0].leaf.group->type : GroupType::cyclic;
  };
  for (const char* n : {"n in N", "n natural", "n is a natural number", "n nonnegative integer",
                        "n a positive integer"})
    EXPECT_EQ(group(std::string(n) + ", k integer, k > n"), GroupType::Borel) << n;
  EXPECT_EQ(group("n - 1 in N, k positive integer, k <= n"), GroupType::Gm);
  EXPECT_ANY_THROW((void)answer(r, "n not in N, k complex"));
  EXPECT_ANY_THROW((void)answer(r, "n in M, k complex"));
}

// What is not an integer, and twice it is one, is half of an odd one.
TEST(ParametricEquation, HalvesOfOddIntegers) {
  const std::string bessel = "(n^2 - 1)/(4*z^2) - 1";
  EXPECT_EQ(answer(bessel, "n integer, n/2 not an integer").strata[0].leaf.abelian, Truth::yes);
  EXPECT_EQ(answer(bessel, "n/2 not an integer, n integer").strata[0].leaf.abelian, Truth::yes);
  EXPECT_FALSE(answer(bessel, "n integer, n/3 not an integer").strata[0].leaf.group);
  EXPECT_ANY_THROW((void)answer(bessel, "n integer, n/2 not an integer, (n + 1)/2 not an integer"));
}

// Two rational exponent differences of a reducible equation make the third one rational.
TEST(ParametricEquation, RiemannWithRationalDifferences) {
  const std::string r = "(l^2 - 1)/(4*z^2) + (m^2 - 1)/(4*(z - 1)^2) + "
                        "(1 - l^2 - m^2 + n^2)/(4*z*(z - 1))";
  const auto abelian = [&](const std::string& assumed) {
    return answer(r, assumed).strata[0].leaf.abelian;
  };
  EXPECT_EQ(abelian("n complex, l - 1/2 integer, m - 3/2 integer"), Truth::yes);
  EXPECT_EQ(abelian("(l + m + n - 1)/2 integer, 3*l integer, 5*m integer"), Truth::yes);
  EXPECT_EQ(abelian("(l + m + n - 1)/2 integer, 3*l integer"), Truth::unknown);
  EXPECT_EQ(abelian("n complex, l - 1/2 integer, 3*m - 1/2 integer"), Truth::unknown);
  const std::string irreducible =
      "(l + m + n - 1)/2 not an integer, (l + m - n - 1)/2 not an integer, "
      "(l - m + n - 1)/2 not an integer, (l - m - n - 1)/2 not an integer, "
      "l - 1/2 not an integer, m - 1/2 not an integer, ";
  EXPECT_EQ(abelian(irreducible + "60*n not an integer"), Truth::no); // in no row of Schwarz' table
  EXPECT_EQ(abelian(irreducible + "12*n not an integer"), Truth::unknown);
}

// Hydrogen: n = l is the orbital number, k the principal one.  Abelian exactly where |k| <= l.
TEST(ParametricEquation, IntegersAndTheirSigns) {
  const std::string r = "n*(n + 1)/z^2 + 1/4 - k/z";
  const auto one = [&](const std::string& more) {
    const auto a = answer(r, "n integer, k integer, " + more);
    EXPECT_EQ(a.strata.size(), 1U) << more;
    return a.strata[0].leaf.group ? a.strata[0].leaf.group->type : GroupType::SL2;
  };
  EXPECT_EQ(one("k > n, n >= 0"), GroupType::Borel);
  EXPECT_EQ(one("k < -n, n >= 0"), GroupType::Borel);
  EXPECT_EQ(one("k <= n, k > 0"), GroupType::Gm);
  EXPECT_EQ(one("k <= n, k >= -n, n > 0"), GroupType::Gm);
  EXPECT_FALSE(answer(r, "n integer, k integer, k > n - 1, n >= 0").strata[0].leaf.group);
  EXPECT_FALSE(answer(r, "n integer, k > n, n >= 0").strata[0].leaf.group); // k may be none
}

TEST(Families, ASignOfNumTimesDenIsNoneOfTheQuotientWhereDenIsComplex) {
  const auto answered =
      answer("(1/9-1)/(4*z^2)-3/(16*(z-1)^2)+(8/9-C/D)/(4*z*(z-1))", "A > 0, A = C*D");
  for (const auto& s : answered.strata)
    EXPECT_NE(s.leaf.abelian, Truth::no) << to_string(s.conditions) << reason(s.leaf);
}

// Generic irrationality says nothing about a reducible family.
TEST(Families, AReducibleFamilyIsNotCalledNonAbelian) {
  // omega' + omega^2 for omega = a/z + b/(z-1)
  const auto answered =
      answer("(a^2-a)/z^2 + (b^2-b)/(z-1)^2 + 2*a*b/(z*(z-1))", "a complex, b complex");
  for (const auto& s : answered.strata)
    EXPECT_NE(s.leaf.abelian, Truth::no) << to_string(s.conditions) << reason(s.leaf);
}

TEST(Families, EulersEquationHasTwoExponentialSolutions) {
  EXPECT_EQ(answer("a/z^2", "a complex").abelian(), Truth::yes);
}

TEST(Families, ContradictionsAreTold) {
  EXPECT_THROW(static_cast<void>(answer("a/z^2 + 1", "a > 1, a < 0")), InputError);
  EXPECT_THROW(static_cast<void>(answer("a/z^2 + z", "a > 0, a^2 + a = 0")), InputError);
}

TEST(Families, RationalAndIntegerParameters) {
  EXPECT_EQ(answer("(a^2-2)/z^3", "a rational").strata.size(), 1U);
  EXPECT_EQ(answer("(a^2-2)/z^3", "a integer").strata.size(), 1U);
  EXPECT_EQ(answer("(a^2-2)/z^3", "a real").strata.size(), 2U);
  EXPECT_EQ(answer("(2*a-1)*(a-3)/z^3", "a integer").strata.size(), 2U);
  EXPECT_EQ(answer("(2*a-1)*(a-3)/z^3", "2*a odd integer").strata.size(), 2U);
  EXPECT_EQ(answer("(a-3)/z^3", "a not an integer").strata.size(), 1U);
  EXPECT_EQ(answer("(a^2-2*b^2)/z^3", "a rational, b rational").strata.size(), 2U); // a = b = 0
}

TEST(Families, ALongInequalityDoesNotKeepZ3Busy) {
  EXPECT_EQ(answer("a*z", "(a+1)^1000 > 0, a != 0").strata.size(), 1U);
}

TEST(Families, EquationsAmongTheParametersAreSolved) {
  const auto a = answer("z + a + b", "a + b = 0");
  ASSERT_EQ(a.strata.size(), 1U);
  EXPECT_EQ(a.abelian(), Truth::no);
}

TEST(Families, WhereTheLeadingCoefficientVanishes) {
  const auto a = answer("a*z + b", "a complex, b complex");
  EXPECT_EQ(a.strata.size(), 3U); // Airy; r constant; r = 0
  EXPECT_TRUE(a.decided());
  EXPECT_EQ(a.abelian(), Truth::unknown);
}

} // namespace
} // namespace kov
