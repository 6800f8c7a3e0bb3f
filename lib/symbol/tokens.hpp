#pragma once
// The words of a formula: numbers, names, signs.  Used by the parsers of expression.hpp and notations.hpp only.

#include "symbol/expression.hpp"

#include <deque>
#include <optional>

namespace kov {

[[nodiscard]] inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// May begin a name.
[[nodiscard]] inline bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

struct Token {
  enum class Kind : std::uint8_t { number, decimal, name, sign, command, end };
  Kind kind = Kind::end;
  Span span;
  std::string_view
      text; ///< of a sign: one character, "^" for "**" as well; of a command: with its backslash
  bool after_blank = false; ///< in pasted text: a blank stands before it

  [[nodiscard]] bool is(std::string_view sign) const { return kind == Kind::sign && text == sign; }
};
using TokenKind = Token::Kind;

/// Another token at the same place.
[[nodiscard]] inline Token made(const Token& at, Token::Kind kind, std::string_view text) {
  return {.kind = kind, .span = at.span, .text = text, .after_blank = at.after_blank};
}
[[nodiscard]] inline bool opens(const Token& t) { return t.is("(") || t.is("[") || t.is("{"); }
[[nodiscard]] inline bool closes(const Token& t) { return t.is(")") || t.is("]") || t.is("}"); }
/// The tokens from one place to another.
[[nodiscard]] inline std::vector<Token> part_of(const std::vector<Token>& all, std::size_t from,
                                                std::size_t to) {
  return {all.begin() + static_cast<std::ptrdiff_t>(from),
          all.begin() + static_cast<std::ptrdiff_t>(to)};
}
/// The place of the bracket that opens the one at `close`; 0 where none does.
[[nodiscard]] inline std::size_t opening_of(const std::vector<Token>& all, std::size_t close) {
  for (long depth = 0; close > 0; --close) {
    depth += closes(all[close]) - opens(all[close]);
    if (depth == 0) break;
  }
  return close;
}
[[nodiscard]] inline bool is_named(const Token& t, std::string_view name) {
  return t.kind == Token::Kind::name && t.text == name;
}

/// Cuts a text into tokens.  Throws InputError for bytes that belong to none, with what to write.
class Tokens {
public:
  Tokens(std::string_view text, OriginPtr origin) : text_(text), origin_(std::move(origin)) {}
  /// These tokens, cut from `text` by somebody else; the last one is Kind::end.
  Tokens(std::string_view text, OriginPtr origin, std::vector<Token> given)
      : text_(text), origin_(std::move(origin)), given_(std::move(given)) {}

  /// The next token; Kind::end for ever after the last one.
  [[nodiscard]] Token next();
  /// While above 0, decimals are tokens instead of errors (the second argument of root).
  int decimals_allowed = 0;
  /// Signs of other programs are tokens instead of errors: [ ] { } % . $ @ ;
  bool foreign_signs = false;
  /// Also those of pasted text: : & ~ and \\name as a command.
  bool pasted_signs = false;

  [[nodiscard]] InputError error(Span where, std::string message, std::string hint = {}) const {
    return {*origin_, where, std::move(message), std::move(hint)};
  }
  [[nodiscard]] std::string_view text() const noexcept { return text_; }
  [[nodiscard]] const OriginPtr& origin() const noexcept { return origin_; }

private:
  [[nodiscard]] Token number();
  [[nodiscard]] Token command(std::size_t begin);
  [[nodiscard]] Token cut(Token::Kind kind, std::size_t begin) const;
  void skip_digits();
  void refuse_decimal(const Token& t) const;
  [[noreturn]] void strange_character() const;

  std::string_view text_;
  OriginPtr origin_;
  std::vector<Token> given_;
  std::size_t position_ = 0; ///< in the text, or among the given tokens
};

/// An equation or a formula from its tokens.  Throws InputError.
[[nodiscard]] Expression parse_tokens(Tokens tokens, const ParseLimits& limits,
                                      bool allow_equation = true);

/// Tokens and the texts of those that stand in no text.  A copy would speak of the texts of the first.
struct TokenList {
  TokenList(std::vector<Token> tokens_, std::deque<std::string> texts_)
      : tokens(std::move(tokens_)), texts(std::move(texts_)) {}
  TokenList(TokenList&&) = default;
  TokenList& operator=(TokenList&&) = default;

  std::vector<Token> tokens;
  std::deque<std::string> texts;
};
/// The notations of other programs as ours (notations.hpp); the last token is Kind::end.
[[nodiscard]] TokenList translated(std::vector<Token> tokens, std::string_view text,
                                   const OriginPtr& origin);
/// The same of a text, as parse_ode has it.
[[nodiscard]] TokenList translated(std::string_view text, const OriginPtr& origin);

/// The first bracket that is closed by another kind: (x].
[[nodiscard]] std::optional<InputError> wrong_bracket(const std::vector<Token>& tokens,
                                                      const OriginPtr& origin);

/// 0.5 -> 1/2, 2.50e-3 -> 1/400; nothing where the fraction would be absurdly long.
[[nodiscard]] std::string exact_fraction(std::string_view decimal);
[[nodiscard]] Span make_span(std::size_t begin, std::size_t end);
/// 'text', cut after 40 bytes.
[[nodiscard]] std::string quoted(std::string_view s);

} // namespace kov
