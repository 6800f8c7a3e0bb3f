#pragma once
// Finite or infinite dihedral: is u = y1/y2 algebraic?
//
// Let F = (y1 y2)^2 in K(z) span the invariants of degree 4, F = k F0 g^2 with F0 squarefree, and
// w^2 = 3F'^2/(4F) - F'' + 4rF, a constant.  On the curve C: s^2 = F0 we have u = exp int eta,
//
//   eta = W dz/(g s),   W^2 = w^2/k,
//
// and the group is finite exactly when N eta = dh/h for some N >= 1 and some function h on C; the
// least such N is the n of the binary dihedral group of order 4n.  Residues of eta not in Q, or
// poles of higher order, or no poles at all (genus >= 1): infinite.  Otherwise let L be the common
// denominator of the residues and E = sum L res(P) P.  Genus 0: N = L.  Genus >= 1: N = L N' with
// N' the order of E in the Jacobian; reduction modulo good primes is injective on torsion, so two
// primes that disagree prove "infinite", and an h proves "finite" (dihedral_torsion.md 9).  Where
// the order modulo primes is beyond reach, p-curvatures prove "infinite" (7).
//
// Source  docs/theory/dihedral_torsion.md

#include "exact/budget.hpp"
#include "exact/modular.hpp"
#include "exact/truth.hpp"
#include "galois/infinite_torsion.hpp"
#include "invariant/invariant.hpp"
#include "linode/singularities.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

/// F = (y1 y2)^2 = k Q^2 prod q_i^e_i over the finite places q_i: at an ordinary point y1 and y2 do
/// not vanish together, so that zeros there are double.
struct QuarticRoot {
  Poly q;              ///< Q, monic, coprime to the places
  std::vector<long> e; ///< parallel to Singularities::finite
  NfElem k;
  NfElem w_squared; ///< 3F'^2/(4F) - F'' + 4rF
};
/// Requires  v spans the rational solutions of Sym^4 (the form is then a square or a fourth power).
/// Throws    InternalError when F has another shape
[[nodiscard]] QuarticRoot quartic_root(const Invariant& v, const Singularities& s);

/// The curve and differential of a dihedral equation.
struct DihedralCurve {
  Field field;
  NfElem w_squared; ///< w^2, not 0
  NfElem k;         ///< F = k F0 g^2
  Poly branch;      ///< F0, monic squarefree, not 1
  RationalFunction g;
  Poly ordinary;              ///< Q: simple zeros of g at ordinary points
  std::vector<Poly> singular; ///< the places where g has a zero
  std::vector<long> order;    ///< its order there
  long genus = 0;
};

/// One prime's answer about the class of E.
struct ReducedOrder {
  PrimeIdeal prime;
  Integer order;
};

/// The fact that settles "finite or infinite?" (docs/theory/dihedral_torsion.md, 4 to 9).
enum class Torsion : std::uint8_t {
  undecided,          ///< no order modulo two primes was found, and p-curvatures vanish
  irrational_residue, ///< of w dz/v at `pole`: infinite
  multiple_pole,      ///< of w dz/v at `pole`: infinite
  holomorphic,        ///< no poles at all, genus >= 1: infinite
  genus_zero,         ///< rational residues: finite, n their common denominator
  orders_differ,      ///< modulo two primes: infinite
  no_function,        ///< with the only possible order: infinite
  curvatures,         ///< the order would be divisible by too many primes: infinite
  function            ///< h = a + b s: finite
};

/// Finite (D_n) or infinite, and what settles it.
struct DihedralAnswer {
  Truth finite = Truth::unknown;
  Torsion by = Torsion::undecided;
  Integer n;                ///< of D_n, if finite
  std::optional<Poly> pole; ///< where by = irrational_residue or multiple_pole; unset: infinity
  std::optional<NfElem> residue_squared;     ///< of the irrational residue, where it is one number
  Integer residue_denominator{1};            ///< L
  std::vector<ReducedOrder> orders;          ///< what primes said, where they were asked
  std::optional<InfiniteTorsion> curvatures; ///< by = curvatures
  std::optional<RationalFunction> a;         ///< finite, genus >= 1: h = a + b s
};

/// Requires w^2 != 0 and some e odd.
[[nodiscard]] DihedralCurve dihedral_curve(const QuarticRoot& root, const Singularities& s);
/// s: the local data of the equation.
/// Requires  every exponent difference rational and no logarithm (otherwise the group is infinite).
/// Unknown   large genus and a large order
/// Throws    OutOfBudget
/// Given     const RationalFunction r = RationalFunction(-3, 16*z*z) -
///               RationalFunction(3, 16*(z - 1)*(z - 1)) + RationalFunction(11, 72*z*(z - 1));
/// Given     const Classification known = classify(r);
/// Given     const DihedralCurve curve = *known.curve;
/// Example   curve.branch  // -> z^2 - z
/// Example   decide_dihedral(curve, *known.local).n  // -> 3
[[nodiscard]] DihedralAnswer decide_dihedral(const DihedralCurve& curve, const Singularities& s,
                                             const Budget& budget = {});

} // namespace kov
