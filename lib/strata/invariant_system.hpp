#pragma once
// Rational solutions v = P prod q^e of the m-th symmetric power over Q(parameters), deg P <= D, and
// the proof that there is none at any point of a stratum.
//
// With S = prod q^ceil(order/2) and theta = S (log derivative of prod q^e) the recurrence of
// docs/theory/normal_form.md (2.5) makes the condition linear in the coefficients of P:
//
//   T_0 = P,  T_1 = S P' + theta P,
//   T_(i+1) = S T_i' + (theta - i S') T_i - i (m-i+1) r S^2 T_(i-1),
//
// and v solves Sym^m exactly when T_(m+1) = 0.  docs/theory/strata.md, 5

#include "places/scheme.hpp"

namespace kov::strata {

struct InvariantForm {
  long m = 0;
  std::vector<long> e; ///< parallel to Scheme::finite
  long degree = 0;     ///< D >= 0
};

/// A solution over Q(parameters), not zero at any point of the stratum.
struct ParametricInvariant {
  InvariantForm form;
  MPoly p; ///< in z and the parameters
};

/// Solves the system over Q(parameters).  Unset: only the zero solution there.
/// Needs  the solution found may vanish identically somewhere
/// Checked: L_(m+1) v = 0 by the recurrence of (2.1) on v itself
/// Given   const Scheme s = std::get<Scheme>(scheme(a, 0, everywhere.where_nonzero(a.num())));
/// Example std::get<0>(find_invariant(s, {2, {}, 0}, everywhere))->p  // -> 1
[[nodiscard]] std::variant<std::optional<ParametricInvariant>, Needs>
find_invariant(const Scheme& s, const InvariantForm& form, const ParametrisedSet& region,
               const Budget& budget = {});

/// A maximal minor of the system: the rows are powers of z.
struct MaximalMinor {
  std::vector<long> rows;
  MPoly value;
};
/// The system has only the zero solution at every point of the stratum, because these minors have
/// no common zero there: one is known not to vanish, or they have one parameter, and their gcd is.
struct Excluded {
  std::vector<MaximalMinor> minors;
};
/// It has a nonzero solution at most where these polynomials vanish together.
struct Unsettled {
  std::vector<MPoly> together;
};
/// Requires that find_invariant found none.  Needs: a maximal minor may vanish there.
[[nodiscard]] std::variant<Excluded, Needs, Unsettled>
exclude_invariant(const Scheme& s, const InvariantForm& form, const ParametrisedSet& region,
                  const Budget& budget = {});

} // namespace kov::strata
