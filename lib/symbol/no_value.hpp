#pragma once

#include "symbol/input_error.hpp"

#include <utility>

namespace kov {

/// An error of a text without a value: a division by 0, or an equation without its highest derivative.
/// Example NoValue(parse_expression("1/0", "-r").error("division by zero")).message()  // -> division by zero
class NoValue : public InputError {
public:
  explicit NoValue(InputError error) : InputError(std::move(error)) {}
};

} // namespace kov
