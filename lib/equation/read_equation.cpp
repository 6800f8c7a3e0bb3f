#include "equation/read_equation.hpp"

#include "equation/assumptions.hpp"
#include "equation/linear_form.hpp"
#include "exact/lists.hpp"
#include "symbol/author_words.hpp"
#include "symbol/constants.hpp"
#include "symbol/one_name.hpp"
#include "symbol/operators.hpp"
#include "symbol/pasted_characters.hpp"
#include "symbol/suggest.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

namespace kov {

bool is_usual_variable(const std::string& name, const std::string& unknown) {
  static const std::set<std::string> of_any{"x",    "z",      "t",        "X",    "Z",
                                            "zeta", "eta",    "xi",       "rho",  "tau",
                                            "phi",  "varphi", "vartheta", "theta"};
  static const std::set<std::string> of_x{"t", "tau", "z", "phi", "theta"};
  static const std::set<std::string> variables{"x", "z", "r", "s"};
  if (unknown == "t" || name == unknown) return false;
  if (unknown == "x") return of_x.contains(name);
  if (name == "y") return !variables.contains(unknown);
  if (name == "r") return unknown != "y";
  return of_any.contains(name);
}

namespace {

// A letter, or the name of a Greek one, with an index or none: omega_0, w0.
std::string letter_of(const std::string& name) {
  const std::string base = name.substr(0, name.find_first_of("_0123456789"));
  return base.size() == 1 || base == "hbar" || is_greek(base) ? base : "";
}
// Nobody's variable.
bool is_constant_letter(const std::string& letter) {
  static const std::set<std::string> greek{
      "alpha", "beta", "gamma", "delta", "epsilon", "kappa",  "lambda", "mu",    "nu",   "omega",
      "sigma", "zeta", "eta",   "xi",    "rho",     "Lambda", "Gamma",  "Delta", "hbar", "Omega"};
  static const std::string latin = "abcdghklmnABCDEGHKLMN";
  return letter.size() == 1 ? latin.find(letter) != std::string::npos : greek.contains(letter);
}

} // namespace

bool may_be_constant(const std::string& variable) {
  return is_greek(variable) && variable != "tau";
}

std::optional<std::string> obvious_variable(const std::vector<std::string>& names,
                                            const std::string& unknown, bool by_time) {
  const auto is_variable = [&](const std::string& name) {
    return is_usual_variable(name, unknown) && !(by_time && may_be_constant(name));
  };
  std::optional<std::string> found;
  bool all_constant = true;
  for (const std::string& name : names) {
    if (is_variable(name)) {
      if (found) return std::nullopt;
      found = name;
      continue;
    }
    const std::string letter = letter_of(name);
    if (letter.empty() || letter == unknown || is_variable(letter)) return std::nullopt;
    all_constant = all_constant && (is_constant_letter(letter) ||
                                    (by_time && std::isupper(letter.front()) != 0)); // L, R, F
  }
  if (found) return found;
  if (!all_constant) return std::nullopt;
  return by_time ? "t" : unnamed_variable({}, unknown);
}

std::string unnamed_variable(const EquationText& text, const std::string& unknown) {
  const std::vector<std::string> declared = declared_names(text);
  for (const char* letter : {"x", "t", "z"})
    if (letter != unknown && !is_among(std::string(letter), declared)) return letter;
  return "z";
}

bool is_constant_of_mathematics(const std::string& name) { return name == "pi" || name == "e"; }

InputError variable_or_constant(const Expression& where, const std::string& name) {
  return where.error("is " + name + " the variable, or a constant?",
                     "the variable: --variable " + name + "; a constant: --parameter " + name);
}

std::vector<std::string> declared_names(const EquationText& text) {
  std::vector<std::string> names = text.parameters;
  for (const auto& [name, value] : text.set)
    names.push_back(name);
  if (text.minpoly) std::ranges::copy(names_in(*text.minpoly), std::back_inserter(names));
  for (const AssumedText& sentence : text.assume)
    for (const std::string& name : names_in_assumption(sentence))
      if (name != text.variable) names.push_back(name);
  for (const std::string& name : {text.variable, text.unknown})
    if (!name.empty()) names.push_back(name);
  return names;
}

namespace {

// The text with every word of the list as the product that it may be.
std::string with_products_for(const std::set<std::string>& words, std::string_view text) {
  const auto belongs = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    if (is_identifier(std::string(1, text[i])))
      while (end < text.size() && belongs(text[end]))
        ++end;
    const std::string word(text.substr(i, end - i));
    const bool command = i > 0 && text[i - 1] == '\\';
    out += words.contains(word) && !command ? as_product(word)
           : end > i                        ? word
                                            : std::string(1, text[i]);
    i = std::max(end, i + 1);
  }
  return out;
}

// One formula of a question.
class Words {
public:
  Words(const Expression& formula, const EquationText& text)
      : formula_(formula), declared_(declared_names(text)) {
    const Differentiated d = differentiated_in(formula);
    const auto take = [&](const std::string& name) {
      const bool known = name == "I" || name == "Pi" || is_one_name(name) ||
                         d.arguments.contains(name) || is_among(name, declared_);
      if (!known) words_.insert(name);
    };
    for (const std::string& name : names_in(formula))
      if (name[0] != 'D' || !is_one_name(name.substr(1))) take(name); // Dx: another message
    for (const std::string& name : d.functions) {
      take(name);
      if (words_.contains(name) && unknown_.empty()) unknown_ = name;
    }
  }

  void refuse() const {
    if (words_.empty()) return;
    const bool differentiated = !unknown_.empty();
    const std::string word = differentiated ? unknown_ : *words_.begin();
    constexpr std::size_t longest = 100;
    const std::string_view whole = formula_.text();
    const std::string instead = with_products_for(words_, whole);
    const bool whole_latex = std::ranges::count(whole, '{') == std::ranges::count(whole, '}');
    const bool shown = whole.size() <= longest && instead != whole && whole_latex;
    const Expression* place = find_name(formula_, word);
    const auto near = nearest(word, declared_); // but kx is k*x beside k
    if (near && near->size() > 2 && !differentiated &&
        as_product(word).find(*near) == std::string::npos)
      throw(place != nullptr ? *place : formula_)
          .error("unknown name '" + word + "'", "did you mean " + *near + "?");
    throw(place != nullptr ? *place : formula_)
        .error(word + " is read as one name",
               "write " + (shown ? instead : as_product(word) + " for " + word) +
                   (differentiated
                        ? "; if it is one name: --unknown " + word + " (in a file unknown = \"" +
                              word + "\")"
                        : "; if it is one name: --parameter " + word + ", or --variable " + word));
  }

private:
  const Expression& formula_;
  std::vector<std::string> declared_;
  std::set<std::string> words_;
  std::string unknown_;
};

} // namespace

std::vector<Expression> formulas(const EquationText& text) {
  std::vector<Expression> all;
  for (const auto* e : {&text.r, &text.p, &text.q, &text.ode})
    if (*e) all.push_back(**e);
  if (text.change && text.change->nonzero) all.push_back(*text.change->nonzero);
  for (const Divisor& d : text.divisors)
    all.push_back(d.formula);
  for (const auto* list : {&text.zero, &text.nonzero})
    all.insert(all.end(), list->begin(), list->end());
  return all;
}

std::vector<Expression> divisors_in(const Expression& e) {
  std::vector<Expression> all;
  const auto take = [&](const Expression& d) {
    if (d.kind() != Expression::Kind::number) all.push_back(d);
  };
  if (e.kind() == Expression::Kind::quotient) take(e.operand(1));
  if (e.kind() == Expression::Kind::power)
    if (const auto n = as_rational(e.operand(1)); n && sign(*n) < 0) take(e.operand(0));
  for (const Expression& x : e.operands())
    std::ranges::move(divisors_in(x), std::back_inserter(all));
  return all;
}

namespace {

// Which of the three forms; an error for none and for two.
GivenEquation::Form form_of(const EquationText& text) {
  const auto refuse = [](const Expression& e, const std::string& message) {
    throw e.error(message, "give r, or p and q, or one whole equation");
  };
  if (text.r) {
    if (text.ode) refuse(*text.ode, "both r and an equation are given");
    if (text.p) refuse(*text.p, "both r and p are given");
    if (text.q) refuse(*text.q, "both r and q are given");
    return GivenEquation::Form::r;
  }
  if (text.ode) {
    if (text.p) refuse(*text.p, "both an equation and p are given");
    if (text.q) refuse(*text.q, "both an equation and q are given");
    return GivenEquation::Form::ode;
  }
  if (text.p && !text.q)
    throw text.p->error("p is given without q", "y'' + p y' + q y = 0 needs both");
  if (text.q && !text.p)
    throw text.q->error("q is given without p", "write p = 0 if there is none");
  if (!text.p) throw InvalidArgument("an equation needs r, or p and q, or its whole text");
  return GivenEquation::Form::pq;
}

const char* message_of_zero(const Divisor& d) {
  return d.by == Divisor::By::order       ? "the coefficient of the second derivative is zero"
         : d.by == Divisor::By::reduction ? "the reduction to a linear equation divides by this, "
                                            "which is zero"
                                          : "division by zero";
}

class EquationReader {
public:
  EquationReader(const EquationText& text, const Budget& budget)
      : text_(text), budget_(budget), formulas_(formulas(text)) {
    result_.form = form_of(text);
  }

  EquationNames names() {
    define_constants();
    find_names();
    return {result_.variable, result_.unknown};
  }

  GivenEquation read() {
    names();
    refuse_unknown_names();
    refuse_free_parameters();
    constants_.reserve(result_.variable);
    if (text_.ode) constants_.reserve(result_.unknown);
    constants_.gather(formulas_);
    reduce();
    if (!constants_.field()->is_rational()) {
      result_.constant = constants_.field()->letter();
      result_.constant_meaning = constants_.definition();
    }
    return std::move(result_);
  }

private:
  void define_constants() {
    for (const std::string& name : text_.parameters)
      constants_.reserve(name);
    if (text_.minpoly) {
      const std::vector<std::string> names = names_in(*text_.minpoly);
      if (names.size() != 1)
        throw text_.minpoly->error("a polynomial in the name of one constant is expected",
                                   "write e.g. a^2 - 2");
      constants_.define_root(names.front(), *text_.minpoly);
    }
    for (const auto& [name, value] : text_.set) {
      if (name == "I") throw value.error("I is the imaginary unit and cannot be set");
      if (constants_.is_defined(name)) throw value.error("'" + name + "' has a value already");
      constants_.define_value(name, value);
    }
    const auto known = settable_names(text_);
    for (const auto& [name, value] : text_.set)
      if (!std::ranges::binary_search(known, name)) throw unknown(name, value, known);
  }

  static InputError unknown(const std::string& name, const Expression& value,
                            const std::vector<std::string>& known) {
    const auto near = nearest(name, known);
    return value.error("'" + name + "' gets a value but does not occur in the equation",
                       near            ? "did you mean " + *near + "?"
                       : known.empty() ? "it has no names"
                                       : "its names: " + enumerate(known));
  }

  // Names that stand for nothing that is known so far: the variable, the parameters, mistakes.
  [[nodiscard]] std::vector<std::string> open_names() const {
    std::set<std::string> names;
    for (const Expression& e : formulas_)
      for (const std::string& name : names_in(e))
        if (name != "I" && !constants_.is_defined(name) && !is_parameter(name) &&
            !(text_.ode && name == result_.unknown))
          names.insert(name);
    return {names.begin(), names.end()};
  }

  [[nodiscard]] bool is_parameter(const std::string& name) const {
    return is_among(name, text_.parameters);
  }

  void find_names() {
    result_.variable = text_.variable;
    refuse_words(text_);
    if (text_.ode) {
      const OdeNames names = ode_names(*text_.ode, text_.unknown);
      result_.unknown = names.unknown;
      if (result_.variable.empty()) result_.variable = names.variable;
    }
    if (result_.variable.empty()) result_.variable = inferred_variable();
    const Expression& first = formulas_.front();
    if (!is_identifier(result_.variable))
      throw first.error("'" + result_.variable + "' cannot be the name of a variable",
                        "a name has letters, digits and _ only");
    if (result_.variable == "I" || constants_.is_defined(result_.variable))
      throw first.error("'" + result_.variable + "' is a constant and cannot be the variable");
    if (is_parameter(result_.variable))
      throw first.error("'" + result_.variable + "' is both the variable and a parameter");
    if (text_.ode && result_.unknown == result_.variable)
      throw first.error("'" + result_.unknown + "' is both the unknown function and the variable");
  }

  [[nodiscard]] std::string inferred_variable() const {
    std::vector<std::string> names = open_names();
    for (const std::string& name : names)
      if (is_constant_of_mathematics(name)) throw constant_of_mathematics(name);
    if (names.empty()) return text_.ode ? unnamed_variable(text_, result_.unknown) : "z";
    const bool has_z = is_among("z", names);
    if (!text_.infer_variable || has_z) return "z";
    std::erase_if(names, [](const std::string& n) { return n == "Pi" || n == "i"; }); // an error
    if (names.empty()) return "z";
    if (names.size() == 1 && !is_usual_variable(names.front(), text_.ode ? result_.unknown : ""))
      throw variable_or_constant(formulas_.front(), names.front());
    if (names.size() == 1) return names.front();
    throw formulas_.front().error("which of " + enumerate(names) + " is the variable?",
                                  other_names(names));
  }

  [[nodiscard]] InputError constant_of_mathematics(const std::string& name) const {
    const Expression* place = nullptr;
    for (const Expression& e : formulas_)
      if (place == nullptr) place = find_name(e, name);
    return (place != nullptr ? *place : formulas_.front())
        .error(name + " is a constant, and constants are algebraic numbers here",
               "with --parameter " + name + " the answer is for all of its values" +
                   (name == "e" ? "; the exponential function is exp(x)" : ""));
  }

  // A hint what to write for the names that are not the variable.
  static std::string other_names(std::vector<std::string> names) {
    for (const char* usual : {"x", "t", "s"}) {
      const auto x = std::ranges::find(names, usual);
      if (x == names.end()) continue;
      names.erase(x);
      std::string flags, list;
      for (const std::string& name : names) {
        flags += " --parameter " + name;
        list += (list.empty() ? "\"" : ", \"") + name + "\"";
      }
      return "if it is " + std::string(usual) + ", write" + flags + " (in a file parameters = [" +
             list + "]), or give values: --set " + names.front() +
             "=...; otherwise name it: --variable";
    }
    return "say it with --variable (or variable = \"...\" in a file); each other name is a "
           "parameter (--parameter NAME) or has a value (--set)";
  }

  // Several at once; one alone has a message with its place.
  void refuse_unknown_names() const {
    std::vector<std::string> names = open_names();
    std::erase(names, result_.variable);
    if (names.size() > 1) throw unknown_names(formulas_.front(), names, result_.variable);
  }

  void refuse_free_parameters() const {
    std::set<std::string> free;
    for (const Expression& e : formulas_)
      for (const std::string& name : names_in(e))
        if (is_parameter(name) && !constants_.is_defined(name)) free.insert(name);
    if (!free.empty()) throw FreeParameters({free.begin(), free.end()});
  }

  void reduce() {
    const Reading reading{
        .variable = result_.variable, .constants = &constants_, .budget = budget_};
    for (const Divisor& d : text_.divisors)
      if (is_zero(rational_function(d.formula, reading))) throw d.formula.error(message_of_zero(d));
    if (text_.r) {
      result_.normal_form.r = rational_function(*text_.r, reading);
      result_.p = RationalFunction(coerce(Poly(0), constants_.field()));
      result_.q = -result_.normal_form.r;
      result_.normal_form.p = result_.p;
      return;
    }
    if (text_.ode) {
      const SecondOrder ode = second_order(*text_.ode, result_.unknown, reading);
      result_.p = ode.p;
      result_.q = ode.q;
    } else {
      result_.p = rational_function(*text_.p, reading);
      result_.q = rational_function(*text_.q, reading);
    }
    budget_.check_degree(2 * std::max(degree(result_.p.num()), degree(result_.p.den())) +
                         std::max(degree(result_.q.num()), degree(result_.q.den())));
    result_.normal_form = normal_form(result_.p, result_.q);
  }

  const EquationText& text_;
  const Budget& budget_;
  std::vector<Expression> formulas_;
  Constants constants_;
  GivenEquation result_;
};

} // namespace

FreeParameters::FreeParameters(std::vector<std::string> names, const std::string& why)
    : Error("free parameters: " + enumerate(names) + (why.empty() ? "" : "; " + why)),
      names_(std::move(names)) {}

InputError unknown_names(const Expression& at, const std::vector<std::string>& names,
                         const std::string& variable) {
  std::string flags;
  for (const std::string& name : names)
    flags += " --parameter " + name;
  return at.error("unknown names " + enumerate(names),
                  "the variable is " + variable + "; if they are parameters write" + flags +
                      ", or give them values: --set " + names.front() + "=...");
}

void check_names(const EquationText& text) {
  for (const std::string& name : text.parameters)
    if (!is_identifier(name) || name == "I")
      throw InputError("parameters", 0, 0, 1,
                       "'" + printable(name) + "' cannot be the name of a parameter",
                       "a name has letters, digits and _ only; I is the imaginary unit");
}

void refuse_words(const EquationText& text) {
  if (text.ode && !differentiates(*text.ode)) return; // which has a message of its own
  for (const Expression& e : formulas(text))
    Words(e, text).refuse();
}

EquationNames equation_names(const EquationText& text) {
  const Budget budget;
  return EquationReader(text, budget).names();
}

std::vector<std::string> settable_names(const EquationText& text) {
  std::set<std::string> names(text.parameters.begin(), text.parameters.end());
  const auto take = [&](const Expression& e) {
    for (const std::string& name : names_in(e))
      if (name != "I") names.insert(name);
  };
  for (const Expression& e : formulas(text))
    take(e);
  if (text.minpoly) take(*text.minpoly);
  for (const auto& [name, value] : text.set)
    take(value);
  names.insert(text.names.begin(), text.names.end());
  return {names.begin(), names.end()};
}

GivenEquation read_equation(const EquationText& text, const Budget& budget) {
  return EquationReader(text, budget).read();
}

} // namespace kov
