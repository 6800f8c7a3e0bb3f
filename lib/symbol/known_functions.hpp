#pragma once
// The functions of which answers are made, by what they are short for or by their derivative.

#include "symbol/expression.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

struct KnownFunction {
  std::vector<std::string> arguments; ///< the last one is the variable, the others are constants
  std::optional<Expression> means;    ///< sec(x) is 1/cos(x)
  std::optional<Expression>
      slope; ///< the derivative by the variable, where it is short for nothing
};

/// Null for other functions.
/// Example written(*known_function("besselj", 2)->slope)  // -> besselj(n - 1, x) - n/x*besselj(n, x)
/// Example written(*known_function("sec", 1)->means)  // -> 1/cos(x)
[[nodiscard]] const KnownFunction* known_function(const std::string& name, std::size_t arguments);

} // namespace kov
