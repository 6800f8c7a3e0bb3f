#pragma once
// Every sentence about a stratum: read from its values, never read back.

#include "strata/decide_strata.hpp"

namespace kov::strata {

using kov::to_string; // of conditions

/// "a != 0", "nu is in 1/2 + Z"; empty: always.
[[nodiscard]] std::vector<std::string> condition_texts(const Stratum& s);
/// Why the verdict holds, or "undecided: ..."
[[nodiscard]] std::string reason(const Leaf& leaf);
/// The same without long formulas.
[[nodiscard]] std::string reason_in_brief(const Leaf& leaf);
/// "SL(2, C)", "diagonal or dihedral"; empty where nothing is known.
/// Example group_text(std::get<Leaf>(decide_leaf(z + a, 0, everywhere)))  // -> SL(2, C)
[[nodiscard]] std::string group_text(const Leaf& leaf);
/// "abelian only if ..."; empty where the stratum is decided.
[[nodiscard]] std::string open_condition(const Leaf& leaf);
/// "two poles meet"
[[nodiscard]] std::string to_string(const Event& e);
/// The sentence about what is wrong where all of them vanish.
[[nodiscard]] std::string sentence(const Genericity& g);
/// Why a stratum is empty, or nothing is known of it; empty: it is not said.
[[nodiscard]] std::string to_string(const WhyEnded& why);

} // namespace kov::strata
