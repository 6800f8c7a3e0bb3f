#pragma once
// toml++ 3.3 runs into undefined behaviour when it asks whether certain characters beyond ASCII
// (U+00B7, for one) are white space.  Files may have such characters in strings and comments only.

#include <cstddef>
#include <optional>
#include <string_view>

namespace kov {

/// The offset of the first byte beyond ASCII outside strings and comments (or right after a line
/// continuation inside a string), if there is one.
[[nodiscard]] std::optional<std::size_t> stray_character(std::string_view toml);

} // namespace kov
