#pragma once
// The answer of a study in one line: the same for each command that asks.

#include "integrability/verdict.hpp"
#include "literature/integral_class.hpp"

#include <span>

namespace kov::study {

struct Headline {
  Verdict verdict = Verdict::undecided;
  std::vector<IntegralClass> excluded; ///< of these classes at once, for some parameters at least
  std::size_t trusted = 0;             ///< steps on trust
  std::size_t unchecked = 0;           ///< hypotheses that are not proved
  std::size_t refused = 0;             ///< manifolds that are not invariant
  bool complete = true;                ///< no limit and no error of the program ended a part of it
  friend bool operator==(const Headline&, const Headline&) = default;
};

/// The verdict on sets that are all parameters: are some of them open, integrable, excluded?  Without sets: undecided.
/// Example verdict_of_sets(false, true, true) == Verdict::depends  // -> yes
[[nodiscard]] Verdict verdict_of_sets(bool open, bool integrable, bool excluded);

/// The headline of a file: one manifold that proves non-integrability is enough, or several together;
/// otherwise all have to be decided.  together: what they exclude, null where nobody asked.
/// Example headline(std::vector<Headline>{}).verdict == Verdict::undecided  // -> yes
[[nodiscard]] Headline headline(std::span<const Headline> manifolds,
                                const Headline* together = nullptr);

} // namespace kov::study
