#pragma once
// Texts, one after the other.

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

} // namespace kov
