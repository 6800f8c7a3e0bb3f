// I, sqrt(2), the root of a polynomial beside parameters: what is said for all of them at once is
// what the solver says at single values.

#include "decide/decide.hpp"
#include "equation/parametric_equation.hpp"
#include "symbol/notations.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace kov {
namespace {

EquationText text_of(const std::string& r, const std::string& minpoly = "") {
  EquationText text;
  text.r = parse_expression(r, "r");
  text.variable = "z";
  if (!minpoly.empty()) text.minpoly = parse_expression(minpoly, "minpoly");
  text.parameters = {"b"};
  return text;
}

strata::StrataAnswer with_parameter(EquationText text, const std::string& assumption) {
  text.assume.push_back({assumption, nullptr, ""});
  return strata::decide_strata(read_parametric_equation(text).question);
}

Truth at(EquationText text, const std::string& value) {
  text.parameters.clear();
  text.set.emplace_back("b", parse_expression(value, "value"));
  return decide(read_equation(text).normal_form).abelian;
}

struct Case {
  const char* r;
  const char* minpoly;
  const char* assumption;
};

class AlgebraicConstantsBeside : public ::testing::TestWithParam<Case> {};

TEST_P(AlgebraicConstantsBeside, AParameterAgreeWithSingleValues) {
  const Case& c = GetParam();
  const EquationText text = text_of(c.r, c.minpoly);
  const auto answer = with_parameter(text, c.assumption);
  const Ring ring = answer.question->r.ring();
  const auto b = ring->index("b");
  for (const char* value : {"1", "2", "1/3", "5/7", "12"}) {
    const MFraction v = evaluate(parse_expression(value, "value"), ParameterScope(ring, {}));
    const auto holds = [&](const Condition& condition) {
      return is_zero(substitute(condition.p, {{b, v}})) == (condition.sign == Sign::zero);
    };
    for (const auto& x : answer.strata) {
      if (x.leaf.abelian == Truth::unknown || x.solved.contains(b)) continue;
      if (std::all_of(x.conditions.begin(), x.conditions.end(), holds)) {
        EXPECT_EQ(x.leaf.abelian, at(text, value)) << c.r << ", b = " << value;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Families, AlgebraicConstantsBeside,
    ::testing::Values(Case{"(I*b - 1)/(4*z^2) + z", "", "b > 0"},
                      Case{"I*b/z^2 + b/(z - 1)^2", "", "b > 0"},
                      Case{"(sqrt(2) + b)/z^2 - 3/(16*(z - 1)^2)", "", "b > 0"},
                      Case{"a*b*z + 1/z^4", "a^3 - 2", "b != 0"}, Case{"b*z^2 + I", "", "b != 0"},
                      Case{"(b - sqrt(-3))/z^3", "", "b arbitrary complex"},
                      Case{"b/(z^2 - sqrt(2)) + b*I/z", "", "b real"}));

TEST(AlgebraicConstants, DecideFamilies) {
  EXPECT_EQ(with_parameter(text_of("(I*b - 1)/(4*z^2) + 1/(z - 1)"), "b > 0").abelian(), Truth::no);
  // Delta^2 = 1 +- 4 sqrt(2) is not the square of a rational number
  EXPECT_EQ(with_parameter(text_of("b*z + sqrt(2)/z^2"), "b != 0").abelian(), Truth::no);
  EXPECT_EQ(with_parameter(text_of("a*b/z^3", "a^2 - 5"), "b != 0").abelian(), Truth::no);
}

// The relation I^2 = -1 stays when another equation is solved.
TEST(AlgebraicConstants, AreNotLostWhenAParameterIsSolvedFor) {
  for (const char* r : {"(b^2 - I)*z + I*b*z^3 + 1/z^2", "(b^2 - I)*z + I/(z - b)^2 + b*z^3"}) {
    const auto answer = with_parameter(text_of(r), "b arbitrary complex");
    EXPECT_EQ(answer.abelian(), Truth::no) << r;
    for (const auto& x : answer.strata)
      EXPECT_FALSE(x.solved.contains(answer.question->r.ring()->index("I"))) << r;
  }
}

TEST(AlgebraicConstants, AreIndependent) {
  const auto r = [](const char* text) {
    return to_string(read_parametric_equation(text_of(text)).question.r);
  };
  EXPECT_EQ(r("(sqrt(8) - 2*sqrt(2))*z^3 + b*z"), r("b*z"));
  EXPECT_EQ(r("(sqrt(-1) - I)*z^3 + b*z"), r("b*z"));
  EXPECT_EQ(r("sqrt(4)*b*z"), r("2*b*z"));
  EXPECT_EQ(r("(sqrt(6)*sqrt(2) - 2*sqrt(3))*z^3 + b*z"), r("b*z"));
  EXPECT_EQ(r("I^3*b + I*b + z"), r("z"));
  // c^2 - 2 is 0
  EXPECT_EQ(
      to_string(read_parametric_equation(text_of("(c^2 - 1/4)/z^2 + b*(c^2 - 2)*z", "c^2 - 2"))
                    .question.r),
      "7/(4*z^2)");
  EXPECT_THROW(static_cast<void>(read_parametric_equation(text_of("I*z^3 + b*z", "I^2 - 2"))),
               InputError);
}

// w = sqrt(f(b)) is a parameter with w^2 = f(b): at a value of w the strata say what the solver says
// for the number b with this root.
TEST(AlgebraicConstants, RootsOfFunctionsOfTheParameters) {
  const std::vector<std::pair<std::string, std::string>> roots{{"sqrt(b)", "w^2"},
                                                               {"sqrt(b - 1)", "w^2 + 1"},
                                                               {"sqrt(1/b)", "1/w^2"},
                                                               {"sqrt(4*b + 1)", "(w^2 - 1)/4"}};
  for (const char* form : {"W*z", "(W - 1/4)/z^2", "(W^2 - 1/4)/z^2 - 1", "b/z^2 + W", "z^2 + W",
                           "(W - 1/4)/z^2 - b", "W/z^2 + 1/(z - 1)^2"})
    for (const auto& [root, b] : roots) {
      std::string r = form;
      for (std::size_t i; (i = r.find('W')) != std::string::npos;)
        r.replace(i, 1, root);
      SCOPED_TRACE(r);
      const auto answer = strata::decide_strata(read_parametric_equation(text_of(r)).question);
      const Ring& ring = answer.question->r.ring();
      std::size_t w = 0; // the one whose name is not a word
      while (ring->name(w).find('(') == std::string::npos)
        ++w;
      for (const char* value : {"1", "2", "3/2", "1/3"}) { // roots that are positive
        const Ring one = make_ring({"w"});
        const auto number = [&](const std::string& text, const ParameterScope& scope) {
          const MFraction v = evaluate(parse_expression(text, "number"), scope);
          return is_zero(v) ? Rational(0) : to_rational(v);
        };
        const Rational root_value = number(value, ParameterScope(one, {}));
        const Rational at_b = number(b, ParameterScope(one, {{"w", MFraction(one, root_value)}}));
        const auto* s = strata::stratum_at(answer, {{w, root_value}, {ring->index("b"), at_b}});
        ASSERT_NE(s, nullptr) << value;
        if (s->leaf.abelian == Truth::unknown) continue;
        EXPECT_EQ(s->leaf.abelian, at(text_of(r), to_string(at_b))) << value;
      }
    }
}

TEST(AlgebraicConstants, APositiveNumberHasAPositiveRoot) { // sympy issue 22525
  EquationText text;
  text.ode =
      parse_expression("4*N*sqrt(N-1)*y + (4*s^2*(N-1) + (N - 2*s*(N-1))^2)*y'' = 0", "ode", true);
  text.variable = "s";
  text.parameters = {"N"};
  const auto answer = with_parameter(text, "N > 1");
  EXPECT_EQ(answer.abelian(), Truth::no);
  for (const auto& s : answer.strata) {
    ASSERT_TRUE(s.leaf.group) << to_string(s.conditions);
    EXPECT_EQ(s.leaf.group->type, GroupType::SL2) << to_string(s.conditions);
  }
}

TEST(AlgebraicConstants, WhatIsNotRead) {
  EXPECT_THROW(static_cast<void>(read_parametric_equation(text_of("root(x^2 - 2, 1.4)*b*z"))),
               FreeParameters);
  for (const char* r : {"sqrt(z)*b", "sqrt(b + sqrt(2))*z", "sqrt(b + z)", "sqrt(b - b)*b*z"})
    EXPECT_THROW(static_cast<void>(read_parametric_equation(text_of(r))), FreeParameters) << r;
  EXPECT_THROW(static_cast<void>(read_parametric_equation(text_of("sqrt(2)*b*z*c", "c^2 - 2"))),
               FreeParameters);
}

// What is 0 by the equations of the constants is 0, beside parameters, too.
TEST(AlgebraicConstants, DivisionByAZeroIsAnErrorOfTheInput) {
  for (const auto& [r, minpoly] : std::vector<std::pair<std::string, std::string>>{
           {"b/(a^2-2)", "a^2-2"},
           {"b + (a^2-2)^(-1)", "a^2-2"},
           {"b*z/(z*(a^3-2*a))", "a^2-2"},
           {"b*(1 + 1/(z*(a^2+a+1) + a^2+a+1))", "a^2+a+1"},
           {"b/(I^2+1)", ""},
           {"b*(I*I+1)^(-2)", ""},
           {"b/(sqrt(2)^2-2)", ""},
           {"b/(sqrt(6)-sqrt(2)*sqrt(3))", ""},
           {"b/(1+I*sqrt(-1))", ""}})
    EXPECT_THROW((void)read_parametric_equation(text_of(r, minpoly)), InputError) << r;
  for (const auto& [r, minpoly] : std::vector<std::pair<std::string, std::string>>{
           {"b/(a^2-3)", "a^2-2"}, {"b/(a^2+2)", "a^2-2"}, {"b/(I-1)", ""}, {"0^2*b+1/(b-I)", ""}})
    EXPECT_NO_THROW((void)read_parametric_equation(text_of(r, minpoly))) << r;
}

TEST(AlgebraicConstants, ALeadingCoefficientThatIsZeroIsAnErrorOfTheInput) {
  for (const auto& [ode, minpoly] :
       std::vector<std::pair<std::string, std::string>>{{"(a^2-2)*y'' + b*y = 0", "a^2-2"},
                                                        {"(I^2+1)*y'' + b*y = 0", ""},
                                                        {"y'' + b/(a^2-2)*y = 0", "a^2-2"},
                                                        {"y'' + y/(b*(I^2+1)) = 0", ""}}) {
    EquationText text = text_of("b", minpoly);
    text.r.reset();
    text.ode = parse_ode(ode, "ode");
    EXPECT_THROW((void)read_parametric_equation(text), InputError) << ode;
  }
}

} // namespace
} // namespace kov
