#pragma once
// Lists that are used as sets.

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace kov {

/// Whether x stands in the list; one comparison for each entry.
/// Example is_among(2, std::vector{1, 2, 3})  // -> yes
template <class T, class List> [[nodiscard]] bool is_among(const T& x, const List& all) {
  return std::ranges::find(all, x) != std::ranges::end(all);
}

/// Appends x unless it stands in the list already.
/// Given   std::vector<int> all{1}; add_once(all, 1); add_once(all, 2);
/// Example all.size()  // -> 2
template <class T> void add_once(std::vector<T>& all, std::type_identity_t<T> x) {
  if (!is_among(x, all)) all.push_back(std::move(x));
}
/// The same for each of them, in their order.
template <class T>
void add_each_once(std::vector<T>& all, const std::vector<std::type_identity_t<T>>& more) {
  for (const T& x : more)
    add_once(all, x);
}

} // namespace kov
