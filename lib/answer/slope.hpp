#pragma once
// Derivatives of formulas, for what is made of solutions.

#include "symbol/expression.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kov::answer {

/// B1^e1 B2^e2 ...
[[nodiscard]] std::vector<std::pair<Expression, Expression>> powers_in(const Expression& e);
/// a (b + c) is a b + a c.
[[nodiscard]] Expression distributed(const Expression& factor, const Expression& e);
/// By x; nothing where somebody would have to know more functions.
[[nodiscard]] std::optional<Expression> slope(const Expression& e, const std::string& x);

} // namespace kov::answer
