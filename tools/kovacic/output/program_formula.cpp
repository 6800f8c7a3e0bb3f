#include "output/program_formula.hpp"

#include "exact/joined.hpp"
#include "symbol/expression.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace kov::cli {
namespace {

using Kind = Expression::Kind;

// Words of the language, its constants, and the functions that scripts call.
const std::set<std::string>& reserved(Program program) {
  static const std::set<std::string> python{
      "and",    "as",   "assert", "async",  "await",    "break", "class", "continue", "def",
      "del",    "elif", "else",   "except", "finally",  "for",   "from",  "global",   "if",
      "import", "in",   "is",     "lambda", "nonlocal", "not",   "or",    "pass",     "raise",
      "return", "try",  "while",  "with",   "yield",    "None",  "True",  "False",    "print",
      "min",    "abs",  "key",    "I",      "pi",       "N",     "diff",  "exp",      "log",
      "sqrt",   "erf",  "Ei",     "int",    "root"};
  static const auto with = [](std::set<std::string> more) {
    more.insert(python.begin(), python.end());
    return more;
  };
  static const std::set<std::string> sympy =
      with({"E", "S", "O", "Q", "C", "Symbol", "Function", "Integer", "Derivative", "Eq",
            "simplify", "rem", "Poly", "Integral"});
  static const std::set<std::string> sage =
      with({"e", "i", "CC", "QQ", "QQbar", "SR", "var", "function", "integrate", "OreAlgebra"});
  static const std::set<std::string> maxima{
      "and",    "or",        "not",       "if",        "then",      "else",      "elseif",
      "do",     "for",       "from",      "in",        "next",      "step",      "thru",
      "unless", "while",     "true",      "false",     "inf",       "minf",      "und",
      "ind",    "infinity",  "done",      "unknown",   "simp",      "numer",     "float",
      "domain", "modulus",   "algebraic", "gcd",       "values",    "labels",    "functions",
      "arrays", "listarith", "ratfac",    "radexpand", "logexpand", "keepfloat", "pi",
      "lambda"};
  static const std::set<std::string> maple{
      "and",      "assuming", "break",   "by",     "catch",     "done",    "do",       "elif",
      "else",     "end",      "error",   "export", "fi",        "finally", "for",      "from",
      "global",   "if",       "implies", "in",     "intersect", "local",   "minus",    "mod",
      "module",   "next",     "not",     "od",     "option",    "options", "or",       "proc",
      "quit",     "read",     "restart", "return", "save",      "stop",    "subset",   "then",
      "to",       "try",      "union",   "use",    "uses",      "while",   "xor",      "true",
      "false",    "FAIL",     "I",       "D",      "O",         "Pi",      "gamma",    "Catalan",
      "infinity", "Digits",   "Order",   "pi",     "diff",      "exp",     "ln",       "log",
      "sqrt",     "erf",      "Ei",      "int",    "RootOf",    "rem",     "simplify", "list",
      "set"};
  static const std::set<std::string> mathematica{
      "C",        "D",       "E",        "I",      "K",    "N",     "O",   "Pi",        "Abs",
      "Degree",   "Catalan", "Infinity", "Log",    "Exp",  "Sqrt",  "Erf", "Integrate", "Simplify",
      "Together", "First",   "Solve",    "SortBy", "True", "False", "Null"};
  switch (program) {
  case Program::sympy:
    return sympy;
  case Program::sage:
    return sage;
  case Program::maxima:
    return maxima;
  case Program::maple:
    return maple;
  case Program::mathematica:
    return mathematica;
  }
  return python;
}

// _ is a pattern in Mathematica.
std::string writable(const std::string& name, Program program) {
  if (program != Program::mathematica) return name;
  std::string plain;
  for (const char c : name)
    if (c != '_') plain += c;
  return plain.empty() || (plain.front() >= '0' && plain.front() <= '9') ? "u" + plain : plain;
}

std::string unused(const std::string& name, Program program, const std::set<std::string>& used) {
  std::string free = writable(name, program);
  while (used.contains(free) || reserved(program).contains(free))
    free += program == Program::mathematica ? "0" : "_";
  return free;
}

// Fully parenthesized where it matters: the text is for a reader that is a program.
class Writer {
public:
  Writer(Program program, std::string variable, const ProgramNames& names)
      : program_(program), variable_(std::move(variable)), names_(names) {}

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
      return inside(e.operand(0)) + power_sign(program_) + inside(e.operand(1));
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
  // pi is ours unless the variable has that name.
  [[nodiscard]] std::string name(const std::string& name) const {
    const bool pi = name == "pi" && variable_ != "pi";
    if (!pi && name != "I") return names_(name);
    switch (program_) {
    case Program::maxima:
      return pi ? "%pi" : "%i";
    case Program::maple:
    case Program::mathematica:
      return pi ? "Pi" : "I";
    default:
      return name;
    }
  }

  [[nodiscard]] static std::string function(const std::string& ours, Program program) {
    if (ours == "Ei" && program == Program::maxima) return "expintegral_ei";
    if (program != Program::mathematica) return ours;
    if (ours == "Ei") return "ExpIntegralEi";
    std::string theirs = ours;
    theirs.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(theirs.front())));
    return theirs;
  }
  [[nodiscard]] std::string bracketed(const std::string& arguments) const {
    return program_ == Program::mathematica ? "[" + arguments + "]" : "(" + arguments + ")";
  }

  [[nodiscard]] std::string call(const Expression& e) const {
    if (e.name() == "int") {
      const char* integral = program_ == Program::sympy         ? "Integral"
                             : program_ == Program::mathematica ? "Integrate"
                             : program_ == Program::maple       ? "int"
                                                                : "integrate";
      return integral + bracketed((*this)(e.operand(0)) + ", " + names_(variable_));
    }
    if (e.name() == "root") return root(e);
    std::string list = kov::joined(e.operands(), [&](const Expression& x) { return (*this)(x); });
    return function(e.name(), program_) + bracketed(list);
  }

  // root(p(x), approximation): the root of p nearest to the point
  [[nodiscard]] std::string root(const Expression& e) const {
    const std::vector<std::string> all = names_in(e.operand(0));
    const std::string x = all.empty() ? "x" : names_(all.front());
    const std::string p = (*this)(e.operand(0));
    const std::string at = (*this)(e.operand(1));
    switch (program_) {
    case Program::sympy:
      return fmt::format("min(Poly((lambda {0}: {1})(Symbol('{0}')), Symbol('{0}')).all_roots(), "
                         "key=lambda t: abs(N(t) - ({2})))",
                         x, p, at);
    case Program::maxima:
      return fmt::format("first(sort(map(rhs, solve({0}, {1})), lambda([s, t], "
                         "is(cabs(float(rectform(s - ({2})))) < "
                         "cabs(float(rectform(t - ({2}))))))))",
                         p, x, at);
    case Program::maple:
      return fmt::format("RootOf({}, {}, {})", p, x, at);
    case Program::mathematica:
      return fmt::format("First[SortBy[{1} /. Solve[({0}) == 0, {1}], Abs[N[# - ({2})]] &]]", p, x,
                         at);
    case Program::sage: // a text, so that x is that of the ring
      return fmt::format("min(QQ['{1}']('{0}').roots(QQbar, multiplicities=False), key=lambda t: "
                         "abs(CC(t) - CC({2})))",
                         p, x, at);
    }
    return {};
  }

  Program program_;
  std::string variable_;
  const ProgramNames& names_;
};

} // namespace

std::optional<Program> program_of(const std::string& format) {
  static const std::map<std::string, Program> programs{{"sympy", Program::sympy},
                                                       {"maxima", Program::maxima},
                                                       {"maple", Program::maple},
                                                       {"mathematica", Program::mathematica},
                                                       {"sage", Program::sage}};
  const auto found = programs.find(format);
  return found == programs.end() ? std::nullopt : std::optional(found->second);
}

const char* power_sign(Program program) { return program == Program::sympy ? "**" : "^"; }

ProgramNames::ProgramNames(Program program, const std::set<std::string>& question)
    : program_(program) {
  for (const std::string& name : question) // those that keep their letters first
    if (unused(name, program, {}) == name) used_.insert(name);
  for (const std::string& name : question) {
    if (used_.contains(name)) continue;
    const std::string other = unused(name, program, used_);
    used_.insert(other);
    names_.emplace(name, other);
  }
}

std::string ProgramNames::operator()(const std::string& name) const {
  const auto other = names_.find(name);
  return other == names_.end() ? name : other->second;
}

std::string ProgramNames::own(const std::string& name) const {
  std::string free = writable(name, program_);
  while (used_.contains(free))
    free += program_ == Program::mathematica ? "0" : "_";
  return free;
}

std::string program_formula(const std::string& formula, const std::string& variable,
                            Program program, const ProgramNames& names) {
  return Writer(program, variable, names)(parse_expression(formula, "formula"));
}

} // namespace kov::cli
