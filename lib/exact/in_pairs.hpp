#pragma once
// Long products and sums, by a balanced tree.

#include "exact/poly.hpp"

#include <utility>
#include <vector>

namespace kov {

/// f of neighbours, then of what comes out, until one is left: a balanced tree, far cheaper for long products
/// than one factor after the other.  Requires an entry.
/// Example in_pairs(std::vector{1, 2, 3}, std::plus{})  // -> 6
template <class T, class F> [[nodiscard]] T in_pairs(std::vector<T> all, const F& f) {
  while (all.size() > 1) {
    std::vector<T> next;
    for (std::size_t i = 0; i + 1 < all.size(); i += 2)
      next.push_back(f(all[i], all[i + 1]));
    if (all.size() % 2 == 1) next.push_back(std::move(all.back()));
    all = std::move(next);
  }
  return std::move(all.front());
}

/// num/den, where nothing is cancelled.
struct PolyQuotient {
  Poly den, num;
};
/// The sum over the product of all denominators.
[[nodiscard]] inline PolyQuotient sum(std::vector<PolyQuotient> all) {
  if (all.empty()) return {Poly(1), Poly()};
  return in_pairs(std::move(all), [](const PolyQuotient& x, const PolyQuotient& y) {
    return PolyQuotient{x.den * y.den, x.num * y.den + y.num * x.den};
  });
}

} // namespace kov
