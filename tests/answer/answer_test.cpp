// One equation as people write it, its solutions in their letters; each is put into the given equation at points.

#include "answer/answer.hpp"

#include "answer/notation.hpp"
#include "answer/solve.hpp"
#include "decide/afterwards.hpp"
#include "equation/understood.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::answer {
namespace {

using Texts = std::vector<std::string>;

struct Asked {
  const char* ode;
  std::vector<std::string> parameters;
  Texts wanted; ///< as people read them
  const char* variable = "x";
};

Solutions answered(const Asked& asked, const Style& style = {}) {
  EquationText names;
  names.parameters = asked.parameters;
  names.variable = asked.variable;
  const EquationText text = understood(asked.ode, "-e", names).text;
  const Given given = given_equation(text);
  try {
    const GivenEquation equation = read_equation(text);
    Options options;
    options.variable = equation.variable;
    const Decision decision = decide(equation.normal_form, options);
    return solutions_of(given, equation, decision, equation.p * RationalFunction(Rational(-1, 2)),
                        style);
  } catch (const FreeParameters&) {
    const ParametricEquation equation = *read_parts(text).front().equation;
    strata::StrataLimits limits;
    limits.decide.variable = equation.variable;
    return solutions_of(given, equation, strata::decide_strata(equation.question, limits), style)
        .general;
  }
}

Texts shown_texts(const Solutions& all) {
  Texts texts;
  for (const Expression& y : all.y)
    texts.push_back(for_people(y));
  return texts;
}

class Answers : public testing::TestWithParam<Asked> {};

TEST_P(Answers, SolveTheGivenEquation) {
  const Solutions found = answered(GetParam());
  EXPECT_EQ(shown_texts(found), GetParam().wanted) << GetParam().ode;
  EXPECT_TRUE(found.failed.empty()) << GetParam().ode << ": " << found.failed.front();
  EXPECT_TRUE(found.read_back) << GetParam().ode;
}

INSTANTIATE_TEST_SUITE_P(
    Elementary, Answers,
    testing::Values(Asked{"y'' + 4y = 0", {}, {"cos(2*x)", "sin(2*x)"}},
                    Asked{"y'' + 2y' + 5y = 0", {}, {"exp(-x)*cos(2*x)", "exp(-x)*sin(2*x)"}},
                    Asked{"y'' + (2/x) y' + y = 0", {}, {"cos(x)/x", "sin(x)/x"}},
                    Asked{"4 x y'' + 2 y' + y = 0", {}, {"cos(sqrt(x))", "sin(sqrt(x))"}},
                    Asked{"x^2 y'' + x y' + y = 0", {}, {"cos(log(x))", "sin(log(x))"}},
                    Asked{"y'' - 2 tan(x) y' + 3 y = 0", {}, {"sin(x)", "cos(x) - 1/(2*cos(x))"}},
                    Asked{"y'' + a^2 y = 0", {"a"}, {"cos(a*x)", "sin(a*x)"}},
                    Asked{"x'' + 2 gamma x' + omega^2 x = 0",
                          {"gamma", "omega"},
                          {"exp(t*sqrt(gamma^2 - omega^2) - gamma*t)",
                           "exp(-gamma*t - t*sqrt(gamma^2 - omega^2))"},
                          "t"}));

INSTANTIATE_TEST_SUITE_P(
    WithAName, Answers,
    testing::Values(
        Asked{"y'' = x y", {}, {"Ai(x)", "Bi(x)"}},
        Asked{"x^2 y'' + x y' + x^2 y = 0", {}, {"J_0(x)", "Y_0(x)"}},
        Asked{"y'' + e^x y = 0", {}, {"J_0(2*exp(x/2))", "Y_0(2*exp(x/2))"}},
        Asked{"y'' + exp(2x) y = 0", {}, {"J_0(exp(x))", "Y_0(exp(x))"}},
        Asked{"y'' = (x^2 - 2) y", {}, {"D_(1/2)(sqrt(2)*x)", "D_(1/2)(-sqrt(2)*x)"}},
        Asked{"x y'' + (1/2 - x) y' - y/3 = 0", {}, {"M(1/3, 1/2, x)", "sqrt(x)*M(5/6, 3/2, x)"}},
        Asked{"y'' = x^4 y", {}, {"sqrt(x)*I_(1/6)(x^3/3)", "sqrt(x)*K_(1/6)(x^3/3)"}}));

INSTANTIATE_TEST_SUITE_P(
    WithANameAndParameters, Answers,
    testing::Values(Asked{"x^2 y'' + x y' + (x^2 - n^2) y = 0", {"n"}, {"J_n(x)", "Y_n(x)"}},
                    Asked{"(1-x^2) y'' - 2x y' + n(n+1) y = 0", {"n"}, {"P_n(x)", "Q_n(x)"}},
                    Asked{"x*(1-x)*y'' + (c - (a+b+1)*x)*y' - a*b*y = 0",
                          {"a", "b", "c"},
                          {"2F1(a, b; c; x)", "x^(1 - c)*2F1(a - c + 1, b - c + 1; 2 - c; x)"}},
                    Asked{"x y'' + (b - x) y' - a y = 0", {"a", "b"}, {"M(a, b, x)", "U(a, b, x)"}},
                    Asked{"y'' = a x y", {"a"}, {"Ai(a^(1/3)*x)", "Bi(a^(1/3)*x)"}}));

TEST(Answers, ExponentialsWhereTheyAreAskedFor) {
  Style complex;
  complex.complex = true;
  EXPECT_EQ(shown_texts(answered({"y'' + 4y = 0", {}, {}}, complex)),
            (Texts{"exp(2*I*x)", "exp(-2*I*x)"}));
}

TEST(Answers, AFormulaThatDoesNotSolveIsLeftOut) {
  const Given given{parse_expression("y'' = x*y", "-e", true), "y", "x", {}, {}};
  const Solutions found =
      shown(given, {parse_expression("airyai(x)", "y"), parse_expression("airybi(2*x)", "y")});
  EXPECT_EQ(shown_texts(found), Texts{"Ai(x)"});
  ASSERT_EQ(found.failed.size(), 1U);
  EXPECT_THAT(found.failed.front(), testing::HasSubstr("Bi(2*x)"));
}

TEST(Answers, WhereTwoAreABasisIsSaid) {
  const Solutions legendre = answered({"(1-x^2) y'' - 2x y' + n(n+1) y = 0", {"n"}, {}});
  EXPECT_EQ(legendre.unless, Texts{"n is a negative integer"});
  const Solutions gauss =
      answered({"x*(1-x)*y'' + (c - (a+b+1)*x)*y' - a*b*y = 0", {"a", "b", "c"}, {}});
  EXPECT_EQ(gauss.unless, Texts{"c is an integer"});
}

elementary::WholeAnswer whole(const char* ode, const std::vector<std::string>& parameters = {}) {
  EquationText names;
  names.parameters = parameters;
  names.variable = "x";
  EquationTexts texts;
  texts.ode = ode;
  const AskedEquation asked = asked_equation(texts, names, Door::options);
  const Given given = given_equation(asked.text);
  try {
    const GivenEquation equation = read_equation(asked.text);
    const Decidable what = in_its_variable(equation);
    const Decision decision = decided(what, {});
    return whole_of(asked, solutions_of(given, equation, decision, what.gauge).y);
  } catch (const FreeParameters&) {
    const ParametricEquation equation = *read_parts(asked.text).front().equation;
    const auto strata = strata::decide_strata(equation.question, {});
    return whole_of(asked, solutions_of(given, equation, strata).general.y);
  }
}

// Two solutions in functions with a name make the answer to the whole equation; each is put into it.
TEST(Whole, ByFunctionsWithAName) {
  EXPECT_EQ(whole("y'' - x y = 1").particular.value_or("none"),
            "pi*airybi(x)*int(airyai(x), x) - pi*airyai(x)*int(airybi(x), x)");
  EXPECT_EQ(whole("y'' = x y, y(0) = 1, y'(0) = 0").with_values.value_or("none"),
            "pi*airybiprime(0)*airyai(x) - pi*airyaiprime(0)*airybi(x)");
  EXPECT_EQ(whole("y' = y^2 + x").general.value_or("none"),
            "(airyaiprime(-x) + c*airybiprime(-x))/(airyai(-x) + c*airybi(-x))");
  for (const char* ode :
       {"x^2 y'' + x y' + (x^2 - 1) y = x", "x^2 y'' + x y' + x^2 y = 0, y(1) = 1, y'(1) = 0",
        "y'' + exp(x) y = 1", "y'' = x^4 y, y(1) = 0, y'(1) = 1", "y' = x^2 + y^2, y(1) = 2",
        "(1-x^2) y'' - 2x y' + 3/4 y = x", "y'' = (x^2 - 2) y, y(1) = 1, y'(1) = 0",
        "y'' - x y = x^2, y(1) = 1, y'(1) = 0", "x y'' + (1/2 - x) y' - y/3 = 1"}) {
    const elementary::WholeAnswer all = whole(ode);
    EXPECT_TRUE(all.failed.empty()) << ode << ": " << all.failed.front();
    EXPECT_EQ(std::string(ode).find("y(") != std::string::npos, all.with_values.has_value())
        << ode << ": " << all.no_values;
    EXPECT_TRUE(all.general || all.with_values) << ode;
  }
  for (const char* ode : {"x^2 y'' + x y' + (x^2 - n^2) y = x", "y' = y^2 + a x",
                          "x^2 y'' + x y' + (x^2 - n^2) y = 0, y(1) = 1, y'(1) = 0"}) {
    const elementary::WholeAnswer all = whole(ode, {"a", "n"});
    EXPECT_TRUE(all.failed.empty() && (all.general || all.with_values)) << ode;
  }
  EXPECT_EQ(whole("x^2 y'' + x y' + x^2 y = 0, y(0) = 1, y'(0) = 0").no_values,
            "the solutions have no value at 0");
}

Family family(const char* ode, const std::vector<AssumedText>& assume = {}) {
  EquationText names;
  names.parameters = {"a"};
  names.variable = "x";
  EquationText text = understood(ode, "-e", names).text;
  text.assume = assume;
  return decide_family(text, {});
}

// t = exp(a x) is no variable where a = 0, and there the equation is another one.
TEST(Families, CoverTheValuesForWhichTheVariableIsNone) {
  const Family all = family("y'' + exp(a*x)*y = 0");
  ASSERT_EQ(all.parts.size(), 2U);
  EXPECT_EQ(in_words(all.parts[0].part), "a != 0");
  EXPECT_EQ(in_words(all.parts[1].part), "a = 0");
  EXPECT_TRUE(all.is_complete());
  EXPECT_EQ(all.strata().size(), 2U);
  EXPECT_EQ(all.abelian(), Truth::unknown); // no, and yes for a = 0
  EXPECT_EQ(all.group(), std::nullopt);
}

TEST(Families, HaveNoPartThatTheAssumptionsExclude) {
  const Family positive = family("y'' + exp(a*x)*y = 0", assumed_texts({"a > 0"}, "a")),
               zero = family("y'' + exp(a*x)*y = 0", assumed_texts({"a = 0"}, "a"));
  ASSERT_EQ(positive.parts.size(), 1U);
  EXPECT_EQ(positive.abelian(), Truth::no);
  EXPECT_TRUE(positive.known && positive.known->generic.empty());
  ASSERT_EQ(zero.parts.size(), 1U);
  EXPECT_TRUE(zero.first_is_left_out);
  EXPECT_EQ(zero.abelian(), Truth::yes);
  EXPECT_FALSE(zero.known);
}

TEST(DecidedTwice, TwoProofsThatExcludeEachOtherAreAnError) {
  const RationalFunction airy(Poly::z());
  const auto closed = [](GroupType type) { return ClosedAnswer::of({type, {}}, "a formula"); };
  EXPECT_EQ(decided_twice(closed(GroupType::SL2), airy, {}).abelian(), Truth::no);
  EXPECT_THROW((void)decided_twice(closed(GroupType::Gm), airy, {}), Contradiction);
}

// Each function, with its derivative: its equation holds at points, and a neighbouring one does not.
TEST(ReadBack, KnowsEachFunction) {
  const std::pair<const char*, const char*> all[]{
      {"x^2*y'' + x*y' + (x^2 - n^2)*y = 0", "besselj(n, x)"},
      {"x^2*y'' + x*y' + (x^2 - n^2)*y = 0", "bessely(n, x)"},
      {"x^2*y'' + x*y' - (x^2 + n^2)*y = 0", "besseli(n, x)"},
      {"x^2*y'' + x*y' - (x^2 + n^2)*y = 0", "besselk(n, x)"},
      {"x*y'' + (b - x)*y' - a*y = 0", "hyp1f1(a, b, x)"},
      {"x*y'' + (b - x)*y' - a*y = 0", "hyperu(a, b, x)"},
      {"x*(1 - x)*y'' + (c - (a + b + 1)*x)*y' - a*b*y = 0", "hyp2f1(a, b, c, x)"},
      {"(1 - x^2)*y'' - 2*x*y' + (n*(n + 1) - m^2/(1 - x^2))*y = 0", "legenp(n, m, x)"},
      {"(1 - x^2)*y'' - 2*x*y' + (n*(n + 1) - m^2/(1 - x^2))*y = 0", "legenq(n, m, x)"},
      {"y'' = (x^2/4 - n - 1/2)*y", "pcfd(n, x)"},
      {"y'' = x*y", "airyai(x)"},
      {"y'' = x*y", "airybi(x)"},
      {"y'' + 2*x*y' = 0", "erf(x)"},
      {"y'' - 2*x*y' = 0", "erfi(x)"},
      {"x*y'' + (1 - x)*y' = 0", "Ei(x)"},
      {"y'' = cos(x)", "int(sin(x), x)"}};
  for (const auto& [ode, text] : all) {
    const ReadBackEquation right{parse_expression(ode, "-e", true), "y", "x", {}, {}};
    const bool integral = std::string(text).starts_with("int");
    EXPECT_EQ(read_back(text, right), ReadBack::solves) << text;
    const ReadBackEquation wrong{
        parse_expression("y'' = 3*y" + std::string(integral ? "/7" : ""), "-e", true),
        "y",
        "x",
        {},
        {}};
    EXPECT_EQ(read_back(text, wrong), ReadBack::differs) << text;
  }
}

} // namespace
} // namespace kov::answer
