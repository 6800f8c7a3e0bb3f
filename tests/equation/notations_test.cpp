// An equation with parameters is the same equation in the notation of every other program: their
// derivatives and whole calls of their solvers, with letters for the function, the variable and the
// parameters that are drawn anew in each round.

#include "equation/linear_form.hpp"
#include "equation/parametric_equation.hpp"
#include "support/random.hpp"
#include "symbol/notations.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using test::Random;
using test::random_rounds;

struct Letters {
  std::string y, x, a, b;
};

Letters some_letters(Random& random) {
  std::vector<std::string> all{"a", "b", "c", "m", "n", "k", "r",  "t",   "u",
                               "w", "y", "f", "q", "s", "x", "nu", "psi", "E2"};
  const auto draw = [&] {
    const std::string letter = random.one_of(all);
    std::erase(all, letter);
    return letter;
  };
  return {draw(), draw(), draw(), draw()};
}

/// How a program writes the derivatives of order 0, 1, 2, and an equation.
struct Notation {
  std::vector<std::vector<std::string>> derivatives; // each a way: {y, y', y''} with Y and X
  std::vector<std::string> equations;                // with L and R for the sides
  std::vector<std::string> calls;                    // of its solver, with T for the equation
  std::string half;
};

const std::vector<Notation>& notations() {
  static const std::vector<Notation> all{
      {{{"Y", "Y'", "Y''"}, {"Y(X)", "Y'(X)", "Y''(X)"}}, {"L = R"}, {"T"}, "1/2"},
      {{{"Y(X)", "diff(Y(X), X)", "diff(Y(X), X$2)"},
        {"Y(X)", "diff(Y(X),X)", "diff(diff(Y(X), X), X)"},
        {"diff(Y(X), [X $ 0])", "diff(Y(X), [X $ 1])", "diff(Y(X), [X $ 2])"},
        {"Y(X)", "D(Y)(X)", "(D@@2)(Y)(X)"}},
       {"L = R", "L - (R) = 0"},
       {"T", "T;", "dsolve(T, Y(X));", "dsolve({T}, Y(X))", "DEtools[kovacicsols](T, Y(X))",
        "kovacicsols(T, Y(X))"},
       "1/2"},
      {{{"Y", "'diff(Y, X)", "'diff(Y, X, 2)"}, {"Y", "'diff(Y,X,1)", "'diff('diff(Y,X),X)"}},
       {"L = R"},
       {"T", "T$", "ode2(T, Y, X);", "contrib_ode(T, Y, X)"},
       "1/2"},
      {{{"Y(X)", "diff(Y(X), X)", "diff(Y(X), X, 2)"},
        {"Y", "diff(Y, X)", "diff(Y, X, 2)"},
        {"Y", "derivative(Y, X)", "derivative(Y, X, X)"}},
       {"L == R", "L - (R)"},
       {"T", "desolve(T, Y)", "desolve(T, [Y, X])", "desolve(T, Y, ivar=X)"},
       "1/2"},
      {{{"Y(X)", "Derivative(Y(X), X)", "Derivative(Y(X), (X, 2))"},
        {"Y(X)", "Y(X).diff(X)", "Y(X).diff(X, 2)"},
        {"Y(X)", "diff(Y(X), X)", "Y(X).diff(X).diff(X)"}},
       {"Eq(L, R)", "L - (R)"},
       {"T", "dsolve(T, Y(X))", "dsolve(T)"},
       "S(1)/2"},
      {{{"Y[X]", "Y'[X]", "Y''[X]"},
        {"Y[X]", "D[Y[X], X]", "D[Y[X], {X, 2}]"},
        {"Y[X]", "Derivative[1][Y][X]", "Derivative[2][Y][X]"}},
       {"L == R"},
       {"T", "DSolve[T, Y[X], X]", "DSolve[T, Y, X]", "DSolve[{T}, Y[X], X]"},
       "1/2"}};
  return all;
}

std::string filled(std::string pattern, const std::vector<std::pair<char, std::string>>& words) {
  std::string text;
  for (const char c : pattern) {
    const auto word =
        std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.first == c; });
    text += word == words.end() ? std::string(1, c) : word->second;
  }
  return text;
}

/// Random coefficients of y, y', y'' on both sides; H is one half.
struct Coefficients {
  std::vector<std::string> left, right;
};

Coefficients some_coefficients(Random& random) {
  const auto one = [&] {
    return random.one_of<std::string>({"A", "B*X", "(A + H)*X", "(X^2 - B^2)", "3*A/X",
                                       "(X - A)/(X + 2)", "-H", "(A*B + X)^2", "2*I*A"});
  };
  return {{one(), one(), "(X^2 + A*X + 1)"},
          {one(), random.once_in(2) ? one() : "0", random.once_in(2) ? one() : "0"}};
}

std::string side(const std::vector<std::string>& coefficients, const std::vector<std::string>& y) {
  std::string sum;
  for (std::size_t i = 0; i < y.size(); ++i)
    sum += (sum.empty() ? "" : " + ") + ("(" + coefficients[i] + ")*" + y[i]);
  return sum;
}

std::string written(const Notation& n, const Coefficients& c, const Letters& l, Random& random) {
  const std::vector<std::string>& y = random.one_of(n.derivatives);
  std::string equation =
      filled(random.one_of(n.equations), {{'L', side(c.left, y)}, {'R', side(c.right, y)}});
  const std::string call = random.one_of(n.calls);
  equation = filled(call, {{'T', equation}});
  std::string text;
  for (std::size_t i = 0; i < equation.size(); ++i) { // D, S, I and Eq are words of the notation
    const bool alone = (i == 0 || std::isalpha(static_cast<unsigned char>(equation[i - 1])) == 0) &&
                       (i + 1 == equation.size() ||
                        std::isalpha(static_cast<unsigned char>(equation[i + 1])) == 0);
    const std::string letter(1, equation[i]);
    text += alone ? filled(letter, {{'Y', l.y}, {'X', l.x}, {'A', l.a}, {'B', l.b}, {'H', n.half}})
                  : letter;
  }
  return text;
}

EquationText text_of(const std::string& ode, const Letters& l) {
  EquationText text;
  text.ode = parse_ode(ode, "-e");
  text.parameters = {l.a, l.b};
  return text;
}

std::string with_parameters(const std::string& ode, const Letters& l) {
  EquationText text = text_of(ode, l);
  if (ode_names(*text.ode).variable.empty()) text.variable = l.x;
  return to_string(read_parametric_equation(text).question.r);
}

std::string with_values(const std::string& ode, const Letters& l) {
  EquationText text = text_of(ode, l);
  if (ode_names(*text.ode).variable.empty()) text.variable = l.x;
  text.set = {{l.a, parse_expression("2/3", "a")}, {l.b, parse_expression("-5", "b")}};
  return to_string(read_equation(text).normal_form.r, l.x);
}

TEST(NotationsOfEquations, GiveOneEquationWithParametersAndWithout) {
  random_rounds(200, [](Random& random) {
    const Letters letters = some_letters(random);
    const Coefficients c = some_coefficients(random);
    const std::string ours = written(notations().front(), c, letters, random);
    SCOPED_TRACE(ours);
    const std::string general = with_parameters(ours, letters),
                      special = with_values(ours, letters);
    for (const Notation& n : notations()) {
      const std::string theirs = written(n, c, letters, random);
      SCOPED_TRACE(theirs);
      EXPECT_EQ(with_parameters(theirs, letters), general);
      EXPECT_EQ(with_values(theirs, letters), special);
    }
  });
}

std::string complaint(const std::string& ode, const std::vector<std::string>& parameters) {
  EquationText text;
  text.ode = parse_ode(ode, "-e");
  text.parameters = parameters;
  try {
    return to_string(read_parametric_equation(text).question.r);
  } catch (const InputError& e) {
    return e.message() + " / " + e.hint();
  }
}

// What is wrong is said with parameters as it is without.
TEST(NotationsOfEquations, MistakesHaveNamesAlsoWithParameters) {
  for (const auto& [ode, says] : std::vector<std::pair<std::string, std::string>>{
           {"diff(y(x), x, 2) = a*y(2*x)", "is a function of x"},
           {"y''(2) = a*y(x)", "is a function of x"},
           {"diff(y(x), x, a) = y(x)", "order of a derivative"},
           {"diff(y(x), x) = a*y(x)", "the coefficient of y'' is zero"},
           {"diff(y(x), x, 3) = a*y(x)", "order 3"},
           {"diff(y(x), x, 2) = a", "not homogeneous: the term -a has no y"},
           {"diff(y(x), x, 2)*y(x) = a", "not linear in y"},
           {"diff(y(x), x, 2) = a*b*y(x)", "--parameter b"},
           {"y'' = a*nu*y/x^2", "--parameter nu"},
           {"y'' = a*b*c*y", "--parameter NAME"},
           {"dsolve({diff(y(x), x, 2) = a*y(x), y(0) = 1}, y(x))", "initial values"}})
    try {
      EXPECT_NE(complaint(ode, {"a"}).find(says), std::string::npos)
          << ode << ": " << complaint(ode, {"a"});
    } catch (const InputError& e) {
      EXPECT_NE(e.message().find(says), std::string::npos) << ode << ": " << e.message();
    }
}

// y''/y = r, also with more terms and a factor below.
TEST(NotationsOfEquations, QuotientsByTheUnknownAreLinear) {
  const Letters l{"y", "x", "a", "b"};
  const auto r = [&](const std::string& ode) { return with_parameters(ode, l); };
  EXPECT_EQ(r("y''/y = a*x"), r("y'' = a*x*y"));
  EXPECT_EQ(r("-b*y''/(2*y) + x^2 = a"), r("-b*y''/2 + x^2*y = a*y"));
  EXPECT_EQ(r("x*y''/(a*y) + y'/y + b*y/y = 0"), r("x*y'' + a*y' + a*b*y = 0"));
  EXPECT_EQ(r("(y'' - b*y)/y = a/x"), r("y'' = (a/x + b)*y"));
  for (const char* wrong : {"y''/y = y", "y''/y' = a", "y''/(y + 1) = a", "(y''/y)' = a",
                            "(y'' + a)/y = x", "y''/y + y = a"})
    EXPECT_THROW(static_cast<void>(r(wrong)), InputError) << wrong;
}

} // namespace
} // namespace kov
