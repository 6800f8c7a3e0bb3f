#pragma once
// A failing formula made smaller: terms, factors, groups and numbers are taken out as long as it still
// fails, and what is left is written as a file.

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace kov::test {

/// Does this text still show the failure?  A text that cannot be read does not: say false.
using StillFails = std::function<bool(const std::string&)>;

namespace smaller_parts {

struct Span {
  std::size_t begin, end;
};

// Terms and factors at every depth, groups, and numbers of more than one digit: the longest first.
inline std::vector<Span> parts(const std::string& text) {
  std::vector<Span> all;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || std::string("(+-*/,=^").find(text[i - 1]) != std::string::npos;
    if (!begins) continue;
    int depth = 0;
    for (std::size_t j = i; j < text.size(); ++j) {
      if (text[j] == '(') ++depth;
      if (text[j] == ')') --depth;
      if (depth < 0) break;
      const bool ends =
          j + 1 == text.size() || std::string(")+-*/,=").find(text[j + 1]) != std::string::npos;
      if (depth == 0 && ends) all.push_back({i, j + 1});
    }
  }
  std::sort(all.begin(), all.end(),
            [](Span a, Span b) { return a.end - a.begin > b.end - b.begin; });
  return all;
}

// Is it one group, as (a + b) is and (a)*(b) is not?
inline bool is_group(const std::string& part) {
  int depth = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    depth += part[i] == '(' ? 1 : part[i] == ')' ? -1 : 0;
    if (depth == 0 && i + 1 < part.size()) return false;
  }
  return part.size() > 2 && part.front() == '(';
}

// 0, 1, one of its operands, what a group contains, or a number with fewer digits.
inline std::vector<std::string> smaller_ones(const std::string& part) {
  std::vector<std::string> all = {"0", "1"};
  for (const Span s : parts(part))
    if (s.end - s.begin < part.size()) all.push_back(part.substr(s.begin, s.end - s.begin));
  if (is_group(part)) all.push_back(part.substr(1, part.size() - 2));
  if (part.size() > 1 && part.find_first_not_of("0123456789") == std::string::npos)
    all.push_back(part.substr(0, part.size() - 1));
  return all;
}

// Fewer characters, or smaller digits.
inline bool is_less(const std::string& a, const std::string& b) {
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

} // namespace smaller_parts

/// The text after all that could be taken out; `most`: so many times it is asked.
inline std::string smaller(std::string text, const StillFails& still_fails, int most = 300) {
  using namespace smaller_parts;
  for (bool again = true; again;) {
    again = false;
    for (const Span part : parts(text)) {
      for (const std::string& by : smaller_ones(text.substr(part.begin, part.end - part.begin))) {
        std::string next = text;
        next.replace(part.begin, part.end - part.begin, by);
        if (!is_less(next, text)) continue;
        if (--most < 0) return text;
        if (!still_fails(next)) continue;
        text = std::move(next);
        again = true;
        break;
      }
      if (again) break;
    }
  }
  return text;
}

/// Writes a failure to kovacic-failure-SEED.txt in the working directory: the file's name.
inline std::string written_failure(std::uint64_t seed, const std::string& text) {
  const std::string name = "kovacic-failure-" + std::to_string(seed) + ".txt";
  std::ofstream(name) << text << "\n";
  return name;
}

} // namespace kov::test
