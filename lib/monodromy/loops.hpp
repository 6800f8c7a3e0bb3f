#pragma once
// A tree of loops from one base point b: for every singularity s the straight segment from b
// towards s, once around s on a small circle, counterclockwise, and back on the segment.
//
// Order: by the angle under which b sees the singularities, counterclockwise.  For a base outside
// the circle that holds all singularities the angle is counted from the direction of its centre, so
// that loop 1, then loop 2, ..., then the last one together are the large circle from b,
// counterclockwise:
//
//   M_n ... M_2 M_1 = M_circle             (continuation along loop 1 first)
//
// docs/theory/monodromy.md 3

#include "monodromy/point.hpp"

#include <optional>
#include <vector>

namespace kov::monodromy {

/// Expansion points and, between neighbours, the point where their expansions meet.
struct Path {
  std::vector<Point> vertices;
  std::vector<Point> joints; ///< one fewer
};

[[nodiscard]] Path reversed(Path path);

struct Loop {
  std::size_t singularity = 0; ///< index into the list that was given
  Path approach;               ///< from the base to the circle
  Path circle;                 ///< closed
};

struct LoopTree {
  Point base;
  std::vector<Loop> loops;
  std::optional<Path> large_circle; ///< for a base outside
};

/// Requires the singularities disjoint; the base, if given, exact.
/// Errors   InvalidArgument: the base is a singularity, or sees two of them in one direction;
///          OutOfBudget: singularities too near to each other
[[nodiscard]] LoopTree loop_tree(const std::vector<ComplexBall>& singularities,
                                 const std::optional<Point>& base = {});

} // namespace kov::monodromy
