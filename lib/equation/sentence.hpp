#pragma once
// One assumption as text: where its formula ends and what is said of it.

#include "equation/read_equation.hpp"
#include "parameters/conditions.hpp"
#include "system/system.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

struct Sentence {
  enum class Kind : std::uint8_t { sign, membership, declaration };
  Kind kind = Kind::declaration;
  Expression left;
  std::optional<Expression> right; ///< sign: left - right is meant; membership: the offset
  Sign sign = Sign::nonzero;
  bool holds = true;          ///< membership: in, or not in
  Rational modulus{1};        ///< membership: left - offset in modulus Z, positive
  std::optional<Sort> sort{}; ///< declaration: real, rational, or any complex number
  std::string text{};         ///< the sentence itself
  OriginPtr origin{};         ///< where it stands
  Span span{};

  [[nodiscard]] InputError error(const std::string& message, const std::string& hint = {}) const {
    return {*origin, span, message, hint};
  }
};

/// "A > 0, n not an integer" in parts.  Errors  InputError, also for a text without a sentence
/// Example sentences({"A > 0, B >= C, n not an integer", nullptr, ""}).size()  // -> 3
/// Example sentences({"k +- m not in 1/2+Z", nullptr, ""}).size()  // -> 2
/// Example sentences({"2*nu odd integer", nullptr, ""}).at(0).modulus  // -> 2
/// Example sentences({"n in N", nullptr, ""}).size()  // -> 2
/// Example sentences({"c is blue", nullptr, ""}).size()  // -> throws InputError
[[nodiscard]] std::vector<Sentence> sentences(const AssumedText& text);

/// Sorted, once each.
[[nodiscard]] std::vector<std::string> names_in(const Sentence& s);

} // namespace kov
