#pragma once
// Invariant manifolds, proved, and the particular solutions on them.
//
// A set {f_1 = ... = f_k = 0} is invariant when each X(f_i) vanishes on it; that is an ideal
// membership over Q(parameters).  The levels F = c of first integrals cut out a curve, the phase
// curve Gamma of a family of particular solutions; no solution formula is needed, since all
// functions of time that occur are elements of the function field of that curve.

#include "system/claims.hpp"
#include "system/system.hpp"

#include <memory>
#include <variant>

namespace kov {

struct InvariantManifold {
  std::string name;
  std::vector<Equation> equations;
  std::vector<Equation> levels;
  std::shared_ptr<const Ideal> ideal; ///< equations and relations
  std::shared_ptr<const Ideal> curve; ///< with the levels
  std::vector<MPoly> nonzero;
  /// Variables that the equations determine, e.g. M1 -> 0; applied everywhere for readable results.
  Substitution solved;
  bool linear = false;                ///< `solved` says everything that the equations say
  std::vector<std::string> proof;     ///< one line per statement proved
  std::vector<std::string> rewritten; ///< one line per equation read without its multiplicities

  /// f restricted to the manifold (not to the levels).
  [[nodiscard]] MFraction restrict(const MFraction& f) const;
  /// f is in the ideal of the phase curve.  "Yes" is a proof; "no" is one if the ideal is radical,
  /// so that everything divided by is recorded and must turn out to be a unit of the function
  /// field.
  [[nodiscard]] bool vanishes_on_curve(const MFraction& f) const;
};

/// Why a set is not what its file says.
struct ManifoldFailure {
  std::string message; ///< a full sentence
  std::string component;
  MFraction value; ///< what should vanish and does not
};

/// Proves invariance and that the levels are first integrals on it, and that the result is a curve
/// on which the field is not zero.   Errors  OutOfBudget, here and in all work with its ideals
[[nodiscard]] std::variant<InvariantManifold, ManifoldFailure>
prove_invariant(const VectorField& v, const ManifoldSpec& spec, const Budget& budget = {});

/// Factors of a function that vanishes on the phase curve, none of which does: the curve has
/// several components.  Empty: none was seen, which proves nothing.
[[nodiscard]] std::vector<MPoly> factors_on_components(const InvariantManifold& m);

/// Invariance alone: the reduced derivative of the first equation that fails, or nothing.
[[nodiscard]] std::optional<ManifoldFailure>
invariance_failure(const VectorField& v, const std::vector<Equation>& equations,
                   const Ideal& ideal);

} // namespace kov
