#pragma once
// The first logarithm of the variational equations of higher order at a place.
//
// x = sum xi_j, y = y(t) + sum eta_j with xi_j, eta_j homogeneous of degree j in (c1, c2) and
// xi_1 = c1 u1 + c2 u2 solves the equations of motion for each e.  xi_j'' = w xi_j + F_j,
// eta_j'' = v eta_j + G_j, and a logarithm appears where one of the residues of F_j u_1, F_j u_2
// (and, never, of G_j y_t, G_j y_e) is not 0.   docs/theory/jets.md 3, 4
//
// Cost  j-th order: O(j^3) products of series

#include "jets/place.hpp"

namespace kov::jets {

struct Logarithm {
  int order = 0; ///< of the variational equation
  /// R(c1, c2), homogeneous of degree order + 1: the local monodromy is exp of a multiple of its
  /// Hamiltonian field, up to terms of higher order.
  MFraction form;
  /// xi_2, ..., xi_(order - 1) and eta_2, ..., eta_(order - 1)
  std::vector<Series> across, along;
};

/// orders 2..up_to; unset: none of them has a logarithm there, for any value of e.
/// Errors  NeedsMoreTerms, OutOfBudget
[[nodiscard]] std::optional<Logarithm> first_logarithm(const InvariantPlane& plane, const Place& p,
                                                       int up_to, const Budget& budget);

} // namespace kov::jets
