#include "render_program.hpp"

#include "render.hpp"
#include "symbol/author_words.hpp"
#include "symbol/expression.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace kov::cli {
namespace {

using Kind = Expression::Kind;

// A name that is no word of Python's.
std::string safe_name(const std::string& name, Program program) {
  static const std::set<std::string> words{
      "and",    "as",   "assert", "async",  "await",  "break",   "class",    "continue",
      "def",    "del",  "elif",   "else",   "except", "finally", "for",      "from",
      "global", "if",   "import", "in",     "is",     "lambda",  "nonlocal", "not",
      "or",     "pass", "raise",  "return", "try",    "while",   "with",     "yield"};
  return program != Program::maxima && words.contains(name) ? name + "_" : name;
}

// Fully parenthesized where it matters: the text is for a reader that is a program.
class Writer {
public:
  Writer(Program program, const std::string& variable)
      : program_(program), variable_(safe_name(variable, program)) {}

  [[nodiscard]] std::string operator()(const Expression& e) const {
    switch (e.kind()) {
    case Kind::number:
      return program_ == Program::sympy ? "Integer(" + to_string(e.number()) + ")"
                                        : to_string(e.number());
    case Kind::decimal:
      return e.name();
    case Kind::name:
      return name(e.name());
    case Kind::negate:
      return "-" + inside(e.operand(0));
    case Kind::sum:
      return joined(e, " + ");
    case Kind::product:
      return joined(e, "*");
    case Kind::quotient:
      return inside(e.operand(0)) + "/" + inside(e.operand(1));
    case Kind::power:
      return inside(e.operand(0)) + (program_ == Program::sympy ? "**" : "^") +
             inside(e.operand(1));
    case Kind::call:
      return call(e);
    case Kind::derivative:
    case Kind::equation:
      throw e.error("no expression");
    }
    return {};
  }

private:
  [[nodiscard]] std::string inside(const Expression& e) const {
    const bool atom = e.kind() == Kind::name || e.kind() == Kind::number || e.kind() == Kind::call;
    return atom ? (*this)(e) : "(" + (*this)(e) + ")";
  }
  [[nodiscard]] std::string joined(const Expression& e, const std::string& sign) const {
    std::string text;
    for (const Expression& operand : e.operands())
      text += (text.empty() ? "" : sign) + inside(operand);
    return text;
  }
  [[nodiscard]] std::string name(const std::string& name) const {
    if (program_ == Program::maxima && (name == "I" || name == "pi"))
      return name == "I" ? "%i" : "%pi";
    return safe_name(name, program_);
  }

  [[nodiscard]] std::string call(const Expression& e) const {
    if (e.name() == "int")
      return (program_ == Program::sympy ? "Integral(" : "integrate(") + (*this)(e.operand(0)) +
             ", " + variable_ + ")";
    if (e.name() == "root") return root(e);
    std::string list;
    for (const Expression& x : e.operands())
      list += (list.empty() ? "" : ", ") + (*this)(x);
    const bool other = program_ == Program::maxima && e.name() == "Ei";
    return (other ? "expintegral_ei" : e.name()) + "(" + list + ")";
  }

  // root(p(x), approximation): the root of p nearest to the point
  [[nodiscard]] std::string root(const Expression& e) const {
    const std::vector<std::string> names = names_in(e.operand(0));
    const std::string x = names.empty() ? "x" : names.front();
    const std::string p = (*this)(e.operand(0));
    const std::string at = (*this)(e.operand(1));
    switch (program_) {
    case Program::sympy:
      return fmt::format("min(Poly({}, Symbol('{}')).all_roots(), key=lambda t: abs(N(t) - ({})))",
                         with_symbol(p, x), x, at);
    case Program::maxima:
      return fmt::format("first(sort(map(rhs, solve({0}, {1})), lambda([s, t], "
                         "is(cabs(float(rectform(s - ({2})))) < "
                         "cabs(float(rectform(t - ({2}))))))))",
                         p, x, at);
    case Program::sage:
      return fmt::format("min(QQ['{1}']({0}).roots(QQbar, multiplicities=False), key=lambda t: "
                         "abs(CC(t) - CC({2})))",
                         p, x, at);
    }
    return {};
  }
  static std::string with_symbol(const std::string& p, const std::string& x) {
    return fmt::format("(lambda {}: {})(Symbol('{}'))", x, p, x);
  }

  Program program_;
  std::string variable_;
};

// One program's words for what every script says.
class Script {
public:
  Script(const Json& result, Program program)
      : result_(result), program_(program), variable_(result.at("variable").get<std::string>()),
        z_(safe_name(variable_, program)) {}

  [[nodiscard]] std::string text() {
    comment("y'' = r y; written by kovacic");
    if (!result_.at("group").is_null())
      comment("the differential Galois group is " + group_text(result_.at("group")));
    comment("its identity component is abelian: " + result_.at("abelian").get<std::string>());
    begin();
    constants();
    define("r", formula(result_.at("r").get<std::string>()));
    equation();
    given_form();
    if (result_.contains("strata")) strata();
    if (result_.at("solutions").is_array()) solutions();
    if (result_.contains("basis")) basis();
    if (result_.contains("polynomial_of_y")) polynomial_of_y(result_.at("polynomial_of_y"));
    return std::move(text_);
  }

private:
  [[nodiscard]] std::string formula(const std::string& text) const {
    return program_formula(text, variable_, program_);
  }
  void line(const std::string& text) { text_ += text + "\n"; }
  void comment(std::string words) {
    std::replace(words.begin(), words.end(), '\n', ' ');
    if (program_ != Program::maxima) return line("# " + words);
    for (std::size_t at = 0; (at = words.find("*/", at)) != std::string::npos;)
      words.replace(at, 2, "* /");
    line("/* " + words + " */");
  }
  void define(const std::string& name, const std::string& value) {
    line(program_ == Program::maxima ? name + " : " + value + "$" : name + " = " + value);
  }

  // Names without a value: parameters.
  [[nodiscard]] std::vector<std::string> parameters() const {
    std::vector<std::string> names;
    for (const std::string& name :
         names_in(parse_expression(result_.at("r").get<std::string>(), "r")))
      if (name != variable_ && name != "I" &&
          !(result_.contains("constants") && result_.at("constants").contains(name)))
        names.push_back(safe_name(name, program_));
    return names;
  }

  void begin() {
    const std::vector<std::string> others = parameters();
    if (program_ == Program::sympy) {
      line("from sympy import *");
      for (const std::string& name : others)
        define(name, "Symbol('" + name + "')");
      define(z_, "Symbol('" + z_ + "')");
      define("y", "Function('y')");
    } else if (program_ == Program::sage) {
      line("from ore_algebra import OreAlgebra");
      for (const std::string& name : others)
        define(name, "var('" + name + "')");
      define(z_, "var('" + z_ + "')");
      define("y", "function('y')(" + z_ + ")");
    }
  }

  void constants() {
    if (!result_.contains("constants")) return;
    for (const auto& [name, meaning] : result_.at("constants").items())
      if (name != "I" && is_identifier(name))
        define(safe_name(name, program_), formula(meaning.get<std::string>()));
  }

  void equation() {
    switch (program_) {
    case Program::sympy:
      return define("equation", fmt::format("Eq(Derivative(y({0}), ({0}, 2)), r*y({0}))", z_));
    case Program::maxima:
      return define("equation", fmt::format("'diff(y, {}, 2) = r*y", z_));
    case Program::sage:
      define("equation", fmt::format("diff(y, {}, 2) == r*y", z_));
      if (!result_.contains("constants") && parameters().empty())
        line(fmt::format("operator = OreAlgebra(QQ['{0}'].fraction_field(), 'D{0}')", z_) +
             fmt::format(".gen()^2 - QQ['{0}'].fraction_field()(r)  # for ore_algebra", z_));
    }
  }

  void given_form() {
    if (!result_.contains("original") || result_.at("original").at("factor") == "1") return;
    comment("the solutions of the given equation are those of y'' = r y times this factor");
    define("factor", formula(result_.at("original").at("factor").get<std::string>()));
  }

  void strata() {
    for (const Json& stratum : result_.at("strata")) {
      std::string where;
      for (const Json& condition : stratum.at("conditions"))
        where += (where.empty() ? "" : ", ") +
                 (condition.is_string() ? condition.get<std::string>() : condition.dump());
      comment((where.empty() ? "for all values" : "where " + where) +
              ": abelian: " + stratum.at("abelian").get<std::string>());
    }
  }

  void solutions() {
    int number = 0;
    for (const Json& solution : result_.at("solutions")) {
      ++number;
      if (solution.contains("note")) comment(solution.at("note").get<std::string>());
      if (solution.at("kind") == "exponential")
        exponential(number, solution.at("y").get<std::string>());
      else
        algebraic(number, solution.at("minimal_polynomial"));
    }
  }

  // Both solutions where the list above has one, or a polynomial.
  void basis() {
    comment("a basis of solutions (checked by kovacic, in exact arithmetic)");
    const bool first_is_there = result_.at("solutions").at(0).contains("y");
    if (!first_is_there) define("y1", formula(result_.at("basis").at(0).get<std::string>()));
    define("y2", formula(result_.at("basis").at(1).get<std::string>()));
  }

  void exponential(int number, const std::string& y) {
    const std::string name = "y" + std::to_string(number);
    define(name, formula(y));
    const std::string left = "diff(" + name + ", " + z_ + ", 2) - r*" + name;
    if (program_ == Program::sympy)
      line("print(simplify((" + left + ")/" + name + "))  # 0");
    else if (program_ == Program::maxima)
      line("ratsimp(radcan((" + left + ")/" + name + "));");
    else
      line("print(((" + left + ")/" + name + ").simplify_full())  # 0");
  }

  // y'/y is a root w of P over K(z): P' + P_w (r - w^2) is divisible by P.
  void algebraic(int number, const Json& coefficients) {
    const std::string name = "P" + std::to_string(number);
    const std::string w = z_ == "w" ? "v" : "w";
    comment("y = exp(integral of " + w + "), where " + name + " = 0");
    if (number == 1) unknown(w);
    const std::string power = program_ == Program::sympy ? "**" : "^";
    define(name, polynomial(coefficients, w));
    const std::string flow =
        fmt::format("diff({0}, {1}) + diff({0}, {2})*(r - {2}{3}2)", name, z_, w, power);
    divide(flow, name, w);
  }

  void unknown(const std::string& name) {
    if (program_ == Program::sympy) define(name, "Symbol('" + name + "')");
    if (program_ == Program::sage) define(name, "var('" + name + "')");
  }
  [[nodiscard]] std::string polynomial(const Json& coefficients, const std::string& x) const {
    std::string sum;
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      sum += (i == 0 ? "(" : " + (") + formula(coefficients[i].get<std::string>()) + ")*" + x +
             (program_ == Program::sympy ? "**" : "^") + std::to_string(i);
    return sum;
  }

  // y^k = factor X, Q(z, X) = 0, is a solution: docs/theory/algebraic_solution.md, 5.
  void polynomial_of_y(const Json& y) {
    if (y.contains("missing"))
      return comment("no polynomial of y: " + y.at("missing").get<std::string>());
    const std::string k = y.at("power").dump(), x = z_ == "X" ? "T" : "X";
    const std::string power = program_ == Program::sympy ? "**" : "^";
    comment("y" + power + k + " = y_factor*" + x + " for the solutions of y'' = r y, where Q = 0");
    unknown(x);
    define("y_factor", formula(y.at("factor").get<std::string>()));
    if (y.contains("given_factor")) {
      comment("for those of the given equation this is the factor");
      define("given_factor", formula(y.at("given_factor").get<std::string>()));
    }
    define("Q", polynomial(y.at("polynomial"), x));
    define("y_beta", fmt::format("-diff(y_factor, {})/({}*y_factor)", z_, k));
    define("Q_z", fmt::format("diff(Q, {})", z_));
    define("Q_X", fmt::format("diff(Q, {})", x));
    define("Q_2", fmt::format("2*diff(Q_z, {0})*Q_z*Q_X - diff(Q_X, {0})*Q_z{2}2 - "
                              "diff(Q_z, {1})*Q_X{2}2",
                              x, z_, power));
    define("y_check",
           fmt::format("{0}*{1}*Q_2 - ({0} - 1)*Q_z{2}2*Q_X + 2*{0}*y_beta*{1}*Q_z*Q_X{2}2 - "
                       "{0}{2}2*(r + diff(y_beta, {3}) - y_beta{2}2)*{1}{2}2*Q_X{2}3",
                       k, x, power, z_));
    divide("y_check", "Q", x);
  }

  // Prints the remainder, which is 0.
  void divide(const std::string& f, const std::string& by, const std::string& x) {
    if (program_ == Program::sympy)
      line(fmt::format("print(simplify(rem({}, {}, {})))  # 0", f, by, x));
    else if (program_ == Program::maxima)
      line(fmt::format("ratsimp(second(divide(ratsimp({}), {}, {})));", f, by, x));
    else
      line(fmt::format("print((({}).polynomial(SR, '{}') % {}.polynomial(SR, '{}')))  # 0", f, x,
                       by, x));
  }

  const Json& result_;
  Program program_;
  std::string variable_;
  std::string z_; // the variable there
  std::string text_;
};

} // namespace

std::optional<Program> program_of(const std::string& format) {
  if (format == "sympy") return Program::sympy;
  if (format == "maxima") return Program::maxima;
  if (format == "sage") return Program::sage;
  return std::nullopt;
}

std::string program_formula(const std::string& formula, const std::string& variable,
                            Program program) {
  return Writer(program, variable)(parse_expression(formula, "formula"));
}

std::string program_text(const Json& result, Program program) {
  if (!result.at("r").is_string()) return {};
  return Script(result, program).text();
}

} // namespace kov::cli
