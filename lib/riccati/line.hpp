#pragma once
// A formal exponential solution at one singular place, modulo one prime.
//
// If y'/y = omega is rational over the algebraic closure of K(z), its expansion at the place c is
// one of at most two formal lines that r determines (docs/theory/riccati_one_place.md):
//
//   simple, or regular with a logarithm    1 line   omega = alpha/t + ...
//   regular, Delta not an integer          2 lines  alpha = (1 +- Delta)/2
//   irregular                              2 lines  omega = +-[sqrt r]_c + alpha/t + ...
//
// and omega has numerator and denominator of bounded degree, so that rational reconstruction from
// enough terms finds it or proves that it does not exist.  The same holds modulo p.

#include "linode/degree_bounds.hpp"
#include "linode/modular_series.hpp"

#include <optional>

namespace kov {

/// How many formal lines the place has; 0 for ramified places; -1 if they are not finite in number
/// (Delta an integer without logarithm, or not known to have one).
/// Example formal_lines(singularities(z*z + 3).infinity)  // -> 2
/// Example formal_lines(singularities(RationalFunction(1, z)).finite.front())  // -> 1
/// Example formal_lines(singularities(RationalFunction(2, z*z)).finite.front())  // -> -1
[[nodiscard]] int formal_lines(const Singularity& s);

/// A place with its local equation modulo one prime ideal of degree one.
struct ModularPlace {
  PrimeIdeal prime;
  mp_limb_t root = 0; ///< c modulo p (0 at infinity, where t = 1/z)
  bool at_infinity = false;
  long order = 0;      ///< of the pole of the local equation u'' = B/(t^order A) u
  NmodPoly a;          ///< A, A(0) != 0
  NmodPoly b;          ///< B
  mp_limb_t delta = 0; ///< regular: Delta; irregular: the square root a of u

  [[nodiscard]] long nu() const noexcept { return order < 2 ? 1 : order / 2; }
};

/// Unset when the prime is not good for this place: integrality, a simple root of q modulo p where
/// no other factor vanishes, the same order, Delta or sqrt(u) in F_p, and k +- Delta != 0 for 0 < k
/// < n.
[[nodiscard]] std::optional<ModularPlace>
reduce_place(const Singularities& s, const Singularity& place, const PrimeIdeal& prime, long n);

/// t^nu * omega to n terms along the line with the given sign (+1 or -1; +1 for single lines),
/// where omega = u'/u in the local variable.
[[nodiscard]] NmodPoly expand_line(const ModularPlace& place, int sign, long n);

} // namespace kov
