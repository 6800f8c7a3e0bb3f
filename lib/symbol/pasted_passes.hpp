#pragma once
// The passes of pasted text on its way to our own notation, tokens to tokens.  Used by pasted.hpp only.

#include "symbol/pasted.hpp"
#include "symbol/tokens.hpp"

#include <set>

namespace kov {

/// The state that the passes share: where the text stands, what was found, what could not be understood.
struct Pasting {
  std::string_view text; ///< as it was written; spans are places in it
  OriginPtr origin;
  const PastedNames& names;
  std::set<std::string, std::less<>> unknowns{}; ///< what is differentiated
  std::deque<std::string> texts{};               ///< of tokens that stand in no text
  std::vector<ReadingNote> notes{};
  std::vector<InputError> errors{};
  bool by_time = false; ///< dots above were read

  [[nodiscard]] std::string_view kept(std::string s) { return texts.emplace_back(std::move(s)); }
  void refuse(Span where, std::string message, std::string hint = {}) {
    errors.emplace_back(*origin, where, std::move(message), std::move(hint));
  }
  void note(ReadingNote n);
  /// Throws the first error, with the others in its hint; nothing where there is none.
  void stop_at_errors() const;
};

/// The place of the bracket that closes the one at `open`; that of the last token where none does.
[[nodiscard]] std::size_t closing_of(const std::vector<Token>& tokens, std::size_t open);
/// sin, exp, sqrt, ... and what notations call functions.
[[nodiscard]] bool is_function_word(std::string_view name);

/// Commands of LaTeX: \frac, \left, \cdot, ^{\prime\prime}, y^{(2)}, \ddot, \sqrt, Greek letters, \sin, ...
[[nodiscard]] std::vector<Token> without_latex(std::vector<Token> tokens, Pasting& p);

/// d^2y/dx^2, dy/dx, d/dx (p y') as diff, and d/dx alone as the operator Dx.
[[nodiscard]] std::vector<Token> without_quotients_of_d(std::vector<Token> tokens, Pasting& p);
/// Could A/B be a derivative: both begin with d?
[[nodiscard]] bool is_quotient_of_d(const std::vector<Token>& a, const std::vector<Token>& b);

/// Decimals become fractions, e^x a call of exp, RootOf a root, sin x a call.
[[nodiscard]] std::vector<Token> with_plain_functions(std::vector<Token> tokens, Pasting& p);

/// A * where factors stand side by side; what could also be meant otherwise is asked back.
[[nodiscard]] std::vector<Token> with_products(std::vector<Token> tokens, Pasting& p);

/// The tokens as a text in our own notation.
[[nodiscard]] std::string text_of(const std::vector<Token>& tokens);

} // namespace kov
