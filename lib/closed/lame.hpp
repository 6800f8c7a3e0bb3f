#pragma once
// Lame's equation y_tt = (n(n+1) wp(t; g2, g3) + B) y: when is the identity component abelian?
//
//   n in Z          always; G = T_4 where w^2(B, g2, g3) = 0, else dihedral (finite or not)
//   n in 1/2 + Z    exactly where Q_m(B, g2, g3) = 0, m = |n + 1/2| >= 1: the quaternion group;
//                   SL2 elsewhere, and for n = -1/2
//   n + 1/2 = k/b   b = 3, 4, 5: exactly where the group is finite (S4 or A5), which happens on the
//                   common zeros of some polynomials in B, g2, g3
//   other n         never: SL2
//
// for g2^3 != 27 g3^2; on the degenerate curve the equation is one of Riemann, Bessel or Euler.
// n may be replaced by -1-n; n >= -1/2 is chosen.
//
// Source  docs/theory/lame.md, where all of this is proved

#include "closed/closed_answer.hpp"
#include "closed/kimura.hpp"
#include "closed/lame_polynomials.hpp"
#include "exact/budget.hpp"
#include "exact/rational_function.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace kov {

enum class LameCase : std::uint8_t {
  hermite,    ///< n in Z
  brioschi,   ///< n in 1/2 + Z
  polyhedral, ///< n + 1/2 = k/b in lowest terms, b = 3, 4 or 5
  other       ///< all other n, also irrational and complex ones
};

/// n for alpha = n(n+1), from (2n+1)^2 = 1 + 4 alpha.
struct LameIndex {
  LameCase kind = LameCase::other;
  std::optional<Rational> n; ///< >= -1/2; unset if n is irrational
};
/// Example lame_index(NfElem(2))  // -> {LameCase::hermite, 1}
/// Example lame_index(NfElem(3))  // -> {LameCase::other, none}
[[nodiscard]] LameIndex lame_index(const NfElem& alpha);
[[nodiscard]] LameIndex lame_index(const Rational& n);

/// The normal form r(x) of f y'' + f'/2 y' - (alpha x + B) y = 0, f = 4x^3 - g2 x - g3.
[[nodiscard]] RationalFunction lame_equation(const NfElem& alpha, const LameParameters<NfElem>& p);

/// The closed answer for numbers.  Also for g2^3 = 27 g3^2.
/// Unknown  the group (not "abelian?") for n in Z with w^2 != 0: dihedral, finite or infinite
/// Source   docs/theory/lame.md
/// Example  describe(*lame_answer(2, {0, 4, 0}).group)  // -> T_4 = {(c d; 0 1/c) : c^4 = 1}
[[nodiscard]] ClosedAnswer lame_answer(const NfElem& alpha, const LameParameters<NfElem>& p,
                                       const Budget& budget = {});

/// Up to this n Lame's polynomial w^2, of degree 2n + 1 in B, is written out: seconds for 100.
inline constexpr long max_lame_degree = 60;

/// The closed answer where B, g2, g3 are rational functions of parameters: "all of these are 0".
/// Valid where the denominators of B, g2, g3 and the discriminant are not 0.
struct LameConditions {
  LameIndex index;
  MPoly discriminant; ///< numerator of g2^3 - 27 g3^2
  /// The identity component is abelian exactly where all of these vanish: none = always; {1} =
  /// never.
  std::vector<MPoly> abelian;
  /// hermite: G = T_4 exactly where this vanishes, else G is irreducible and dihedral.  Unset for n
  /// > max_lame_degree.
  std::optional<MPoly> reducible;
  /// polyhedral: G = S4 exactly where all of these vanish; elsewhere on `abelian`, A5.
  std::vector<MPoly> octahedral;

  [[nodiscard]] bool always() const { return abelian.empty(); }
  [[nodiscard]] bool never() const;
};
/// Requires  a ring in at least one of B, g2, g3
/// Cost      O(n^2) operations in Q(parameters), n^3 for denominators 3, 4, 5
[[nodiscard]] LameConditions lame_conditions(const LameIndex& index,
                                             const LameParameters<MFraction>& p,
                                             const Budget& budget = {});

/// On the degenerate curve, g2 and g3 not both 0: f = 4 (x-a)^2 (x+2a) with a = -3 g3/(2 g2), and
/// the equation is Riemann's with exponent differences l, 1/2, n + 1/2;
/// l^2 = (n(n+1) a + B)/(3a) is returned.
template <class R>
[[nodiscard]] R degenerate_exponent_squared(const R& alpha, const LameParameters<R>& p);
/// The l for which the degenerate equation has an abelian identity component.
[[nodiscard]] ThirdExponents degenerate_exponents(const LameIndex& index);
/// Is a number with this rational square among them?
[[nodiscard]] bool contains_root(const ThirdExponents& l, const Rational& square);

/// Which values of (2n+1)^2 = 1 + 4 alpha leave a chance, for alpha that depends on parameters:
/// (2n+1)^2 = (numerator j/denominator)^2 with j = 1, 2, 3, ...
struct LameFamily {
  long numerator = 1;
  long denominator = 1;
  std::string which; ///< for which j, and what has to hold then
};
/// All of them: no other n has an abelian identity component (where g2^3 != 27 g3^2).
/// Source  docs/theory/lame.md
[[nodiscard]] std::vector<LameFamily> lame_families();

} // namespace kov
