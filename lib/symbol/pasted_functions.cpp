// Decimals, e^x, RootOf, sin x: what is a number or a call, written in another way.

#include "exact/lists.hpp"
#include "symbol/constants.hpp"
#include "symbol/pasted_passes.hpp"
#include "symbol/rational_form.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace kov {
namespace {

using List = std::vector<Token>;

constexpr std::array<std::string_view, 42> functions{
    "sin",   "cos",   "tan",     "cot",     "sec",    "csc",    "sinh",   "cosh",   "tanh",
    "coth",  "sech",  "csch",    "exp",     "log",    "ln",     "sqrt",   "root",   "RootOf",
    "diff",  "Diff",  "asin",    "acos",    "atan",   "arcsin", "arccos", "arctan", "asinh",
    "acosh", "atanh", "arsinh",  "arcosh",  "artanh", "sn",     "cn",     "dn",     "wp",
    "abs",   "erf",   "besselj", "bessely", "airyai", "airybi"};
constexpr std::size_t elementary = 16; // the first of them: sin x needs no parentheses

std::string lower(std::string_view s) {
  std::string t(s);
  if (!t.empty() && t[0] >= 'A' && t[0] <= 'Z') t[0] = static_cast<char>(t[0] - 'A' + 'a');
  return t;
}

// One root of p, as a text of our own.
List tokens_of_root(const Token& at, const Expression& p, Pasting& pasting) {
  const std::vector<std::string> names = names_in(p);
  if (names.size() != 1)
    throw p.error("a polynomial in one name is expected", "write e.g. RootOf(_Z^2 - 2)");
  Constants field;
  field.define_root(names.front(), p);
  const std::vector<Rational> c = rational_polynomial(p, names.front());
  std::string root = field.definition();
  if (c.size() == 3 && is_zero(c[1])) root = "sqrt(" + to_string(-c[0] / c[2]) + ")";
  if (c.size() == 2) root = "(" + to_string(-c[0] / c[1]) + ")";
  pasting.note({ReadingNote::What::root, {std::string(p.text()), root}});
  Tokens cut(pasting.kept(root), origin_of_text("RootOf", root));
  cut.decimals_allowed = 1;
  List all;
  for (Token x = cut.next(); x.kind != TokenKind::end; x = cut.next()) {
    x.span = at.span;
    all.push_back(x);
  }
  all.back().after_blank = false;
  return all;
}

bool is_elementary(const std::string& name) {
  return std::find(functions.begin(), functions.begin() + elementary, name) !=
         functions.begin() + elementary;
}

struct OpenCall {
  std::string_view of;
  long commas = 0;
};

// A quotient beside what binds closer.
bool needs_group(const List& before, const Token& next) {
  const bool bound = !before.empty() && (before.back().is("^") || before.back().is("/"));
  return bound || next.is("^") || next.kind == TokenKind::name || next.is("(");
}

std::size_t end_of_exponent(const List& all, std::size_t from) {
  if (all[from].is("(")) return closing_of(all, from) + 1;
  const bool call = all[from].kind == TokenKind::name && from + 1 < all.size() &&
                    all[from + 1].is("(") && is_function_word(all[from].text);
  return call ? closing_of(all, from + 1) + 1 : from + 1;
}

class PlainFunctions {
public:
  PlainFunctions(List in, Pasting& p) : in_(std::move(in)), p_(p) {}

  List operator()() {
    while (in_[at_].kind != TokenKind::end)
      step();
    out_.push_back(in_[at_]);
    return std::move(out_);
  }

private:
  [[nodiscard]] const Token& token(std::size_t i) const { return in_[std::min(i, in_.size() - 1)]; }
  void sign(const Token& at, std::string_view s) {
    out_.push_back(made(at, TokenKind::sign, s));
    out_.back().after_blank = false;
  }
  void copy(std::size_t from, std::size_t to) {
    for (at_ = from; at_ < to;)
      step();
  }

  void step() {
    const Token t = token(at_);
    if (t.kind == TokenKind::decimal) return decimal(t);
    if (t.kind == TokenKind::name && named(t)) return;
    if (t.is("(")) groups_.push_back({at_ > 0 ? token(at_ - 1).text : "", 0});
    if (t.is(",") && !groups_.empty()) ++groups_.back().commas;
    if (t.is(")") && !groups_.empty()) groups_.pop_back();
    out_.push_back(t);
    ++at_;
  }

  // An approximation stays one: the second argument of root.
  void decimal(const Token& t) {
    ++at_;
    if (!groups_.empty() && groups_.back().of == "root" && groups_.back().commas == 1)
      return out_.push_back(t);
    const std::string exact = exact_fraction(t.text);
    if (exact.empty()) return out_.push_back(t); // the reader refuses it
    if (!t.text.ends_with("."))                  // the point of a sentence
      p_.note({ReadingNote::What::decimal, {std::string(t.text), exact}});
    const auto slash = exact.find('/');
    const auto number = [&](const std::string& digits) {
      out_.push_back(made(t, TokenKind::number, p_.kept(digits)));
    };
    if (slash == std::string::npos) return number(exact);
    const bool grouped = needs_group(out_, token(at_));
    if (grouped) out_.push_back(made(t, TokenKind::sign, "("));
    number(exact.substr(0, slash));
    sign(t, "/");
    number(exact.substr(slash + 1));
    out_.back().after_blank = false;
    if (grouped) sign(t, ")");
  }
  bool named(const Token& t) {
    const bool called = token(at_ + 1).is("(");
    if (t.text == "RootOf" && called) return root_of(t);
    if ((t.text == "e" || t.text == "E") && !p_.names.has(t.text) && token(at_ + 1).is("^"))
      return exponential(t);
    const std::string small = lower(t.text);
    if (!is_elementary(small) || p_.names.has(t.text)) return false;
    if (small != t.text && !called) return false;
    if (called) {
      out_.push_back(t);
      if (small != t.text) out_.back().text = p_.kept(small);
      ++at_;
      return true;
    }
    return token(at_ + 1).is("^") ? power_of_function(t) : applied(t, at_ + 1);
  }

  // e^x is exp(x) wherever a name stands in the exponent: a power of a number e would not be rational.
  bool exponential(const Token& t) {
    std::size_t from = at_ + 2;
    const bool minus = token(from).is("-");
    from += minus;
    const std::size_t to = end_of_exponent(in_, from);
    const bool has_name = std::ranges::any_of(
        part_of(in_, from, to), [](const Token& x) { return x.kind == TokenKind::name; });
    const Token& then = token(to);
    if (token(from).kind == TokenKind::number && then.kind == TokenKind::name) {
      const std::string number = (minus ? "-" : "") + std::string(token(from).text);
      const std::string name(then.text);
      p_.refuse(t.span, "what is the exponent?",
                "write exp(" + number + "*" + name + "), or exp(" + number + ")*" + name);
      return false;
    }
    if (!has_name || then.is("^")) return false;
    out_.push_back(made(t, TokenKind::name, "exp"));
    sign(t, "(");
    if (minus) sign(token(from - 1), "-");
    const bool group = token(from).is("(");
    copy(from + group, to - group);
    sign(token(to - 1), ")");
    at_ = to;
    return true;
  }

  // sin^2(x), sin^2 x, cosh^(-2)(x); sin^(-1) may be the inverse.
  bool power_of_function(const Token& t) {
    const std::size_t hat = at_ + 1, begin = hat + 1;
    const bool group = token(begin).is("(");
    std::size_t to = group ? closing_of(in_, begin) + 1 : begin + 1;
    if (token(begin).is("-")) ++to;
    const std::size_t first = begin + group + token(begin + group).is("-");
    const bool minus = first > begin + group, plain = first + 1 + group == to;
    const bool number = plain && token(first).kind == TokenKind::number;
    const std::string name(t.text);
    if (minus && number && token(first).text == "1")
      return unclear_power(t, to, "a power of " + name + ", or its inverse?",
                           "write 1/" + name + "(x), or arc" + name + "(x)");
    if (!number && !(plain && token(first).kind == TokenKind::name) && !group)
      return unclear_power(t, to, "a power of " + name + "?", "write (" + name + "(x))^n");
    const List exponent = part_of(in_, begin, to);
    if (token(to).is("(")) {
      const std::size_t end = closing_of(in_, to) + 1;
      out_.push_back(t);
      copy(to, end);
    } else {
      applied(t, to);
    }
    sign(exponent.front(), "^");
    out_.insert(out_.end(), exponent.begin(), exponent.end());
    return true;
  }
  bool unclear_power(const Token& t, std::size_t to, std::string message, std::string hint) {
    p_.refuse(t.span, std::move(message), std::move(hint));
    at_ = to;
    return true;
  }

  // sin x, sin 2x: where the term ends there.
  bool applied(const Token& t, std::size_t from) {
    std::size_t to = from;
    if (token(to).kind == TokenKind::number && token(to + 1).kind == TokenKind::name &&
        !token(to + 1).after_blank)
      ++to;
    const bool argument = token(to).kind == TokenKind::name || token(to).kind == TokenKind::number;
    const Token& then = token(to + 1);
    const bool ends = then.kind == TokenKind::end || then.is("+") || then.is("-") || then.is("=") ||
                      then.is(")") || then.is(",");
    if (!argument) return false;
    if (!ends) // at an error the text does not matter any more
      p_.refuse(t.span, "where does the argument of " + std::string(t.text) + " end?",
                "write " + std::string(t.text) + "(...)");
    out_.push_back(t);
    sign(t, "(");
    if (to > from) {
      out_.push_back(token(from));
      sign(token(to), "*");
    }
    out_.push_back(token(to));
    out_.back().after_blank = false;
    sign(token(to), ")");
    at_ = to + 1;
    return true;
  }

  // RootOf(_Z^2 - 2): one root; the answer for another one is its conjugate.
  bool root_of(const Token& t) {
    const std::size_t close = closing_of(in_, at_ + 1);
    List inside = part_of(in_, at_ + 2, close);
    long depth = 0;
    const auto comma = std::ranges::find_if(inside, [&](const Token& x) {
      depth += opens(x) - closes(x);
      return depth == 0 && x.is(",");
    });
    if (comma != inside.end() && (comma + 1)->kind == TokenKind::decimal) {
      out_.push_back(made(t, TokenKind::name, "root"));
      in_[at_].text = "root";
      ++at_;
      return true;
    }
    if (comma != inside.end()) {
      p_.refuse(t.span, "which root is meant?", "write root(p(x), approximation)");
      at_ = close + 1;
      return true;
    }
    inside.push_back({.kind = TokenKind::end, .span = token(close).span, .text = {}});
    inside = with_products(std::move(inside), p_);
    p_.stop_at_errors();
    const Expression p =
        parse_tokens(Tokens(p_.text, p_.origin, std::move(inside)), ParseLimits{}, false);
    for (const Token& x : tokens_of_root(t, p, p_))
      out_.push_back(x);
    at_ = close + 1;
    return true;
  }

  List in_;
  Pasting& p_;
  List out_;
  std::vector<OpenCall> groups_;
  std::size_t at_ = 0;
};

} // namespace

bool is_function_word(std::string_view name) { return is_among(name, functions); }

std::vector<Token> with_plain_functions(std::vector<Token> tokens, Pasting& p) {
  return PlainFunctions(std::move(tokens), p)();
}

} // namespace kov
