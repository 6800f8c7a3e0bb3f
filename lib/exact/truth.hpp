#pragma once
// Three answers: yes, no, unknown; and "unknown" carries its reason.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace kov {

/// An answer.  It never converts to bool: ask certainly(t).
/// Example !Truth::unknown  // -> Truth::unknown
/// Example certainly(Truth::unknown)  // -> no
enum class Truth : std::uint8_t { no, yes, unknown };

[[nodiscard]] constexpr bool certainly(Truth t) noexcept { return t == Truth::yes; }
[[nodiscard]] constexpr bool possibly(Truth t) noexcept { return t != Truth::no; }
[[nodiscard]] constexpr Truth truth(bool b) noexcept { return b ? Truth::yes : Truth::no; }
[[nodiscard]] constexpr Truth operator!(Truth t) noexcept {
  return t == Truth::unknown ? t : truth(t == Truth::no);
}

/// Why something is unknown.
struct Unable {
  enum class Why : std::uint8_t { parameter, budget, not_implemented, inexact, methods_disagree };
  Why why = Why::not_implemented;
  std::string detail; ///< a full sentence for the user
};

/// A T, or the reason why there is none.
template <class T> class Determined {
public:
  Determined(T value) : v_(std::move(value)) {}
  Determined(Unable why) : v_(std::move(why)) {}
  [[nodiscard]] bool known() const noexcept { return std::holds_alternative<T>(v_); }
  [[nodiscard]] const T& value() const { return std::get<T>(v_); }
  [[nodiscard]] T& value() { return std::get<T>(v_); }
  [[nodiscard]] const Unable& reason() const { return std::get<Unable>(v_); }

private:
  std::variant<T, Unable> v_;
};

} // namespace kov
