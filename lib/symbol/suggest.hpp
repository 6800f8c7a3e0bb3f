#pragma once
// "Did you mean ...?"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kov {

/// The candidate nearest to `name` (edits and neighbouring swaps, case nearly ignored), if
/// it is near enough to be meant: at most a third of the length, and at least one edit.
[[nodiscard]] std::optional<std::string> nearest(std::string_view name,
                                                 std::span<const std::string> candidates);

/// "a, b and c"
[[nodiscard]] std::string enumerate(std::span<const std::string> names);

} // namespace kov
