#pragma once
// Facts that checked steps establish, in the form in which later steps use them.  Statement numbers
// refer to docs/theory/local_exponents.md unless another page is named.

#include "certify/equation/check.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace kov::certify {

/// The exponents at the n points of a place, as far as they are proved.
struct ExponentData {
  long n = 1;
  long order = 0;                  ///< of the pole of r; at infinity of r(1/t)/t^4 at t = 0
  std::optional<Rational> delta{}; ///< the exponent difference, if proved rational
  bool irrational = false;         ///< proved irrational at every point
  long logs = 0;                   ///< number of points with a proved logarithm
  std::optional<Rational> real{};  ///< bound of |Re Delta| (order 2) or |Re eps| (even order >= 4)

  [[nodiscard]] bool ramified() const { return order >= 3 && order % 2 == 1; }
  [[nodiscard]] bool infinite_order() const { return order >= 3 || irrational; }
  [[nodiscard]] bool has_log() const { return logs > 0; }
  /// Order 2, and the exponent difference is not known at all.
  [[nodiscard]] bool open() const { return order == 2 && !delta && !irrational; }
  /// Lower bound for the order at each point of a rational solution of Sym^m, m even (2.1); nothing
  /// if there is none.  An open difference has the value `open_delta`, else it counts as irrational.
  [[nodiscard]] std::optional<Integer>
  lowest(long m, const std::optional<Rational>& open_delta = std::nullopt) const;
  /// Lower bound for the sum over the points of Re alpha, y'/y = alpha/t + ... (3.1), if `real` allows
  /// one.
  [[nodiscard]] std::optional<Rational> lowest_exponent() const;
};

/// All singular places and infinity, which is last.
template <class Place> struct LocalData {
  std::vector<Place> all{};

  [[nodiscard]] bool any(bool (Place::*property)() const) const {
    return std::ranges::any_of(all, [&](const auto& x) { return (x.*property)(); });
  }
  [[nodiscard]] bool has_log() const { return any(&Place::has_log); }
  [[nodiscard]] bool infinite_order() const { return any(&Place::infinite_order); }
  /// D_m, m even, or nothing when some place allows no exponent (2.2).
  [[nodiscard]] std::optional<Integer>
  degree_bound(long m, const std::optional<Rational>& open_delta = std::nullopt) const {
    Integer D(m);
    for (const Place& x : all) {
      const auto e = x.lowest(m, open_delta);
      if (!e) return std::nullopt;
      D -= *e * Integer(x.n);
    }
    return D;
  }
  /// D_1 (3.2) before rounding, if there are bounds of all real parts.
  [[nodiscard]] std::optional<Rational> degree_bound_1() const {
    Rational D(1);
    for (const Place& x : all) {
      const auto e = x.lowest_exponent();
      if (!e) return std::nullopt;
      D -= *e;
    }
    return D;
  }
  /// Lcm of the denominators of (1 + Delta)/2 over the finite places.
  [[nodiscard]] Integer character_order() const {
    Integer n(1);
    for (const Place& x : all)
      if (x.q) n = lcm(n, ((Rational(1) + x.delta.value_or(1)) / Rational(2)).den());
    return n;
  }
};

/// n conjugate points with the same data.
struct PlaceFact : ExponentData {
  std::optional<Poly> q; ///< unset at infinity

  PlaceFact(std::optional<Poly> place, long points, long pole_order);

  /// Takes over Delta^2 (order 2) or eps^2 (even order >= 4), with a polynomial over Q that
  /// vanishes on it if it is not a rational constant.
  void set_square(const Poly& value, const std::optional<Poly>& annihilator);
  /// May the two lines of an imprimitive group be exchanged around this place?  (p_curvature.md)
  [[nodiscard]] bool exchanges_lines() const;
};

struct InvariantFact;

struct LocalFact : LocalData<PlaceFact> {
  [[nodiscard]] const PlaceFact& infinity() const { return all.back(); }
  /// By its number, or infinity.  Refuses a number that none has.
  [[nodiscard]] const PlaceFact& place(std::optional<long> number) const;
  /// Refuses unless every exponent difference is proved rational and every place regular.
  void need_rational() const;
  /// D_m, or -1; refuses an open exponent difference.
  [[nodiscard]] Integer degree_bound(long m) const;
  [[nodiscard]] Integer degree_bound_1() const; ///< Refuses a ramified place.
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
