// Formulas as people type and paste them: what is understood, in our own notation, and what is asked back.

#include "support/random.hpp"
#include "symbol/notations.hpp"
#include "symbol/pasted.hpp"
#include "symbol/tokens.hpp"
#include "symbol/written.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using test::Random;
using test::random_rounds;
using testing::HasSubstr;
using testing::IsEmpty;

struct Family {
  const char* name;
  std::string ours;
  std::vector<std::string> theirs;
};

// What was understood is what the strict reader reads in the text that is shown.
std::string equation(const std::string& text, const PastedNames& names = {}) {
  const Pasted p = pasted_equation(text, "-e", names);
  EXPECT_EQ(written(p.formula), written(parse_ode(p.text(), "-e"))) << text;
  return written(p.formula);
}

std::string formula(const std::string& text) {
  const Pasted p = pasted_formula(text, "-r");
  EXPECT_EQ(written(p.formula), written(parse_expression(p.text(), "-r"))) << text;
  return written(p.formula);
}

std::string asked_back(const std::string& text) {
  try {
    return "understood: " + equation(text);
  } catch (const InputError& e) {
    return e.message() + " / " + e.hint();
  }
}

void same(const Family& f, std::string (*read)(const std::string&)) {
  SCOPED_TRACE(f.name);
  for (const std::string& text : f.theirs)
    EXPECT_EQ(read(text), f.ours) << text;
}
std::string read_equation(const std::string& text) { return equation(text); }

TEST(Pasted, ProductsWithoutASign) {
  same({"names", "y'' = x*y", {"y'' = x y", "y''=x  y", "y'' = x\ty"}}, read_equation);
  same({"numbers", "y'' + 3*y' + 2*y = 0", {"y''+3y'+2y=0", "y'' + 3 y' + 2y = 0"}}, read_equation);
  same({"groups",
        "(1 - x^2)*y'' - 2*x*y' + 6*y = 0",
        {"(1-x^2)y''-2x y'+6y=0", "(1 - x^2) y'' - 2x y' + 6 y = 0"}},
       read_equation);
  same({"between groups", "(x + 1)*(x - 1)*y'' + y = 0", {"(x+1)(x-1)y''+y=0"}}, read_equation);
  same({"behind a power",
        "x^2*y'' + x*y' + (x^2 - 1/4)*y = 0",
        {"x^2 y''+x y'+(x^2-1/4)y=0", "x^2y'' + x y' + (x^2 - 1/4) y = 0"}},
       read_equation);
  same({"a blank before a group", "x*(1 - x)*y'' = y", {"x (1-x) y'' = y"}}, read_equation);
  same({"a quotient before the unknown", "y'' + 1/x*y' = 0", {"y'' + 1/x y' = 0", "y''+1/x*y'=0"}},
       read_equation);
  same({"a number below and a blank", "y'' = 1/4*x*y", {"y'' = 1/4 x y"}}, read_equation);
  same({"calls", "sin(x)*y(x)", {"sin(x) y(x)", "sin(x)y(x)"}},
       [](const std::string& text) { return equation(text + " = y'(x)").substr(0, 11); });
  EXPECT_EQ(formula("2m x + 3k"), "2*m*x + 3*k");
  EXPECT_EQ(formula("p^2/(2m) + k q^2/2"), "p^2/(2*m) + k*q^2/2");
}

TEST(Pasted, WhatCouldMeanTwoThingsIsAskedBack) {
  for (const auto& [text, both] : std::vector<std::pair<const char*, std::vector<const char*>>>{
           {"y'' = a(b+c)*y", {"product or a function", "a*(b + c)"}},
           {"y'' = x(t)*y", {"product or a function"}},
           {"a(1-b)y'' = y", {"a*(1 - b)"}},
           {"y'' = f (x)*y", {"product or a function"}},
           {"y'' = 1/2x*y", {"1/(2*x)", "(1/2)*x"}},
           {"y'' = a/b c y", {"a/(b*c)", "(a/b)*c"}},
           {"y'' + y/2x = 0", {"y/(2*x)", "(y/2)*x"}},
           {"y'' = x^2a*y", {"^2*a", "^(2*a)"}},
           {"y'' = (x+1)2 y", {"exponent"}},
           {"y'' = x 2 y", {"exponent"}},
           {"y'' = 3 4 y", {"two numbers"}},
           {"y'' = e^2x*y", {"exp(2*x)", "exp(2)*x"}},
           {"y'' = sin x cos x*y", {"argument of sin", "argument of cos"}},
           {"y'' = sin^-1(x)*y", {"inverse"}},
           {"x^{2}y'' = x^12*y", {"two digits"}}})
    for (const char* one : both)
      EXPECT_THAT(asked_back(text),
                  testing::AllOf(HasSubstr(one), testing::Not(HasSubstr("understood"))))
          << text;
}

// A call stays one: y (x), y' (x) and sin (x) with a blank.
TEST(Pasted, CallsOfTheUnknownAndOfFunctionsAreNoProducts) {
  EXPECT_EQ(equation("x(1-x)y'' = y"), "x*(1 - x)*y'' = y"); // x stands by itself
  EXPECT_EQ(equation("y' = y(1-y)"), "y' = y*(1 - y)");
  EXPECT_EQ(equation("y''(x) = sin (x) y (x)"), "y''(x) = sin(x)*y(x)");
  EXPECT_EQ(equation("u'' (t) + u (t) = 0"), "u''(t) + u(t) = 0");
  EXPECT_EQ(equation("y'' (1-x) = y"), "y''*(1 - x) = y");
}

TEST(Pasted, AllErrorsAtOnce) {
  const std::string all = asked_back("y'' = a(b+c)*y + 1/2x*y + #3");
  EXPECT_THAT(all, HasSubstr("'#'"));
  const std::string two = asked_back("y'' = a(b+c)*y + 1/2x*y + f(x)*y");
  for (const char* one : {"is a(b + c)", "column 20", "does x stand", "is f(x)"})
    EXPECT_THAT(two, HasSubstr(one));
}

TEST(Pasted, NumbersAreExact) {
  EXPECT_EQ(equation("y''+0.25*y=0"), "y'' + 1/4*y = 0");
  EXPECT_EQ(equation("y'' + .5y = 0"), "y'' + 1/2*y = 0");
  EXPECT_EQ(equation("y'' = 2.50e-3 x y"), "y'' = 1/400*x*y");
  EXPECT_EQ(equation("y'' = 1e3 x y"), "y'' = 1000*x*y");
  EXPECT_EQ(equation("y'' = x^0.5*y"), "y'' = x^(1/2)*y");
  EXPECT_EQ(equation("y'' = x*y/2.5"), "y'' = x*y/(5/2)");
  EXPECT_EQ(equation("y'' = -y."), "y'' = -y");
  EXPECT_EQ(equation("y'' = root(x^3 - 2, 1.26)*y"), "y'' = root(x^3 - 2, 1.26)*y");
  EXPECT_EQ(equation("y'' = 0.3333333333333 y").find("1/3"), std::string::npos);
  EXPECT_THAT(sentences(pasted_equation("y'' = 0.25*y", "-e").notes),
              testing::ElementsAre(HasSubstr("0.25 = 1/4")));
}

TEST(Pasted, CharactersOfUnicode) {
  same({"primes", "y'' + y' - y = 0", {"y″ + y′ − y = 0", "y’’ + y’ – y = 0", "y\" + y' - y = 0"}},
       read_equation);
  same({"powers and products",
        "(1 - x^2)*y'' - 2*x*y' = 0",
        {"(1-x²)y″ − 2x·y′ = 0", "(1 − x²)×y″ − 2⋅x y′ = 0"}},
       read_equation);
  same({"Greek", "y'' + omega_0^2*y = lambda*y", {"y″ + ω_0² y = λ y", "y'' + ω_0^2 y = λy"}},
       read_equation);
  same({"dots", "x'' + 2*x' + t*x = 0", {"ẍ + 2ẋ + t x = 0", "x\u0308 + 2x\u0307 + t x = 0"}},
       read_equation);
  same({"exponents below", "y'' = x^(-2)*y", {"y″ = x⁻² y"}}, read_equation);
  same({"fractions and roots", "y'' = 1/2*sqrt(2)*y", {"y'' = ½ √2 y", "y'' = ½·√(2)·y"}},
       read_equation);
  same({"blanks", "y'' = x*y", {"y''\u00a0=\u2009x\u202fy"}}, read_equation);
  EXPECT_EQ(formula("2α β₁"), "2*alpha*beta1");
  for (const char* strange : {"y'' = ∞*y", "∂²y = y", "y'' = x → y", "y'' = \xff y"})
    EXPECT_THAT(asked_back(strange), HasSubstr("unexpected")) << strange;
}

TEST(Pasted, Latex) {
  same({"fractions of d",
        "diff(y, x, 2) = x*y",
        {R"(\frac{d^2y}{dx^2} = x y)", R"(\dfrac{d^{2}y}{dx^{2}} = x\,y)",
         R"(\frac{\mathrm{d}^2 y}{\mathrm{d}x^2} = x \cdot y)", R"($\frac{d^2 y}{d x^2} = x y$)",
         R"(\begin{equation} \frac{d^2y}{dx^2} = x\, y. \end{equation})"}},
       read_equation);
  same({"primes",
        "y'' = x^2*y",
        {R"(y^{\prime\prime} = x^{2} y)", R"(y'' = x^2 y)", R"(y^{(2)} = x^{2} y)"}},
       read_equation);
  same({"groups",
        "x^2*diff(y, x, 2) + x*diff(y, x) + (x^2 - 1/4)*y = 0",
        {R"(x^2\frac{d^2y}{dx^2}+x\frac{dy}{dx}+\left(x^2-\frac{1}{4}\right)y=0)",
         R"(x^{2} \frac{d^{2}y}{dx^{2}} + x \frac{dy}{dx} + \bigl(x^2 - \tfrac14\bigr) y = 0)"}},
       read_equation);
  same({"dots",
        "x'' + omega^2*x = 0",
        {R"(\ddot{x} + \omega^2 x = 0)", R"(\ddot x + \omega^{2} x = 0)"}},
       read_equation);
  same({"functions",
        "y'' = sin(x)^2*y",
        {R"(y'' = \sin^2(x) y)", R"(y'' = \left(\sin x\right)^2 y)"}},
       read_equation);
  EXPECT_EQ(equation(R"(y'' = \sqrt[3]{2}\, y)"), "y'' = 2^(1/3)*y");
  EXPECT_EQ(equation(R"(y'' = \operatorname{sech}(x) y)"), "y'' = sech(x)*y");
  EXPECT_EQ(equation(R"(\frac{d}{dx}\left[(1-x^2)\frac{dy}{dx}\right]+6y=0)"),
            "diff((1 - x^2)*diff(y, x), x) + 6*y = 0");
  for (const char* bad :
       {R"(\foo y'' = y)", R"(y'' = \frac{x)", R"(y'' = x_{a+b} y)", R"(y'' = \frac)"})
    EXPECT_THAT(asked_back(bad), testing::Not(HasSubstr("understood"))) << bad;
}

TEST(Pasted, QuotientsOfD) {
  same({"second order",
        "diff(y, x, 2) = x*y",
        {"d^2y/dx^2 = x*y", "d²y/dx² = x y", "d2y/dx2 = x y", "d^2 y/dx^2 = x y"}},
       read_equation);
  same({"of a group", "diff((1 - x^2)*diff(y, x), x) + 2*y = 0", {"d/dx((1-x^2) dy/dx) + 2 y = 0"}},
       read_equation);
  same({"with its argument", "diff(y(x), x, 2) = x*y(x)", {"d^2y(x)/dx^2 = x y(x)"}},
       read_equation);
  EXPECT_EQ(written(pasted_equation("d^2/dx^2 + x", "-e").formula), "Dx^2 + x");
  EXPECT_EQ(equation("y'' = d/dx*y", {{"d"}, ""}), "y'' = d/dx*y"); // d has a meaning
  EXPECT_EQ(equation("y'' = delta/dx*y"), "y'' = delta/dx*y");
  EXPECT_EQ(equation("d^2y/dx^3 = y'"), "d^2*y/dx^3 = y'"); // no derivative: the orders differ
}

TEST(Pasted, Functions) {
  same({"e",
        "y'' = exp(x)*y",
        {"y'' = e^x*y", "y'' = E^x y", "y'' = e^{x} y", "y''=e^(x) y", "y'' = exp(x) y"}},
       read_equation);
  EXPECT_EQ(equation("y'' = e^-x y"), "y'' = exp(-x)*y");
  EXPECT_EQ(equation("y'' = e^x*y", {{"e"}, ""}), "y'' = e^x*y");
  EXPECT_EQ(equation("y'' = e^2*y"), "y'' = e^2*y");
  EXPECT_EQ(equation("y''[x] + Sin[x] y[x] == 0"), "y''(x) + sin(x)*y(x) = 0");
  EXPECT_EQ(equation("y'' + sin 2x = 0"), "y'' + sin(2*x) = 0");
  EXPECT_EQ(equation("y'' - RootOf(_Z^2-2)*x*y = 0"), "y'' - sqrt(2)*x*y = 0");
  EXPECT_THAT(equation("y'' = RootOf(_Z^3-2) y"), HasSubstr("root(x^3 - 2, 1.25"));
  EXPECT_THAT(asked_back("y'' = RootOf(_Z^2-1)*y"), HasSubstr("reducible"));
  EXPECT_THAT(asked_back("y'' = RootOf(_Z^2-2, index=1)*y"), HasSubstr("which root"));
}

TEST(Pasted, Wrappers) {
  same({"assignments",
        "diff(y(x), x, 2) + y(x) = 0",
        {"ode := diff(y(x),x,x)+y(x)=0", "ode := diff(y(x),x,x)+y(x)=0;",
         "eq: diff(y(x),x,2)+y(x)=0$", "ode = Eq(diff(y(x),x,x)+y(x), 0)",
         "dsolve(diff(y(x),x,x)+y(x)=0,y(x))", "DSolve[D[y[x],{x,2}]+y[x]==0,y[x],x]",
         "dsolve({diff(y(x),x,x)+y(x)=0}, y(x))"}},
       read_equation);
  const Pasted list = pasted_equation("[-x, 0, 1]", "-e");
  EXPECT_EQ(written(list.formula), "-x*y + 0*y' + 1*y''");
  EXPECT_THAT(sentences(list.notes), testing::ElementsAre(HasSubstr("lowest derivative first")));
}

TEST(Pasted, ConditionsStandBesideTheEquation) {
  for (const char* text :
       {"y'' = x*y, y(0)=1, y'(0)=0", "y'' = x y; y(0) = 1; y'(0) = 0",
        "{y''==x*y, y(0)==1, y'(0)==0}", "dsolve({y'' = x*y, y(0)=1, D(y)(0)=0}, y(x))",
        "DSolve[{y''[x]==x y[x], y[0]==1, y'[0]==0}, y[x], x]"}) {
    const Pasted p = pasted_equation(text, "-e");
    EXPECT_EQ(p.conditions.size(), 2U) << text;
    EXPECT_FALSE(p.as_written);
  }
  for (const char* wrong :
       {"y'' = x*y, z'' = y", "y'' = x*y, y", "y''(x) = x*y(x), y'(x) = y(x)", "y'' = 1,5*y"})
    EXPECT_THAT(asked_back(wrong), HasSubstr("neither an equation")) << wrong;
}

// What the strict reader understands, the forgiving one understands alike, without a word.
TEST(Pasted, StrictTextsAreReadAsTheyStand) {
  for (const char* text :
       {"y'' = x*y", "z^2*y'' + z*y' + (z^2-1/4)*y = 0", "(p*y')' = q*y",
        "diff(y(x), x$2) = x*y(x)", "y''[x] == x*y[x]", "'diff(y, x, 2) = %i*y", "Dx^2 - x",
        "Eq(y(x).diff(x, 2), x*y(x))", "y''/y = a*x^-2", "y'' = -a^2*y/(2*x)",
        "y'' = sqrt(2)*root(x^3-2, 1.26)*y", "(D@@2)(y)(x) = x*y(x)"}) {
    const Pasted p = pasted_equation(text, "-e");
    EXPECT_TRUE(p.as_written) << text << " -> " << p.text();
    EXPECT_THAT(p.notes, IsEmpty());
    const Expression strict = parse_ode(text, "-e");
    if (std::string(text) != "Dx^2 - x") {
      EXPECT_EQ(written(p.formula), written(strict));
    }
  }
}

// Tokens of translated notations are views of texts that lie beside them: a list that is copied, as a
// growing vector once did, speaks of texts that are gone.
static_assert(!std::is_copy_constructible_v<TokenList>);
TEST(Pasted, AnOrderIsReadBesideConditions) {
  EXPECT_EQ(
      written(pasted_equation("dsolve({diff(y(x), x$2) = x*y(x), y(0) = 1}, y(x))", "-e").formula),
      written(
          pasted_equation("dsolve({diff(y(x), x, x) = x*y(x), y(0) = 1}, y(x))", "-e").formula));
}

// A random formula loses its signs where the rules say so, and comes back.
std::string random_formula(Random& random, int depth) {
  if (depth == 0)
    return random.one_of<std::string>({"x", "a", "b", "2", "3", "x^2", "a^3", "sin(x)"});
  const std::string f = random_formula(random, depth - 1), g = random_formula(random, depth - 1);
  switch (random.between(0, 3)) {
  case 0:
    return "(" + f + " + " + g + ")";
  case 1:
    return "(" + f + " - " + g + ")^2";
  case 2:
    return "(" + f + ")/(" + g + ")";
  default:
    return f + "*" + g;
  }
}

TEST(Pasted, SignsThatAreLeftOutComeBack) {
  random_rounds(300, [](Random& random) {
    const std::string ours = random_formula(random, 3);
    std::string theirs;
    for (const char c : ours)
      theirs += c == '*' && random.once_in(2) ? ' ' : c;
    SCOPED_TRACE(theirs);
    try {
      EXPECT_EQ(written(pasted_formula(theirs, "-r").formula),
                written(parse_expression(ours, "-r")));
    } catch (const InputError& e) { // asked back: a number behind a factor, a factor behind a line
      EXPECT_THAT(e.message(), testing::AnyOf(HasSubstr("number"), HasSubstr("below the line"),
                                              HasSubstr("product or a function")));
    }
  });
}

} // namespace
} // namespace kov
