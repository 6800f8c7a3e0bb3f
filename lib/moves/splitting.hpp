#pragma once
// No further integral, if a perturbation of the free rigid body splits the separatrices of that body.
//
// The parameters that are made small are found: a change of scale that leaves the moments of inertia as
// they are takes every value of them to small ones.  So what is proved for small values holds for all.
//
// Source  docs/theory/moves.md (3), docs/theory/splitting.md

#include "moves/e3.hpp"
#include "study/exclusion.hpp"
#include "system/weights.hpp"

namespace kov {

/// One order of the moments, and where all sums of residues vanish: sets of equations.
struct OrderOfMoments {
  std::array<std::size_t, 3> axes; ///< that of the largest moment first
  std::vector<std::vector<MPoly>> left;
};

/// The set excluded: three different moments, not all small parameters 0, none of `nonzero` 0, and for no
/// order all equations of a set that is left.
struct SplittingFinding {
  FreeBody body;
  Weights small;                      ///< H at eps^w p is H at p in scaled variables and time
  std::vector<std::size_t> direction; ///< those in the leading term
  long order = 1;                     ///< of that term
  std::vector<MPoly> nonzero;
  std::vector<OrderOfMoments> orders;
  ParameterValues at = {};           ///< the values of parameters of the file
  std::vector<Trusted> trusted = {}; ///< that other orders, or what is left of some, are empty
};

/// Unset: the system is not a perturbed free body with moments and real parameters that may differ, or the
/// criterion says nothing.
/// Errors  OutOfBudget
[[nodiscard]] std::optional<SplittingFinding> find_splitting(const System& s, const Budget& budget);
[[nodiscard]] Exclusion exclusion(const System& s, const SplittingFinding& found);

} // namespace kov
