#pragma once
// Splitting of separatrices of a perturbed Euler top: theorem_certificates.md 6.

#include "certify/theorem/family.hpp"

namespace kov::certify {

/// The names of a step, and its perturbation H1 = first/(2 (A B C)^power) of this order.
struct SplittingData {
  std::array<std::size_t, 3> moments{}, small{}; ///< parameters of the family
  unsigned long order = 1, power = 1;
  MPoly first;
  Conditions region;
};

/// The real variables of the proof: those of the family, _alpha, _beta, _delta, _s, _F, _Y (and _i,
/// which does not occur in a condition).
[[nodiscard]] Ring splitting_ring(const Family& y);

/// Z4, Z5: the conditions of which the proof shows that no point satisfies them all, in the ring
/// above.  Refuses a perturbation of degree above 12.
[[nodiscard]] Conditions splitting_conditions(const Family& y, const SplittingData& d,
                                              const Ring& ring, Arithmetic& a);

} // namespace kov::certify
