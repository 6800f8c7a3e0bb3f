#pragma once
// Stokes matrices at infinity of the equations whose connection problem is solved by closed
// formulas:
//
//   r = a x                     Airy: three directions, slope 3/2 (ramified)
//   r = u x^2 + w               Weber: four directions, slope 2
//   r = a + b/x + c/x^2         Whittaker and Bessel, a != 0: two directions, slope 1
//   r = a x^(n-2) + c/x^2       Bessel, other n >= 1: n directions, slope n/2 (ramified for odd n)
//
// x = z - centre.  With the monodromy matrices and the exponential torus they generate a dense
// subgroup of the differential Galois group (Ramis).  docs/theory/monodromy.md 10

#include "monodromy/monodromy.hpp"

namespace kov::monodromy {

/// The solutions above a Stokes direction, counterclockwise, are Y S where Y are those below.
struct StokesMatrix {
  Ball direction;         ///< arg x
  ComplexBall multiplier; ///< of the recessive solution (docs/theory/monodromy.md 10.1)
  BallMatrix matrix;      ///< S for Y(base) = 1, rows (y, y'): unipotent
};

struct Stokes {
  std::string family;                 ///< "Airy", "Weber", "Whittaker", "Bessel"
  std::vector<StokesMatrix> matrices; ///< counterclockwise, from the first one behind the base
  std::vector<std::string> self_tests;
};

/// Every radius is at most 10^-digits.  Nothing for other equations y'' + p y' + q y = 0, which
/// says nothing of them.
/// Errors   OutOfBudget when the accuracy is not reached; InternalError when a self-test fails
/// Source   docs/theory/monodromy.md 10
[[nodiscard]] std::optional<Stokes> stokes_at_infinity(const RationalFunction& p,
                                                       const RationalFunction& q, const Point& base,
                                                       const Request& request = {});

} // namespace kov::monodromy
