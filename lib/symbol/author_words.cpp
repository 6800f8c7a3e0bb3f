#include "symbol/author_words.hpp"

#include "symbol/tokens.hpp"

#include <algorithm>

namespace kov {
namespace {

bool is_ascii_control(unsigned char c) { return c <= 0x20 || c == 0x7f; }

// The length of a control character of Unicode (in UTF-8) at this place, 0 if there is none.
std::size_t control_at(const std::string& s, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < s.size() ? static_cast<unsigned char>(s[at + i]) : 0U;
  };
  const auto between = [](unsigned x, unsigned low, unsigned high) {
    return low <= x && x <= high;
  };
  if (is_ascii_control(static_cast<unsigned char>(s[at]))) return 1;
  if (byte(0) == 0xc2 && between(byte(1), 0x80, 0x9f)) return 2; // C1
  const bool breaks = byte(0) == 0xe2 && byte(1) == 0x80 && between(byte(2), 0xa8, 0xae);
  const bool marks = byte(0) == 0xe2 && byte(1) == 0x80 && between(byte(2), 0x8e, 0x8f);
  const bool turns = byte(0) == 0xe2 && byte(1) == 0x81 && between(byte(2), 0xa6, 0xa9);
  return breaks || marks || turns ? 3 : 0;
}

} // namespace

std::string one_line(const std::string& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size();) {
    if (const std::size_t skipped = control_at(words, i); skipped > 0) {
      if (!text.empty() && text.back() != ' ') text += ' ';
      i += skipped;
    } else {
      text += words[i++];
    }
  }
  if (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

bool is_identifier(const std::string& name) {
  return !name.empty() && is_letter(name.front()) &&
         std::ranges::all_of(name, [](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

std::string name_in_words(const std::string& name) {
  if (is_identifier(name)) return name;
  std::string inside = name;
  std::ranges::replace(inside, '"', '\'');
  return '"' + inside + '"';
}

} // namespace kov
