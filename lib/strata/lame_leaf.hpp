#pragma once
// Lame's equation on a stratum.  docs/theory/lame.md; strata.md, 10

#include "special/lame_family.hpp"
#include "strata/classical.hpp"

namespace kov::strata {

/// As classical_answer.  Unset: the degenerate curve, where the equation is another classical one.
/// Throws  OutOfBudget
[[nodiscard]] std::variant<std::monostate, ClassicalAnswer, Needs>
lame_answer_on(const LameFamilyForm& form, const Region& region, const Budget& budget);

} // namespace kov::strata
