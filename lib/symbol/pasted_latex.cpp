// Commands of LaTeX in pasted text.

#include "exact/lists.hpp"
#include "symbol/pasted_characters.hpp"
#include "symbol/pasted_passes.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

using List = std::vector<Token>;

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& all, std::string_view s) {
  return is_among(s, all);
}

constexpr std::array<std::string_view, 30> layout{
    "left", "right",  "big",   "Big",   "bigl",         "bigr",      "Bigl",     "Bigr",
    "bigg", "Bigg",   "quad",  "qquad", "displaystyle", "textstyle", "nonumber", ",",
    ";",    "!",      ":",     " ",     "\\",           "[",         "]",        "(",
    ")",    "hspace", "biggl", "biggr", "Biggl",        "Biggr"};
constexpr std::array<std::string_view, 4> with_a_name{"begin", "end", "label", "tag"};
constexpr std::array<std::string_view, 8> upright{"mathrm", "operatorname", "text", "textrm",
                                                  "mathit", "mathsf",       "rm",   "mbox"};

constexpr std::array<std::pair<std::string_view, std::string_view>, 9> sign_commands{
    {{"{", "("},
     {"lbrace", "("},
     {"}", ")"},
     {"rbrace", ")"},
     {"cdot", "*"},
     {"times", "*"},
     {"ast", "*"},
     {"div", "/"},
     {"prime", "'"}}};

void put_group(List& out, const Token& at, const List& inner, bool group) {
  if (group) out.push_back(made(at, TokenKind::sign, "("));
  out.insert(out.end(), inner.begin(), inner.end());
  if (group) out.push_back(made(inner.empty() ? at : inner.back(), TokenKind::sign, ")"));
  if (group) out.back().after_blank = false;
}

void put_power(const List& inner, const Token& hat, Pasting& p, List& out) {
  const auto is_prime = [](const Token& t) { return t.is("'"); };
  if (!inner.empty() && std::ranges::all_of(inner, is_prime))
    return put_group(out, hat, inner, false);
  const bool order = inner.size() == 3 && inner[0].is("(") && inner[1].kind == TokenKind::number &&
                     inner[1].text.size() == 1 && inner[2].is(")") && !out.empty() &&
                     out.back().kind == TokenKind::name;
  if (order) { // y^{(2)}
    for (char n = inner[1].text[0]; n > '0'; --n)
      out.push_back(made(hat, TokenKind::sign, "'"));
    p.note({ReadingNote::What::derivative,
            {std::string(
                p.text.substr(hat.span.offset, inner[2].span.offset + 2 - hat.span.offset))}});
    return;
  }
  out.push_back(hat);
  put_group(out, hat, inner, inner.size() > 1);
}

void put_fraction(const List& a, const List& b, const Token& t, Pasting& p, List& out) {
  const bool derivative = is_quotient_of_d(a, b);
  const auto is_number = [](const List& x) {
    return x.size() == 1 && x[0].kind == TokenKind::number;
  };
  if (!out.empty() && out.back().kind == TokenKind::number && is_number(a) && is_number(b))
    p.refuse(t.span, "a number and a fraction side by side: a sum, or a product?",
             "write a sum like 2 1/2 as 5/2, a product with \\cdot");
  if (!derivative) out.push_back(made(t, TokenKind::sign, "("));
  put_group(out, t, a, !derivative && a.size() > 1);
  out.push_back(made(t, TokenKind::sign, "/"));
  put_group(out, t, b, !derivative && b.size() > 1);
  if (derivative) return;
  out.push_back(made(b.empty() ? t : b.back(), TokenKind::sign, ")"));
  out.back().after_blank = false;
}

class Latex {
public:
  Latex(List in, Pasting& p) : in_(std::move(in)), p_(p) {}

  List operator()() {
    List out;
    while (now().kind != TokenKind::end)
      element(out);
    while (!out.empty() && (out.back().is(".") || out.back().is(","))) // the end of a sentence
      out.pop_back();
    out.push_back(now());
    return out;
  }

private:
  [[nodiscard]] const Token& now() const { return in_[std::min(at_, in_.size() - 1)]; }
  [[nodiscard]] const Token& next() const { return in_[std::min(at_ + 1, in_.size() - 1)]; }

  void element(List& out) {
    const Token t = now();
    if (t.kind == TokenKind::command) return command(out);
    if (t.kind == TokenKind::name && t.text == "sqrt" && next().is("["))
      p_.refuse(t.span, "which root is meant?", "write \\sqrt[3]{x}, or x^(1/3)");
    if (t.is("^")) return power(out);
    if (t.kind == TokenKind::name && t.text.ends_with("_") && next().is("{")) return index(out);
    ++at_;
    if (t.is("$") || t.is("&") || t.is("~")) return;
    if (t.is("{") || t.is("[")) return out.push_back(made(t, TokenKind::sign, "("));
    if (t.is("}") || t.is("]")) return out.push_back(made(t, TokenKind::sign, ")"));
    if (t.kind == TokenKind::name && t.text.starts_with("_") && !out.empty() &&
        out.back().kind == TokenKind::name && !t.after_blank) { // the index of a command
      out.back().text = p_.kept(std::string(out.back().text) + std::string(t.text));
      if (out.back().text.ends_with("_") && now().is("{")) {
        --at_;
        in_[at_] = out.back();
        out.pop_back();
      }
      return;
    }
    out.push_back(t);
  }

  // {...}, one digit, or one element
  List argument(const Token& of) {
    List inner;
    if (now().kind == TokenKind::end) {
      p_.refuse(of.span, std::string(of.text) + " has no argument");
      return inner;
    }
    if (now().is("{")) {
      const Token open = now();
      for (++at_; !now().is("}") && now().kind != TokenKind::end;)
        element(inner);
      if (now().kind == TokenKind::end) p_.refuse(open.span, "this brace is never closed");
      ++at_;
    } else if (now().kind == TokenKind::number && now().text.size() > 1) {
      Token& number = in_[at_];
      inner.push_back({.kind = TokenKind::number,
                       .span = {number.span.offset, 1},
                       .text = number.text.substr(0, 1),
                       .after_blank = number.after_blank});
      number.text.remove_prefix(1);
      ++number.span.offset, --number.span.length;
    } else {
      if (of.text.ends_with("frac")) split_name();
      element(inner);
    }
    return inner;
  }

  // Without braces the argument of \frac is one letter: \frac x2 y is x/2 y.
  void split_name() {
    const Token word = now();
    const bool letters = word.kind == TokenKind::name && word.text.size() > 1;
    if (!letters || (word.span.length != word.text.size() && !is_digit(word.text.back()))) return;
    if (word.span.length != word.text.size() || word.text.find('_') != std::string_view::npos)
      return p_.refuse(word.span, "where does the argument of \\frac end?",
                       "write \\frac{...}{...}");
    List parts;
    for (std::size_t i = 0; i < word.text.size();) {
      const bool digits = is_digit(word.text[i]);
      std::size_t end = i + 1;
      while (i > 0 && end < word.text.size() && is_digit(word.text[end]) == digits)
        ++end;
      parts.push_back({.kind = digits ? TokenKind::number : TokenKind::name,
                       .span = make_span(word.span.offset + i, word.span.offset + end),
                       .text = word.text.substr(i, end - i),
                       .after_blank = i == 0 && word.after_blank});
      i = end;
    }
    const auto at = in_.begin() + static_cast<std::ptrdiff_t>(at_);
    in_.insert(in_.erase(at), parts.begin(), parts.end());
  }

  // x_{10}
  void index(List& out) {
    Token name = now();
    at_ += 1;
    const Token brace = now();
    const List inner = argument(brace);
    std::string text(name.text);
    for (const Token& t : inner) {
      if (t.kind != TokenKind::name && t.kind != TokenKind::number)
        p_.refuse(t.span, "an index has letters and digits only");
      text += t.text;
    }
    name.text = p_.kept(std::move(text));
    out.push_back(name);
  }

  void power(List& out) {
    const Token hat = now();
    ++at_;
    if (now().kind == TokenKind::number && now().text.size() > 1) {
      const std::string digits(now().text), one = digits.substr(0, 1);
      p_.refuse(now().span, "an exponent of two digits, or a factor?",
                "write ^{" + digits + "}, or ^" + one + " \\cdot " + digits.substr(1));
    }
    put_power(argument(hat), hat, p_, out);
  }
  void command(List& out) {
    const Token t = now();
    const std::string_view name = t.text.substr(1);
    ++at_;
    if (is_one_of(layout, name)) return;
    if (is_one_of(with_a_name, name)) return static_cast<void>(argument(t));
    for (const auto& [command, sign] : sign_commands)
      if (name == command) return out.push_back(made(t, TokenKind::sign, sign));
    if (name == "frac" || name == "dfrac" || name == "tfrac") {
      const List a = argument(t), b = argument(t);
      return put_fraction(a, b, t, p_, out);
    }
    if (name == "sqrt") return root(t, out);
    if (name == "partial") return out.push_back(made(t, TokenKind::name, "d"));
    if (name == "dot" || name == "ddot") return dots(t, name == "dot" ? 1 : 2, out);
    if (is_one_of(upright, name)) return upright_name(t, out);
    const std::string_view letter = name.starts_with("var") ? name.substr(3) : name;
    if (is_greek(letter) || is_function_word(name) || name == "imath" || name == "hbar" ||
        name == "ell")
      return out.push_back(made(t, TokenKind::name, name == "imath" ? "I" : letter));
    p_.refuse(t.span, "the LaTeX command " + std::string(t.text) + " has no meaning here");
  }

  // \sqrt{x}, \sqrt[3]{x}
  void root(const Token& t, List& out) {
    List degree;
    if (now().is("["))
      for (++at_; now().kind != TokenKind::end;) {
        if (now().is("]")) {
          ++at_;
          break;
        }
        element(degree);
      }
    const List inner = argument(t);
    if (degree.empty()) {
      out.push_back(made(t, TokenKind::name, "sqrt"));
      return put_group(out, t, inner, inner.size() != 1 || !inner[0].is("("));
    }
    put_group(out, t, inner, true);
    for (const std::string_view sign : {"^", "(", "1", "/"})
      out.push_back(made(t, sign == "1" ? TokenKind::number : TokenKind::sign, sign));
    put_group(out, t, degree, degree.size() > 1);
    out.push_back(made(t, TokenKind::sign, ")"));
  }

  void dots(const Token& t, int order, List& out) {
    p_.by_time = true;
    const List inner = argument(t);
    put_group(out, t, inner, inner.size() > 1);
    for (; order > 0; --order)
      out.push_back(made(t, TokenKind::sign, "'"));
    out.back().after_blank = false;
  }

  // \mathrm{d} and \operatorname{sech}
  void upright_name(const Token& t, List& out) {
    std::string text;
    for (const Token& part : argument(t))
      text += part.text;
    if (!text.empty()) out.push_back(made(t, TokenKind::name, p_.kept(std::move(text))));
  }

  List in_;
  Pasting& p_;
  std::size_t at_ = 0;
};

bool is_latex(const List& tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].kind == TokenKind::command) return true;
    const bool above =
        tokens[i].is("^") || (tokens[i].kind == TokenKind::name && tokens[i].text.ends_with("_"));
    if (above && tokens[i + 1].is("{")) return true;
  }
  return tokens.size() > 2 && tokens.front().is("$") && tokens[tokens.size() - 2].is("$");
}

} // namespace

std::vector<Token> without_latex(std::vector<Token> tokens, Pasting& p) {
  return is_latex(tokens) ? Latex(std::move(tokens), p)() : tokens;
}

} // namespace kov
