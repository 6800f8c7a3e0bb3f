// Right sides, initial values, Riccati equations: those with a known solution, put into the given equation.

#include "elementary/check.hpp"
#include "elementary/solutions.hpp"
#include "elementary/whole.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

namespace kov::elementary {
namespace {

using test::Random;
using test::random_rounds;

LettersPtr letters() {
  return std::make_shared<Letters>("x", std::vector<std::string>{"a", "s", "c"});
}

Expression equation(const std::string& text) { return parse_expression(text, "e", true); }

LinearEquation linear(const std::string& text) {
  return linear_equation(equation(text), "y", letters());
}

std::string particular(const std::string& ode) {
  const LinearEquation e = linear(ode);
  const auto y = particular_solution(e, homogeneous_basis(e));
  if (!y) return "none";
  return holds_at_points(equation(ode), "y", *y) ? text(*y, is_hyperbolic(equation(ode)))
                                                 : "wrong: " + text(*y);
}

TEST(Particular, WhatTextbooksAsk) {
  EXPECT_EQ(particular("y'' + y = tan(x)"), "cos(x)*log((1 - sin(x))/(sin(x) + 1))/2");
  EXPECT_EQ(particular("y'' + y = 1/cos(x)"), "cos(x)*log(cos(x)) + x*sin(x)");
  EXPECT_EQ(particular("x^2*y'' - 3*x*y' + 4*y = x^2*log(x)"), "x^2*log(x)^3/6");
  EXPECT_EQ(particular("y'' + y = cosh(2*x)"), "cosh(2*x)/5");
  EXPECT_EQ(particular("y'' + 4*y = sin(x)^2"), "1/8 - x*sin(2*x)/8");
  EXPECT_EQ(particular("y'' - s*y = -1"), "1/s");
  EXPECT_EQ(particular("y'' + y = x*exp(x)"), "(x - 1)*exp(x)/2");
  EXPECT_EQ(particular("y'' + y = x^2"), "x^2 - 2");
  EXPECT_EQ(particular("y'' - 2*y' + y = exp(x)/x"), "x*exp(x)*log(x)");
  for (const char* ode :
       {"y'' + a^2*y = cos(a*x)", "y'' + y = 1/sin(x)^2", "y'' - y = 1/(1 + exp(x))",
        "x^2*y'' + x*y' + y = log(x)", "y'' + 2*a*y' + s*y = sin(x)", "y'' + 4*y = 1/cos(2*x)",
        "x^2*y'' - 2*y = 1/x", "y'' + y = exp(-x^2)", "y'' + y = 1/x", "y'' - y = x*sinh(x)",
        "x^2*y'' - 2*y = x^2", "y'' + y = cot(x)", "y'' + y = tan(x)^2",
        "y'' + 2*y = exp(x)*cos(x)", "y'' - 3*y' + 2*y = sqrt(x)",
        "x^2*y'' + 3*x*y' + 5*y = 1/x"}) {
    const std::string found = particular(ode);
    EXPECT_TRUE(found != "none" && !found.starts_with("wrong")) << ode << ": " << found;
  }
}

std::string number(Random& random) {
  const long n = random.between(-4, 4);
  return "(" + std::to_string(n == 0 ? 5 : n) + ")";
}

std::string homogeneous(Random& random) {
  const std::string b = number(random), c = number(random);
  return random.once_in(2) ? "y'' + " + b + "*y' + " + c + "*y"
                           : "x^2*y'' + " + b + "*x*y' + " + c + "*y";
}

// Of a sum of two products.
std::string some_function(Random& random) {
  static const std::vector<std::string> atoms{
      "x",      "x^2", "exp(x)",        "x*exp(-2*x)", "sin(2*x)", "x*cos(x)",
      "log(x)", "1/x", "exp(x)*sin(x)", "sinh(x)",     "sin(x)^2", "sqrt(x)"};
  return number(random) + "*" + random.one_of(atoms) + " + " + number(random) + "*" +
         random.one_of(atoms);
}

// L y for a known y: y itself need not be found again, but some solution.
TEST(Particular, OfARightSideWithAKnownSolution) {
  random_rounds(20, [](Random& random) {
    const std::string left = homogeneous(random), known = some_function(random);
    const LinearEquation e = linear(left + " = 0");
    const Element y = element(parse_expression(known, "y"), e.right.letters());
    const Element f = e.c2 * derivative(derivative(y)) + e.c1 * derivative(y) + e.c0 * y;
    const std::string ode = left + " = " + text(f);
    const std::string found = particular(ode);
    EXPECT_TRUE(found != "none" && !found.starts_with("wrong") &&
                found.find("int(") == std::string::npos)
        << ode << ", y = " << known << ": " << found;
  });
}

WholeAnswer answered(const std::string& ode, const std::vector<std::string>& conditions) {
  WholeEquation e{equation(ode), "y", "x"};
  for (const std::string& c : conditions)
    e.conditions.push_back(equation(c));
  return whole_answer(e, [](const LettersPtr&) { return std::optional<Basis>(); });
}

TEST(InitialValues, GiveOneRealFunction) {
  const auto y = [](const std::string& ode, const std::vector<std::string>& conditions) {
    const WholeAnswer a = answered(ode, conditions);
    EXPECT_TRUE(a.failed.empty()) << ode;
    return a.with_values ? *a.with_values : a.no_values;
  };
  EXPECT_EQ(y("y'' + 4*y = 0", {"y(0) = 1", "y'(0) = 0"}), "cos(2*x)");
  EXPECT_EQ(y("y'' + 3*y' + 2*y = 0", {"y(0) = 1", "y'(0) = -1"}), "exp(-x)");
  EXPECT_EQ(y("y'' + y = 0", {"y(1) = 1", "y'(1) = 0"}), "cos(x - 1)");
  EXPECT_EQ(y("y'' + y = x", {"y(0) = a", "y'(0) = 1"}), "a*cos(x) + x");
  EXPECT_EQ(y("y'' + y = 0", {"y(0) = 0", "y(pi/2) = 1"}), "sin(x)");
  EXPECT_EQ(y("x^2*y'' - 2*y = 0", {"y(1) = 1", "y'(1) = 2"}), "x^2");
  EXPECT_EQ(y("x^2*y'' - 2*y = 0", {"y(0) = 1", "y'(0) = 2"}), "the solutions have no value at 0");
  EXPECT_EQ(y("y'' + y = 0", {"y(0) = 0", "y(pi) = 0"}), "more than one solution has these values");
  EXPECT_EQ(y("y'' + y = 0", {"y(0) = 1", "y(0) = 2"}),
            "no solution has these values: they contradict each other");
  EXPECT_EQ(y("y'' + y = 0", {"y(0) = 0"}), "two values are needed for one function");
}

TEST(General, WithoutTheUnknown) {
  EXPECT_EQ(answered("y'' + cos(x)*y' = 0", {}).general.value_or("none"),
            "c1 + c2*int(exp(-sin(x)), x)");
  EXPECT_EQ(answered("y'' + sqrt(2)*cos(sqrt(2)*x)*y' = 0", {}).general.value_or("none"),
            "c1 + c2*int(exp(-sin(sqrt(2)*x)), x)");
  EXPECT_EQ(answered("y'' + tan(x)*y' = 0", {}).general.value_or("none"), "c1 + c2*sin(x)");
}

TEST(FirstOrder, WhatTextbooksAsk) {
  const auto general = [](const std::string& ode) {
    const WholeAnswer a = answered(ode, {});
    EXPECT_TRUE(a.failed.empty()) << ode;
    return a.general.value_or("none");
  };
  EXPECT_EQ(general("y' = x*y"), "c*exp(x^2/2)");
  EXPECT_EQ(general("y' + 2*y = x"), "c*exp(-2*x) + (2*x - 1)/4");
  EXPECT_EQ(general("x*y' = y + x^2"), "c*x + x^2");
  EXPECT_EQ(general("y' = a*y"), "c*exp(a*x)");
  EXPECT_EQ(general("y' + tan(x)*y = cos(x)"), "c*cos(x) + x*cos(x)");
  EXPECT_EQ(general("y' = 2*x"), "c + x^2");
  EXPECT_EQ(general("y' + y = exp(-x^2)"), "c*exp(-x) + exp(-x)*int(exp(-x^2 + x), x)");
}

TEST(FirstOrder, HasOneValue) {
  EXPECT_EQ(answered("y' = -y", {"y(0) = 3"}).with_values.value_or("none"), "3*exp(-x)");
  EXPECT_EQ(answered("x*y' = y + x^2", {"y(1) = a"}).with_values.value_or("none"),
            "x^2 + (a - 1)*x");
  EXPECT_EQ(answered("y' = -y", {"y(0) = 1", "y'(0) = 0"}).no_values,
            "one value is needed for one function");
  EXPECT_EQ(answered("x*y' = -y", {"y(0) = 1"}).no_values, "the solutions have no value at 0");
}

// y' - f' = b (y - f): some solution, which `whole_answer` has put into the equation.
TEST(FirstOrder, OfRandomEquationsWithAKnownSolution) {
  random_rounds(20, [](Random& random) {
    static const std::vector<std::string> rates{"1/x", "x", "cos(x)", "tan(x)", "exp(x)",
                                                "x^2", "3", "a",      "a/x"};
    const std::string b = number(random) + "*" + random.one_of(rates);
    const Element f = element(parse_expression(some_function(random), "f"), letters());
    const std::string ode =
        "y' = " + b + "*y + " + text(derivative(f)) + " - (" + b + ")*(" + text(f) + ")";
    const WholeAnswer found = answered(ode, {"y(1) = 2"});
    EXPECT_TRUE(found.failed.empty() && found.general && found.with_values)
        << ode << ": " << found.no_values;
  });
}

TEST(Bernoulli, IsALinearEquationForAPower) {
  const auto asked = [](const std::string& ode, const std::string& linear, const Rational& exponent,
                        const std::vector<std::string>& conditions = {}) {
    WholeEquation e{equation(ode), "y", "x"};
    e.bernoulli = {equation(linear), "v", exponent};
    for (const std::string& c : conditions)
      e.conditions.push_back(equation(c));
    return whole_answer(e, [](const LettersPtr&) { return std::optional<Basis>(); });
  };
  const WholeAnswer logistic =
      asked("y' = y - y^3", "v' + 2*v = 2", Rational(-1, 2), {"y(0) = -1/2"});
  EXPECT_EQ(logistic.general.value_or("none"), "1/sqrt(c*exp(-2*x) + 1)");
  EXPECT_EQ(logistic.special, (std::vector<std::string>{"-1/sqrt(c*exp(-2*x) + 1)", "0"}));
  EXPECT_EQ(logistic.with_values.value_or("none"), "-1/sqrt(3*exp(-2*x) + 1)");
  EXPECT_EQ(
      asked("y*y' = x", "v' = 2*x", Rational(1, 2), {"y(0) = 1"}).with_values.value_or("none"),
      "sqrt(x^2 + 1)");
  EXPECT_EQ(asked("y' = y - y^3", "v' + 2*v = 2", Rational(-1, 2), {"y(0) = 0"}).with_values, "0");
  EXPECT_EQ(asked("y' = y - y^2", "v' + v = 1", -1).special,
            std::vector<std::string>{"0"}); // one root
  EXPECT_EQ(asked("y' = a*y - y^3", "v' + 2*a*v = 2", Rational(-1, 2)).nonzero,
            std::vector<std::string>{"a"});
}

// Where a formula divides by parameters it says so.
TEST(FirstOrder, NamesTheParametersThatItDividesBy) {
  const auto nonzero = [](const std::string& ode) { return answered(ode, {}).nonzero; };
  EXPECT_EQ(nonzero("y' + a*y = b"), std::vector<std::string>{"a"});
  EXPECT_EQ(nonzero("(a - b)*y' = y"), std::vector<std::string>{"a - b"});
  EXPECT_TRUE(nonzero("y' + a*y = 0").empty());
}

TEST(InitialValues, OfOtherFunctions) {
  EXPECT_EQ(answered("y'' = x*y", {"y(0) = 1", "y'(0) = 0"}).no_values,
            "c1 and c2 were not computed: the solutions are not elementary functions");
}

TEST(InitialValues, IntegralsStartThere) {
  const WholeAnswer a = answered("y'' + y = exp(-x^2)", {"y(1) = 0", "y'(1) = 1"});
  ASSERT_TRUE(a.with_values && a.failed.empty());
  EXPECT_NE(a.with_values->find("int("), std::string::npos);
  EXPECT_EQ(a.integrals, "each integral starts at x = 1");
  EXPECT_FALSE(answered("y'' + y = exp(-x^2)", {"y(1) = 0", "y(2) = 1"}).with_values);
  EXPECT_FALSE(answered("y'' + y = 1/x", {"y(0) = 0", "y'(0) = 1"}).with_values); // no value there
}

// The function, put into the equation and at the points, which `whole_answer` has done: there is one.
TEST(InitialValues, OfRandomEquations) {
  random_rounds(20, [](Random& random) {
    const std::string left = homogeneous(random), at = std::to_string(random.between(1, 2));
    const std::string ode = left + " = " + (random.once_in(2) ? "0" : some_function(random));
    const WholeAnswer a =
        answered(ode, {"y(" + at + ") = " + number(random), "y'(" + at + ") = " + number(random)});
    EXPECT_TRUE(a.failed.empty() &&
                (a.with_values || a.no_values.find("an integral") != std::string::npos))
        << ode << ": " << a.no_values << (a.failed.empty() ? "" : a.failed.front());
  });
}

WholeAnswer riccati(const std::string& ode, const std::string& a, const std::string& linear,
                    const std::vector<std::string>& conditions = {}) {
  WholeEquation e{equation(ode), "y", "x"};
  e.riccati = {parse_expression(a, "a"), equation(linear), "u"};
  for (const std::string& c : conditions)
    e.conditions.push_back(equation(c));
  return whole_answer(e, [](const LettersPtr&) { return std::optional<Basis>(); });
}

TEST(Riccati, InItsOwnUnknown) {
  EXPECT_EQ(*riccati("y' = y^2 + 1", "1", "u'' + u = 0").general, "tan(x + c)");
  EXPECT_EQ(*riccati("y' = y^2 + 1", "1", "u'' + u = 0", {"y(0) = 0"}).with_values, "tan(x)");
  EXPECT_EQ(*riccati("y' = 1 - y^2", "-1", "u'' - u = 0", {"y(0) = 1"}).with_values, "1");
  EXPECT_EQ(riccati("y' = 1 - y^2", "-1", "u'' - u = 0").special,
            (std::vector<std::string>{"1", "-1"}));
}

// (y - f)' = a (y - f)^2 + b (y - f) has the solution f.
TEST(Riccati, OfRandomEquationsWithAKnownSolution) {
  random_rounds(12, [](Random& random) {
    const std::string a = number(random), b = number(random), c = number(random);
    const std::string ode = "y' = " + a + "*y^2 + " + b + "*y + " + c,
                      linear = "u'' - " + b + "*u' + " + a + "*" + c + "*u = 0";
    const WholeAnswer found = riccati(ode, a, linear, {"y(0) = " + number(random)});
    EXPECT_TRUE(found.failed.empty() && found.general && found.with_values)
        << ode << ": " << found.no_values;
  });
}

} // namespace
} // namespace kov::elementary
