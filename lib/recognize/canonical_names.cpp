#include "recognize/canonical_names.hpp"

#include <algorithm>

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

} // namespace

std::map<std::string, std::string>
fresh_names(const std::vector<std::pair<std::string, std::string>>& parameters,
            const std::set<std::string>& taken) {
  std::map<std::string, std::string> names;
  for (const char* letter :
       {"l", "m", "n", "a", "b", "c", "k", "u", "w", "B", "g2", "g3", "p", "N"}) {
    const bool same = std::any_of(parameters.begin(), parameters.end(), [&](const auto& p) {
      return p.first == letter && p.second == letter;
    });
    if (same || !taken.contains(letter)) continue;
    for (long i = 1; !names.contains(letter); ++i)
      if (const std::string fresh = std::string(letter) + "_" + std::to_string(i);
          !taken.contains(fresh))
        names.emplace(letter, fresh);
  }
  return names;
}

std::string renamed(const std::string& text, const std::map<std::string, std::string>& names) {
  if (names.empty()) return text;
  std::string result;
  for (auto at = text.begin(); at != text.end();) {
    const auto end = std::find_if_not(at, text.end(), in_name);
    if (end == at) {
      result += *at++;
      continue;
    }
    const std::string word(at, end);
    const auto found = names.find(word);
    const bool stays = found == names.end() || (word.size() == 1 && is_article(text, at));
    result += stays ? word : found->second;
    at = end;
  }
  return result;
}

} // namespace kov
