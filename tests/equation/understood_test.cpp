// Pasted equations that are not linear and homogeneous with rational coefficients: what is decided instead.

#include "equation/first_order_form.hpp"
#include "equation/function_change.hpp"
#include "equation/linear_form.hpp"
#include "equation/parametric_equation.hpp"
#include "equation/question.hpp"
#include "equation/understood.hpp"
#include "support/random.hpp"
#include "symbol/written.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using test::Random;
using test::random_rounds;
using testing::HasSubstr;

EquationText given(const std::vector<std::string>& parameters = {},
                   const std::string& variable = {}) {
  EquationText text;
  text.parameters = parameters;
  text.variable = variable;
  return text;
}

Understood read(const std::string& ode, const EquationText& with = given()) {
  return understood(ode, "-e", with);
}

std::string r_of(const std::string& ode, const EquationText& with = given()) {
  const GivenEquation e = read_equation(read(ode, with).text);
  return e.variable + ": " + to_string(e.normal_form.r, e.variable);
}

std::string complaint(const std::string& ode, const EquationText& with = given()) {
  try {
    return "understood: " + r_of(ode, with);
  } catch (const InputError& e) {
    return e.message() + " / " + e.hint();
  }
}

TEST(Understood, OperatorsOfOneVariable) {
  for (const char* airy : {"D^2 - x", "Dx^2 - x", "D^2 y = x y", "(D^2 - x) y = 0", "d^2/dx^2 - x",
                           "D*D = x", "(D^2 - x) y"})
    EXPECT_EQ(r_of(airy), "x: x") << airy;
  EXPECT_EQ(r_of("(D - x)(D + x)"), "x: x^2 - 1");
  EXPECT_EQ(r_of("(D + x)(D - x)"), "x: x^2 + 1");
  for (const char* euler : {"theta^2 - x", "θ^2 - x", "theta^2 y = x y", "x^2 y'' + x y' = x y"})
    EXPECT_EQ(r_of(euler), r_of("x^2*y'' + x*y' - x*y = 0")) << euler;
  EXPECT_EQ(read("theta^2 - a*x", given({"a"})).text.variable, "x");
  EXPECT_EQ(read("theta^2 - a*x").text.variable, "x");
  EXPECT_THAT(complaint("theta^2 - t*x"), HasSubstr("which of t and x is the variable"));
  EXPECT_EQ(r_of("y'' = D*y", given({}, "D")), "D: D"); // something is differentiated: D is a name
}

TEST(Understood, NamesThatRunIntoTheUnknownAreProducts) {
  for (const char* text : {"y'' = yx", "y'' = ax y"})
    EXPECT_THAT(complaint(text), HasSubstr("is read as one name")) << text;
  for (const char* text : {"y'' = xy", "y'' - xy = 0", "u'' = xu", "y'' = x y"})
    EXPECT_EQ(r_of(text), "x: x") << text;
  EXPECT_EQ(r_of("xy'' = x^2y"), "x: x");
  EXPECT_TRUE(read("y'' = xy*x*y", given({"xy"})).text.ode);
  EXPECT_EQ(r_of("psi'' = x psi"), "x: x");
  EXPECT_EQ(r_of("y'' = xi*y"), "xi: xi"); // a Greek letter
}

// The variable is the only usual one beside constants; constants alone have the unnamed one.
TEST(Understood, TheVariableBesideConstants) {
  for (const auto& [text, variable] : std::vector<std::pair<std::string, std::string>>{
           {"x^2 y'' + x y' + (x^2 - n^2) y = 0", "x"},
           {"y'' + (a - 2 q cos(2 z)) y = 0", "z"},
           {"psi'' = (x^2 - E) psi", "x"},
           {"x'' + 2 gamma x' + omega_0^2 x = 0", "t"},
           {"y'' = a^2 y", "x"},
           {"y'' = lambda*y", "x"},
           {"y'' = exp(a) y", "x"},
           {"x(1-x) y'' + (c - (a + b + 1) x) y' - a b y = 0", "x"},
           {"(1-x^2) y'' - 2x y' + n(n+1) y = 0", "x"},
           {"\\ddot\\theta + 2\\zeta\\omega_0\\dot\\theta + \\omega_0^2\\theta = 0", "t"},
           {"\u1e8d + 2\u03b3\u1e8b + \u03c9\u2080\u00b2x = 0", "t"},
           {"L\\ddot Q + R\\dot Q + Q/C = 0", "t"},
           {"x'' + 2 zeta omega_n x' + omega_n^2 x = 0", "t"},
           {"rho^2 R'' + rho R' + (rho^2 - n^2) R = 0", "rho"},
           {"(1-xi^2) w'' - 2 xi w' + n(n+1) w = 0", "xi"},
           {"Theta'' + cot(theta) Theta' + n(n+1) Theta = 0", "theta"},
           {"x'' + w0^2 x = F0*cos(w t)", "t"}}) {
    EquationTexts typed;
    typed.ode = text;
    const AskedEquation asked = asked_equation(typed, {}, Door::options);
    const std::string found = asked.text.change ? asked.text.change->variable : asked.text.variable;
    EXPECT_EQ(found, variable) << text;
    EXPECT_FALSE(asked.text.parameters.empty()) << text;
    const auto told = std::ranges::find(asked.notes, ReadingNote::What::names, &ReadingNote::what);
    EXPECT_TRUE(told != asked.notes.end() && told->of.size() > 2) << text;
  }
}

TEST(Understood, WhatMayBeAVariableIsAskedBack) {
  for (const char* text : {"y'' = x2 y", "y'' = s y", "y'' = r^2 y + 1", "x'' = y x",
                           "theta'' + 2 zeta omega_0 theta' + omega_0^2 theta = 0",
                           "y'' + 2 xi omega y' + omega^2 y = 0", "psi'' + (lambda - xi^2) psi = 0",
                           "u'' + rho*k*u = 0"})
    EXPECT_THAT(complaint(text), HasSubstr("the variable, or a constant?")) << text;
  for (const char* text : {"y'' = t x y", "y'' = x x2 y", "y'' = s w y"})
    EXPECT_THAT(complaint(text), HasSubstr("the variable?")) << text;
  EXPECT_TRUE(read("y'' = a^2*y", given({"a"})).text.ode);
  for (const char* text : {"y'' = x^2 y", "y'' = t y", "y'' = xi*y", "diff(y(a), a, 2) = a*y(a)",
                           "y''[k] == k*y[k]", "y'' = 2 y"})
    EXPECT_NO_THROW((void)r_of(text)) << text;
}

TEST(Understood, TheRightSideStandsBeside) {
  for (const auto& [text, right, r] :
       std::vector<std::tuple<const char*, const char*, const char*>>{
           {"y'' + x^2*y = sin(x)", "sin(x)", "x: -x^2"},
           {"y'' - y = e^x + x", "exp(x) + x", "x: 1"},
           {"x^2 y'' - 2 y - 3 x = 0", "3*x", "x: 2/x^2"},
           {"sin(x) = y'' + y", "-sin(x)", "x: -1"}}) {
    const Understood u = read(text);
    EXPECT_EQ(u.right_side.value_or(""), right) << text;
    EXPECT_EQ(r_of(text), r) << text;
    EXPECT_FALSE(u.read_as.empty());
  }
  for (const char* homogeneous : {"y'' = x*y + 0", "y''/y = x", "y'' - x*y = 0"})
    EXPECT_FALSE(read(homogeneous).right_side) << homogeneous;
  EXPECT_THAT(complaint("x*(y'' + 1) = y"),
              HasSubstr("not homogeneous")); // a term inside of a product
  EXPECT_THAT(complaint("y'' = t*x"), HasSubstr("which of t and x"));
}

// The equation as it was asked stays beside the one that is decided.
TEST(Understood, TheWholeEquation) {
  EXPECT_FALSE(read("y'' + y = 0").whole);
  EXPECT_EQ(written(read("y'' + y = tan x").whole->ode), "y'' + y = tan(x)");
  EXPECT_EQ(read("y'' + y = 0, y(0) = 1, y'(0) = 0").whole->conditions.size(), 2U);
  const Understood riccati = read("y' = x y^2 + 1");
  EXPECT_EQ(written(riccati.whole->ode), "y' = x*y^2 + 1");
  EXPECT_EQ(written(riccati.whole->riccati->a), "x");
}

// y = -u'/(a u) solves y' = a y^2 + b y + c where u solves the equation for u: with numbers for the derivatives.
TEST(Understood, RiccatiEquations) {
  EXPECT_EQ(r_of("y' = y^2 + x"), "x: -x");
  EXPECT_EQ(r_of("y' + y^2 = x"), "x: x");
  EXPECT_EQ(r_of("y' = -y*y + x^2 + 1"), "x: x^2 + 1");
  EXPECT_EQ(r_of("y'(x) = y(x)^2 + x"), "x: -x");
  EXPECT_EQ(r_of("diff(y(x), x) = y(x)^2 + x"), "x: -x");
  EXPECT_EQ(r_of("y' = (y + x)^2"), r_of("u'' - 2*x*u' + x^2*u = 0"));
  EXPECT_EQ(r_of("x*y' = y^2 - x^2"), r_of("u'' + u'/x - u = 0"));
  EXPECT_FALSE(first_order_form(parse_expression("y'' = y^2", "-e", true), "y", "x"));
}

// What solves y' = b y, and the constants, solve the equation that is decided.
TEST(Understood, LinearEquationsOfTheFirstOrder) {
  EXPECT_EQ(r_of("y' = x y"), r_of("y'' - (x + 1/x)*y' = 0"));
  EXPECT_EQ(r_of("y' = y + exp(x)"), r_of("y'' - y' = 0"));
  EXPECT_EQ(r_of("x*y' + 2*y = x^3"), r_of("y'' + 3/x*y' = 0"));
  EXPECT_EQ(r_of("dy/dx = y/x"), r_of("y'' = 0"));
  EXPECT_EQ(r_of("y' = 2x"), r_of("y'' = 0"));
  EXPECT_EQ(r_of("x/y' = 1/y"), r_of("y'' - (x + 1/x)*y' = 0"));
}

TEST(Understood, BernoulliEquations) {
  const auto form = [](const char* s) {
    return *first_order_form(parse_expression(s, "-e", true), "y", "x");
  };
  EXPECT_EQ(form("y' = y - x*y^3").linear, "v' + 2*v = 2*x");
  EXPECT_EQ(form("y*y' = x").substitution, "y = sqrt(v)");
  EXPECT_EQ(form("y*y' = x").linear, "v' = 2*x");
  EXPECT_EQ(form("y' = 1/y").linear, "v' = 2");
  EXPECT_EQ(form("x*y' + y = y^(-2)*sin(x)").linear, "v' + (3/x)*v = 3*sin(x)/x");
  EXPECT_EQ(r_of("y' = y - x*y^3"), r_of("v'' + 2*v' = 0"));
}

TEST(Understood, WhatIsSolvedOfTheFirstOrderIsSaid) {
  for (const char* other :
       {"y' = y^3 + x", "y'^2 = y^2", "y' = exp(y)", "y' = sin(x*y)", "y' = y^3 + y^2",
        "y' = x + 1/y", "y' = sqrt(y)", "y' = y^x", "y' = x*y^(1/2)", "y' = 2^y"})
    EXPECT_THAT(complaint(other), HasSubstr("not one that is solved here")) << other;
}

TEST(Understood, FunctionsBecomeTheVariable) {
  for (const auto& [text, change] : std::vector<std::pair<const char*, const char*>>{
           {"y'' = e^x*y", "t = exp(x)"},
           {"y'' = e^(2x) y + 3 y", "t = exp(2*x)"},
           {"y'' = e^-x y", "t = exp(x)"},
           {"y'' = sin(x)*y", "t = tan(x/2)"},
           {"y'' = cos(x)*y", "t = cos(x)"},
           {"y'' = cosh(x)^-2*y", "t = cosh(2*x)"},
           {"y'' = sinh(x) y", "t = exp(x)"},
           {"x^(3/2)*y'' + y = 0", "t = x^(1/2)"},
           {"sqrt(1 + 2*x)*y'' = x*y", "t = (2*x + 1)^(1/2)"}})
    EXPECT_THAT(sentences(read(text).notes), testing::Contains(HasSubstr(change))) << text;
  for (const auto& [text, words] : std::vector<std::pair<const char*, const char*>>{
           {"y'' = x sin(x) y", "also x outside"},
           {"y'' = exp(x) y + exp(sqrt(2)*x) y", "not rational"},
           {"y'' = exp(x)*sin(x)*y", "no one variable"},
           {"y'' = exp(x^2)*y", "not a multiple of x"},
           {"y'' = sqrt(x)*sqrt(x + 1)*y", "roots of two"},
           {"y'' = sqrt(x^2 + 1)*y", "linear function"},
           {"y'' = log(x)*y", "'log' is not a rational function"}})
    EXPECT_THAT(complaint(text), HasSubstr(words)) << text;
}

// Another road to the equation in t: with y = f(t(x)) for a power f = t^s the chain rule is written out by hand.
struct Road {
  const char* text; // y'' + A y' + B y = 0
  const char* t;    // its variable
  // t', t'' and the coefficients as functions of t
  const char *first, *second, *a, *b;
};

TEST(Understood, TheChainRuleHolds) {
  for (const Road& road : std::vector<Road>{
           {"y'' + e^x y' + (e^(2x) + 1) y = 0", "exp(x)", "t", "t", "t", "t^2 + 1"},
           {"y'' + tanh(x) y' + sinh(2x) y = 0", "exp(2*x)", "2*t", "4*t", "(t - 1)/(t + 1)",
            "(t^2 - 1)/(2*t)"},
           {"y'' + sin(x) y' + cos(x) y = 0", "cos(x)", "0", "0", "", ""},
           {"y'' + sin(x) y' + sin(x) y = 0", "tan(x/2)", "(1 + t^2)/2", "t*(1 + t^2)/2",
            "2*t/(1 + t^2)", "2*t/(1 + t^2)"},
           {"y'' + tan(2x) y' + sin(2x) y = 0", "tan(x)", "1 + t^2", "2*t*(1 + t^2)",
            "2*t/(1 - t^2)", "2*t/(1 + t^2)"},
           {"y'' + sqrt(x) y' + x y = 0", "x^(1/2)", "1/(2*t)", "-1/(4*t^3)", "t", "t^2"}}) {
    SCOPED_TRACE(road.text);
    const Understood u = read(road.text);
    EXPECT_THAT(sentences(u.notes), testing::Contains(HasSubstr(std::string("t = ") + road.t)));
    if (std::string(road.first) == "0") continue;
    const std::string first = std::string("(") + road.first + ")";
    const std::string hand = first + "^2*y'' + ((" + road.second + ") + (" + road.a + ")*" + first +
                             ")*y' + (" + road.b + ")*y = 0";
    EquationText text;
    text.ode = parse_expression(hand, "-e", true);
    text.variable = "t";
    EXPECT_EQ(to_string(read_equation(u.text).normal_form.r, "t"),
              to_string(read_equation(text).normal_form.r, "t"));
  }
}

// cos: by t = cos(x) y'' = (1 - t^2) y_tt - t y_t, and sin(x) y' = -(1 - t^2) y_t.
TEST(Understood, EvenEquationsHaveTheCosineAsVariable) {
  const auto by_hand = [](const std::string& ode) {
    EquationText text;
    text.ode = parse_expression(ode, "-e", true);
    text.variable = "t";
    return to_string(read_equation(text).normal_form.r, "t");
  };
  const auto ours = [](const std::string& ode) {
    return to_string(read_equation(read(ode).text).normal_form.r, "t");
  };
  EXPECT_EQ(ours("y'' + sin(x) y' + cos(x) y = 0"),
            by_hand("(1 - t^2)*y'' - t*y' - (1 - t^2)*y' + t*y = 0"));
  EXPECT_EQ(ours("y'' + cos(2x) y + cos(x) y = 0"),
            by_hand("(1 - t^2)*y'' - t*y' + (2*t^2 - 1 + t)*y = 0"));
  EXPECT_EQ(ours("y'' + sinh(x) y' + cosh(x) y = 0"),
            by_hand("(t^2 - 1)*y'' + t*y' + (t^2 - 1)*y' + t*y = 0"));
}

TEST(Understood, ParametersAndConstantsStay) {
  const Understood u = read("y'' = sqrt(2)*a*exp(b*x)*y", given({"a", "b"}, "x"));
  EXPECT_EQ(u.text.variable, "t");
  EquationText text;
  text.ode = parse_expression("b^2*(t^2*y'' + t*y') = sqrt(2)*a*t*y", "-e", true);
  text.variable = "t";
  text.parameters = {"a", "b"};
  EXPECT_EQ(to_string(read_parametric_equation(u.text).question.r),
            to_string(read_parametric_equation(text).question.r));
  EXPECT_EQ(read("y'' = a*exp(x)*y").text.change->variable, "x");
}

TEST(Understood, AnEquationThatIsWrittenOutIsLeftAsItIs) {
  for (const char* text :
       {"y'' = x*y", "x^2*y'' + x*y' + (x^2 - 1/4)*y = 0", "diff(y(x), x$2) = x*y(x)"}) {
    const Understood u = read(text);
    EXPECT_EQ(u.read_as, "") << text;
    for (const std::string& note : sentences(u.notes)) // but what was inferred is shown
      EXPECT_EQ(note, "the unknown is y, the variable is x") << text;
  }
}

} // namespace
} // namespace kov
