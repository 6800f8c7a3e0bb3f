#include "output/render_program.hpp"

#include "exact/joined.hpp"
#include "output/render.hpp"
#include "symbol/author_words.hpp"
#include "symbol/expression.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <set>

namespace kov::cli {
namespace {

// The names in the formulas of a result, its variable and its constants.
std::set<std::string> names_of(const Json& result) {
  std::set<std::string> names;
  const std::function<void(const Json&)> take = [&](const Json& j) {
    if (j.is_string()) names.merge(names_in_text(j.get_ref<const std::string&>()));
    if (j.is_structured())
      for (const Json& member : j)
        take(member);
  };
  for (const char* key : {"variable", "r", "constants", "basis"})
    if (result.contains(key)) take(result.at(key));
  if (result.contains("constants"))
    for (const auto& [name, meaning] : result.at("constants").items())
      names.merge(names_in_text(name));
  if (result.at("liouvillian").is_array())
    for (const Json& solution : result.at("liouvillian"))
      for (const char* key : {"y", "minimal_polynomial"})
        if (solution.contains(key)) take(solution.at(key));
  for (const char* function : {"exp", "log", "sqrt", "root", "int", "erf", "erfi", "Ei", "I"})
    names.erase(function);
  for (const std::string& name : names_in(parse_expression(result.at("r").get<std::string>(), "r")))
    if (name != "I") names.insert(name); // a variable may be called like a function
  return names;
}

// One program's words for what every script says.
class Script {
public:
  Script(const Json& result, Program program)
      : result_(result), program_(program), variable_(result.at("variable").get<std::string>()),
        names_(program, names_of(result)), z_(names_(variable_)), y_(names_.own("y")),
        r_(names_.own("r")) {}

  [[nodiscard]] std::string text() {
    if (const std::string given = about_given(result_); !given.empty()) comment(given);
    comment(y_ + "'' = " + r_ + " " + y_ + "; written by kovacic");
    if (!result_.at("group").is_null())
      comment("the differential Galois group is " +
              letters_beside(result_).in(group_text(result_.at("group"))));
    comment("its identity component is abelian: " + result_.at("abelian").get<std::string>());
    begin();
    constants();
    define(r_, formula(result_.at("r").get<std::string>()));
    equation();
    given_form();
    if (result_.contains("strata")) strata();
    if (result_.at("liouvillian").is_array()) solutions();
    if (result_.contains("basis")) basis();
    if (result_.contains("polynomial_of_y")) polynomial_of_y(result_.at("polynomial_of_y"));
    return std::move(text_);
  }

private:
  [[nodiscard]] std::string formula(const std::string& text) const {
    return program_formula(text, variable_, program_, names_);
  }
  void line(const std::string& text) { text_ += text + "\n"; }
  [[nodiscard]] std::string commented(std::string words) const {
    std::ranges::replace(words, '\n', ' ');
    const bool maxima = program_ == Program::maxima;
    if (!maxima && program_ != Program::mathematica) return "# " + words;
    const std::string end = maxima ? "*/" : "*)";
    for (std::size_t at = 0; (at = words.find(end, at)) != std::string::npos;)
      words.insert(at + 1, " ");
    return (maxima ? "/* " : "(* ") + words + " " + end;
  }
  void comment(const std::string& words) { line(commented(words)); }
  void define(const std::string& name, const std::string& value) {
    switch (program_) {
    case Program::maxima:
      return line(name + " : " + value + "$");
    case Program::maple:
      return line(name + " := " + value + ":");
    case Program::mathematica:
      return line(name + " = " + value + ";");
    default:
      return line(name + " = " + value);
    }
  }

  // Names without a value: parameters.
  [[nodiscard]] std::vector<std::string> parameters() const {
    std::vector<std::string> names;
    for (const std::string& name :
         names_in(parse_expression(result_.at("r").get<std::string>(), "r")))
      if (name != variable_ && name != "I" &&
          !(result_.contains("constants") && result_.at("constants").contains(name)))
        names.push_back(name);
    return names;
  }

  // Symbols are shown with the letters of the question where the program can.
  void symbol(const std::string& name) {
    if (program_ == Program::sympy) define(names_(name), "Symbol('" + name + "')");
    if (program_ == Program::sage) define(names_(name), "var('" + names_(name) + "')");
  }
  void begin() {
    if (program_ == Program::sympy) line("from sympy import *");
    if (program_ == Program::sage) line("from ore_algebra import OreAlgebra");
    for (const std::string& name : parameters())
      symbol(name);
    symbol(variable_);
    if (program_ == Program::sympy) define(y_, "Function('" + y_ + "')");
    if (program_ == Program::sage) define(y_, "function('" + y_ + "')(" + z_ + ")");
  }

  void constants() {
    if (!result_.contains("constants")) return;
    for (const auto& [name, meaning] : result_.at("constants").items())
      if (name != "I" && is_identifier(name))
        define(names_(name), formula(meaning.get<std::string>()));
  }

  void equation() {
    const std::string equation = names_.own("equation");
    switch (program_) {
    case Program::sympy:
      return define(equation,
                    fmt::format("Eq(Derivative({1}({0}), ({0}, 2)), {2}*{1}({0}))", z_, y_, r_));
    case Program::maxima:
      return define(equation, fmt::format("'diff({1}, {0}, 2) = {2}*{1}", z_, y_, r_));
    case Program::maple:
      return define(equation, fmt::format("diff({1}({0}), {0}, {0}) = {2}*{1}({0})", z_, y_, r_));
    case Program::mathematica:
      return define(equation, fmt::format("{1}''[{0}] == {2}*{1}[{0}]", z_, y_, r_));
    case Program::sage:
      define(equation, fmt::format("diff({1}, {0}, 2) == {2}*{1}", z_, y_, r_));
      if (!result_.contains("constants") && parameters().empty())
        define(names_.own("operator"),
               fmt::format("OreAlgebra(QQ['{0}'].fraction_field(), 'D{0}').gen()^2 - "
                           "QQ['{0}'].fraction_field()({1})  # for ore_algebra",
                           z_, r_));
    }
  }

  void given_form() {
    if (!result_.contains("original") || result_.at("original").at("factor") == "1") return;
    comment("the solutions of " +
            question_text(result_, result_.contains("unknown") ? unknown_of(result_) : "y") +
            " are those of " + y_ + "'' = " + r_ + " " + y_ + " times this factor");
    define(names_.own("factor"), formula(result_.at("original").at("factor").get<std::string>()));
  }

  void strata() {
    if (const Json domain = result_.value("domain", Json::array()); !domain.empty())
      comment("there is an equation for " + listed(domain) + " only");
    if (const Json given = result_.value("assumed", Json::array()); !given.empty())
      comment("assumed: " + listed(given));
    for (const Json& stratum : result_.at("strata")) {
      std::string where = joined(stratum.at("conditions"), [&](const Json& condition) {
        return condition.is_string() ? condition.get<std::string>() : condition.dump();
      });
      if (stratum.contains("equation"))
        where += ", where the equation is " + stratum.at("equation").get<std::string>();
      comment((where.empty() ? "for all values" : "where " + where) +
              ": abelian: " + stratum.at("abelian").get<std::string>());
    }
  }

  void solutions() {
    int number = 0;
    for (const Json& solution : result_.at("liouvillian")) {
      ++number;
      if (solution.contains("note")) comment(solution.at("note").get<std::string>());
      if (solution.at("kind") == "exponential")
        solved("y" + std::to_string(number), solution.at("y").get<std::string>());
      else
        algebraic(number, solution.at("minimal_polynomial"));
    }
  }

  // Both solutions where the list above has one, or a polynomial.
  void basis() {
    comment("a basis of solutions (checked by kovacic, in exact arithmetic)");
    const bool first_is_there = result_.at("liouvillian").at(0).contains("y");
    if (!first_is_there) solved("y1", result_.at("basis").at(0).get<std::string>());
    solved("y2", result_.at("basis").at(1).get<std::string>());
  }

  // What is printed is said to be 0.
  void left(const std::string& value) {
    switch (program_) {
    case Program::maxima:
      return line(value + ";  " + commented("0"));
    case Program::maple:
      return line(value + ";  # 0");
    case Program::mathematica:
      return line("Print[" + value + "]  (* 0 *)");
    default:
      return line("print(" + value + ")  # 0");
    }
  }

  // A solution, and what is left of it in the equation.
  void solved(const std::string& letter, const std::string& y) {
    const std::string name = names_.own(letter);
    define(name, formula(y));
    const std::string quotient = fmt::format("({} - {}*{})/{}", twice(name), r_, name, name);
    switch (program_) {
    case Program::sympy: // no end is in sight for an integral over roots of a polynomial
      if (text_.find("all_roots()") != std::string::npos && y.find("int(") != std::string::npos)
        return;
      return left("simplify(" + quotient + ")");
    case Program::maple:
      return left("simplify(" + quotient + ")");
    case Program::maxima:
      return left("ratsimp(radcan(" + quotient + "))");
    case Program::mathematica:
      return left("Simplify[" + quotient + "]");
    case Program::sage:
      return left("(" + quotient + ").simplify_full()");
    }
  }
  [[nodiscard]] std::string derivative(const std::string& f, const std::string& x) const {
    return program_ == Program::mathematica ? "D[" + f + ", " + x + "]"
                                            : "diff(" + f + ", " + x + ")";
  }
  [[nodiscard]] std::string twice(const std::string& f) const {
    switch (program_) {
    case Program::maple:
      return "diff(" + f + ", " + z_ + ", " + z_ + ")";
    case Program::mathematica:
      return "D[" + f + ", {" + z_ + ", 2}]";
    default:
      return "diff(" + f + ", " + z_ + ", 2)";
    }
  }

  // y'/y is a root w of P over K(z): P' + P_w (r - w^2) is divisible by P.
  void algebraic(int number, const Json& coefficients) {
    const std::string name = names_.own("P" + std::to_string(number)), w = names_.own("w");
    comment(y_ + " = exp(integral of " + w + "), where " + name + " = 0");
    if (number == 1) unknown(w);
    define(name, polynomial(coefficients, w));
    divide(fmt::format("{} + {}*({} - {}{}2)", derivative(name, z_), derivative(name, w), r_, w,
                       power_sign(program_)),
           name, w);
  }

  void unknown(const std::string& name) {
    if (program_ == Program::sympy) define(name, "Symbol('" + name + "')");
    if (program_ == Program::sage) define(name, "var('" + name + "')");
  }
  [[nodiscard]] std::string polynomial(const Json& coefficients, const std::string& x) const {
    std::string sum;
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      sum += (i == 0 ? "(" : " + (") + formula(coefficients[i].get<std::string>()) + ")" +
             (i == 0 ? "" : "*" + x) + (i < 2 ? "" : power_sign(program_) + std::to_string(i));
    return sum;
  }

  // y^k = factor X, Q(z, X) = 0, is a solution: docs/theory/algebraic_solution.md, 5.
  void polynomial_of_y(const Json& y) {
    if (y.contains("missing"))
      return comment("no polynomial of " + y_ + ": " + y.at("missing").get<std::string>());
    const auto own = [&](const char* name) { return names_.own(name); };
    const std::string k = y.at("power").dump(), x = own("X"), power = power_sign(program_);
    const std::string factor = own("y_factor"), q = own("Q"), beta = own("y_beta"),
                      q_z = own("Q_z"), q_x = own("Q_X"), q_2 = own("Q_2"), check = own("y_check");
    comment(y_ + power + k + " = " + factor + "*" + x + " for the solutions of " + y_ +
            "'' = " + r_ + " " + y_ + ", where " + q + " = 0");
    unknown(x);
    define(factor, formula(y.at("factor").get<std::string>()));
    if (y.contains("given_factor")) {
      comment("for those of the given equation this is the factor");
      define(own("given_factor"), formula(y.at("given_factor").get<std::string>()));
    }
    define(q, polynomial(y.at("polynomial"), x));
    define(beta, fmt::format("-{}/({}*{})", derivative(factor, z_), k, factor));
    define(q_z, derivative(q, z_));
    define(q_x, derivative(q, x));
    define(q_2, fmt::format("2*{0}*{3}*{4} - {1}*{3}{5}2 - {2}*{4}{5}2", derivative(q_z, x),
                            derivative(q_x, x), derivative(q_z, z_), q_z, q_x, power));
    define(check, fmt::format("{0}*{1}*{2} - ({0} - 1)*{3}{4}2*{5} + 2*{0}*{6}*{1}*{3}*{5}{4}2 - "
                              "{0}{4}2*({7} + {8} - {6}{4}2)*{1}{4}2*{5}{4}3",
                              k, x, q_2, q_z, power, q_x, beta, r_, derivative(beta, z_)));
    divide(check, q, x);
  }

  // Prints the remainder, which is 0.
  void divide(const std::string& f, const std::string& by, const std::string& x) {
    switch (program_) {
    case Program::sympy:
      return left(fmt::format("simplify(rem({}, {}, {}))", f, by, x));
    case Program::maxima:
      return left(fmt::format("ratsimp(second(divide(ratsimp({}), {}, {})))", f, by, x));
    case Program::maple:
      return left(fmt::format("simplify(rem({}, {}, {}))", f, by, x));
    case Program::mathematica:
      return left(fmt::format("Simplify[PolynomialRemainder[{}, {}, {}]]", f, by, x));
    case Program::sage:
      return left(
          fmt::format("(({}).polynomial(SR, '{}') % {}.polynomial(SR, '{}'))", f, x, by, x));
    }
  }

  const Json& result_;
  Program program_;
  std::string variable_;
  ProgramNames names_;
  std::string z_; // the variable there
  std::string y_; // the unknown function
  std::string r_;
  std::string text_;
};

} // namespace

std::string program_text(const Json& result, Program program) {
  if (!result.at("r").is_string()) return {};
  return Script(result, program).text();
}

} // namespace kov::cli
