#pragma once
// Three answers: yes, no, unknown; and "unknown" carries its reason.

#include <cstdint>
#include <string>

namespace kov {

/// An answer.  It never converts to bool: ask certainly(t).
/// Example !Truth::unknown  // -> Truth::unknown
/// Example certainly(Truth::unknown)  // -> no
enum class Truth : std::uint8_t { no, yes, unknown };

[[nodiscard]] constexpr bool certainly(Truth t) noexcept { return t == Truth::yes; }
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

} // namespace kov
