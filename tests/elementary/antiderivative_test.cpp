// Integrals of elementary functions: those with a known answer, and that what has none gets none.

#include "elementary/antiderivative.hpp"
#include "elementary/check.hpp"
#include "elementary/rational_integral.hpp"
#include "elementary/read.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

namespace kov::elementary {
namespace {

using test::Random;
using test::random_rounds;

LettersPtr letters() { return std::make_shared<Letters>("x", std::vector<std::string>{"a", "n"}); }

std::string integrated(const std::string& f) {
  const auto y = antiderivative(element(parse_expression(f, "f"), letters()));
  return y ? text(*y) : "none";
}

TEST(Antiderivative, OfRationalFunctions) {
  EXPECT_EQ(integrated("1/(x^2 + 1)"), "atan(x)");
  EXPECT_EQ(integrated("1/(x^2 - 1)"), "log((x - 1)/(x + 1))/2");
  EXPECT_EQ(integrated("x/(x^4 + 1)"), "atan(x^2)/2");
  EXPECT_NE(integrated("1/(x^4 + 1)"), "none");
  EXPECT_NE(integrated("1/(x^3 - 1)"), "none");
  EXPECT_NE(integrated("1/(x^2 - a)"), "none");
  EXPECT_NE(integrated("1/(x^2 - 2)"), "none");
  EXPECT_NE(integrated("(x^5 + a)/(x^2*(x - a)^3*(x^2 + x + 1)^2)"), "none");
  EXPECT_EQ(integrated("1/(x^5 + x + 3)"), "none");
}

TEST(Antiderivative, OfPowersExponentialsSinesAndLogarithms) {
  EXPECT_EQ(integrated("x*exp(a*x)"), "(a*x - 1)*exp(a*x)/a^2");
  EXPECT_EQ(integrated("x^n"), "x^(n + 1)/(n + 1)");
  EXPECT_EQ(integrated("log(x)"), "x*log(x) - x");
  EXPECT_EQ(integrated("log(x)/x"), "log(x)^2/2");
  EXPECT_EQ(integrated("sin(x)^2"), "x/2 - sin(2*x)/4");
  EXPECT_EQ(integrated("atan(x)"), "x*atan(x) - log(x^2 + 1)/2");
  for (const char* f :
       {"x^3*exp(-x)*cos(2*x)", "x^2*log(x)^2", "sqrt(x)*log(x)", "log(x + 1)*x",
        "log(x)/(x + 1)^2", "exp(a*x)*sin(n*x)", "cos(log(x))", "exp(x)*(1/x - 1/x^2)", "x*atan(x)",
        "x*cosh(x)", "sin(x)*sin(2*x)*cos(3*x)", "x/sqrt(x^2 + 1)", "x^n*log(x)", "x*exp(-x^2)"})
    EXPECT_NE(integrated(f), "none") << f;
  for (const char* f :
       {"exp(x^2)", "exp(x)/x", "sin(x)/x", "log(x)/(x + 1)", "exp(-x^2)*cos(x)", "cos(x^2)"})
    EXPECT_EQ(integrated(f), "none") << f;
}

TEST(Antiderivative, OfRationalFunctionsOfSineCosineExponentialAndLogarithm) {
  for (const char* f :
       {"tan(x)", "1/cos(x)", "1/sin(x)", "tan(x)^2", "1/cos(x)^3", "1/(2 + cos(x))",
        "sin(x)^2/cos(x)", "1/(1 + cos(a*x))", "cot(x)", "sin(x)/(1 + cos(x)^2)", "1/(1 + exp(x))",
        "exp(x)/(1 + exp(2*x))", "1/cosh(x)", "tanh(x)", "1/(x*log(x))", "1/(x*(1 + log(x)^2))",
        "tan(x) + x*exp(x) + 1/x"})
    EXPECT_NE(integrated(f), "none") << f;
  for (const char* f : {"x*tan(x)", "1/log(x)", "x/(1 + exp(x))"})
    EXPECT_EQ(integrated(f), "none") << f;
  EXPECT_EQ(integrated("1/cos(x)^2"), "tan(x)");
  EXPECT_EQ(integrated("tan(x)"), "-log(cos(x))");
  EXPECT_EQ(integrated("tan(x)^2"), "tan(x) - x");
}

TEST(Antiderivative, OfRationalFunctionsTimesARootOfAQuadratic) {
  for (const char* f :
       {"1/sqrt(x^2 + 1)", "1/sqrt(1 - x^2)", "1/(sqrt(x - 1)*sqrt(x))", "sqrt(x^2 + 1)",
        "sqrt(1 - x^2)", "1/(x*sqrt(x^2 + 1))", "x/sqrt(1 - x)", "1/sqrt(2 - x^2)",
        "sqrt(x)/(x + 1)", "1/sqrt(x^2 + a^2)", "sqrt(x^2 + x)/x", "1/sqrt(2*x^2 + x + 3)",
        "x^2/sqrt(3 + x - x^2)", "1/sqrt(x^2 + 1) + exp(x)", "1/((x - 2)^2*sqrt(x + 1))"})
    EXPECT_NE(integrated(f), "none") << f;
  for (const char* f : {"1/sqrt(x^3 + 1)", "1/sqrt(x^4 + x + 1)", "exp(x)/sqrt(x^2 + 1)"})
    EXPECT_EQ(integrated(f), "none") << f;
  EXPECT_EQ(integrated("1/sqrt(x^2 + 1)"), "log(sqrt(x^2 + 1) + x)");
}

std::string small(Random& random) { return std::to_string(random.between(1, 4)); }

// A sum of two products of what is differentiated below.
std::string some_function(Random& random, const std::vector<std::string>& atoms) {
  std::string sum;
  for (long i = 0; i < 2; ++i) {
    sum += (i > 0 ? (random.once_in(2) ? " + " : " - ") : "") + small(random);
    sum += "*x^" + std::to_string(random.between(0, 3)) + "*" + random.one_of(atoms);
  }
  return sum;
}

TEST(Antiderivative, ADerivativeIsIntegrated) {
  const std::vector<std::string> atoms{"exp(2*x)", "exp(-x)*cos(x)", "sin(3*x)",  "log(x)",
                                       "log(x)^2", "cos(x)^3",       "sqrt(x)",   "exp(a*x)",
                                       "x^n",      "atan(x)",        "1/(x + 2)", "1/(x^2 + 2)",
                                       "1"};
  random_rounds(25, [&](Random& random) {
    const std::string given = some_function(random, atoms);
    const Element f = derivative(element(parse_expression(given, "f"), letters()));
    const auto y = antiderivative(f);
    ASSERT_TRUE(y) << given << ": " << text(f);
    EXPECT_TRUE(is_derivative_at_points(*y, f)) << given;
  });
}

TEST(Antiderivative, OfRandomRationalFunctionsOfSineAndCosine) {
  random_rounds(20, [](Random& random) {
    const std::string c = "cos(x)", s = "sin(x)";
    const std::string f =
        "(" + small(random) + "*" + c + " - " + small(random) + "*" + s + " + " + small(random) +
        ")*" + random.one_of(std::vector<std::string>{c, s, "1"}) + "/" +
        random.one_of(std::vector<std::string>{c + "^2", s, "(3 + " + c + ")", "(2 - " + s + "^2)",
                                               "(" + c + "*(1 + " + s + "))"});
    EXPECT_NE(integrated(f), "none") << f;
  });
}

} // namespace
} // namespace kov::elementary
