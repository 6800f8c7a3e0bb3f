#include "symbol/tokens.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

struct Typeset {
  std::string_view bytes;
  const char* hint;
};
constexpr std::array typeset_signs{
    Typeset{"\xE2\x88\x92", "write the ASCII sign -"},
    Typeset{"\xE2\x80\x93", "write the ASCII sign -"},
    Typeset{"\xC2\xB7", "write the ASCII sign *"},
    Typeset{"\xC3\x97", "write the ASCII sign *"},
    Typeset{"\xE2\x8B\x85", "write the ASCII sign *"},
    Typeset{"\xC2\xB2", "write ^2"},
    Typeset{"\xC2\xB3", "write ^3"},
    Typeset{"\xE2\x80\xB2", "write the ASCII sign '"},
    Typeset{"\xE2\x80\xB3", "write ''"},
    Typeset{"\xE2\x80\x99", "write the ASCII sign '"},
    Typeset{"\xE2\x88\x9A", "write sqrt(...)"},
    Typeset{"\"", "for a second derivative write two primes: y''"},
    Typeset{"[", "use parentheses ( )"},
    Typeset{"]", "use parentheses ( )"},
    Typeset{"{", "use parentheses ( )"},
    Typeset{"}", "use parentheses ( )"},
    Typeset{"$", "for a second derivative write y'' or diff(y, z, 2)"}};

} // namespace

std::string exact_fraction(std::string_view decimal) {
  std::string digits;
  long scale = 0;
  std::size_t i = 0;
  bool after_point = false;
  for (; i < decimal.size() && (is_digit(decimal[i]) || decimal[i] == '.'); ++i) {
    if (decimal[i] == '.') {
      after_point = true;
      continue;
    }
    digits += decimal[i];
    scale -= after_point;
  }
  if (digits.empty() || digits.size() > 60) return {};
  if (i < decimal.size()) { // e, E
    const std::string exponent(decimal.substr(i + 1));
    if (exponent.size() > 4) return {};
    scale += std::stol(exponent);
  }
  if (scale < -60 || scale > 60) return {};
  const Integer n = Integer::parse(digits);
  const Integer power = pow(Integer(10), static_cast<unsigned long>(std::abs(scale)));
  return to_string(scale < 0 ? Rational(n, power) : Rational(n * power));
}

Span make_span(std::size_t begin, std::size_t end) {
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)};
}

std::string quoted(std::string_view s) {
  constexpr std::size_t longest = 40;
  return "'" + std::string(s.substr(0, longest)) + (s.size() > longest ? "..." : "") + "'";
}

Token Tokens::cut(Token::Kind kind, std::size_t begin) const {
  return {.kind = kind,
          .span = make_span(begin, position_),
          .text = text_.substr(begin, position_ - begin)};
}

void Tokens::skip_digits() {
  while (position_ < text_.size() && is_digit(text_[position_]))
    ++position_;
}

Token Tokens::next() {
  if (!given_.empty()) {
    const Token& t = given_[std::min(position_++, given_.size() - 1)];
    refuse_decimal(t);
    return t;
  }
  while (position_ < text_.size() && is_space(text_[position_]))
    ++position_;
  const std::size_t begin = position_;
  if (begin >= text_.size()) return cut(Token::Kind::end, begin);
  const char c = text_[begin];
  if (is_digit(c) || (c == '.' && begin + 1 < text_.size() && is_digit(text_[begin + 1])))
    return number();
  if (is_letter(c)) {
    while (position_ < text_.size() && (is_letter(text_[position_]) || is_digit(text_[position_])))
      ++position_;
    return cut(Token::Kind::name, begin);
  }
  const bool known = std::string_view("+-*/^()=,'").find(c) != std::string_view::npos;
  const bool foreign = std::string_view("[]{}%.$@;").find(c) != std::string_view::npos;
  const bool pasted = pasted_signs && std::string_view(":&~\\").find(c) != std::string_view::npos;
  if (!known && !(foreign && foreign_signs) && !pasted) strange_character();
  ++position_;
  if (c == '\\') return command(begin);
  const bool double_star = c == '*' && position_ < text_.size() && text_[position_] == '*';
  position_ += double_star;
  Token t = cut(Token::Kind::sign, begin);
  if (double_star) t.text = "^";
  return t;
}

Token Tokens::command(std::size_t begin) {
  while (position_ < text_.size() && is_letter(text_[position_]) && text_[position_] != '_')
    ++position_;
  if (position_ == begin + 1 && position_ < text_.size()) ++position_; // \, and \{
  return cut(Token::Kind::command, begin);
}

Token Tokens::number() {
  const std::size_t begin = position_;
  skip_digits();
  bool decimal = false;
  if (position_ < text_.size() && text_[position_] == '.') {
    decimal = true;
    ++position_;
    skip_digits();
  }
  // 1e3, 1E-3; but the e of 2*e or 2exp begins a name
  std::size_t p = position_;
  if (p < text_.size() && (text_[p] == 'e' || text_[p] == 'E')) {
    ++p;
    if (p < text_.size() && (text_[p] == '+' || text_[p] == '-')) ++p;
    if (p < text_.size() && is_digit(text_[p])) {
      decimal = true;
      position_ = p;
      skip_digits();
    }
  }
  const Token t = cut(decimal ? Token::Kind::decimal : Token::Kind::number, begin);
  refuse_decimal(t);
  return t;
}

void Tokens::refuse_decimal(const Token& t) const {
  if (t.kind != Token::Kind::decimal || decimals_allowed > 0) return;
  const std::string exact = exact_fraction(t.text);
  throw error(t.span, "decimal number " + quoted(t.text) + ": only exact numbers are accepted",
              exact.empty() ? "write it as a fraction of integers" : "write " + exact);
}

void Tokens::strange_character() const {
  const std::string_view rest = text_.substr(position_);
  for (const Typeset& sign : typeset_signs)
    if (rest.starts_with(sign.bytes))
      throw error(make_span(position_, position_ + sign.bytes.size()),
                  "unexpected character " + quoted(sign.bytes), sign.hint);
  const auto byte = static_cast<unsigned char>(rest[0]);
  if (byte > 0x20 && byte < 0x7F)
    throw error(make_span(position_, position_ + 1),
                "unexpected character " + quoted(rest.substr(0, 1)));
  std::size_t n = 1;
  while (byte >= 0xC0 && n < std::min<std::size_t>(4, rest.size()) &&
         (static_cast<unsigned char>(rest[n]) & 0xC0) == 0x80)
    ++n;
  constexpr std::string_view hex = "0123456789abcdef";
  const std::string code{'0', 'x', hex[byte >> 4], hex[byte & 15]};
  throw error(make_span(position_, position_ + n),
              n > 1 ? "unexpected character " + quoted(rest.substr(0, n))
                    : "unexpected byte " + code,
              "formulas are written in plain ASCII");
}

std::optional<InputError> wrong_bracket(const std::vector<Token>& tokens, const OriginPtr& origin) {
  std::vector<Token> open;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& t = tokens[i];
    if (t.is("(") || t.is("[") || t.is("{")) open.push_back(t);
    const bool index = i > 2 && t.is("]") && tokens[i - 2].is("[") && i + 1 < tokens.size();
    if (index && (tokens[i - 3].text == "sqrt" || tokens[i - 3].text == "Sqrt") &&
        (tokens[i + 1].is("(") || tokens[i + 1].is("{")) && !tokens[i + 1].after_blank)
      return InputError(*origin, tokens[i - 3].span, "which root is meant?",
                        "write x^(1/3), or sqrt(3)*(x)");
    const bool closes = t.is(")") || t.is("]") || t.is("}");
    if (!closes || open.empty()) continue; // too many of them: the parser says so
    const Token before = open.back();
    open.pop_back();
    const char* own = before.is("(") ? ")" : before.is("[") ? "]" : "}";
    if (t.is(own)) continue;
    const long column = InputError(*origin, before.span, "").column();
    return InputError(*origin, t.span, quoted(t.text) + " does not close " + quoted(before.text),
                      quoted(before.text) + " stands at column " + std::to_string(column) +
                          "; write " + quoted(own));
  }
  return std::nullopt;
}

} // namespace kov
