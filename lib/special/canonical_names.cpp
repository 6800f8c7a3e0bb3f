#include "special/canonical_names.hpp"

#include <algorithm>

namespace kov {
namespace {

bool in_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
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
    result += found == names.end() ? word : found->second;
    at = end;
  }
  return result;
}

} // namespace kov
