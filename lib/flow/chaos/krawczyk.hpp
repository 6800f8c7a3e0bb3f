#pragma once
// Krawczyk's test for F(x) = 0 in any number of unknowns, in balls.
//
//   K = m - C F(m) + (1 - C J)(B - m),   J encloses DF over the box B around m, C any matrix.
//
// K inside B proves that B contains exactly one zero, that it lies in K, and that every matrix in J (so DF at the
// zero) is regular [Krawczyk1969].

#include "flow/number/enclosure.hpp"

#include <optional>
#include <vector>

namespace kov::flow {

using BallVector = std::vector<Enclosure>;
using BallMatrix = std::vector<BallVector>;

/// The middles of an approximate inverse, exact numbers; nothing if the matrix seems singular.
[[nodiscard]] std::optional<BallMatrix> approximate_inverse(BallMatrix a);
/// C b.
[[nodiscard]] BallVector applied(const BallMatrix& c, const BallVector& b);
/// K - m, for B = m +- radius.
[[nodiscard]] BallVector krawczyk_shift(const BallMatrix& c, const BallVector& value,
                                        const BallMatrix& slope, const std::vector<double>& radius);
/// K lies inside B, in every component.
[[nodiscard]] bool shift_inside(const BallVector& shift, const std::vector<double>& radius);
/// An upper bound of |x|; infinity where there is none.
[[nodiscard]] double bound_of(const Enclosure& x);

} // namespace kov::flow
