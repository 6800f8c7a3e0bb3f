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

bool is_name(const Token& t, std::string_view name) {
  return t.kind == TokenKind::name && t.text == name;
}

bool adjacent(const Token& a, const Token& b) {
  return a.span.offset + a.span.length == b.span.offset;
}

// A number of at most three digits.
std::optional<long> small_number(const Token& t) {
  if (t.kind != TokenKind::number || t.text.size() > 3) return std::nullopt;
  return std::stol(std::string(t.text));
}

/// One pass over the tokens, from left to right.
class Translation {
public:
  Translation(std::string_view text, const OriginPtr& origin) : source_(text, origin) {
    source_.foreign_signs = true;
    source_.decimals_allowed = 1; // the reader refuses them where they do not belong
    for (Token t = source_.next();; t = source_.next()) {
      in_.push_back(t);
      if (t.kind == TokenKind::end) break;
    }
    if (const auto wrong = wrong_bracket(in_, origin)) throw InputError(*wrong);
    unwrap();
    look_for_brackets();
  }
  Translation(std::vector<Token> tokens, std::string_view text, const OriginPtr& origin)
      : source_(text, origin), in_(std::move(tokens)) {
    look_for_brackets();
  }

  TokenList tokens() {
    while (at_ + 1 < in_.size())
      step();
    out_.push_back(in_.back());
    return {std::move(out_), std::move(texts_)};
  }

private:
  enum class Group : std::uint8_t { plain, derivative, fraction, equation };
  struct WrittenDerivative {
    Token variable;
    long order;
    std::size_t end; // of its closing parenthesis
  };

  [[nodiscard]] const Token& peek(std::size_t ahead) const {
    return in_[std::min(at_ + ahead, in_.size() - 1)];
  }
  [[nodiscard]] bool opens(std::size_t ahead) const {
    return peek(ahead).is("(") || peek(ahead).is("[");
  }
  [[nodiscard]] bool closes(std::size_t ahead) const {
    return peek(ahead).is(")") || peek(ahead).is("]");
  }

  void push(const Token& at, TokenKind kind, std::string_view text) {
    out_.push_back({.kind = kind, .span = at.span, .text = text, .after_blank = at.after_blank});
  }
  void sign(const Token& at, std::string_view text) { push(at, TokenKind::sign, text); }
  std::string_view kept(std::string text) { return texts_.emplace_back(std::move(text)); }

  void look_for_brackets() {
    for (std::size_t i = 1; i < in_.size(); ++i)
      brackets_ = brackets_ || (in_[i].is("[") && ends_operand(in_[i - 1]));
  }

  // ---- a whole call of a solver: dsolve(equation, y(x)) is its equation

  [[nodiscard]] static bool is_solver(const Token& t) {
    static constexpr std::array<std::string_view, 6> solvers{
        "dsolve", "DSolve", "desolve", "ode2", "contrib_ode", "kovacicsols"};
    return t.kind == TokenKind::name && is_among(t.text, solvers);
  }

  // The parenthesis that opens its arguments, also those of DEtools[kovacicsols]; 0: another text.
  [[nodiscard]] std::size_t arguments_of_solver() const {
    const bool in_package = peek(1).is("[") && is_solver(peek(2)) && peek(3).is("]");
    const std::size_t at = in_package ? 4 : is_solver(peek(0)) ? 1 : 0;
    return at > 0 && opens(at) ? at : 0;
  }

  void unwrap() {
    drop_statement_end();
    const std::size_t open = arguments_of_solver();
    if (open == 0) return;
    std::vector<std::size_t> commas;
    std::size_t close = open;
    for (long depth = 0; close + 1 < in_.size(); ++close) {
      const Token& t = in_[close];
      depth += opening(t) - closing(t);
      if (depth == 0) break;
      if (t.is(",") && depth == 1) commas.push_back(close);
      if (t.is(",") && depth == 2 && in_[open + 1].is("{") && commas.empty()) refuse_values(t);
    }
    if (close + 2 != in_.size()) return; // something follows: no call by itself
    commas.push_back(close);
    for (std::size_t i = 0; i + 1 < commas.size(); ++i)
      check_argument(commas[i] + 1, commas[i + 1]);
    in_.erase(in_.begin() + static_cast<std::ptrdiff_t>(commas.front()), in_.end() - 1);
    in_.erase(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(open) + 1);
  }

  // y   y(x)   y[x]   x   [y, x]   option = ...; nothing that restricts the solutions
  void check_argument(std::size_t from, std::size_t to) const {
    const bool option = from + 1 < to && in_[from].kind == TokenKind::name &&
                        in_[from + 1].is("=") && in_[from].text != "ics";
    for (std::size_t i = from; i < to && !option; ++i)
      if (in_[i].kind != TokenKind::name && !in_[i].is(",") && !opening(in_[i]) && !closing(in_[i]))
        refuse_values(in_[from]);
  }
  [[noreturn]] void refuse_values(const Token& at) const {
    throw source_.error(at.span, "initial values have no place here",
                        "the answer is about all solutions: give the equation alone");
  }

  static bool opening(const Token& t) { return t.is("(") || t.is("[") || t.is("{"); }
  static bool closing(const Token& t) { return t.is(")") || t.is("]") || t.is("}"); }

  // Maple's and Maxima's ; and Maxima's $
  void drop_statement_end() {
    if (in_.size() < 2) return;
    const Token& last = in_[in_.size() - 2];
    if (last.is(";") || last.is("$")) in_.erase(in_.end() - 2);
  }

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
    if (t.is("(") && power_of_d()) return;
    bracket_or_sign();
  }

  void bracket_or_sign() {
    const Token& t = in_[at_];
    if (t.is(",") && !groups_.empty() && comma()) return;
    if (t.is("(") || t.is("[") || t.is("{")) {
      groups_.push_back(Group::plain);
      sign(t, "(");
    } else if (t.is(")") || t.is("]") || t.is("}")) {
      if (!groups_.empty()) groups_.pop_back();
      sign(t, ")");
    } else {
      refuse_foreign(t);
      out_.push_back(t);
    }
    ++at_;
  }

  // Refuses a sign that no rule has used.
  void refuse_foreign(const Token& t) const {
    if (t.kind == TokenKind::sign &&
        std::string_view("%.$@;").find(t.text) != std::string_view::npos)
      throw source_.error(t.span, "unexpected " + quoted(t.text));
  }

  [[nodiscard]] bool after_operand() const {
    return at_ > 0 && (in_[at_ - 1].kind == TokenKind::number || ends_operand(in_[at_ - 1]));
  }
  static bool ends_operand(const Token& t) {
    return t.kind == TokenKind::name || t.is(")") || t.is("]") || t.is("'");
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
    if (!is_name(n, "i") && !is_name(n, "I")) return false;
    push(n, TokenKind::name, "I");
    at_ += 2;
    return true;
  }

  // Maxima's 'diff: a derivative that is not carried out
  bool noun() {
    if (after_operand() || !is_name(peek(1), "diff")) return false;
    ++at_;
    return true;
  }

  void name() {
    const Token t = in_[at_];
    if (derivative_of_mathematica() || d_of_maple()) return;
    const bool d = brackets_ && t.text == "D";
    if ((d || t.text == "diff" || t.text == "Diff" || t.text == "Derivative" ||
         t.text == "derivative") &&
        opens(1))
      return open(t, "diff", Group::derivative);
    if (t.text == "Rational" && opens(1)) return open(t, "", Group::fraction);
    if (t.text == "Eq" && opens(1)) return open(t, "", Group::equation);
    if (number_of_sympy()) return;
    out_.push_back(t);
    if (brackets_ && t.text == "Sqrt") out_.back().text = "sqrt";
    ++at_;
  }

  // S(3), Integer(3), S.Half
  bool number_of_sympy() {
    const Token t = in_[at_];
    if (t.text == "S" && peek(1).is(".") && is_name(peek(2), "Half")) {
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
      if (const auto d = derivation(at_ + 1)) {
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

  // The arguments after the first one of diff: x, x   x, 2   x$2   (x, 2)   {x, 2}   [x$2]
  [[nodiscard]] std::optional<WrittenDerivative> derivation(std::size_t at) const {
    WrittenDerivative d{.variable = {}, .order = 0, .end = at};
    const auto token = [&](std::size_t i) { return in_[std::min(i, in_.size() - 1)]; };
    for (;; ++at) {
      const bool pair = opening(token(at));
      if (pair) ++at;
      const Token v = token(at++);
      if (v.kind != TokenKind::name || (d.order > 0 && v.text != d.variable.text))
        return std::nullopt;
      d.variable = v;
      const bool counted = token(at).is("$") || token(at).is(",");
      const auto count = counted ? small_number(token(at + 1)) : std::nullopt;
      if (count) at += 2;
      if (pair && (!count || !closing(token(at)))) return std::nullopt;
      if (pair) ++at;
      d.order += count.value_or(1);
      d.end = at;
      if (d.order > max_order) return std::nullopt;
      if (token(at).is(")") || token(at).is("]")) return d;
      if (!token(at).is(",")) return std::nullopt;
    }
  }

  void by(const Token& comma, const WrittenDerivative& d) {
    sign(comma, ",");
    out_.push_back(d.variable);
    if (d.order != 1) {
      sign(d.variable, ",");
      push(d.variable, TokenKind::number, kept(std::to_string(d.order)));
    }
    at_ = d.end;
  }

  // Derivative[2][y]; [x] follows as the argument
  bool derivative_of_mathematica() {
    if (!is_name(in_[at_], "Derivative") || !opens(1) || !closes(3) || !opens(4) || !closes(6))
      return false;
    const auto order = small_number(peek(2));
    if (!order || *order > max_order || peek(5).kind != TokenKind::name) return false;
    primes(peek(5), *order);
    at_ += 7;
    return true;
  }

  void primes(const Token& function, long order) {
    out_.push_back(function);
    for (; order > 0; --order)
      sign(function, "'");
  }

  // D(y), D(D(y)), where (x) follows
  bool d_of_maple() {
    long order = 0;
    std::size_t ahead = 0;
    for (; order <= max_order && is_name(peek(ahead), "D") && peek(ahead + 1).is("("); ahead += 2)
      ++order;
    if (order == 0 || peek(ahead).kind != TokenKind::name) return false;
    const Token function = peek(ahead++);
    for (long i = 0; i < order; ++i)
      if (!peek(ahead++).is(")")) return false;
    if (!peek(ahead).is("(")) return false;
    primes(function, order);
    at_ += ahead;
    return true;
  }

  // (D@@2)(y)
  bool power_of_d() {
    const auto order = small_number(peek(4));
    if (!is_name(peek(1), "D") || !peek(2).is("@") || !peek(3).is("@") || !order ||
        *order > max_order || !peek(5).is(")") || !peek(6).is("(") ||
        peek(7).kind != TokenKind::name || !peek(8).is(")"))
      return false;
    primes(peek(7), *order);
    at_ += 9;
    return true;
  }

  // y(x).diff(x, 2): the function is what was written last
  bool method() {
    if (!is_name(peek(1), "diff") || !peek(2).is("(") || out_.empty()) return false;
    const auto d = derivation(at_ + 3);
    if (!d || ++methods_ > max_methods) return false;
    const auto begin = start_of_operand();
    const Token dot = in_[at_];
    const std::array<Token, 2> head{Token{TokenKind::name, dot.span, "diff"},
                                    Token{TokenKind::sign, dot.span, "("}};
    out_.insert(out_.begin() + begin, head.begin(), head.end());
    groups_.push_back(Group::plain);
    by(dot, *d);
    return true;
  }

  [[nodiscard]] std::ptrdiff_t start_of_operand() const {
    auto i = static_cast<std::ptrdiff_t>(out_.size()) - 1;
    const auto token = [&](std::ptrdiff_t at) { return out_[static_cast<std::size_t>(at)]; };
    if (!token(i).is(")")) return i;
    for (long depth = 0; i > 0; --i) {
      depth += token(i).is(")") - token(i).is("(");
      if (depth == 0) break;
    }
    return i > 0 && token(i - 1).kind == TokenKind::name ? i - 1 : i;
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
  return Translation(text, origin).tokens();
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
