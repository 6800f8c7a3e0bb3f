#pragma once
// All exponential solutions y'/y in K(z) from one singular place, without families.
//
// Source  docs/theory/riccati_one_place.md, with proofs

#include "riccati/lift.hpp"
#include "riccati/line.hpp"

#include <string>
#include <vector>

namespace kov {

/// Why no exponential solution exists.
struct NoExponential {
  std::optional<Obstruction> obstruction{}; ///< the exponents alone exclude it
  // otherwise, from one place modulo one prime:
  bool at_infinity = false;
  long place = -1; ///< index into Singularities::finite
  PrimeIdeal prime{};
  mp_limb_t root = 0;
  mp_limb_t delta = 0; ///< Delta (regular) or sqrt(u) (irregular) modulo p
  long terms = 0;      ///< T
  long length = 0;     ///< L; every line needs a recurrence longer than this
};

/// The answer to "which exponential solutions are there?", when there is at most one.
struct ExponentialSearch {
  std::vector<ExponentialSolution> solutions; ///< at most one; verified
  std::optional<NoExponential> none;          ///< proof of absence
  /// Set when every place has Delta an integer and no logarithm: all solutions are (square roots
  /// of) rational functions and the question has no finite answer.
  bool projectively_trivial = false;
};

/// Requires  at most one exponential solution (the Galois group is not diagonal): then it lies in
///           K(z).  A second one modulo a prime is an accident of this prime; after twenty of them
///           OutOfBudget.
/// Throws    OutOfBudget
/// Cost      T = O(n + D_1) terms of one or two series and a half-gcd modulo p; the lift costs as
///           many primes as the answer has digits, or one linear recurrence over K.
/// Example   exponential_solutions(singularities(z*z + 3)).solutions.front().omega()
///           // -> (z^2 + 1)/z
/// Example   exponential_solutions(singularities(z)).none->obstruction->kind  // -> Kind::odd_order
/// Example   exponential_solutions(singularities(1)).solutions.size()  // -> throws OutOfBudget
[[nodiscard]] ExponentialSearch exponential_solutions(const Singularities& s,
                                                      const Budget& budget = {});

} // namespace kov
