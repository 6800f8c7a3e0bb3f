#pragma once
// Facts that checked steps establish, in the form in which later steps use them.  Statement numbers
// refer to docs/theory/local_exponents.md unless another page is named.

#include "certify/equation/check.hpp"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace kov::certify {

/// n conjugate points with the same data.
struct PlaceFact {
  std::optional<Poly> q; ///< unset at infinity
  long n = 1;
  long order = 0;                ///< of the pole of r; at infinity of r(1/t)/t^4 at t = 0
  std::optional<Rational> delta; ///< the exponent difference, if proved rational
  bool irrational = false;       ///< proved irrational at every point
  long logs = 0;                 ///< number of points with a proved logarithm
  std::optional<Rational> real;  ///< bound of |Re Delta| (order 2) or |Re eps| (even order >= 4)

  PlaceFact(std::optional<Poly> place, long points, long pole_order);

  /// Takes over Delta^2 (order 2) or eps^2 (even order >= 4), with a polynomial over Q that
  /// vanishes on it if it is not a rational constant.
  void set_square(const Poly& value, const std::optional<Poly>& annihilator);
  [[nodiscard]] bool ramified() const { return order >= 3 && order % 2 == 1; }
  [[nodiscard]] bool infinite_order() const { return order >= 3 || irrational; }
  /// May the two lines of an imprimitive group be exchanged around this place?  (p_curvature.md)
  [[nodiscard]] bool exchanges_lines() const;
  /// Lower bound for the order at each point of a rational solution of Sym^m, m even (2.1); nothing
  /// if there is none.
  [[nodiscard]] std::optional<long> lowest(long m) const;
  /// Lower bound for the sum over the points of Re alpha, y'/y = alpha/t + ... (3.1).
  [[nodiscard]] Rational lowest_exponent() const;
};

struct InvariantFact;

struct LocalFact {
  std::vector<PlaceFact> places;
  PlaceFact infinity;

  [[nodiscard]] bool any(bool (PlaceFact::*property)() const) const;
  [[nodiscard]] bool infinite_order() const { return any(&PlaceFact::infinite_order); }
  [[nodiscard]] bool has_log() const;
  /// Refuses unless every exponent difference is proved rational and every place regular.
  void need_rational() const;
  /// D_m, or -1 when some place allows no exponent (2.2).
  [[nodiscard]] Integer degree_bound(long m) const;
  [[nodiscard]] Integer degree_bound_1() const; ///< D_1 (3.2)
  /// Lcm of the denominators of (1 + Delta)/2 over the finite places.
  [[nodiscard]] Integer character_order() const;
  /// Lcm of the denominators of Delta where v does not branch (dihedral_torsion.md).
  [[nodiscard]] Integer residue_denominator(const InvariantFact& v) const;
};

struct ExponentialFact {};
struct IrreducibleFact {};

/// v = p prod q^e, a solution of Sym^m.
struct InvariantFact {
  Invariant data;
  Poly branch;      ///< F0 = the product of the q with half-integer e
  NfElem w_squared; ///< m = 2: v'^2 - 2 v v'' + 4 r v^2, a constant

  /// v/sqrt(F0) = A/B.
  [[nodiscard]] std::pair<Poly, Poly> fraction() const;
  /// Is w dz/v a holomorphic differential?  true is a proof (dihedral_torsion.md 8).
  [[nodiscard]] bool holomorphic_quotient() const;
};

struct AbsentFact { ///< Sym^m has no rational solution
  long m = 0;
};
struct PCurvatureFact {
  mp_limb_t p = 0;
  std::string shows;
};
struct TorsionFact {
  long n = 0;
  const InvariantFact* of = nullptr;
};
/// The prime-to-p part of the torsion order is at most bound.
struct ReductionFact {
  mp_limb_t p = 0;
  Integer bound;
  const InvariantFact* of = nullptr;
};
struct Conclusion {
  std::optional<std::string> group;
  std::optional<Integer> n;
  std::optional<bool> abelian;
};

using Fact = std::variant<LocalFact, ExponentialFact, IrreducibleFact, InvariantFact, AbsentFact,
                          PCurvatureFact, TorsionFact, ReductionFact, Conclusion>;
/// Facts do not move: TorsionFact and ReductionFact point to an InvariantFact.
using Premises = std::vector<const Fact*>;

/// The first premise of a kind, or null.
template <class T> [[nodiscard]] const T* find(const Premises& premises) {
  for (const Fact* f : premises)
    if (const T* x = std::get_if<T>(f)) return x;
  return nullptr;
}

} // namespace kov::certify
