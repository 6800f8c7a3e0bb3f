#include "equation/equation_file.hpp"
#include "equation/linear_form.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

std::optional<Expression> formula(const std::string& text, const char* name,
                                  bool equation = false) {
  if (text.empty()) return std::nullopt;
  return parse_expression(text, name, equation);
}

struct Given {
  std::string r, p, q, ode, minpoly, variable;
  std::vector<std::pair<std::string, std::string>> set;
  std::vector<std::string> parameters;
};

GivenEquation read(const Given& g, const Budget& budget = {}) {
  EquationText text;
  text.r = formula(g.r, "r");
  text.p = formula(g.p, "p");
  text.q = formula(g.q, "q");
  text.ode = formula(g.ode, "ode", true);
  text.minpoly = formula(g.minpoly, "minpoly");
  text.variable = g.variable;
  text.parameters = g.parameters;
  for (const auto& [name, value] : g.set)
    text.set.emplace_back(name, parse_expression(value, "--set"));
  return read_equation(text, budget);
}

Given ode(const std::string& text) {
  return {.r{}, .p{}, .q{}, .ode = text, .minpoly{}, .variable{}, .set{}, .parameters{}};
}
Given only_r(const std::string& text) {
  return {.r = text, .p{}, .q{}, .ode{}, .minpoly{}, .variable{}, .set{}, .parameters{}};
}

std::string r_of(const Given& g) {
  const GivenEquation e = read(g);
  return to_string(e.normal_form.r, e.variable);
}

TEST(ReadEquation, LinearEquationsInAnyShape) {
  const struct {
    const char* text;
    const char* r;
  } table[] = {
      {"y'' = z*y", "z"},
      {"y''-z*y", "z"},
      {"z*y = y''", "z"},
      {"2*y'' = 2*z*y", "z"},
      {"z^2*y'' + z*y' + (z^2-1/4)*y = 0", "-1"},
      {"y'' + y'/z + y*(1 - 1/(4*z^2)) = 0", "-1"},
      {"(z*y')' = 0", "-1/(4*z^2)"},
      {"(z*y')'/z + y = 0", "(-4*z^2 - 1)/(4*z^2)"},
      {"diff(y, z, 2) = z*y", "z"},
      {"diff(diff(y,z),z) = z*y", "z"},
      {"diff(y(z), z, 2) - z*y(z) = 0", "z"},
      {"u'' = x*u", "x"},
      {"y'' = root(y^2-2,1.4)^2*x*y", "2*x"},
      {"y''(x) = x*y(x)", "x"},
      {"x''=t*x", "t"},
      {"diff(w, s, 2) = s*w", "s"},
      {"y'' + z*y' - z*y' = y", "1"},
      {"y'' = 0", "0"},
      {"0 = y''", "0"},
      {"-(y''-y) = 0", "1"},
      {"y''/z = y", "z"},
      {"(y'' - z*y)*(z+1)^2/3 = 0", "z"},
      {"y''^1 = y", "1"},
      {"y'''+y'' - y''' = y", "1"},
      {"(y + z*y'')' - y' - z*y''' = y", "1"},
  };
  for (const auto& [text, r] : table)
    EXPECT_EQ(r_of(ode(text)), r) << text;
}

TEST(ReadEquation, NormalFormRemembersTheFactor) {
  const GivenEquation e = read({.r{},
                                .p = "1/z",
                                .q = "1 - 1/(4*z^2)",
                                .ode{},
                                .minpoly{},
                                .variable{},
                                .set{},
                                .parameters{}});
  EXPECT_EQ(to_string(e.normal_form.r), "-1");
  EXPECT_EQ(to_string(e.normal_form.p), "1/z");
  EXPECT_EQ(e.form, GivenEquation::Form::pq);
}

TEST(ReadEquation, NamesAndConstants) {
  Given g = only_r("a^2*z");
  g.minpoly = "a^2-2";
  EXPECT_EQ(r_of(g), "2*z");
  g = only_r("c*z + b");
  g.set = {{"c", "1/2"}, {"b", "sqrt(2)*c"}};
  EXPECT_EQ(r_of(g), "(z + sqrt(2))/2");
  g = only_r("t^2");
  EXPECT_EQ(read(g).variable, "t");
  g.variable = "s";
  EXPECT_THROW((void)read(g), InputError);
  EXPECT_EQ(read(only_r("I")).variable, "z");
  g = only_r("(1+sqrt(2)+I)*a");
  g.variable = "a";
  EXPECT_EQ(read(g).constant, "b"); // not the name of the variable
}

std::string complaint(const Given& g) {
  try {
    return r_of(g);
  } catch (const InputError& e) {
    return render(e);
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(ReadEquation, CaretsPointAtTheMistake) {
  EXPECT_EQ(complaint(ode("y'' + y'^2 = 0")),
            "ode:1:7: error: this is not linear in y\n"
            "    1 | y'' + y'^2 = 0\n"
            "      |       ^~~~\n"
            "  note: only a2*y'' + a1*y' + a0*y = 0 with rational "
            "functions a2, a1, a0 can be solved\n");
  EXPECT_EQ(complaint(ode("y'' = r(z)*y")), "ode:1:7: error: unknown function 'r'\n"
                                            "    1 | y'' = r(z)*y\n"
                                            "      |       ^~~~\n"
                                            "  note: known functions are sqrt and root\n");
}

TEST(ReadEquation, EveryMistakeHasAName) {
  const struct {
    Given given;
    const char* says;
  } table[] = {
      {ode("y''*y = 0"), "not linear"},
      {ode("y/y'' = 0"), "not linear"},
      {ode("sqrt(y'') = 0"), "'y' is not a constant"},
      {ode("2^(y'') = 0"), "not linear"},
      {ode("y'' + y = z"), "not homogeneous: the term -z has no y"},
      {ode("y''' = y"), "the equation has order 3"},
      {ode("y' = y"), "the coefficient of y'' is zero"},
      {ode("y'' - y'' + y = 0"), "the coefficient of y'' is zero"},
      {ode("y'' = y''"), "everything cancels"},
      {ode("y = 0"), "no derivative of an unknown function"},
      {ode("y'' = u'"), "two functions are differentiated: u and y"},
      {ode("diff(y,z)+diff(y,x)=y"), "two variables, x and z: a partial differential equation"},
      {ode("u_tt = u_xx"), "two variables, t and x: a partial differential equation"},
      {ode("y'' = 0^0*y"), "0^0 has no value"},
      {ode("y'' = (z-z)^0*y"), "0^0 has no value"},
      {ode("diff(y,z,z)=y"), "order of a derivative is a small integer"},
      {ode("diff(y,z,10^9)=y"), "order of a derivative is a small integer"},
      {ode("diff(y)+y''=0"), "diff has two or three arguments"},
      {ode("y''''''''''''''''''''''''''''''''''''''''=y"), "only second-order"},
      {ode("y''(0)=y"), "is a function of x"},
      {ode("y''=a*x*y"), "which of a and x is the variable?"},
      {ode("y''/(z-z) = y"), "division by zero"},
      {only_r("I'"), "a derivative does not belong here"},
      {only_r("a*b"), "which of a and b is the variable?"},
      {{.r = "z", .p = "1", .q{}, .ode{}, .minpoly{}, .variable{}, .set{}, .parameters{}},
       "both r and p are given"},
      {{.r = "z", .p{}, .q = "1", .ode{}, .minpoly{}, .variable{}, .set{}, .parameters{}},
       "both r and q are given"},
      {{.r = "z", .p{}, .q{}, .ode = "y''=y", .minpoly{}, .variable{}, .set{}, .parameters{}},
       "both r and an equation are given"},
      {{.r{}, .p = "1", .q{}, .ode{}, .minpoly{}, .variable{}, .set{}, .parameters{}},
       "p is given without q"},
      {{.r{}, .p{}, .q = "1", .ode{}, .minpoly{}, .variable{}, .set{}, .parameters{}},
       "q is given without p"},
      {{.r{}, .p{}, .q{}, .ode{}, .minpoly{}, .variable{}, .set{}, .parameters{}},
       "needs r, or p and q"},
      {{.r = "z", .p{}, .q{}, .ode{}, .minpoly = "2", .variable{}, .set{}, .parameters{}},
       "name of one constant"},
      {{.r = "z", .p{}, .q{}, .ode{}, .minpoly = "a*b", .variable{}, .set{}, .parameters{}},
       "name of one constant"},
      {{.r = "z", .p{}, .q{}, .ode{}, .minpoly = "z^2-2", .variable = "z", .set{}, .parameters{}},
       "is a constant and cannot be the variable"},
      {{.r = "z", .p{}, .q{}, .ode{}, .minpoly{}, .variable{}, .set = {{"I", "1"}}, .parameters{}},
       "cannot be set"},
      {{.r = "z",
        .p{},
        .q{},
        .ode{},
        .minpoly{},
        .variable{},
        .set = {{"a", "1"}, {"a", "2"}},
        .parameters{}},
       "has a value already"},
      {{.r = "z", .p{}, .q{}, .ode{}, .minpoly{}, .variable{}, .set = {{"a", "z"}}, .parameters{}},
       "unknown name 'z'"},
      {{.r = "n*z", .p{}, .q{}, .ode{}, .minpoly{}, .variable{}, .set{}, .parameters = {"n"}},
       "free parameters: n"},
      {{.r = "z", .p{}, .q{}, .ode{}, .minpoly{}, .variable = "z", .set{}, .parameters = {"z"}},
       "both the variable and a parameter"},
  };
  for (const auto& [given, says] : table)
    EXPECT_NE(complaint(given).find(says), std::string::npos) << says << "\n" << complaint(given);
}

TEST(ReadEquation, DegreesAreLimited) {
  Budget budget;
  budget.max_degree = 100;
  EXPECT_THROW((void)read(ode("y'' + z^60*y' + y = 0"), budget), OutOfBudget);
  EXPECT_THROW((void)read(only_r("z^101"), budget), OutOfBudget);
  EXPECT_NO_THROW((void)read(only_r("z^100"), budget));
}

// --- files ------------------------------------------------------------------------------------

std::string file_complaint(const std::string& text) {
  try {
    const EquationFile file = read_equation_file(parse_document(text, "f.toml"));
    return to_string(read_equation(file.asked.text).normal_form.r);
  } catch (const InputError& e) {
    return render(e);
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(EquationFile, Reads) {
  const EquationFile file = read_equation_file(parse_document(R"(
format = "equation/1"
title = "Airy"
cite = ["Kovacic1986"]
[ode]
variable = "x"
r = "n*x"
[assume]
n = "nonzero"
[[expect]]
where = { n = "1" }
group = "SL2"
case = 4
source = "ex. 1"
[[expect]]
outcome = "undecided"
)",
                                                              "f.toml"));
  EXPECT_EQ(file.title, "Airy");
  EXPECT_EQ(file.asked.text.variable, "x");
  EXPECT_EQ(file.asked.text.parameters, std::vector<std::string>{"n"});
  ASSERT_EQ(file.expect.size(), 2U);
  EXPECT_EQ(file.expect[0].where.front().first, "n");
  EXPECT_EQ(file.expect[0].kovacic_case, 4);
  EXPECT_EQ(file.expect[1].outcome, "undecided");
}

TEST(EquationFile, ErrorsPointIntoTheFile) {
  EXPECT_EQ(
      file_complaint("format = \"equation/1\"\n[ode]\nr = \"z + 0.5\"\n"), // as people write it
      "(2*z + 1)/2");
  EXPECT_EQ(file_complaint("format = \"equation/1\"\n[ode]\nvarible = \"z\"\nr = \"z\"\n"),
            "f.toml:3:1: error: unknown key 'varible' in [ode]\n"
            "    3 | varible = \"z\"\n"
            "      | ^~~~~~~\n"
            "  note: did you mean 'variable'?\n");
  EXPECT_EQ(file_complaint("format = \"equation/1\"\n[ode]\nr = '''\nz +\n 2z'''\n"), "3*z");
  EXPECT_NE(file_complaint("format = \"equation/1\"\n[ode]\node = \"y\\u0027\\u0027 = q*y*z\"\n")
                .find("f.toml:3"),
            std::string::npos);
}

TEST(EquationFile, EveryMistakeHasAName) {
  const std::string head = "format = \"equation/1\"\n[ode]\nr = \"z\"\n";
  const struct {
    std::string text;
    const char* says;
  } table[] = {
      {"", "the key 'format' is missing"},
      {"format = \"equation/2\"", "unknown format 'equation/2'"},
      {"format = 1", "'format' must be a string"},
      {"format = \"equation/1\"", "neither an [ode] nor a [system] table"},
      {"format = \"equation/1\"\n[ode]\n", "[ode] has no equation"},
      {"format = \"equation/1\"\node = 3\n", "must be a table"},
      {"format = \"equation/1\n", "not TOML"},
      {head + "[expects]\ngroup = \"SL2\"\n", "did you mean 'expect'?"},
      {head + "[[expect]]\nsource = \"x\"\n", "this block expects nothing"},
      {head + "[[expect]]\ncase = 7\n", "Kovacic's cases are 1, 2, 3 and 4"},
      {head + "[[expect]]\ncase = \"4\"\n", "'case' must be an integer"},
      {head + "[[expect]]\noutcome = \"maybe\"\n", "'maybe' is not a value of outcome"},
      {head + "[[expect]]\ncse = 1\n", "did you mean 'case'?"},
      {head + std::string("a = \"\xFF\"\n"), "not TOML"},
      {head + std::string("\0", 1), "not TOML"},
      // toml++ 3.3 reaches unreachable code in these
      {head + "[[form\xC2\xB7(z-1)]]\n", "not TOML"},
      {head + "a = \"\"\"b \\\n \xC2\xB7\"\"\"\n", "unknown key 'a'"},
      {head + "\xC2\xB7 = 1\n", "not TOML"},
      {head + "# \xC2\xB7\ncte = \"\xC2\xB7\"\n", "unknown key 'cte'"},
  };
  for (const auto& [text, says] : table)
    EXPECT_NE(file_complaint(text).find(says), std::string::npos) << says << "\n"
                                                                  << file_complaint(text);
}

} // namespace
} // namespace kov
