#pragma once
// How much an error can grow along the segment from 0 to t: Gronwall's inequality in a weighted
// maximum norm.  docs/theory/monodromy.md 2
//
//   D' = A D - F,  D(0) = 0   =>   |D(t)|_w <= |t| max |F|_w exp(|t| max ||A||_w),
//
// |v|_w = max_i |v_i| 2^-w_i.  The weights make the norm of A small; any choice is correct.

#include "monodromy/local_system.hpp"
#include "monodromy/magnitude.hpp"

namespace kov::monodromy {

struct Growth {
  std::vector<long> weights;
  Magnitude exponent;             ///< of the integral of ||A||_w over the segment
  std::vector<Magnitude> inverse; ///< of |den_i(0)/den_i| on the segment
};

/// Requires |t| <= 1.
/// Errors  Imprecise when the segment cannot be told to be free of zeros of the denominators
[[nodiscard]] Growth growth(const LocalSystem& s, const ComplexBall& t);

} // namespace kov::monodromy
