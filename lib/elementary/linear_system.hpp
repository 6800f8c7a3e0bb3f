#pragma once
// Constants c with sum c_j images_j = f, where images and f are elements: the coefficients of all monomials and of all
// powers of x are compared.

#include "elementary/element.hpp"

#include <optional>
#include <vector>

namespace kov::elementary {

/// Free of x; those that are free are 0.  Nothing: there are none.
/// Given   const auto letters = std::make_shared<Letters>("x", std::vector<std::string>{});
/// Given   const Element t(letters, letters->variable_value());
/// Example *coefficients_of(sin(t), {cos(t), sin(t)})  // -> {0, 1}
[[nodiscard]] std::optional<std::vector<MFraction>>
coefficients_of(const Element& f, const std::vector<Element>& images);

} // namespace kov::elementary
