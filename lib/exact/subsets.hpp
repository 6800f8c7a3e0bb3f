#pragma once
// Subsets of {0, ..., n - 1}.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kov {

/// All subsets with k members, each ascending, in lexicographic order.
/// Example subsets(3, 2).size()  // -> 3
/// Example subsets(3, 2).at(1).at(1)  // -> 2
[[nodiscard]] inline std::vector<std::vector<std::size_t>> subsets(std::size_t n, std::size_t k) {
  std::vector<std::vector<std::size_t>> all;
  if (k > n) return all;
  std::vector<bool> in(n, false);
  std::fill(in.begin(), in.begin() + static_cast<std::ptrdiff_t>(k), true);
  do {
    auto& some = all.emplace_back();
    for (std::size_t i = 0; i < n; ++i)
      if (in[i]) some.push_back(i);
  } while (std::prev_permutation(in.begin(), in.end()));
  return all;
}

} // namespace kov
