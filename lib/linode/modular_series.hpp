#pragma once
// Power series solutions modulo p of equations written with t d/dt.

#include "exact/modular.hpp"

#include <vector>

namespace kov {

/// c2 t^2 u'' + c1 t u' + c0 u = 0 over F_p.
struct ThetaEquation {
  NmodPoly c2;
  NmodPoly c1;
  NmodPoly c0;
};

/// The first n coefficients of the solution with the given initial ones.
///
/// Requires  the indicial value k(k-1)c2(0) + k c1(0) + c0(0) nonzero modulo p for
///           initial.size() <= k < n (checked); n < p
/// Cost      O(n (deg c2 + deg c1 + deg c0)), three inner products per coefficient
/// Given     const auto mod101 = [](const Poly& f) { return *PrimeIdeal{101, 0}.reduce(f); };
/// Example   power_series_solution({mod101(1), mod101(0), mod101(-z*z)}, {1, 1}, 4)
///           == mod101(1 + z + Rational(1, 2)*z*z + Rational(1, 6)*pow(z, 3))  // -> yes
[[nodiscard]] NmodPoly power_series_solution(const ThetaEquation& equation,
                                             const std::vector<mp_limb_t>& initial, long n);

/// r = num/den modulo p, shifted so that the place in question is t = 0.
struct ModularEquation {
  NmodPoly num;
  NmodPoly den;
};

/// The shortest linear recurrence of the sequence: its length L and V(x) of degree L with
/// sum_i V_i s_(i+j) = 0 (Berlekamp-Massey, by half-gcd in FLINT).  Requires 2L <= n for the true
/// L; otherwise the result means nothing more than that no recurrence has a length <= n/2.
/// Given   const Poly fibonacci = 1 + z + 2*z*z + 3*pow(z, 3) + 5*pow(z, 4) + 8*pow(z, 5);
/// Example shortest_recurrence(mod101(fibonacci), 6).length  // -> 2
struct Recurrence {
  long length = 0;
  NmodPoly characteristic;
};
[[nodiscard]] Recurrence shortest_recurrence(const NmodPoly& series, long n);

} // namespace kov
