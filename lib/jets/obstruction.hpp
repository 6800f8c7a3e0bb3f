#pragma once
// Obstructions to integrability by the variational equations of orders 2, 3, ... along an invariant plane.
//
// Not integrable, if at a place over infinity the first logarithm, R(c1, c2) at order k, commutes
// with no quadratic form but 0, and the group of the normal equation is infinite
// (docs/theory/jets.md 2.4).  Both are proved here or nothing is said; a logarithm alone is no
// obstruction, and no logarithm proves nothing.

#include "decide/decide.hpp"
#include "jets/logarithm.hpp"

namespace kov::jets {

/// Why the group of the normal equation is infinite.
enum class InfiniteGroup : std::uint8_t {
  first_family, ///< for all but countably many energies: the equation of the highest terms (2.6)
  homogeneous,  ///< for all energies but one: it is the equation of the highest terms (2.7)
  equilibria,   ///< for all but countably many energies: by its exponents at equilibria (2.9)
  decided       ///< at one energy: its identity component (2.8)
};

/// The system is not integrable where, of each list, some polynomial does not vanish.
struct HigherObstruction {
  Logarithm logarithm;  ///< the form in c1, c2, the parameters and the energy E
  MFraction local_form; ///< the same form in the free coefficient e of the solution
  Place place;
  InvariantPlane plane; ///< reflected for the place y = -infinity
  std::string within;   ///< "q3 = p3 = 0", or empty: the invariant subspace
  InfiniteGroup because = InfiniteGroup::first_family;
  std::optional<MFraction> energy;              ///< of the curve, if it was decided
  std::optional<Decision> group;                ///< where it was decided
  std::vector<std::vector<MPoly>> not_all_zero; ///< in the parameters, in the ring of the plane
  std::string certificate;                      ///< that our own checker accepted
  std::string no_certificate;                   ///< why there is none
};

struct HigherOrders {
  int up_to = 0; ///< the order that was looked at
  std::optional<HigherObstruction> obstruction;
  std::string open; ///< why there is none, as a clause; empty: no logarithm up to `up_to`
  std::optional<InvariantPlane> plane;
};

struct HigherOptions {
  int order = 3; ///< 2..largest_order
  Options decide;
};
inline constexpr int largest_order = 7;

/// Errors  InvalidArgument for another order; OutOfBudget is turned into `open`
[[nodiscard]] HigherOrders higher_orders(const System& s, const ManifoldSpec& m,
                                         const HigherOptions& options = {});

/// The 3x3 determinants of (c1 R_2, c2 R_2 - c1 R_1, c2 R_1) in the monomials of c1, c2, R_i =
/// dR/dc_i: some quadratic form but 0 commutes with R exactly where all vanish (2.5).
[[nodiscard]] std::vector<MPoly> commuting_determinants(const InvariantPlane& plane,
                                                        const MFraction& form);
/// Is a homogeneous potential of this degree k, with this difference of exponents at infinity, in
/// the first family of Morales-Ruiz and Ramis?  2k divides (k - 2)(difference -+ 1).
/// Example in_first_family(3, 5)  // -> yes
/// Example in_first_family(3, 9)  // -> no
[[nodiscard]] bool in_first_family(long degree, const Rational& difference);

} // namespace kov::jets
