#pragma once
// On which levels of known first integrals the phase curves lie along which something was proved.

#include <cstdint>
#include <string>
#include <vector>

namespace kov {

/// left = right, formulas: "h = 1/2", "h^2 - 3 = 0".
struct LevelEquation {
  std::string left, right;
  friend bool operator==(const LevelEquation&, const LevelEquation&) = default;
};
/// Example sentence(LevelEquation{"h", "1/2"})  // -> h = 1/2
[[nodiscard]] std::string sentence(const LevelEquation& e);

/// A value for each level; empty: the level was not free, or is a general one.
using LevelChoice = std::vector<LevelEquation>;
[[nodiscard]] std::string sentence(const LevelChoice& c);
/// Each of which is needed for some parameters: "h = 0 or a general level".
[[nodiscard]] std::string sentence(const std::vector<LevelChoice>& all);

struct Levels {
  enum class Which : std::uint8_t {
    none,      ///< no level is free, or it is not said which
    these,     ///< `values`
    of_energy, ///< the same, of the energy alone
    all_but_special,
    all_but_finitely_many,  ///< energies
    all_but_countably_many, ///< energies
    energy_not_zero,
    energy_of_part_not_zero
  };
  Which which = Which::none;
  std::vector<LevelChoice> values = {};
  std::vector<std::string> fixed = {}; ///< by the file, in its words: "G1^2 + G2^2 + G3^2 = 1"
  std::vector<std::string> ones = {};  ///< parameters that are 1 by a change of scale

  [[nodiscard]] bool empty() const { return *this == Levels{}; }
  friend bool operator==(const Levels&, const Levels&) = default;
};
/// These, or none where the choice is empty.
[[nodiscard]] Levels levels_at(const LevelChoice& c);
/// Example sentence(Levels{Levels::Which::all_but_special})
///         // -> all levels of the first integrals except special ones
[[nodiscard]] std::string sentence(const Levels& l);

} // namespace kov
