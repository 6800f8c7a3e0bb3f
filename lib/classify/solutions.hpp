#pragma once
// The particular solutions along which a system is studied: the manifolds of the file, and those
// that find_manifolds() finds by itself, cut out by levels of known integrals.

#include "integrability/report.hpp"

namespace kov {

/// The system with claims for first integrals and Casimirs that the file does not state: those of
/// degree <= 2 that hold for all parameters, independent of what is stated.  They cut manifolds into
/// curves and reduce variational equations.
/// A budget that is spent is not an error: nothing is added then.
[[nodiscard]] System with_found_integrals(System s, const Budget& budget);

/// A first integral with the parameter that names its level.
struct KnownLevel {
  MFraction integral;
  std::size_t level = 0;
  std::optional<std::size_t> claim; ///< of the file, that says so; unset: the Hamiltonian
};

/// A system with a name for the level of each integral that it states and that is proved.
struct LevelledSystem {
  System system;
  std::vector<ClaimReport> claims; ///< in its ring
  std::vector<KnownLevel> levels;
};
/// The parameters of the result begin with those of s, at the same places of the ring.
[[nodiscard]] LevelledSystem with_levels(const System& s, std::vector<ClaimReport> claims);

/// Three or more, without those that label levels: then the cheap ways come first.
[[nodiscard]] bool has_many_parameters(const System& s, const std::vector<KnownLevel>& levels);

struct ParticularSolutions {
  std::vector<ManifoldSpec> manifolds; ///< those of the file first; each set once
  std::vector<std::string> left_out;   ///< searches that a limit ended, as sentences
  /// Again, for what is left: where H = 0, and with more free levels.
  std::vector<ManifoldSpec> at_energy_zero = {}, at_all_levels = {};
  std::vector<std::vector<MPoly>> special = {}; ///< where all of a list vanish there may be more
  std::vector<MPoly> wanted = {}; ///< with a square root of one of these there may be more
};
/// search: also those that the file does not name.
[[nodiscard]] ParticularSolutions particular_solutions(const System& s,
                                                       const std::vector<KnownLevel>& levels,
                                                       bool search, const Budget& budget);

} // namespace kov
