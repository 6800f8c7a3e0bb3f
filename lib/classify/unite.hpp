#pragma once
// Integrable strata that adjoin one another, as one set with one list of integrals.

#include "study/classification.hpp"
#include "system/system.hpp"

namespace kov {

/// The same integrals may serve where P = 0 and where P != 0: then both strata have them, and are one if that can be
/// proved at once.
/// Errors  OutOfBudget; then the strata are as they were
/// Source  docs/theory/classify.md (7)
void unite_integrable(const System& s, SystemClassification& c, const Budget& budget);

} // namespace kov
