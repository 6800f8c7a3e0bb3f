#include "symbol/notations.hpp"

#include "exact/lists.hpp"
#include "symbol/operators.hpp"
#include "symbol/tokens.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>

namespace kov {
namespace {

constexpr long max_order = 20;   // higher derivatives are left to the reader's own message
constexpr int max_methods = 200; // each y(x).diff(...) is a search backwards

bool adjacent(const Token& a, const Token& b) {
  return a.span.offset + a.span.length == b.span.offset;
}

// A number of at most three digits.
std::optional<long> small_number(const Token& t) {
  if (t.kind != TokenKind::number || t.text.size() > 3) return std::nullopt;
  return std::stol(std::string(t.text));
}

const Token& token(const std::vector<Token>& all, std::size_t i) {
  return all[std::min(i, all.size() - 1)];
}

bool ends_operand(const Token& t) {
  return t.kind == TokenKind::name || t.is(")") || t.is("]") || t.is("'");
}
bool opens_list(const Token& t) { return opens(t) && !t.is("{"); }
bool closes_list(const Token& t) { return closes(t) && !t.is("}"); }

bool has_arguments_in_brackets(const std::vector<Token>& all) {
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].is("[") && ends_operand(all[i - 1])) return true;
  return false;
}

// ---- a whole call of a solver: dsolve(equation, y(x)) is its equation

bool is_equation_solver(const Token& t) {
  static constexpr std::array<std::string_view, 6> solvers{"dsolve", "DSolve",      "desolve",
                                                           "ode2",   "contrib_ode", "kovacicsols"};
  return t.kind == TokenKind::name && is_among(t.text, solvers);
}

// The parenthesis that opens its arguments, also those of DEtools[kovacicsols]; 0: another text.
std::size_t arguments_of_solver(const std::vector<Token>& all) {
  const bool in_package =
      token(all, 1).is("[") && is_equation_solver(token(all, 2)) && token(all, 3).is("]");
  const std::size_t at = in_package ? 4 : is_equation_solver(token(all, 0)) ? 1 : 0;
  return at > 0 && opens_list(token(all, at)) ? at : 0;
}

[[noreturn]] void refuse_values(const Token& at, const Tokens& source) {
  throw source.error(at.span, "initial values have no place here",
                     "the answer is about all solutions: give the equation alone");
}

// y   y(x)   y[x]   x   [y, x]   option = ...; nothing that restricts the solutions
void check_argument(const std::vector<Token>& all, std::size_t from, std::size_t to,
                    const Tokens& source) {
  const bool option = from + 1 < to && all[from].kind == TokenKind::name && all[from + 1].is("=") &&
                      all[from].text != "ics";
  for (std::size_t i = from; i < to && !option; ++i)
    if (all[i].kind != TokenKind::name && !all[i].is(",") && !opens(all[i]) && !closes(all[i]))
      refuse_values(all[from], source);
}

// The equation alone; without Maple's and Maxima's ; and Maxima's $ at the end.
void unwrap(std::vector<Token>& all, const Tokens& source) {
  if (all.size() >= 2 && (all[all.size() - 2].is(";") || all[all.size() - 2].is("$")))
    all.erase(all.end() - 2);
  const std::size_t open = arguments_of_solver(all);
  if (open == 0) return;
  std::vector<std::size_t> commas;
  std::size_t close = open;
  for (long depth = 0; close + 1 < all.size(); ++close) {
    const Token& t = all[close];
    depth += opens(t) - closes(t);
    if (depth == 0) break;
    if (t.is(",") && depth == 1) commas.push_back(close);
    if (t.is(",") && depth == 2 && all[open + 1].is("{") && commas.empty())
      refuse_values(t, source);
  }
  if (close + 2 != all.size()) return; // something follows: no call by itself
  commas.push_back(close);
  for (std::size_t i = 0; i + 1 < commas.size(); ++i)
    check_argument(all, commas[i] + 1, commas[i + 1], source);
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(commas.front()), all.end() - 1);
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(open) + 1);
}

// Refuses a sign that no rule has used.
void refuse_foreign(const Token& t, const Tokens& source) {
  if (t.kind == TokenKind::sign && std::string_view("%.$@;").find(t.text) != std::string_view::npos)
    throw source.error(t.span, "unexpected " + quoted(t.text));
}

// ---- derivatives

struct WrittenDerivative {
  Token variable;
  long order = 0;
  std::size_t end = 0; // of its closing parenthesis
};

// The arguments after the first one of diff: x, x   x, 2   x$2   (x, 2)   {x, 2}   [x$2]
std::optional<WrittenDerivative> derivation(const std::vector<Token>& all, std::size_t at) {
  WrittenDerivative d;
  for (;; ++at) {
    const bool pair = opens(token(all, at));
    if (pair) ++at;
    const Token v = token(all, at++);
    if (v.kind != TokenKind::name || (d.order > 0 && v.text != d.variable.text))
      return std::nullopt;
    d.variable = v;
    const bool counted = token(all, at).is("$") || token(all, at).is(",");
    const auto count = counted ? small_number(token(all, at + 1)) : std::nullopt;
    if (count) at += 2;
    if (pair && (!count || !closes(token(all, at)))) return std::nullopt;
    if (pair) ++at;
    d.order += count.value_or(1);
    d.end = at;
    if (d.order > max_order) return std::nullopt;
    if (closes_list(token(all, at))) return d;
    if (!token(all, at).is(",")) return std::nullopt;
  }
}

struct PrimedFunction {
  Token function;
  long order;
  std::size_t length; // of its tokens
};

// Derivative[2][y], (D@@2)(y), D(D(y)), where the argument follows
std::optional<PrimedFunction> primed_function(const std::vector<Token>& all, std::size_t at) {
  const auto peek = [&](std::size_t ahead) { return token(all, at + ahead); };
  const auto primed = [](const Token& function, std::optional<long> order, std::size_t length) {
    return function.kind == TokenKind::name && order && *order <= max_order
               ? std::optional(PrimedFunction{function, *order, length})
               : std::nullopt;
  };
  if (is_named(peek(0), "Derivative") && opens_list(peek(1)) && closes_list(peek(3)) &&
      opens_list(peek(4)) && closes_list(peek(6)))
    return primed(peek(5), small_number(peek(2)), 7);
  if (peek(0).is("(") && is_named(peek(1), "D") && peek(2).is("@") && peek(3).is("@") &&
      peek(5).is(")") && peek(6).is("(") && peek(8).is(")"))
    return primed(peek(7), small_number(peek(4)), 9);
  long order = 0;
  std::size_t ahead = 0;
  for (; order <= max_order && is_named(peek(ahead), "D") && peek(ahead + 1).is("("); ahead += 2)
    ++order;
  if (order == 0) return std::nullopt;
  const Token function = peek(ahead++);
  for (long i = 0; i < order; ++i)
    if (!peek(ahead++).is(")")) return std::nullopt;
  if (function.kind != TokenKind::name || !peek(ahead).is("(")) return std::nullopt;
  return PrimedFunction{function, order, ahead};
}

std::size_t start_of_operand(const std::vector<Token>& all) {
  if (!all.back().is(")")) return all.size() - 1;
  const std::size_t open = opening_of(all, all.size() - 1);
  return open > 0 && all[open - 1].kind == TokenKind::name ? open - 1 : open;
}

/// One pass over the tokens, from left to right.
class Translation {
public:
  Translation(std::vector<Token> tokens, std::string_view text, const OriginPtr& origin)
      : source_(text, origin), in_(std::move(tokens)), brackets_(has_arguments_in_brackets(in_)) {}

  TokenList tokens() {
    while (at_ + 1 < in_.size())
      step();
    out_.push_back(in_.back());
    return {std::move(out_), std::move(texts_)};
  }

private:
  enum class Group : std::uint8_t { plain, derivative, fraction, equation };
  [[nodiscard]] const Token& peek(std::size_t ahead) const { return token(in_, at_ + ahead); }
  void push(const Token& at, TokenKind kind, std::string_view text) {
    out_.push_back(made(at, kind, text));
  }
  void sign(const Token& at, std::string_view text) { push(at, TokenKind::sign, text); }

  void step() {
    const Token& t = in_[at_];
    product_by_juxtaposition();
    if (t.kind == TokenKind::name) return name();
    if (t.is("%") && constant()) return;
    if (t.is("'") && noun()) return;
    if (t.is(".") && method()) return;
    if (t.is("=") && peek(1).is("=") && adjacent(t, peek(1))) {
      sign(t, "=");
      at_ += 2;
      return;
    }
    if (t.is("(") && primed()) return;
    bracket_or_sign();
  }

  void bracket_or_sign() {
    const Token& t = in_[at_];
    if (t.is(",") && !groups_.empty() && comma()) return;
    if (opens(t)) {
      groups_.push_back(Group::plain);
      sign(t, "(");
    } else if (closes(t)) {
      if (!groups_.empty()) groups_.pop_back();
      sign(t, ")");
    } else {
      refuse_foreign(t, source_);
      out_.push_back(t);
    }
    ++at_;
  }

  [[nodiscard]] bool after_operand() const {
    return at_ > 0 && (in_[at_ - 1].kind == TokenKind::number || ends_operand(in_[at_ - 1]));
  }
  // In Mathematica's notation arguments stand in brackets, so that x (x + 1) and 2 x are products.
  void product_by_juxtaposition() {
    const Token& t = in_[at_];
    const bool starts = t.kind == TokenKind::number || t.kind == TokenKind::name || t.is("(");
    if (!brackets_ || !starts || !after_operand()) return;
    const Token& before = in_[at_ - 1];
    if (t.is("(") && adjacent(before, t) && (before.kind == TokenKind::name || before.is("'")))
      throw source_.error(t.span, "brackets and parentheses are mixed",
                          "in Mathematica's notation the argument of a function stands in [ ], and "
                          "a product is written with * or a blank");
    sign({.kind = TokenKind::sign, .span = make_span(t.span.offset, t.span.offset), .text = {}},
         "*");
  }

  // Maxima's %i
  bool constant() {
    const Token& n = peek(1);
    if (!is_named(n, "i") && !is_named(n, "I")) return false;
    push(n, TokenKind::name, "I");
    at_ += 2;
    return true;
  }

  // Maxima's 'diff: a derivative that is not carried out
  bool noun() {
    if (after_operand() || !is_named(peek(1), "diff")) return false;
    ++at_;
    return true;
  }

  void name() {
    const Token t = in_[at_];
    if (primed()) return;
    const bool d = brackets_ && t.text == "D";
    if ((d || t.text == "diff" || t.text == "Diff" || t.text == "Derivative" ||
         t.text == "derivative") &&
        opens_list(peek(1)))
      return open(t, "diff", Group::derivative);
    if (t.text == "Rational" && opens_list(peek(1))) return open(t, "", Group::fraction);
    if (t.text == "Eq" && opens_list(peek(1))) return open(t, "", Group::equation);
    if (number_of_sympy()) return;
    out_.push_back(t);
    if (brackets_ && t.text == "Sqrt") out_.back().text = "sqrt";
    ++at_;
  }

  // S(3), Integer(3), S.Half
  bool number_of_sympy() {
    const Token t = in_[at_];
    if (t.text == "S" && peek(1).is(".") && is_named(peek(2), "Half")) {
      for (const auto& [kind, text] :
           {std::pair{TokenKind::sign, "("}, std::pair{TokenKind::number, "1"},
            std::pair{TokenKind::sign, "/"}, std::pair{TokenKind::number, "2"},
            std::pair{TokenKind::sign, ")"}})
        push(t, kind, text);
      at_ += 3;
      return true;
    }
    const bool number = peek(2).kind == TokenKind::number || peek(2).is("-");
    if ((t.text != "S" && t.text != "Integer") || !peek(1).is("(") || !number) return false;
    open(t, "", Group::plain);
    return true;
  }

  void open(const Token& t, std::string_view function, Group group) {
    if (!function.empty()) push(t, TokenKind::name, function);
    sign(peek(1), "(");
    groups_.push_back(group);
    at_ += 2;
  }

  // The comma that ends the first argument.
  bool comma() {
    const Token& t = in_[at_];
    switch (groups_.back()) {
    case Group::plain:
      return false;
    case Group::derivative:
      if (const auto d = derivation(in_, at_ + 1)) {
        ++at_;
        by(t, *d);
        return true;
      }
      groups_.back() = Group::plain; // the reader says what is wrong
      return false;
    case Group::fraction:
      sign(t, "/");
      break;
    case Group::equation:
      sign(t, "=");
      break;
    }
    groups_.back() = Group::plain;
    ++at_;
    return true;
  }

  void by(const Token& comma, const WrittenDerivative& d) {
    sign(comma, ",");
    out_.push_back(d.variable);
    if (d.order != 1) {
      sign(d.variable, ",");
      push(d.variable, TokenKind::number, texts_.emplace_back(std::to_string(d.order)));
    }
    at_ = d.end;
  }

  bool primed() {
    const auto f = primed_function(in_, at_);
    if (!f) return false;
    out_.push_back(f->function);
    for (long order = f->order; order > 0; --order)
      sign(f->function, "'");
    at_ += f->length;
    return true;
  }

  // y(x).diff(x, 2): the function is what was written last
  bool method() {
    if (!is_named(peek(1), "diff") || !peek(2).is("(") || out_.empty()) return false;
    const auto d = derivation(in_, at_ + 3);
    if (!d || ++methods_ > max_methods) return false;
    const auto begin = start_of_operand(out_);
    const Token dot = in_[at_];
    const std::array<Token, 2> head{Token{TokenKind::name, dot.span, "diff"},
                                    Token{TokenKind::sign, dot.span, "("}};
    out_.insert(out_.begin() + static_cast<std::ptrdiff_t>(begin), head.begin(), head.end());
    groups_.push_back(Group::plain);
    by(dot, *d);
    return true;
  }

  Tokens source_;
  std::vector<Token> in_;
  std::vector<Token> out_;
  std::vector<Group> groups_;     // of the open parentheses
  std::deque<std::string> texts_; // of tokens that stand in no text
  std::size_t at_ = 0;
  bool brackets_ = false;
  int methods_ = 0;
};

// Something that only other programs write, so that our own texts take no second way.
bool is_foreign(std::string_view text) {
  static constexpr std::array<std::string_view, 18> marks{
      "diff(",        "Diff(",       "D(", "Derivative", "derivative(", "Eq(",    "==",
      "Rational(",    "%",           ";",  "$",          "@@",          "solve(", "ode2(",
      "contrib_ode(", "kovacicsols", "S",  "Integer("};
  return text.find('[') != std::string_view::npos ||
         std::ranges::any_of(marks, [&](std::string_view mark) {
           return text.find(mark) != std::string_view::npos;
         });
}

} // namespace

TokenList translated(std::vector<Token> tokens, std::string_view text, const OriginPtr& origin) {
  return Translation(std::move(tokens), text, origin).tokens();
}

TokenList translated(std::string_view text, const OriginPtr& origin) {
  Tokens source(text, origin);
  source.foreign_signs = true;
  source.decimals_allowed = 1; // the reader refuses them where they do not belong
  std::vector<Token> all{source.next()};
  while (all.back().kind != TokenKind::end)
    all.push_back(source.next());
  if (const auto wrong = wrong_bracket(all, origin)) throw InputError(*wrong);
  unwrap(all, source);
  return translated(std::move(all), text, origin);
}

Expression parse_ode(std::string_view text, const OriginPtr& origin, const ParseLimits& limits) {
  const auto read = [&] {
    if (text.size() > limits.max_length || !is_foreign(text))
      return parse_expression(text, origin, true, limits);
    const TokenList list = translated(text, origin);
    return parse_tokens(Tokens(text, origin, list.tokens), limits);
  };
  const Expression e = read();
  const auto d = derivation_in(e);
  return d ? applied(e, *d, limits.max_length / 4) : e;
}

Expression parse_ode(std::string text, const std::string& name) {
  const OriginPtr origin = origin_of_text(name, std::move(text));
  return parse_ode(origin->text, origin);
}

} // namespace kov
