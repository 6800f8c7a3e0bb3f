#pragma once
// Is an exponent difference rational?  Proofs that it never is, and bounds for its square.
// docs/theory/strata.md, 4

#include "places/scheme.hpp"

namespace kov::strata {

/// Sets exponent, delta, irrational from chi.  Needs: the discriminant of chi is negative
/// but for a factor that may vanish.
[[nodiscard]] std::optional<Needs> classify_exponent(ParametricPlace& p,
                                                     const ParametrisedSet& region);

/// chi in the parameters that no relation of the region determines, where that leaves one
/// irreducible polynomial: its roots contain those of chi.
void eliminate_relations(std::vector<MFraction>& chi, const ParametrisedSet& region);

/// A rational B with Delta^2 <= B for every real Delta^2, on the whole stratum; from a short list.
[[nodiscard]] std::optional<Rational> bound_of_square(const ParametricPlace& p,
                                                      const ParametrisedSet& region);

/// Delta as a rational function of the parameters, if Delta^2 is a square there.
/// Given   const MFraction r = Rational(1, 4) * (a * a - one) / (z * z);
/// Given   const ParametrisedSet pole = everywhere.where_nonzero((a - one).num())
///                                 .where_nonzero((a + one).num());
/// Given   const Scheme s = std::get<Scheme>(scheme(r, 0, pole));
/// Example exponent_difference(s.finite.front())  // -> a
[[nodiscard]] std::optional<MFraction> exponent_difference(const ParametricPlace& p);

/// The numerator of chi(x): zero exactly where x is a value of Delta^2.
/// Example where_square_is(s.finite.front(), 4)  // -> -a^2 + 4
[[nodiscard]] MPoly where_square_is(const ParametricPlace& p, const Rational& x);

} // namespace kov::strata
