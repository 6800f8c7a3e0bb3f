#pragma once
// Krawczyk's test for F(x) = 0 in any number of unknowns, in balls.
//
//   K = m - C F(m) + (1 - C J)(B - m),   J encloses DF over the box B around m, C any matrix.
//
// K inside B proves that B contains exactly one zero, that it lies in K, and that every matrix in J (so DF at the
// zero) is regular [Krawczyk1969].

#include "flow/number/double_ball.hpp"

#include <optional>
#include <vector>

namespace kov::flow {

using BallVector = std::vector<Enclosure>;
using BallMatrix = std::vector<BallVector>;

/// The middles of an approximate inverse, exact numbers; nothing if the matrix seems singular.  R: Enclosure, DoubleBall.
template <class R>
[[nodiscard]] std::optional<std::vector<std::vector<R>>>
approximate_inverse(std::vector<std::vector<R>> a);
/// C b.
template <class R>
[[nodiscard]] std::vector<R> applied(const std::vector<std::vector<R>>& c, const std::vector<R>& b);
/// K - m, for B = m +- radius.
template <class R>
[[nodiscard]] std::vector<R>
krawczyk_shift(const std::vector<std::vector<R>>& c, const std::vector<R>& value,
               const std::vector<std::vector<R>>& slope, const std::vector<double>& radius);
/// K lies inside B, in every component.
template <class R>
[[nodiscard]] bool shift_inside(const std::vector<R>& shift, const std::vector<double>& radius);
/// An upper bound of |x|; infinity where there is none.
[[nodiscard]] double bound_of(const Enclosure& x);
[[nodiscard]] inline double bound_of(const DoubleBall& x) {
  return std::isfinite(x.most()) ? x.most() : INFINITY;
}

} // namespace kov::flow
