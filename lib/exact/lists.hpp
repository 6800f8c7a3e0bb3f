#pragma once
// Lists that are used as sets, and lists made of lists.

#include <algorithm>
#include <functional>
#include <ranges>
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

/// f of each entry, in their order: of a function, or a member.
/// Example mapped<int>(std::vector{1, 2}, std::negate{})  // -> {-1, -2}
template <class T, std::ranges::input_range All, class F>
[[nodiscard]] std::vector<T> mapped(All&& all, const F& f) {
  std::vector<T> out;
  if constexpr (std::ranges::sized_range<All>) out.reserve(std::ranges::size(all));
  for (auto&& x : all)
    out.emplace_back(std::invoke(f, x));
  return out;
}

} // namespace kov
