#include "symbol/suggest.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace kov {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

// Damerau-Levenshtein distance (neighbouring swaps count once) in units of a
// quarter, so that a change of case costs little.
std::size_t distance(std::string_view a, std::string_view b) {
  const std::size_t n = b.size();
  std::vector<std::size_t> before(n + 1);
  std::vector<std::size_t> previous(n + 1);
  std::vector<std::size_t> current(n + 1);
  for (std::size_t j = 0; j <= n; ++j)
    previous[j] = 4 * j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = 4 * i;
    for (std::size_t j = 1; j <= n; ++j) {
      const std::size_t change = a[i - 1] == b[j - 1]                 ? 0
                                 : lower(a[i - 1]) == lower(b[j - 1]) ? 1
                                                                      : 4;
      current[j] = std::min({previous[j] + 4, current[j - 1] + 4, previous[j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        current[j] = std::min(current[j], before[j - 2] + 4);
    }
    before.swap(previous);
    previous.swap(current);
  }
  return previous[n];
}

} // namespace

std::optional<std::string> nearest(std::string_view name, std::span<const std::string> candidates) {
  if (name.size() > 200) return std::nullopt;
  std::optional<std::string> best;
  std::size_t best_distance = 0;
  for (const std::string& c : candidates) {
    if (c.size() > 200) continue;
    const std::size_t d = distance(name, c);
    const std::size_t allowed = std::max<std::size_t>(4, 4 * std::max(name.size(), c.size()) / 3);
    // one letter for another one-letter name is a guess, not a slip
    if (d > allowed || (d > 1 && std::max(name.size(), c.size()) < 2)) continue;
    if (!best || d < best_distance) {
      best = c;
      best_distance = d;
    }
  }
  return best;
}

std::string enumerate(std::span<const std::string> names) {
  std::string s;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) s += i + 1 == names.size() ? " and " : ", ";
    s += names[i];
  }
  return s;
}

} // namespace kov
