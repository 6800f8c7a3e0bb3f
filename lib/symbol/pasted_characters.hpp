#pragma once
// Characters that people paste (primes, minus signs, powers, Greek letters) in plain ASCII, each byte with the place
// that it came from.  Used by pasted.hpp only.

#include "symbol/input_error.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kov {

struct PlainCharacters {
  std::string text;
  std::vector<std::uint32_t>
      from;            ///< of each byte of `text`, and of its end: a byte of the original
  bool dotted = false; ///< a letter has a dot above
};

/// Greek letters become their names, sub- and superscripts digits and powers, dots above a letter primes; what stands
/// for nothing is reported in `errors`, all of it.
/// Given   std::vector<InputError> none;
/// Given   const auto plain = [&](const char* s) {
///             return plain_characters(s, origin_of_text("-e", s), none).text; };
/// Example plain("y\u2033 \u2212 x\u00b2\u00b7y")  // -> y'' - x^2*y
[[nodiscard]] PlainCharacters plain_characters(std::string_view text, const OriginPtr& origin,
                                               std::vector<InputError>& errors);

/// alpha, beta, ..., Omega
[[nodiscard]] bool is_greek(std::string_view name);

} // namespace kov
