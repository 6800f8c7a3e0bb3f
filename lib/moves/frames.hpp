#pragma once
// Rotations of a family that move its parameters: a frame in which one of them is 0.
//
// Source  docs/theory/moves.md (2)

#include "moves/equivalence.hpp"

namespace kov {

/// A linear vector field on the phase space that keeps the bracket, and one on the parameters, with
/// xi(H) + eta(H) = 0: together they carry the family into itself.
struct InfinitesimalSymmetry {
  Matrix phase;        ///< xi = A x
  Substitution moving; ///< eta: of the parameters that it moves
};
/// A basis of those with coefficients in the parameters; those with a constant A first, if one can tell.
/// Errors  OutOfBudget
[[nodiscard]] std::vector<InfinitesimalSymmetry>
infinitesimal_symmetries(const System& s, const Budget& budget = {});

/// A rotation to parameters at which one of them is 0, where the sum of two squares is not.
struct Frame {
  std::size_t vanishing = 0;
  Equivalence to;
};
/// Unset: there is none, or something is assumed of these parameters but that they are real.
/// Errors  OutOfBudget
[[nodiscard]] std::optional<Frame> find_frame(const System& s, const Budget& budget = {});

} // namespace kov
