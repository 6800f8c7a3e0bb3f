#pragma once
// A small reader of rational functions for the tests: + - * / ^ **, integers, z, I, sqrt(n), and
// one letter a for the generator of a given field.

#include "exact/rational_function.hpp"

#include <string>

namespace kov::testing {

/// The field of the constants that occur in the text: Q, Q(I) or Q(sqrt n).
[[nodiscard]] Field field_of(const std::string& text);
[[nodiscard]] RationalFunction read(const std::string& text, const Field& k);
[[nodiscard]] inline RationalFunction read(const std::string& text) {
  return read(text, field_of(text));
}

} // namespace kov::testing
