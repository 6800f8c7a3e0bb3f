#pragma once
// Degree bounds on a stratum: D_m for invariants of degree m, D_1 for exponential solutions, and
// the families of exponents behind them when one exponent difference is open.
// docs/theory/strata.md, 3; docs/theory/local_exponents.md, 2 and 3

#include "strata/invariant_system.hpp"

namespace kov::strata {

struct InvariantBound {
  std::optional<InvariantForm> form{};     ///< unset: no invariant
  std::optional<PlaceIndex> no_exponent{}; ///< of Sym^m is an integer there; or
  long degree = 0;                         ///< D_m is negative
};
/// Invariants with more unknowns are not looked for.
inline constexpr long most_unknowns = 40;

/// m even.  An open exponent difference is taken as one with no multiple j Delta, 0 < j <= m/2, in
/// Z: what holds for it holds for those only.
/// Given   const MFraction r = Rational(2) * one / (z * z);
/// Given   const Scheme s = std::get<Scheme>(scheme(r, 0, everywhere));
/// Example invariant_bound(s, 2).form->e  // -> {-2}
[[nodiscard]] InvariantBound invariant_bound(const Scheme& s, long m);

/// The greatest d = alpha_inf - sum alpha_c over the exponents of exponential solutions; unset when
/// some real part is not known.  Open differences are at most sqrt(bound).
struct ExponentialBound {
  std::optional<Rational> d;
  bool odd_order = false; ///< no exponential solution at all: a place of odd order >= 3
  [[nodiscard]] bool excludes() const { return odd_order || (d && *d < Rational(0)); }
};
/// Example exponential_bound(s).d  // -> 3
[[nodiscard]] ExponentialBound
exponential_bound(const Scheme& s, const std::optional<Rational>& open_square_bound = {});

/// For exactly one open place, of degree n, with the same Delta at all its roots: the degrees
///   d = fixed + j Delta/2,   j = -n, -n+2, ..., n   (exponential solutions)
///   d = fixed/2 + j Delta,   j = -n, ..., n         (v = y1 y2, v^2 rational; 2 Delta in Z or j = 0)
struct Families {
  std::vector<Rational> fixed; ///< sorted, each once
  bool complete = false;       ///< false: some exponent is not rational and the list is not given
};
[[nodiscard]] Families exponential_families(const Scheme& s, const ParametricPlace& open);
/// No exponent is open: d = fixed.
[[nodiscard]] Families exponential_families(const Scheme& s);
/// The least even n that makes y^n rational for every exponential solution y.  Requires that all
/// exponent differences are rational constants.
[[nodiscard]] Integer common_denominator(const Scheme& s);
[[nodiscard]] Families product_families(const Scheme& s, const ParametricPlace& open);

} // namespace kov::strata
