#pragma once
// The part of JSON that certificates use: objects, arrays, strings, true, false, null.  Numbers are
// refused (certificates write them as strings), and so are a key that occurs twice, control
// characters in strings and text that is not UTF-8.  Hostile input ends in one InvalidArgument.

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace kov::certify {

struct Json {
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;
  std::variant<std::nullptr_t, bool, std::string, Array, Object> value = nullptr;

  [[nodiscard]] const std::string* text() const { return std::get_if<std::string>(&value); }
  [[nodiscard]] const Array* array() const { return std::get_if<Array>(&value); }
  [[nodiscard]] const Object* object() const { return std::get_if<Object>(&value); }
  [[nodiscard]] const bool* truth() const { return std::get_if<bool>(&value); }
  [[nodiscard]] bool is_null() const { return std::holds_alternative<std::nullptr_t>(value); }
};

/// Throws InvalidArgument with the byte where reading stopped.
[[nodiscard]] Json parse_json(std::string_view text, int max_depth = 64);
/// Compact text; keys in their order.
[[nodiscard]] std::string to_string(const Json& j);

} // namespace kov::certify
