// Factors side by side.

#include "exact/lists.hpp"
#include "symbol/pasted_passes.hpp"
#include "symbol/suggest.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

using List = std::vector<Token>;

bool is_operand_end(const Token& t) {
  return t.kind == TokenKind::number || t.kind == TokenKind::decimal || t.kind == TokenKind::name ||
         t.is(")") || t.is("'");
}
bool is_operand_start(const Token& t) {
  return t.kind == TokenKind::number || t.kind == TokenKind::decimal || t.kind == TokenKind::name ||
         t.is("(");
}

// A word that its notation could not use keeps its own message.
bool is_left_over(std::string_view name) {
  static constexpr std::array<std::string_view, 8> words{
      "D", "Derivative", "derivative", "Eq", "S", "Integer", "Rational", "Subscript"};
  return is_among(name, words);
}

class Products {
public:
  Products(List in, Pasting& p) : in_(std::move(in)), p_(p) {}

  List operator()() {
    for (at_ = 0; at_ < in_.size(); ++at_) {
      const Token& t = in_[at_];
      refuse_unclear_power();
      if (!out_.empty() && is_operand_end(out_.back()) && is_operand_start(t)) between(t);
      out_.push_back(t);
    }
    return std::move(out_);
  }

private:
  [[nodiscard]] std::string shown(std::size_t from, std::size_t to) const {
    const std::string text = text_of(part_of(in_, from, std::min(to, in_.size())));
    return text.size() <= 40 ? text : text.substr(0, 37) + "...";
  }
  [[nodiscard]] bool is_unknown(const Token& t) const {
    return t.kind == TokenKind::name && (p_.unknowns.contains(t.text) || t.text == "diff");
  }
  static Span both(const Token& a, const Token& b) {
    return make_span(a.span.offset, std::max(b.span.offset + b.span.length, a.span.offset + 1));
  }
  // Nothing is written between them.
  static bool touch(const Token& a, const Token& b) {
    return !b.after_blank && a.span.offset + a.span.length >= b.span.offset;
  }

  // y^(2) beside y', and x^1/2
  void refuse_unclear_power() {
    const auto token = [&](std::size_t ahead) -> const Token& {
      return in_[std::min(at_ + ahead, in_.size() - 1)];
    };
    if (!token(1).is("^")) return;
    const std::string base(token(0).text);
    const bool order = is_unknown(token(0)) && token(2).is("(") &&
                       token(3).kind == TokenKind::number && token(4).is(")");
    if (order)
      p_.refuse(both(token(0), token(4)), "a derivative of " + base + ", or a power?",
                "write " + base + "' with as many primes, or " + base + "^" +
                    std::string(token(3).text));
    const bool negative = token(2).is("-") && token(3).kind == TokenKind::number &&
                          token(4).is("/") && token(5).kind == TokenKind::number;
    if (negative) {
      const std::string above(token(3).text), under(token(5).text);
      p_.refuse(both(token(1), token(5)), "where does the exponent end?",
                "write ^(-" + above + "/" + under + "), or ^(-" + above + ")*(1/" + under + ")");
    }
    const bool root = token(2).kind == TokenKind::number && token(2).text == "1" &&
                      token(3).is("/") && token(4).kind == TokenKind::number;
    const std::string below(token(4).text);
    if (root)
      p_.refuse(both(token(1), token(4)), "where does the exponent end?",
                "write ^(1/" + below + "), or ^1*(1/" + below + ")");
  }

  void between(const Token& t) {
    const Token& before = out_.back();
    if (t.is("(") && (before.kind == TokenKind::name || before.is("'"))) return group_after_name(t);
    if (t.kind == TokenKind::number || t.kind == TokenKind::decimal)
      return p_.refuse(both(before, t),
                       before.kind == TokenKind::number ? "two numbers side by side"
                                                        : "a number behind a factor: its exponent?",
                       "write * or ^ between " + std::string(before.text) + " and " +
                           std::string(t.text));
    if (!is_clear_in_exponent(t) || !is_clear_in_quotient(t)) return;
    multiply(t);
  }

  void multiply(const Token& t) {
    out_.push_back(
        {.kind = TokenKind::sign, .span = make_span(t.span.offset, t.span.offset), .text = "*"});
  }

  [[nodiscard]] bool stands_alone(std::string_view name) const {
    for (std::size_t i = 0; i + 1 < in_.size(); ++i)
      if (in_[i].kind == TokenKind::name && in_[i].text == name && !in_[i + 1].is("(") &&
          !in_[i + 1].is("'"))
        return true;
    return false;
  }

  // f(x) is a call, x (1 - x) a product; a(b + c) could be both.
  void group_after_name(const Token& t) {
    const Token name = out_.back();
    const std::size_t close = closing_of(in_, at_);
    const bool single = close == at_ + 2;
    if (name.is("'")) {
      if (t.after_blank && !single) multiply(t);
      return;
    }
    if (is_function_word(name.text) || is_left_over(name.text)) return;
    const auto from = in_.begin() + static_cast<long>(at_); // y(1 - y)
    const bool inside_itself = std::any_of(
        from, in_.begin() + static_cast<long>(std::min(close, in_.size())),
        [&](const Token& x) { return x.kind == TokenKind::name && x.text == name.text; });
    if (is_unknown(name) && inside_itself && !single) return multiply(t);
    if (is_unknown(name) && (!t.after_blank || single)) return;
    // n(n + 1): no function of itself, of a declared constant, or of what stands by itself somewhere
    if ((t.after_blank && !single) || inside_itself || p_.names.has(name.text) ||
        stands_alone(name.text)) {
      if (is_clear_in_exponent(t) && is_clear_in_quotient(t)) multiply(t);
      return;
    }
    const std::string inside = shown(at_, close + 1), letter(name.text);
    static const std::vector<std::string> usual{"sqrt", "root", "sin",  "cos", "tan",
                                                "exp",  "sinh", "cosh", "tanh"};
    if (const auto near = letter.size() > 2 ? nearest(letter, usual) : std::nullopt)
      return p_.refuse(name.span, "unknown function '" + letter + "'",
                       "did you mean " + *near + "?");
    p_.refuse(both(name, in_[std::min(close, in_.size() - 1)]),
              "is " + letter + inside + " a product or a function?",
              "a product: " + letter + "*" + inside +
                  "; functions are not known here but sin, cos, exp, sqrt, ...");
  }

  // x^2a
  [[nodiscard]] bool is_clear_in_exponent(const Token& t) const {
    const std::size_t n = out_.size();
    if (n < 3 || out_[n - 1].kind != TokenKind::number || !touch(out_[n - 1], t) || t.is("("))
      return true;
    const bool power = out_[n - 2].is("^") || (out_[n - 2].is("-") && out_[n - 3].is("^"));
    if (!power || is_unknown(t)) return true;
    const Token& base = out_[out_[n - 2].is("^") ? n - 3 : n - 4]; // x^2y of a formula, not e^2x
    if (p_.unknowns.empty() && base.kind == TokenKind::name && base.text != "e") return true;
    const std::string digits(out_[n - 1].text), letter(t.text);
    p_.refuse(both(out_[n - 1], t), "where does the exponent end?",
              "write ^" + digits + "*" + letter + ", or ^(" + digits + "*" + letter + ")");
    return false;
  }

  // The begin of the factor that ends before `end`.
  [[nodiscard]] std::size_t factor_begin(std::size_t end) const {
    std::size_t i = end - 1;
    for (;;) {
      while (out_[i].is("'") && i > 0)
        --i;
      if (out_[i].is(")")) {
        i = opening_of(out_, i);
        if (i > 0 && (out_[i - 1].kind == TokenKind::name || out_[i - 1].is("'"))) --i;
        while (out_[i].is("'") && i > 0)
          --i;
      }
      std::size_t hat = i;
      if (hat > 1 && out_[hat - 1].is("-")) --hat;
      if (hat < 2 || !out_[hat - 1].is("^")) return i;
      i = hat - 2;
    }
  }

  // 1/2x; but 1/x y' with y' in no denominator, 1/4 y with a number before y, and 1/(2 m) x
  [[nodiscard]] bool is_clear_in_quotient(const Token& t) const {
    const std::size_t n = out_.size(), begin = factor_begin(n);
    if (begin < 2 || !out_[begin - 1].is("/") || is_unknown(t)) return true;
    const bool apart = !touch(out_.back(), t);
    const bool fraction = begin + 1 == n && out_[begin].kind == TokenKind::number &&
                          out_[begin - 2].kind == TokenKind::number;
    if (apart && (fraction || out_.back().is(")"))) return true;
    const auto part = [&](std::size_t from, std::size_t to) {
      const std::string text = text_of(part_of(out_, from, to));
      return text.size() <= 24 ? text : std::string("(...)");
    };
    const std::string below = part(begin, n), top = part(factor_begin(begin - 1), begin - 1);
    const std::string next = t.is("(") ? "(...)" : std::string(t.text);
    p_.refuse(both(out_[begin], t), "does " + next + " stand below the line?",
              "write " + top + "/(" + below + "*" + next + "), or (" + top + "/" + below + ")*" +
                  next);
    return false;
  }

  List in_;
  Pasting& p_;
  List out_;
  std::size_t at_ = 0;
};

} // namespace

std::vector<Token> with_products(std::vector<Token> tokens, Pasting& p) {
  return Products(std::move(tokens), p)();
}

std::string text_of(const std::vector<Token>& tokens) {
  std::string text;
  const Token* before = nullptr;
  for (const Token& t : tokens) {
    if (t.kind == TokenKind::end) break;
    const bool operand = before != nullptr && is_operand_end(*before);
    const bool spaced = t.is("=") || ((t.is("+") || t.is("-")) && operand);
    if (spaced)
      text += " " + std::string(t.text) + " ";
    else if (t.is(","))
      text += ", ";
    else
      text += t.text;
    before = &t;
  }
  return text;
}

} // namespace kov
