#pragma once
// One assumption as text: where its formula ends and what is said of it.

#include "strata/conditions.hpp"
#include "symbol/expression.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace kov {

struct Sentence {
  enum class Kind : std::uint8_t { sign, membership, declaration };
  Kind kind = Kind::declaration;
  Expression left;
  std::optional<Expression> right; ///< sign: left - right is meant; membership: the offset
  strata::Sign sign = strata::Sign::nonzero;
  bool holds = true;  ///< membership: in, or not in
  Integer modulus{1}; ///< membership: left - offset in modulus Z
  bool real = false;  ///< declaration: the name is real
};

/// "A > 0, n not an integer" in parts.  Errors  InputError
[[nodiscard]] std::vector<Sentence> sentences(const std::string& text);

} // namespace kov
