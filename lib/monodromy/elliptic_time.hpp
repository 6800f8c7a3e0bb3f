#pragma once
// Equations whose independent variable is an elliptic time:
//
//   d^2y/dt^2 = R(z) y,   (dz/dt)^2 = F(z),   F squarefree of degree 3 or 4.
//
// t is the variable of the universal cover of the curve w^2 = F(z), w = dz/dt.  Closed loops of the
// curve are words in the loops around the singularities in the z-plane that change the sign of w an
// even number of times.  docs/theory/monodromy.md 11

#include "monodromy/words.hpp"

namespace kov::monodromy {

/// Continued along t -> t + period, Y becomes Y M.
struct PeriodMatrix {
  ComplexBall period;
  Word loops; ///< in the z-plane
  BallMatrix matrix;
};

/// Around a pole of R(z(t)) in the t-plane, counterclockwise.
struct PoleMatrix {
  std::optional<SingularPoint> place; ///< of z; none: infinity
  bool other_sheet = false;           ///< reached through the first branch point
  BallMatrix matrix;
};

struct EllipticMonodromy {
  Point base;                        ///< of z
  ComplexBall speed;                 ///< w = dz/dt there, the principal root of F
  std::vector<PeriodMatrix> periods; ///< two; they generate all periods
  std::vector<PoleMatrix> poles;     ///< one for each pole in a cell of the lattice
  std::vector<std::string> self_tests;
};

/// Y = 1 at the base, rows (y, dy/dt).
/// Requires R defined over the field of F or Q
/// Errors   InvalidArgument: F is not squarefree of degree 3 or 4; those of monodromy()
[[nodiscard]] EllipticMonodromy elliptic_monodromy(const RationalFunction& r, const Poly& f,
                                                   const Request& request = {});

} // namespace kov::monodromy
