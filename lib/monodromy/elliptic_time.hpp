#pragma once
// Systems whose independent variable is an elliptic time:
//
//   dY/dt = (B_0(z) + w B_1(z)) Y,   w = dz/dt,   w^2 = F(z),   F squarefree of degree 3 or 4.
//
// t is the variable of the universal cover of the curve w^2 = F(z).  Closed loops of the
// curve are words in the loops around the singularities in the z-plane that change the sign of w an
// even number of times.  docs/theory/monodromy.md 11

#include "monodromy/two_sheets.hpp"
#include "monodromy/words.hpp"

namespace kov::monodromy {

/// Continued along t -> t + period, Y becomes Y M.
struct PeriodMatrix {
  ComplexBall period;
  Word loops; ///< in the z-plane
  BallMatrix matrix;
};

/// Around a point of the t-plane where z is a pole of B_0 or B_1 (or infinity, where they are no
/// differential without poles), counterclockwise.
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
  long bits = 0; ///< of the precision that was enough
};

/// Y = 1 at the base.
/// Requires entries over the field of F or Q
/// Errors   InvalidArgument: F is not squarefree of degree 3 or 4; those of TwoSheets and
///          monodromy()
[[nodiscard]] EllipticMonodromy elliptic_monodromy(const EllipticSystem& s,
                                                   const Request& request = {});
/// The same for d^2y/dt^2 = R(z) y and the rows (y, dy/dt).
[[nodiscard]] EllipticMonodromy elliptic_monodromy(const RationalFunction& r, const Poly& f,
                                                   const Request& request = {});

/// The elements of the group that were computed, periods before poles, as words.hpp takes them.
[[nodiscard]] Monodromy elements(const EllipticMonodromy& e);

} // namespace kov::monodromy
