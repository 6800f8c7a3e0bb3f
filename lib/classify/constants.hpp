#pragma once
// Algebraic constants that the file does not have: square roots and eigenvalues over which solutions and
// their variations fall apart.
//
// Source  docs/theory/classify.md (7)

#include "classify/board.hpp"

namespace kov {

/// The system with constants that its solutions ask for.  Unset: they ask for none.
[[nodiscard]] std::optional<KnownSystem> with_constants(const Board& b);

/// From now on the question is that of the larger system: what is decided stays, and what is open is open
/// again.  False: a limit; nothing has changed.
bool go_on_with(Board& b, KnownSystem larger);

/// Leaves out the constants that occur in nothing that is shown.
void forget_unused_constants(const System& s, SystemClassification& c);

} // namespace kov
