#pragma once
// The answer of a formula for a family about one of its members.

#include "exact/truth.hpp"
#include "galois/group.hpp"

#include <optional>
#include <string>

namespace kov {

/// The group by a closed formula; nothing here was found by a search.
/// Example ClosedAnswer::of({GroupType::Dinf, {}}, "m is in 1/2 + Z").abelian  // -> Truth::yes
struct ClosedAnswer {
  std::optional<GaloisGroup> group; ///< unset: the formula does not tell it (see reason)
  Truth abelian = Truth::unknown;   ///< is the identity component abelian?
  std::string reason;
  std::optional<Connected> component = std::nullopt; ///< known where the group is, or was

  [[nodiscard]] static ClosedAnswer of(GaloisGroup g, std::string reason) {
    const Connected component = identity_component(g);
    return {std::move(g), truth(is_abelian(component)), std::move(reason), component};
  }
};

} // namespace kov
