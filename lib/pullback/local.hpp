#pragma once
// Laurent expansions at a place, in t = z - c, c a root of the place, or t = 1/z.

#include "linode/residue_series.hpp"
#include "linode/singularities.hpp"

#include <optional>
#include <vector>

namespace kov::pullback {

/// A point of the sphere over K.  At infinity `q` is z, so that residues are constants.
struct Point {
  Poly q = Poly::z();
  bool at_infinity = false;
};

[[nodiscard]] Point point_of(const Singularity& s);

/// t^order (c0 + c1 t + ...), c0 != 0.
struct Laurent {
  long order = 0;
  ResidueSeries terms;
};
/// Requires f != 0; n >= 1 terms.
/// Example laurent(RationalFunction(1, z*z - z), {z, false}, 2).terms  // -> {-1, -1}
[[nodiscard]] Laurent laurent(const RationalFunction& f, const Point& p, long n);

/// a^e for a series with constant term 1.
[[nodiscard]] ResidueSeries power(const ResidueSeries& a, const Rational& e, const Poly& q);
/// (integral of sqrt(r) dz)^2 = u t^-m (1 + ...): the terms without t^0 and beyond of the integral,
/// for r = u t^o (1 + ...) irregular, m = o - 2 at a finite place and 2 - o at infinity.
struct Phase {
  long pole = 0; ///< m
  Poly leading;
  ResidueSeries terms; ///< 1 + ..., ceil(m/2) of them
};
[[nodiscard]] Phase phase(const RationalFunction& r, const Singularity& s);

/// f with principal part sum_i terms[i] t^(i - pole), i < pole, and no other pole.
[[nodiscard]] RationalFunction principal_part(const ResidueSeries& terms, long pole,
                                              const Point& p);

/// All h with h^n = v in K[c]/q.  Requires v != 0.
/// Throws  OutOfBudget
/// Example roots_of(8, 3, z)  // -> {2}
[[nodiscard]] std::vector<Poly> roots_of(const Poly& v, long n, const Poly& q,
                                         const Budget& budget = {});

[[nodiscard]] std::vector<const Singularity*> irregular_places(const Singularities& s);
/// Regular, and so behind every gauge: D no integer, or a logarithm.
[[nodiscard]] bool is_lasting(const Singularity& s);

} // namespace kov::pullback
