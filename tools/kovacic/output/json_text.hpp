#pragma once
// JSON as the text that it is: what is cut out or put in without reading the rest.

#include <string_view>

namespace kov::cli {

/// The value of a member of a JSON object, as it is written there; "" if there is none.  Of an
/// object with a key that occurs twice the first one.  Requires: no escapes in the keys before it.
/// Cost  one pass over the text
[[nodiscard]] std::string_view member(std::string_view object, std::string_view key);

} // namespace kov::cli
