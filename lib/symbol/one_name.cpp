#include "symbol/one_name.hpp"

#include "exact/lists.hpp"
#include "symbol/pasted_characters.hpp"
#include "symbol/tokens.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

constexpr std::array<std::string_view, 10> other_letters{
    "hbar",   "ell",      "varphi", "vartheta", "varepsilon",
    "varrho", "varsigma", "varpi",  "varkappa", ""};
constexpr std::array<std::string_view, 16> glued_functions{
    "sinh", "cosh", "tanh", "coth", "sech", "csch", "sqrt", "sin",
    "cos",  "tan",  "cot",  "sec",  "csc",  "exp",  "log",  "ln"};

bool is_letter_by_name(std::string_view word) {
  return is_greek(word) || is_among(word, other_letters);
}

// The length of the letter at the beginning of the word: the longest name of a Greek one, else 1.
std::size_t letter_length(std::string_view word) {
  for (std::size_t n = std::min<std::size_t>(word.size(), 10); n > 1; --n)
    if (is_letter_by_name(word.substr(0, n))) return n;
  return 1;
}

std::size_t digits_length(std::string_view word) {
  return static_cast<std::size_t>(std::ranges::find_if_not(word, is_digit) - word.begin());
}

// Behind a letter: 12, _0, _m, _theta, and the _ of a fresh letter.
std::size_t index_length(std::string_view word) {
  std::size_t n = digits_length(word);
  if (n < word.size() && word[n] == '_') {
    const std::string_view index = word.substr(n + 1);
    const std::size_t digits = digits_length(index);
    n += 1 + (digits > 0 ? digits : !index.empty() && index[0] != '_' ? letter_length(index) : 0);
  }
  while (n < word.size() && word[n] == '_')
    ++n;
  return n;
}

} // namespace

bool is_one_name(std::string_view word) {
  if (word.empty() || !is_letter(word[0]) || word[0] == '_') return false;
  const std::size_t n = letter_length(word);
  return n + index_length(word.substr(n)) == word.size();
}

std::string as_product(std::string_view word) {
  if (is_among(word, glued_functions)) return std::string(word) + "(...)";
  std::string product;
  const auto factor = [&](std::string_view text) {
    product += (product.empty() ? "" : "*") + std::string(text);
  };
  while (!word.empty()) {
    const auto function = std::ranges::find_if(glued_functions, [&](std::string_view f) {
      return word.starts_with(f) && word.size() > f.size();
    });
    if (function != glued_functions.end()) {
      word.remove_prefix(function->size());
      factor(std::string(*function) + "(" + as_product(word) + ")");
      break;
    }
    std::size_t n = digits_length(word);
    if (n == 0) {
      const bool operates = word[0] == 'D' && word.size() > 1 && is_letter(word[1]); // Dx
      n = operates + letter_length(word.substr(operates));
      n += index_length(word.substr(n));
    }
    factor(word.substr(0, n));
    word.remove_prefix(n);
  }
  return product;
}

} // namespace kov
