#pragma once
// The part of lowest, or of highest, order of a body on e(3)*: a family of its own.
//
// Source  docs/theory/moves.md (4)

#include "moves/equivalence.hpp"
#include "system/weights.hpp"

namespace kov {

enum class Order : std::uint8_t {
  lowest, ///< of integrals that are meromorphic near the origin
  highest ///< of rational ones; H a polynomial in the coordinates
};

struct LeadingPart {
  Order order = Order::lowest;
  long of_momentum = 1, of_gamma = 1; ///< weights
  System system;                      ///< with the same bracket, and parameters but those of levels
  MPoly nonzero;                      ///< the denominator of H at the origin
};

/// Unset: there is none with terms in M and in Gamma that is not all of H; another bracket; a pole.
[[nodiscard]] std::optional<LeadingPart> leading_part(const System& s, Order order = Order::lowest);

/// The set excluded for the leading part, said of the system.  Unset: none, or only for a class of integrals
/// that need not contain all rational ones, or along no curve on a regular leaf.
[[nodiscard]] std::optional<Preimage> said_by(const System& s, const LeadingPart& part,
                                              const ClassifiedStratum& x);

} // namespace kov
