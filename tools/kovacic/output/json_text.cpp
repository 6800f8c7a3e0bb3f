#include "output/json_text.hpp"

#include <algorithm>

namespace kov::cli {
namespace {

// Where a string that begins at `at` ends (behind its quote).
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return std::min(at + 1, text.size());
}

// Where a value ends: at the comma or bracket behind it.
std::size_t end_of_value(std::string_view text, std::size_t at) {
  for (long depth = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"') {
      at = end_of_string(text, at);
      continue;
    }
    if (depth == 0 && (c == ',' || c == '}' || c == ']')) break;
    depth += (c == '{' || c == '[') - (c == '}' || c == ']');
    ++at;
  }
  while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t'))
    --at;
  return at;
}

} // namespace

std::string_view member(std::string_view object, std::string_view key) {
  for (std::size_t at = object.find('{') + 1; at < object.size();) { // from member to member
    at = object.find('"', at);
    if (at == std::string_view::npos) break;
    const std::size_t end = end_of_string(object, at);
    const std::string_view name = object.substr(at + 1, end - at - 2);
    const std::size_t colon = object.find_first_not_of(" \t", end);
    if (colon == std::string_view::npos || object[colon] != ':') break;
    const std::size_t value = object.find_first_not_of(" \t", colon + 1);
    if (value == std::string_view::npos) break;
    at = end_of_value(object, value);
    if (name == key) return object.substr(value, at - value);
  }
  return {};
}

} // namespace kov::cli
