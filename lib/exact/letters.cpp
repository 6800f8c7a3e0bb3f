#include "exact/letters.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace kov {
namespace {

bool in_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_small_letter(char c) { return c >= 'a' && c <= 'z'; }

// "a natural number", "in a row": between words, not "y'' = a x y".
bool is_article(const std::string& text, std::string::const_iterator at) {
  const auto i = static_cast<std::size_t>(at - text.begin());
  if (text[i] != 'a' || i + 2 >= text.size() || text[i + 1] != ' ' || !is_small_letter(text[i + 2]))
    return false;
  const auto before = i == 0 ? std::string::npos : text.find_last_not_of(' ', i - 1);
  return before == std::string::npos || is_small_letter(text[before]) || text[before] == ',';
}

// Calls with each piece of the text: is it a name, and where does it begin?
template <class Piece> void for_each_piece(const std::string& text, Piece piece) {
  for (auto at = text.begin(); at != text.end();) {
    const auto end = std::find_if_not(at, text.end(), in_name);
    const auto next = end == at ? at + 1 : end;
    piece(std::string(at, next), end != at, at);
    at = next;
  }
}

// Everything that our own texts use for something that they introduce.
constexpr std::array ours{"x", "t", "l", "m", "n", "a",  "b",  "c",  "k",  "u",
                          "w", "p", "q", "v", "j", "r",  "y",  "y1", "y2", "F",
                          "N", "B", "Q", "T", "X", "g2", "g3", "nu", "wp", "Delta"};

std::vector<std::string> others(const std::string& letter) {
  if (letter == "x") return {"t", "s"};
  if (letter == "t") return {"s"};
  return {};
}

// Without digits at its end nothing that looks like another letter: g2 -> g2_1.
std::string indexed(const std::string& letter, const std::set<std::string>& taken) {
  for (long i = 1;; ++i)
    if (std::string name = letter + "_" + std::to_string(i); !taken.contains(name)) return name;
}

} // namespace

FreshLetters::FreshLetters(const std::set<std::string>& taken) {
  std::set<std::string> used = taken;
  for (const char* letter : ours) {
    std::string name = letter;
    for (const std::string& other : others(letter))
      if (used.contains(name)) name = other;
    if (used.contains(name)) name = indexed(letter, used);
    used.insert(name);
    if (name != letter) names_.emplace(letter, name);
  }
  if (const std::string& t = (*this)("t"); t != "t" && t.size() == 1)
    names_.emplace("y_tt", "y_" + t + t);
}

FreshLetters::FreshLetters(const Ring& ring) {
  if (ring) *this = FreshLetters(std::set<std::string>(ring->names().begin(), ring->names().end()));
}

std::string FreshLetters::operator()(const std::string& letter) const {
  const auto other = names_.find(letter);
  return other == names_.end() ? letter : other->second;
}

// And so does the letter whose name it had.
void FreshLetters::keep(const std::string& letter) {
  const auto other = names_.find(letter);
  if (other == names_.end()) return;
  const std::string free = other->second;
  names_.erase(other);
  if (names_.erase(free) > 0 && free == "t") names_.erase("y_tt");
}

std::string FreshLetters::in(const std::string& text) const { return renamed(text, names_); }

std::string FreshLetters::in(const std::string& text, const std::string& variable) const {
  std::string all;
  for (const char sign : in(text))
    all += sign == *mark ? variable : std::string(1, sign);
  return all;
}

std::string renamed(const std::string& text, const std::map<std::string, std::string>& names) {
  if (names.empty()) return text;
  std::string result;
  for_each_piece(text, [&](const std::string& word, bool name, std::string::const_iterator at) {
    const auto found = name ? names.find(word) : names.end();
    const bool stays = found == names.end() || (word.size() == 1 && is_article(text, at));
    result += stays ? word : found->second;
  });
  return result;
}

std::set<std::string> names_in_text(const std::string& formula) {
  std::set<std::string> names;
  for_each_piece(formula, [&](const std::string& word, bool name, std::string::const_iterator) {
    if (name && (word[0] < '0' || word[0] > '9')) names.insert(word);
  });
  return names;
}

} // namespace kov
