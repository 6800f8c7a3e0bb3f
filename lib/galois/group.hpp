#pragma once
// Algebraic subgroups of SL(2, C), by name, and their identity components.

#include "exact/integer.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace kov {

enum class GroupType : std::uint8_t {
  SL2,
  Borel,  ///< all triangular matrices, Gm semidirect Ga
  T,      ///< {(c d; 0 1/c) : c^n = 1}; T_1 = Ga
  Gm,     ///< all diagonal matrices
  cyclic, ///< order n, diagonal; n = 1 is the trivial group
  Dinf,   ///< infinite dihedral: the normaliser of the diagonal matrices
  D,      ///< binary dihedral of order 4n, n >= 2; n = 2 is the quaternion group
  A4,     ///< binary tetrahedral, order 24
  S4,     ///< binary octahedral, order 48
  A5      ///< binary icosahedral, order 120
};

/// A subgroup of SL(2, C) up to conjugation.
struct GaloisGroup {
  GroupType type = GroupType::SL2;
  std::optional<Integer> n; ///< T, cyclic and D only; unset there = not determined

  friend bool operator==(const GaloisGroup&, const GaloisGroup&) = default;
};

enum class Connected : std::uint8_t { trivial, additive, torus, borel, sl2 };

/// The component of the identity, a connected group.
/// Example identity_component({GroupType::Dinf, {}})  // -> Gm
[[nodiscard]] Connected identity_component(const GaloisGroup& g);
[[nodiscard]] constexpr bool is_abelian(Connected c) noexcept { return c < Connected::borel; }
[[nodiscard]] std::string to_string(GroupType t); ///< "SL2", "Borel", "T", ..., as in the JSON
[[nodiscard]] std::string to_string(Connected c); ///< "trivial", "Ga", "Gm", "Borel", "SL2"
/// For people.
/// Example describe({GroupType::D, 3})  // -> D_3 (binary dihedral of order 12)
[[nodiscard]] std::string describe(const GaloisGroup& g);
/// Kovacic's case: 1 reducible, 2 imprimitive, 3 finite primitive, 4 SL(2).
/// Example kovacic_case({GroupType::A5, {}})  // -> 3
[[nodiscard]] int kovacic_case(const GaloisGroup& g);

} // namespace kov
