#pragma once
// Power series in t = z - c over the residue field K[c]/q of a place, c any root of q.

#include "exact/poly.hpp"

#include <vector>

namespace kov {

/// Coefficients of t^0, t^1, ...; each a polynomial in c of degree < deg q.
using ResidueSeries = std::vector<Poly>;

/// The Taylor coefficients f^(k)(c)/k!, 0 <= k < n, modulo q.
/// Cost    n exact divisions of polynomials of degree deg f
/// Example taylor_at(pow(z, 3), z*z - 2, 4)  // -> {2*z, 6, 3*z, 1}
[[nodiscard]] ResidueSeries taylor_at(const Poly& f, const Poly& q, long n);
/// a/b to the length of the shorter; Requires b[0] invertible modulo q.
/// Example divide(taylor_at(1, z, 3), taylor_at(1 - z, z, 3), z)  // -> {1, 1, 1}
[[nodiscard]] ResidueSeries divide(const ResidueSeries& a, const ResidueSeries& b, const Poly& q);
/// The square root with constant term 1 of a series with constant term 1.
[[nodiscard]] ResidueSeries square_root(const ResidueSeries& a, const Poly& q);

} // namespace kov
