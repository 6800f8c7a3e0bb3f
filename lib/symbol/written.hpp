#pragma once
// A tree as text in our own notation.

#include "symbol/expression.hpp"

#include <functional>
#include <optional>
#include <string>

namespace kov {

/// Another text for a piece of the tree, in parentheses where it needs them; nothing: as it is.
using Instead = std::function<std::optional<std::string>(const Expression&)>;

/// parse_expression reads it back, whatever notation e came from.
/// Given   const Expression two = parse_expression("a*(b - c)^2/d", "-r");
/// Example written(two)  // -> a*(b - c)^2/d
[[nodiscard]] std::string written(const Expression& e, const Instead& instead = {});

/// Does this name stand anywhere in the tree, also as a function?
[[nodiscard]] bool mentions_name(const Expression& e, const std::string& name);

/// The terms of a sum, with their signs; of an equation left - right.
struct SignedTerm {
  bool minus = false;
  Expression term;
};
[[nodiscard]] std::vector<SignedTerm> terms_of(const Expression& e);
/// "a - b + c"; "0" for none.
[[nodiscard]] std::string sum_of(const std::vector<SignedTerm>& terms, const Instead& instead = {});

} // namespace kov
