#pragma once
// Statements on numbers that depend on a level: what they say for some level.
//
// If x changes with the level, it is in no given countable set for all levels but countably many:
// neither an integer nor rational.
//
// Source  docs/theory/classify.md (1, 2)

#include "parameters/statement.hpp"

namespace kov {

/// Lists of conditions, of which one holds, at levels outside of a countable set.
struct AtGeneralLevel {
  std::vector<std::vector<Statement>> parts; ///< more may hold; none: nothing holds
  /// That is so where each of these changes with the level.
  std::vector<MFraction> changing;
};

/// levels: the variables of which one may choose the value.
/// Given   const Ring ring = make_ring({"s", "h"});
/// Given   const MFraction s = MFraction::variable(ring, "s"), h = MFraction::variable(ring, "h");
/// Given   const Statement rational{AllRational{{s * s, h * h}}}, integer{SumIn{{s * s}, {all_integers}}};
/// Example at_general_level({{rational}, {integer}}, {1}).parts.size()  // -> 1
/// Example at_general_level({{rational}, {integer}}, {1}).changing.at(0)  // -> h^2
[[nodiscard]] AtGeneralLevel at_general_level(std::vector<std::vector<Statement>> parts,
                                              const std::vector<std::size_t>& levels);

} // namespace kov
