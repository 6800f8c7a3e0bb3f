#pragma once
// Invariant sets, most of them linear subspaces, that can be read off the vector field.
//
//   coordinate subspaces  {x_i = 0, i in S}: every term of X_i, i in S, contains a factor x_k,
//                         k in S
//   shifted subspaces     {x_i = c_i, i in S}, the c_i roots of factors of the X_j of degree 1
//   fixed sets            Fix(sigma) of an involution sigma(x)_j = +-x_pi(j) with sigma_* X = X
//   lines                 of systems with two degrees of freedom (lines.hpp; Darboux points of
//                         homogeneous potentials among them), or with more (directions.hpp), or in
//                         subspaces with two (subspace.hpp)
//   parts at rest         y = y_0 where y' and the rest of the system do not meet (rests.hpp)
//   ratios                {exp(a.q) = s exp(b.q), (a - b).q' = 0}
//   intersections         of two of these sets
//
// Each set found is proved invariant; nothing is claimed about completeness.
//
// Source  docs/theory/mechanics.md (4)

#include "manifold/invariant_manifold.hpp"

namespace kov {

struct FoundManifold {
  std::vector<Equation> equations;
  std::string kind; ///< "coordinate subspace", "fixed points of ...", "line ..."
  int dimension = 0;
  int integrals = 0;                    ///< independent ones among the given, restricted to it
  std::vector<std::size_t> independent; ///< their indices among the given
  bool equilibria = false;              ///< the field vanishes on it
  /// dimension - integrals: 1 means that levels cut out phase curves.
  [[nodiscard]] int leaf_dimension() const noexcept { return dimension - integrals; }
};

struct FoundManifolds {
  /// Sets with leaf dimension 1 first, then by dimension; sets of equilibria last.
  std::vector<FoundManifold> proved;
  std::vector<std::string> left_out; ///< searches and sets that a limit left out, as sentences
  /// Parameters for which there may be more lines: in each list all vanish.
  std::vector<std::vector<MPoly>> special = {};
  /// With a square root of one of these as an algebraic constant there may be more lines, where
  /// there are more than two degrees of freedom or function symbols.
  std::vector<MPoly> wanted = {};
};

/// An equation of a found set as a system file reads it: the text of some has derivatives, y' = x'.
[[nodiscard]] std::string text_in_file(const Equation& e);

/// Cost   2^n subsets of n variables (n <= 16), involutions for n <= 8
/// Errors none of limits: what was proved before one is returned, with the limit
[[nodiscard]] FoundManifolds find_manifolds(const VectorField& v,
                                            const std::vector<MFraction>& integrals,
                                            const Budget& budget = {});

} // namespace kov
