#include "exact/factors.hpp"

#include <algorithm>

namespace kov {

Factors::Product Factors::of(const MPoly& den) {
  Product product;
  if (is_constant(den)) {
    product.content = den.coefficient(0);
    return product;
  }
  auto [content, factors] = factor(den);
  product.content = content;
  for (auto& [base, exponent] : factors) {
    const auto at = std::ranges::find(all_, base);
    const auto k = static_cast<std::size_t>(at - all_.begin());
    if (at == all_.end()) all_.push_back(base);
    if (product.exponents.size() <= k) product.exponents.resize(k + 1, 0);
    product.exponents[k] = static_cast<unsigned long>(exponent);
  }
  return product;
}

} // namespace kov
