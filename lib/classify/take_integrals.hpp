#pragma once
// Conclusions about the open sets from first integrals that were found.

#include "classify/board.hpp"

namespace kov {

[[nodiscard]] bool is_enough(const System& s, const IntegralsOfSet& set);
/// Beside H and written without algebraic constants of ours, where they are more than what the piece has.
void keep_integrals(const System& s, const IntegralsOfSet& set, Undecided& piece);
/// Sets are cut along their equations in this order: what several have in common leaves few parts.
void common_equations_first(const System& s, std::vector<IntegralsOfSet>& sets);
/// The set on which the integrals are what they are.
[[nodiscard]] Exclusion conditions_of(const System& s, const IntegralsOfSet& set,
                                      const std::vector<MPoly>& not_covered);
/// Pieces inside the set go to `met`, or are done with.
void take_integrals(Board& b, Round& round, const IntegralsOfSet& set,
                    const std::vector<MPoly>& not_covered, std::vector<Undecided>& met);
/// The same for the pieces that met no set.
void take_elsewhere(Board& b, Round& round, const IntegralsOfSet& set,
                    const std::vector<MPoly>& not_covered);
/// The search and its result, in words.
[[nodiscard]] std::string searched_text(const IntegralsOfSet& set);

} // namespace kov
