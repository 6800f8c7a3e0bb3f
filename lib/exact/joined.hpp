#pragma once
// Texts, one after the other.

#include <concepts>
#include <functional>
#include <ranges>
#include <string>
#include <vector>

namespace kov {

/// Example joined({"a", "b", "c"})  // -> a, b, c
/// Example joined({"a", "b", "c"}, ", ", " and ")  // -> a, b and c
/// Example joined({"a", "b", "c"}, " and ")  // -> a and b and c
[[nodiscard]] inline std::string joined(const std::vector<std::string>& all,
                                        const std::string& between, const std::string& last) {
  std::string whole;
  for (std::size_t i = 0; i < all.size(); ++i)
    whole += (i == 0 ? "" : i + 1 == all.size() ? last : between) + all[i];
  return whole;
}
[[nodiscard]] inline std::string joined(const std::vector<std::string>& all,
                                        const std::string& between = ", ") {
  return joined(all, between, between);
}
/// The words of each entry, one after the other: by a function, or a member.
template <std::ranges::input_range All,
          std::invocable<std::ranges::range_reference_t<const All>> InWords>
[[nodiscard]] std::string joined(const All& all, InWords in_words,
                                 const std::string& between = ", ") {
  std::vector<std::string> words;
  for (const auto& x : all)
    words.emplace_back(std::invoke(in_words, x));
  return joined(words, between);
}

} // namespace kov
